// Question: in which directions does a pixel look for occluders, and are they as even as the text says?
//
// The one idea: keep 14 fixed vectors that are spread evenly, and mirror them all at the plane of a random
// vector, another at each pixel. Mirroring keeps lengths and angles, but only a unit vector makes a mirror.
//
// Source: X_Jun, "Generating random samples"; Luna, BuildOffsetVectors and BuildRandomVectorTexture.
// Look for: the third drawing, pulled out of shape; the histogram, which should be one bar; the bright spots.
// Run: crevice chapter 05
#include <algorithm>
#include <cmath>
#include <numeric>

#include <glm/geometric.hpp>

#include "chapters/notebook/chapter.h"
#include "chapters/props/switched_ao.h"
#include "chapters/terminal/number_text.h"
#include "ssao/judge/luna_limit.h"
#include "ssao/judge/metrics.h"

namespace crevice {
namespace {

using Vectors = std::array<glm::vec3, kCubeVectors>;

// HLSL's reflect, for the whole set.
Vectors mirrored(Vectors vectors, glm::vec3 r) {
    for (glm::vec3& v : vectors) v = v - 2 * glm::dot(v, r) * r;
    return vectors;
}

// The vectors as lines from the origin: x right, y up, z to the upper right. The frame is at 1.6.
Picture drawing(const Vectors& vectors) {
    constexpr int kSide = 241;
    Image3 canvas({kSide, kSide}, glm::vec3(1));
    for (const glm::vec3& v : vectors) {
        for (int step = 0; step <= kSide; ++step) {
            const glm::vec3 p = static_cast<float>(step) / kSide * v;
            const int x = static_cast<int>(120.5f + 75 * (p.x + 0.35f * p.z));
            const int y = static_cast<int>(120.5f - 75 * (p.y + 0.25f * p.z));
            if (x >= 0 && y >= 0 && x < kSide && y < kSide) canvas.set(x, y, 0.4f * glm::normalize(v) + 0.4f);
        }
    }
    return colour_picture(canvas);
}

// The 14 directions mirrored at every vector of the map.
std::vector<glm::vec3> all_mirrored(Vectors offsets, const RandomMap& map, bool unit) {
    for (glm::vec3& o : offsets) o = glm::normalize(o);
    std::vector<glm::vec3> result;
    for (std::size_t i = 0; i < map.x.size(); ++i) {
        const glm::vec3 r(map.x[i], map.y[i], map.z[i]);
        const Vectors d = mirrored(offsets, unit ? glm::normalize(r) : r);
        result.insert(result.end(), d.begin(), d.end());
    }
    return result;
}

// How often the flipped directions point where, seen along n = +z; equal areas, 1 is the mean.
Image<float> density(const std::vector<glm::vec3>& directions) {
    Image<float> result({48, 48}, 0.0f);
    for (const glm::vec3& d : directions) {
        const glm::vec3 n = d.z < 0 ? -d : d;
        const float scale = 1 / std::sqrt(1 + n.z);
        const auto cell = [&](float a) { return static_cast<int>((a * scale + 1) * 23.99f); };
        result.at(cell(n.x), 47 - cell(n.y)) += 3.14159265f * 24 * 24 / static_cast<float>(directions.size());
    }
    return result;
}

// Bars over 0 to 3, a twentieth wide, light below 1.
Picture histogram(const std::vector<float>& sorted) {
    Image<float> canvas({60, 40}, 1.0f);
    const auto first = [&](float value) { return std::lower_bound(sorted.begin(), sorted.end(), value); };
    for (int bar = 0; bar < 60; ++bar) {
        const auto low = 0.05f * static_cast<float>(bar);
        const auto inside = first(low + 0.05f) - first(low);
        const auto height = 300 * inside / static_cast<std::ptrdiff_t>(sorted.size());
        for (int y = 0; y < height && y < 40; ++y) canvas.at(bar, 39 - y) = bar < 20 ? 0.6f : 0.2f;
    }
    return grey_picture(canvas, 0, 1);
}

void show_all_mirrored(Notebook& book, const Vectors& offsets, const RandomMap& map) {
    const std::vector<glm::vec3> directions = all_mirrored(offsets, map, true);
    std::vector<float> unit, raw;
    for (const glm::vec3& d : directions) unit.push_back(glm::length(d));
    for (const glm::vec3& d : all_mirrored(offsets, map, false)) raw.push_back(glm::length(d));
    for (std::vector<float>* lengths : {&unit, &raw}) std::sort(lengths->begin(), lengths->end());
    book.show("lengths", histogram(raw), "|d| / |o| from 0 to 3, r as published; light below 1, dark above.");
    const double mean = std::accumulate(raw.begin(), raw.end(), 0.0) / static_cast<double>(raw.size());
    const float p1 = raw[raw.size() / 100], p99 = raw[raw.size() / 100 * 99];
    book.table({"mean |d| / |o|", "1 %", "99 %", "largest"},
               {{std::to_string(mean), exact_text(p1), exact_text(p99), exact_text(raw.back())}});
    book.check("a unit r keeps every length", unit.front() > 0.99999f && unit.back() < 1.00001f);
    book.check("as published, 1 sample in 100 lies over 2.5 times too far, the worst over 4, none 5",
               p99 > 2.5f && raw.back() > 4 && raw.back() < 5);
    book.show("density", grey_picture(density(directions), 0, 3),
              "Where all flipped directions point, seen along n (1, dark, is even): near the originals.");
}

// What vectors that are not unit do to the picture, at a column's foot.
void show_raw_vectors(Notebook& book) {
    const SwitchedView view = column_foot(book);
    std::vector<Image<float>> pictures;
    std::vector<double> noise;
    for (const char* kind : {"unit", "raw"}) {
        const Words words = {std::string("random_vectors=") + kind, "exponent=1"};
        const SwitchedAo linear = view.ao(words);
        constexpr int kSeeds = 32;
        noise.push_back(
            compare_images(linear.raw, luna_limit(linear.inputs, linear.settings, kSeeds).mean).rmse);
        pictures.push_back(view.ao({words[0]}).raw);
    }
    book.show_row("AO with unit vectors; with raw ones, " + view.command({"random_vectors=raw"}) +
                      "; raw minus unit: less shade at the foot, more further out, and more grain.",
                  {{"ao_unit", ao_picture(pictures[0])},
                   {"ao_raw", ao_picture(pictures[1])},
                   {"raw_minus_unit", difference_picture(difference_of(pictures[1], pictures[0]))}});
    book.check("raw vectors make at least a quarter more noise (RMS from their own mean over 32 seeds)",
               noise[1] > 1.25 * noise[0], decimal_text(noise[0], 4) + " and " + decimal_text(noise[1], 4));
    book.text(
        "Long samples may also pass the near plane, where no pixel shows what is there. The lab rejects "
        "those with raw vectors too; the tutorials go on to divide by `q_z <= 0`.");
}

void sample_vectors(Notebook& book) {
    book.text(R"(
        # 05 Sample vectors

        Fixed directions would show as bands, independent ones would clump. The tutorial takes 14 vectors `o`
        to a cube's corners and faces, a quarter to one unit long, mirrors them at the random `r` of a pixel,
        and flips to the front those behind the surface:

            d = o - 2 (o . r) r        q = p + sign(d . n) radius d
    )");
    const Vectors offsets = cube_offsets(book.seed());
    const glm::vec3 r = glm::normalize(glm::vec3(0.3f, 0.8f, 0.5f));
    const Vectors turned = mirrored(offsets, r);
    book.show_row("The vectors: as stored; mirrored with |r| = 1; with |r| = 1.4, which is no mirror.",
                  {{"stored", drawing(offsets)},
                   {"mirrored", drawing(turned)},
                   {"stretched", drawing(mirrored(offsets, 1.4f * r))}});
    glm::vec3 mean(0);
    float opposite = 1;  // cosine
    for (std::size_t i = 0; i < turned.size(); i += 2) {
        const glm::vec3 first = glm::normalize(turned[i]), second = glm::normalize(turned[i + 1]);
        mean += (first + second) / 14.0f;
        opposite = std::min(opposite, -glm::dot(first, second));
    }
    book.check("the mean direction is 0: no side is preferred", glm::length(mean) < 1e-6f);
    book.check("flipping sends both of a pair the same way: 7 directions, not 14", opposite > 0.99999f);

    const RandomMap map = random_map(book.seed());
    Image3 vectors({256, 256}, glm::vec3(0));
    vectors.x.pixels.assign(map.x.begin(), map.x.end());
    vectors.y.pixels.assign(map.y.begin(), map.y.end());
    vectors.z.pixels.assign(map.z.begin(), map.z.end());
    book.show("random_map", normal_picture(vectors), "The random map: 256 x 256 vectors r, hardly one unit.");
    show_all_mirrored(book, offsets, map);
    show_raw_vectors(book);
    book.try_it({
        "Draw with `1.1f * r` instead of `1.4f * r`: a tenth too long is enough to spoil the set.",
        "In `all_mirrored`, keep every second `d` only: the same density, the other half repeats it.",
        "Run with `--seed 2`: other lengths and another map, but the same statistics.",
    });
    book.errata({
        "*X_Jun, shader:* `r` is used as fetched: `reflect` does not reflect (histogram, last row).",
        "*X_Jun:* mirrored vectors are certain to be uniform. One pixel's are, all together are not.",
        "*X_Jun:* opposite neighbours spread fewer than 14 samples. Flipping makes them one direction.",
        "*Luna, prose:* 14 vectors in the hemisphere. They fill the sphere; the shader flips them.",
        "*X_Jun:* `random_device` seeds both tables: no two runs give the same picture.",
    });
}

const Chapter kChapter("05", "sample_vectors", "Sample vectors", sample_vectors);

}  // namespace
}  // namespace crevice
