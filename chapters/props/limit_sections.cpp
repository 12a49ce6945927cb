#include "chapters/props/limit_sections.h"

#include <algorithm>
#include <cmath>

#include "chapters/props/limit_scenes.h"
#include "chapters/study/supersampled.h"
#include "chapters/terminal/number_text.h"
#include "ssao/light/ao_lookup.h"
#include "ssao/methods/xjun_ssao.h"

namespace crevice {

namespace {

constexpr Size kSize = {320, 180};

// The largest |a - b| over the rows from `first` to the one before `end`, without `rim` columns at each side.
float most_apart(const Image<float>& a, const Image<float>& b, int first, int end, int rim = 0) {
    float most = 0;
    for (int y = first; y < end; ++y) {
        for (int x = rim; x < a.size.width - rim; ++x)
            most = std::max(most, std::fabs(a.at(x, y) - b.at(x, y)));
    }
    return most;
}

}  // namespace

void half_resolution(Notebook& book) {
    Scene scene = bare_floor();
    const GBuffer gbuffer = normal_depth(scene, scene.camera, kSize);
    const AoInputs inputs = ao_inputs(gbuffer, scene.camera, xjun_fetch(kXjunSettings));
    AoInputs misplaced = inputs;  // the upper left pixel's depth at the middle of four
    for (int y = 0; y < inputs.size().height; ++y)
        for (int x = 0; x < inputs.size().width; ++x)
            misplaced.view_depth.at(x, y) = gbuffer.view_depth.at(2 * x, 2 * y);
    const Image<float> ao = luna_occlusion(inputs, kXjunSettings, {}).ao,
                       moved = luna_occlusion(misplaced, kXjunSettings, {}).ao;
    book.show_row(
        "A bare floor at half size: depth at the texel's middle; depth half a texel off (black is 0.85).",
        {{"floor", grey_picture(ao, 0.85f, 1)}, {"floor_misplaced", grey_picture(moved, 0.85f, 1)}});
    book.check("half a texel is enough for a floor to occlude itself",
               buffer_statistics(ao).min > 0.99f && buffer_statistics(moved).min < 0.9f,
               "least " + decimal_text(double(buffer_statistics(ao).min), 3) + " and " +
                   decimal_text(double(buffer_statistics(moved).min), 3));
}

void multisampling(Notebook& book, const Scene& columns) {
    Camera camera = columns.camera;
    camera.eye = {3, 0.4, -3}, camera.target = {6, -0.6, 0}, camera.near_plane = 0.1;
    const Supersampled s = supersample(columns, camera, kSize);
    book.text(R"(
        X_Jun turns MSAA off, as its normals and depths have one sample a pixel. Left on, an edge is lit by
        four samples of two surfaces, and all four get the AO of whichever surface that one sample shows.
    )");
    book.show_row("One sample a pixel; four, each lit and occluded by itself, their mean in linear light.",
                  {{"plain", lit_picture(s.plain)}, {"supersampled", lit_picture(s.four)}});
    book.show_row(
        "Four lit samples with the AO of one; minus the right ones; where a pixel's samples differ.",
        {{"multisampled", lit_picture(s.four_with_one)},
         {"mismatch", difference_picture(s.off, 0.1f)},
         {"edges", mask_picture(s.edge)}});
    book.table({"pixels", "share", "mean difference"},
               {{"edges", decimal_text(s.edge_share, 3), decimal_text(s.off_at_edges, 3)},
                {"elsewhere", decimal_text(1 - s.edge_share, 3), decimal_text(s.off_elsewhere, 3)}});
    book.check("AO of one sample is at least five times as wrong at edges as elsewhere",
               s.off_at_edges > 5 * s.off_elsewhere);
}

// X_Jun looks the map up at v = (y + w) * -0.5 / w instead of (y - w) * -0.5 / w: too small by 1.
void shifted_rows(Notebook& book, const Scene& columns) {
    constexpr Size kExact = {448, 256};  // (y + 1/2) / 256 and that minus 1 are floats
    Camera camera = columns.camera;      // its top row shows what is under the eaves
    camera.eye = {0, -0.5, -6}, camera.target = {0, -3.9, -2};
    const Image<float> ao = xjun_ssao(normal_depth(columns, camera, kSize), camera).ao;
    const auto read = [&](AddressMode mode, float shift, Size size = kSize) {
        return map_at_pixels(ao, size, mode, shift);
    };
    const Image<float> wrap = read(AddressMode::wrap, 0), wrap_off = read(AddressMode::wrap, -1),
                       clamp = read(AddressMode::clamp, 0), clamp_off = read(AddressMode::clamp, -1);
    book.show_row("An AO map read at v, and at v - 1 as X_Jun does, with WRAP; at v - 1 with CLAMP.",
                  {{"wrap", ao_picture(wrap)},
                   {"wrap_off_by_one", ao_picture(wrap_off)},
                   {"clamp_off_by_one", ao_picture(clamp_off)}});
    const Image<float> exact = read(AddressMode::wrap, 0, kExact),
                       exact_off = read(AddressMode::wrap, -1, kExact);
    const float apart = most_apart(wrap, wrap_off, 0, kSize.height);
    book.check("with WRAP the slip is hidden: the same bits where v - 1 is exact, else all but the last",
               most_apart(exact, exact_off, 0, kExact.height) == 0 && apart < 2e-5f, exact_text(apart));
    Image<float> top = clamp_off;
    for (int y = 0; y < kSize.height; ++y) std::copy_n(clamp.row(0), kSize.width, top.row(y));
    book.check("with CLAMP each row is the top one", most_apart(clamp_off, top, 0, kSize.height) == 0);
    const float mixed = most_apart(wrap, clamp, 0, 1, 1);
    book.check(
        "and WRAP is no cure: it mixes the lowest row into the top one, the left column into the right",
        mixed > 0.01f && most_apart(wrap, clamp, 1, kSize.height - 1, 1) == 0,
        "by " + decimal_text(double(mixed), 3));
}

}  // namespace crevice
