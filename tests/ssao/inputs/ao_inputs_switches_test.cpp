// The artifact switches of the fetches: the depth map's border, what is stored, and which point is a texel's.
#include <cmath>

#include <doctest/doctest.h>

#include "rasterizer/base/image_summary.h"
#include "tests/tools/ao_cases.h"
#include "tests/tools/image_checks.h"
#include "tests/tools/special_floats.h"
#include "tests/tools/still_life.h"

using namespace crevice;

namespace {

// Where a border of the picture is repeated: the pixel seen at position i of an axis.
int repeated(int i, int count, MapBorder border) {
    while (border == MapBorder::wrap && i < 0) i += count;
    while (border == MapBorder::wrap && i >= count) i -= count;
    return i < 0 ? 0 : (i < count ? i : count - 1);
}

// A wall that recedes to the right, `slope` a unit, seen orthographically, a quarter unit a pixel.
GBuffer receding_wall(Size size, float slope) {
    GBuffer g = made_up_gbuffer(size, 1);
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
            g.view_depth.at(x, y) = 4 + 0.25f * slope * static_cast<float>(x);
            g.normal.set(x, y, glm::vec3(slope, 0, -1) / std::sqrt(1 + slope * slope));
        }
    }
    return g;
}

}  // namespace

TEST_CASE("border: far away, the outermost pixel, or the opposite one, for every size") {
    for (const Size size : {Size{1, 1}, {2, 1}, {1, 3}, {7, 5}, {16, 9}, {21, 33}}) {
        for (const DepthSource depth : {DepthSource::view_depth, DepthSource::ndc_depth}) {
            CAPTURE(size.width);
            CAPTURE(size.height);
            CAPTURE(static_cast<int>(depth));
            const GBuffer g = made_up_gbuffer(size, 0.2f);
            const auto map_with = [&](MapBorder border) {
                return ao_inputs(g, made_up_camera(), {.depth = depth, .border = border}).depth_map;
            };
            const Image<float> far = map_with(MapBorder::far);
            const float background = far.at(0, 0);
            for (const MapBorder border : {MapBorder::far, MapBorder::edge, MapBorder::wrap}) {
                CAPTURE(static_cast<int>(border));
                const Image<float> map = map_with(border);
                CHECK(pixels_against(map.size, [&](int column, int row) {
                          const int x = column - 1, y = row - 1;
                          const bool inside = x >= 0 && y >= 0 && x < size.width && y < size.height;
                          if (!inside && border == MapBorder::far) return map.at(column, row) == background;
                          return map.at(column, row) == far.at(repeated(x, size.width, border) + 1,
                                                               repeated(y, size.height, border) + 1);
                      }) == "");
            }
        }
    }
}

TEST_CASE("border: what a sample beyond the picture is compared with") {
    const Size size = {12, 8};
    const GBuffer g = made_up_gbuffer(size, 0);
    for (const MapBorder border : {MapBorder::edge, MapBorder::wrap}) {
        CAPTURE(static_cast<int>(border));
        const AoInputs inputs = ao_inputs(g, made_up_camera(), {.border = border});
        const LunaKernel kernel(inputs, {});
        const auto pixel = [&](int x, int y) {
            return static_cast<double>(
                g.view_depth.at(repeated(x, size.width, border), repeated(y, size.height, border)));
        };
        for (int y = -20; y < 30; ++y) {
            for (int x = -30; x < 40; ++x) {
                CAPTURE(x);
                CAPTURE(y);
                const float at_x = static_cast<float>(x), at_y = static_cast<float>(y);
                CHECK(static_cast<double>(kernel.depth_at(Screen2<float>{at_x + 0.5f, at_y + 0.5f})) ==
                      pixel(x, y));
                // Between four pixels: all values are multiples of 1/64.
                const double mean =
                    (pixel(x - 1, y - 1) + pixel(x, y - 1) + pixel(x - 1, y) + pixel(x, y)) / 4;
                CHECK(static_cast<double>(kernel.depth_at(Screen2<float>{at_x, at_y})) == mean);
            }
        }
        for (const float far : {-1e30f, -1e7f, 1e7f, 1e30f, kInfinity, -kInfinity, kNan}) {
            CAPTURE(far);
            const float depth = kernel.depth_at(Screen2<float>{far, 1.5f});
            CHECK(depth >= 2);
            CHECK(depth <= 10);
        }
    }
}

