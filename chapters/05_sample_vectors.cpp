// Question: in which directions does a pixel look for occluders, and are they as even and as random as the text says?
//
// The one idea: keep 14 fixed vectors that are spread evenly, and mirror all of them at the plane of one random vector
// per pixel. Mirroring keeps lengths and angles, so the set stays even; but only a unit vector makes a mirror.
//
// Source: seed 000, "Generating random samples"; seed 002, BuildOffsetVectors and BuildRandomVectorTexture.
// Look for: the third drawing, where a vector that is too long pulls the set out of shape; the histogram, which
//           should be a single bar; the bright spots of the density.
// Run: crevice chapter 05
#include <algorithm>
#include <cmath>
#include <cstdio>

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include "chapters/chapter.h"
#include "ssao/random_vectors.h"

namespace crevice {
namespace {

using Vectors = std::array<glm::vec3, kCubeVectors>;

std::string text(const char* format, float value) {
    char characters[48];
    std::snprintf(characters, sizeof characters, format, static_cast<double>(value));
    return characters;
}

// HLSL's reflect, for the whole set.
Vectors mirrored(Vectors vectors, glm::vec3 r) {
    for (glm::vec3& v : vectors) v = v - 2 * glm::dot(v, r) * r;
    return vectors;
}

// The vectors as lines from the origin, z to the upper right; grey axes from -1 to 1.
Picture drawing(const Vectors& vectors) {
    constexpr int kSide = 241;
    Image3 canvas({kSide, kSide}, glm::vec3(1));
    const auto line = [&](glm::vec3 from, glm::vec3 to, glm::vec3 colour) {
        for (int step = 0; step <= kSide; ++step) {
            const glm::vec3 p = from + static_cast<float>(step) / kSide * (to - from);
            const int x = static_cast<int>(120.5f + 75 * (p.x + 0.35f * p.z));
            const int y = static_cast<int>(120.5f - 75 * (p.y + 0.25f * p.z));
            if (x >= 0 && y >= 0 && x < kSide && y < kSide) canvas.set(x, y, colour);
        }
    };
    for (const glm::vec3& axis : {glm::vec3(1, 0, 0), glm::vec3(0, 1, 0), glm::vec3(0, 0, 1)}) {
        line(-axis, axis, glm::vec3(0.8f));
    }
    for (const glm::vec3& v : vectors) line(glm::vec3(0), v, 0.4f * glm::normalize(v) + 0.4f);
    return colour_picture(canvas);
}

// What mirroring does to 14 unit directions, over every texel of the random map.
struct Mirroring {
    std::vector<float> lengths;         // sorted
    double mean_length = 0;
    float uneven = 0;                   // largest |mean of d d^T - identity / 3| of one texel's set
    Image<float> density{{48, 48}, 0};  // of the flipped directions, seen along n = +z, equal areas; even: 1
    float percentile(std::size_t percent) const { return lengths[percent * (lengths.size() - 1) / 100]; }
};

Mirroring mirroring(Vectors directions, const RandomMap& map, bool unit) {
    Mirroring result;
    for (glm::vec3& d : directions) d = glm::normalize(d);
    const auto count = static_cast<float>(map.x.size() * kCubeVectors);
    for (std::size_t i = 0; i < map.x.size(); ++i) {
        const glm::vec3 r(map.x[i], map.y[i], map.z[i]);
        glm::mat3 spread(-1.0f / 3);
        for (const glm::vec3& d : mirrored(directions, unit ? glm::normalize(r) : r)) {
            result.lengths.push_back(glm::length(d));
            result.mean_length += static_cast<double>(glm::length(d) / count);
            spread += glm::outerProduct(d, d) * (1.0f / kCubeVectors);
            const glm::vec3 flipped = d / (d.z < 0 ? -glm::length(d) : glm::length(d));
            const auto cell = [&](float a) { return static_cast<int>((a / std::sqrt(1 + flipped.z) + 1) * 23.9f); };
            result.density.at(cell(flipped.x), 47 - cell(flipped.y)) += 3.14159265f * 23.9f * 23.9f / count;
        }
        for (int c = 0; c < 9; ++c) result.uneven = std::max(result.uneven, std::fabs(spread[c / 3][c % 3]));
    }
    std::sort(result.lengths.begin(), result.lengths.end());
    return result;
}

// Bars over |d| / |o| from 0 to 3; the highest fills the picture. `lengths` are sorted.
Picture histogram(const std::vector<float>& lengths) {
    Image<float> canvas({360, 160}, 1.0f);
    for (int x = 0; x < 360; ++x) {
        const auto below = [&](int bar) {
            return std::lower_bound(lengths.begin(), lengths.end(), static_cast<float>(bar) / 20);
        };
        const auto share = static_cast<double>(below(x / 6 + 1) - below(x / 6)) / static_cast<double>(lengths.size());
        const int top = 160 - static_cast<int>(2500 * share);
        for (int y = std::max(top, 0); y < 160; ++y) canvas.at(x, y) = x / 6 == 20 ? 0.5f : 0.2f;
    }
    return grey_picture(canvas, 0, 1);
}

void mirror_and_flip(Notebook& book, const Vectors& offsets, const RandomMap& map) {
    const glm::vec3 r = glm::normalize(glm::vec3(0.3f, 0.8f, 0.5f));
    const Vectors turned = mirrored(offsets, r);
    book.show_row("The 14 vectors: as stored; mirrored with |r| = 1; with |r| = 1.4, which is no mirror.",
                  {{"stored", drawing(offsets)}, {"mirrored", drawing(turned)}, {"stretched", drawing(mirrored(offsets, 1.4f * r))}});
    const Mirroring unit = mirroring(offsets, map, true), raw = mirroring(offsets, map, false);
    book.show("lengths", histogram(raw.lengths), "|d| / |o| from 0 to 3 with r as published; the lighter bar begins at 1.");
    const auto row = [](const char* name, const Mirroring& m) {
        return std::vector{std::string(name), text("%.2f", static_cast<float>(m.mean_length)), text("%.2f", m.percentile(1)),
                           text("%.2f", m.percentile(99)), text("%.2f", m.lengths.back()), text("%.2g", m.uneven)};
    };
    book.table({"r", "mean |d|/|o|", "p1", "p99", "max", "unevenness of a set"}, {row("unit", unit), row("as published", raw)});
    book.check("a unit r keeps every length", unit.lengths.front() > 0.99999f && unit.lengths.back() < 1.00001f);
    book.check("a unit r keeps every pixel's set even in all axes", unit.uneven < 1e-5f, text("%.1e", unit.uneven));
    book.check("as published, a sample can lie more than 4, never 5 times too far; 1 in 100 lies beyond 2.5 times",
               raw.lengths.back() > 4 && raw.lengths.back() < 5 && raw.percentile(99) > 2.5f);
    book.text("Samples behind the surface are flipped to its front: `q = p + sign(d . n) radius d`.");
    float cosine = 1;
    for (std::size_t i = 0; i < turned.size(); i += 2) {
        cosine = std::min(cosine, -glm::dot(glm::normalize(turned[i]), glm::normalize(turned[i + 1])));
    }
    book.check("flipping sends both vectors of a pair the same way: 7 directions, not 14", cosine > 0.99999f);
    book.show("density", grey_picture(unit.density, 0, 3), "Where the flipped directions of all pixels point, seen along n "
              "(even: dark grey, 1): they stay near the originals, here the cube's corners and faces.");
}

void sample_vectors(Notebook& book) {
    book.text(R"(
        # 05 Sample vectors

        Each pixel tests 14 points around itself. Fixed directions would show as bands, independent random ones would
        clump. The tutorial takes 14 fixed vectors `o` to the corners and faces of a cube, a quarter to one unit long,
        and mirrors them at a random vector `r` of the pixel:

            d = o - 2 (o . r) r
    )");
    const Vectors offsets = cube_offsets(book.seed());
    std::vector<std::vector<std::string>> rows;
    for (std::size_t i = 0; i < offsets.size(); i += 2) {
        const glm::vec3 o = offsets[i];
        rows.push_back({std::to_string(i) + ", " + std::to_string(i + 1), text("%+.2f", o.x) + text(" %+.2f", o.y) + text(" %+.2f", o.z),
                        text("%.3f", glm::length(o)), text("%.3f", glm::length(offsets[i + 1]))});
    }
    book.table({"pair", "the first", "its length", "length of the opposite"}, rows);
    const RandomMap map = random_map(book.seed());
    Image3 picture({kRandomMapSide, kRandomMapSide}, glm::vec3(0));
    for (int i = 0; i < kRandomMapSide * kRandomMapSide; ++i) {
        const auto t = static_cast<std::size_t>(i);
        picture.set(i % kRandomMapSide, i / kRandomMapSide, 0.5f * glm::vec3(map.x[t], map.y[t], map.z[t]) + 0.5f);
    }
    book.show("random_map", colour_picture(picture), "The random map, RGB = r / 2 + 1/2: 256 x 256 vectors, hardly one unit.");
    mirror_and_flip(book, offsets, map);
    book.try_it({
        "Give `mirror_and_flip` `1.2f * r` instead of `1.4f * r`: longer or shorter by half is enough to spoil the set.",
        "In `mirroring`, leave the 7 odd vectors out: the same density, so 7 samples look in as many directions as 14.",
        "Run with `--seed 2`: other lengths and another map, but the same statistics.",
    });
    book.errata({
        "*Seed 000, shader:* the random vector is used as fetched, so `reflect` is no reflection (table). The lab "
        "normalises it; `as_published` does not.",
        "*Seed 000:* reflected vectors are 'certainly uniform'. Each set is even, the sum of all is not (density).",
        "*Seed 000:* alternating sides keeps fewer than 14 samples spread out. Flipping undoes that: two samples share "
        "one direction, so `samples` = 2 looks one way.",
        "*Seed 002, prose:* 14 vectors in the hemisphere. They fill the sphere; the shader flips them.",
        "*Seed 000:* `random_device` seeds both tables, so no two runs of the tutorial give the same picture.",
    });
}

const Chapter kChapter("05", "sample_vectors", "Sample vectors", sample_vectors);

}  // namespace
}  // namespace crevice
