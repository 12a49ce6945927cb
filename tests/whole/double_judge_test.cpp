// Depths against double: primary rays on the triangles of the scene itself.
#include "ssao/judge/double_judge.h"

#include <algorithm>
#include <vector>

#include <doctest/doctest.h>

#include "rasterizer/draw/normal_depth.h"
#include "scenes/builtin_scenes.h"
#include "ssao/judge/percentile.h"
#include "tests/tools/image_checks.h"

using namespace crevice;

namespace {

constexpr Size kSize = {160, 90};

// In half steps of a float of the triangle's farthest corner, whose rounding its plane has everywhere; at a slant the depth
// changes by more than the position does.
double steps_off(float view_depth, const JudgedPixel& right) {
    return std::fabs(static_cast<double>(view_depth) - right.view_depth) * right.slant * 0x1p24 / right.reach;
}

}  // namespace

TEST_CASE("view depth: within a few float steps of primary rays in double, in every built-in scene") {
    for (const BuiltinScene& builtin : builtin_scenes()) {
        const Scene scene = builtin.make();
        CAPTURE(scene.name);
        const ScreenGeometry geometry = screen_geometry(scene, scene.camera, kSize);
        const GBuffer g = normal_depth(scene, geometry, scene.camera.reversed_z, {});
        const DoubleJudge judge(scene, scene.camera, geometry);
        double sum = 0;
        int count = 0, further = 0;
        CHECK(pixels_against(kSize, [&](int x, int y) {
                  const JudgedPixel right = judge.at(g, x, y);
                  if (!right.surface) return true;
                  const double off = steps_off(g.view_depth.at(x, y), right);
                  sum += off;
                  ++count;
                  further += off < 32 ? 0 : 1;
                  return off < 512;
              }) == "");
        CHECK(sum < 2.0 * std::max(count, 1));
        // Slivers: their snapped corners are kept near the range of their triangle.
        CHECK(further <= count / 1000);
    }
}

TEST_CASE("normals: within what the snapping of corners does to them, in every built-in scene") {
    for (const BuiltinScene& builtin : builtin_scenes()) {
        const Scene scene = builtin.make();
        CAPTURE(scene.name);
        const ScreenGeometry geometry = screen_geometry(scene, scene.camera, kSize);
        const GBuffer g = normal_depth(scene, geometry, scene.camera.reversed_z, {});
        const DoubleJudge judge(scene, scene.camera, geometry);
        std::vector<double> off;
        for (int y = 0; y < kSize.height; ++y) {
            for (int x = 0; x < kSize.width; ++x) {
                const JudgedPixel right = judge.at(g, x, y);
                if (right.surface) off.push_back(glm::length(glm::dvec3(g.normal.at(x, y)) - right.normal));
            }
        }
        if (off.empty()) continue;  // the empty scene
        CHECK(percentile(off, 50) < 1e-4);
        CHECK(percentile(off, 99) < 0.01);
    }
}