TEST_CASE("depth source: the depth map is the source's, the normals stay the method's") {
    const Scene scene = still_life();
    const GBuffer g = normal_depth(scene, scene.camera, {40, 30});
    const auto inputs_of = [&](const TutorialMethod& method, DepthSource depth) {
        LunaSettings settings = method.settings;
        settings.depth_source = depth;
        return ao_inputs(g, scene.camera, method.fetch(settings));
    };
    const TutorialMethod &xjun = kTutorialMethods[0], &luna = kTutorialMethods[1];
    for (const DepthSource depth : {DepthSource::view_depth, DepthSource::ndc_depth}) {
        CAPTURE(static_cast<int>(depth));
        CHECK(content_hash(inputs_of(xjun, depth).depth_map) ==
              content_hash(inputs_of(luna, depth).depth_map));
        CHECK(content_hash(inputs_of(xjun, depth).view_depth) ==
              content_hash(inputs_of(luna, depth).view_depth));
    }
    for (const TutorialMethod* method : {&xjun, &luna}) {
        const AoInputs view = inputs_of(*method, DepthSource::view_depth),
                       ndc = inputs_of(*method, DepthSource::ndc_depth);
        CHECK(content_hash(view.normal) == content_hash(ndc.normal));
        CHECK(content_hash(view.depth_map) != content_hash(ndc.depth_map));
        CHECK(further_apart_than(0.25, view.view_depth, ndc.view_depth) == "");
    }
}

TEST_CASE("texel centre off: the lower right of four pixels as it is; nothing changes at full size") {
    const GBuffer g = made_up_gbuffer({26, 14}, 0.3f);
    for (const bool point_normals : {false, true}) {
        CAPTURE(point_normals);
        AoFetch fetch{.point_normals = point_normals, .texel_centre = TexelCentre::off};
        const AoInputs half = ao_inputs(g, made_up_camera(), fetch);
        CHECK(pixels_against(half.size(), [&](int x, int y) {
                  const int px = 2 * x + 1, py = 2 * y + 1;
                  if (half.view_depth.at(x, y) != g.view_depth.at(px, py)) return false;
                  const glm::vec3 n = half.normal.at(x, y), expected = g.normal.at(px, py);
                  return point_normals ? glm::dot(n, expected) >= 0.99999f * glm::length(expected) ||
                                             expected == glm::vec3(0)
                                       : n == expected;
              }) == "");
        const Scene scene = still_life();
        const GBuffer drawn = normal_depth(scene, scene.camera, {64, 48});
        fetch.scale = 1;
        const AoInputs full = ao_inputs(drawn, scene.camera, fetch);
        fetch.texel_centre = TexelCentre::exact;
        const AoInputs exact = ao_inputs(drawn, scene.camera, fetch);
        CHECK(content_hash(full.view_depth) == content_hash(exact.view_depth));
        CHECK(further_apart_than(0, full.normal.x, exact.normal.x) == "");
        CHECK(further_apart_than(0, full.normal.y, exact.normal.y) == "");
        CHECK(further_apart_than(0, full.normal.z, exact.normal.z) == "");
    }
}

TEST_CASE("texel centre off: half a pixel's slope too deep, and a bare wall occludes itself") {
    const Size size = {64, 32};
    Camera camera = made_up_camera();
    camera.projection = Projection::orthographic;
    camera.ortho_height = 8;
    for (const float slope : {-0.5f, 0.5f}) {
        CAPTURE(slope);
        const GBuffer g = receding_wall(size, slope);
        const AoInputs exact = ao_inputs(g, camera, {}),
                       off = ao_inputs(g, camera, {.texel_centre = TexelCentre::off});
        CHECK(pixels_against(exact.size(), [&](int x, int y) {
                  return off.view_depth.at(x, y) - exact.view_depth.at(x, y) == 0.125f * slope;
              }) == "");
        LunaSettings settings{.exponent = 1};
        const float of_exact = luna_occlusion(exact, settings, {}).ao.at(16, 8),
                    of_off = luna_occlusion(off, settings, {}).ao.at(16, 8);
        CHECK(of_exact > 0.9999f);
        // Taken too deep, p lies behind its wall, which then stands in front of it; too near it does not.
        CHECK((of_off < 0.99f) == (slope > 0));
    }
}
