// Depths against double: primary rays on the triangles of the scene itself.
#include "ssao/judge/double_judge.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <doctest/doctest.h>

#include "rasterizer/draw/normal_depth.h"
#include "scenes/builtin_scenes.h"
#include "ssao/judge/percentile.h"
#include "tests/tools/image_checks.h"
#include "tests/tools/random_sequence.h"
#include "tests/tools/small_scenes.h"

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

TEST_CASE("view depth near the horizon: that of a place within the snapping of corners") {
    // Cut in double, a ground under the eye lies where it is, however far it reaches. The inverse depth of a plane is linear
    // on the screen, and 0 at its horizon. Corners of such a ground lie so close to that line that snapping by 1/512 pixel
    // takes them across; they are kept on their side.
    RandomSequence random(5);
    for (int i = 0; i < 40; ++i) {
        CAPTURE(i);
        const auto half_side = static_cast<float>(std::pow(10.0, random.between(2, 7)));
        const Scene ground = scene_of({quad_mesh({glm::vec3(-half_side, 0, half_side),
                                                  {half_side, 0, half_side},
                                                  {half_side, 0, -half_side},
                                                  {-half_side, 0, -half_side}},
                                                 {0, 1, 0})});
        Camera camera;
        camera.eye = {random.between(-1, 1), random.between(0.5, 3), random.between(-1, 1)};
        camera.target = camera.eye + glm::dvec3(random.between(-3, 3), random.between(-0.5, 0.5), 4);
        camera.up = {random.between(-0.5, 0.5), 1, 0};
        camera.near_plane = 1e-2;
        camera.far_plane = 1e7;
        const ScreenGeometry geometry = screen_geometry(ground, camera, kSize);
        const GBuffer g = normal_depth(ground, geometry, false, {});
        const DoubleJudge judge(ground, camera, geometry);
        const auto inverse = [&](int x, int y) {
            const JudgedPixel right = judge.at(g, x, y);
            return right.surface ? 1 / right.view_depth : std::nan("");
        };
        int shown = 0;
        CHECK(pixels_against({kSize.width - 1, kSize.height - 1}, [&](int x, int y) {
                  const double here = inverse(x, y);
                  const double per_px = std::hypot(inverse(x + 1, y) - here, inverse(x, y + 1) - here);
                  if (std::isnan(per_px)) return true;
                  ++shown;
                  const double off = std::fabs(1 / static_cast<double>(g.view_depth.at(x, y)) - here);
                  constexpr double kSnapped_px = 1.42 / 512;  // in x and in y
                  return off <= kSnapped_px * per_px + 16 * 0x1p-24 * here;
              }) == "");
        CHECK(shown > 1000);
        // The two triangles are cut each by itself; no hole is left between them.
        const auto sky = [&](int x, int y) { return g.triangle.at(x, y) < 0; };
        CHECK(pixels_against({kSize.width - 2, kSize.height - 2}, [&](int x, int y) {
                  return !sky(x + 1, y + 1) || sky(x, y + 1) || sky(x + 2, y + 1) || sky(x + 1, y) ||
                         sky(x + 1, y + 2);
              }) == "");
    }
}
