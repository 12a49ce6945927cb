#include "chapters/props/limit_lookups.h"

#include <algorithm>
#include <cmath>

#include "chapters/props/limit_scenes.h"
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

MisplacedFloor misplaced_floor() {
    Scene scene = bare_floor();
    const GBuffer gbuffer = normal_depth(scene, scene.camera, kSize);
    const AoInputs inputs = ao_inputs(gbuffer, scene.camera, xjun_fetch(kXjunSettings));
    AoInputs misplaced = inputs;
    for (int y = 0; y < inputs.size().height; ++y) {
        for (int x = 0; x < inputs.size().width; ++x)
            misplaced.view_depth.at(x, y) = gbuffer.view_depth.at(2 * x, 2 * y);
    }
    return {luna_occlusion(inputs, kXjunSettings, {}).ao, luna_occlusion(misplaced, kXjunSettings, {}).ao};
}

ShiftedRows shifted_rows(const Scene& columns) {
    constexpr Size kExact = {448, 256};  // (y + 1/2) / 256 and that minus 1 are floats
    Camera camera = columns.camera;      // its top row shows what is under the eaves
    camera.eye = {0, -0.5, -6}, camera.target = {0, -3.9, -2};
    const Image<float> ao = xjun_ssao(normal_depth(columns, camera, kSize), camera).ao;
    const auto read = [&](AddressMode mode, float shift, Size size = kSize) {
        return map_at_pixels(ao, size, mode, shift);
    };
    const Image<float> clamp = read(AddressMode::clamp, 0);
    ShiftedRows rows{read(AddressMode::wrap, 0), read(AddressMode::wrap, -1), read(AddressMode::clamp, -1)};
    rows.apart = most_apart(rows.wrap, rows.wrap_off, 0, kSize.height);
    rows.apart_if_exact =
        most_apart(read(AddressMode::wrap, 0, kExact), read(AddressMode::wrap, -1, kExact), 0, kExact.height);
    Image<float> top = clamp;
    for (int y = 0; y < kSize.height; ++y) std::copy_n(clamp.row(0), kSize.width, top.row(y));
    rows.from_top_row = most_apart(rows.clamp_off, top, 0, kSize.height);
    rows.mixed_rim = most_apart(rows.wrap, clamp, 0, 1, 1);
    rows.mixed_inside = most_apart(rows.wrap, clamp, 1, kSize.height - 1, 1);
    return rows;
}

}  // namespace crevice
