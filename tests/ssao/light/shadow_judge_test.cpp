// The light's path against double: what the map holds, and where a view looks it up. Nothing of the rasterizer's transforms is
// used on the other side but which triangle a texel shows.
#include <cmath>
#include <string>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include "rasterizer/draw/cutouts.h"
#include "ssao/judge/double_judge.h"
#include "ssao/light/shadow_factor.h"
#include "tests/tools/image_checks.h"
#include "tests/tools/random_sequence.h"
#include "tests/tools/small_scenes.h"
#include "tests/tools/still_life.h"

using namespace crevice;

namespace {

const glm::vec3 kSlanting(0.4f, -0.8f, 0.35f);
constexpr int kSide = 128;

// The still life on a grid that floats keep that far away, moved there.
Scene moved_still_life(double away) {
    Scene scene = still_life();
    for (Mesh& mesh : scene.meshes) {
        for (glm::vec3& p : mesh.positions)
            p = glm::round(16.0f * p) / 16.0f + glm::vec3(static_cast<float>(away));
    }
    scene.camera.eye += glm::dvec3(away) + 0.3;  // no float where `away` is large
    scene.camera.target += glm::dvec3(away);
    return scene;
}

// Where a camera's axes point, from its members alone.
struct Axes {
    glm::dvec3 right, up, forward;

    explicit Axes(const Camera& camera) : forward(glm::normalize(camera.target - camera.eye)) {
        right = glm::normalize(glm::cross(camera.up, forward));
        up = glm::cross(forward, right);
    }
};

}  // namespace

TEST_CASE(
    "shadow map: depths are those of the light's rays in double, in every format, far from the origin too") {
    for (const double away : {0.0, 1e5, 1e6}) {
        const Scene scene = moved_still_life(away);
        for (const DepthFormat format : {DepthFormat::d16, DepthFormat::d24, DepthFormat::d32f}) {
            const ShadowSettings settings{.size_px = kSide, .format = format, .bias = {}};
            const ShadowMap map =
                shadow_map(scene, kSlanting, bounds_shadow_fit(world_bounds(scene)), settings);
            const ScreenGeometry geometry = shadow_geometry(scene, map.light, settings);
            GBuffer seen;
            seen.triangle =
                visibility(geometry, format, false, alpha_holes(scene, geometry, {}), {}).triangle;
            const DoubleJudge judge(scene, map.light, geometry);
            const Image<float> depth = ndc_depth(map.depth);
            const double range = map.light.far_plane - map.light.near_plane;
            CAPTURE(away);
            CAPTURE(static_cast<int>(format));
            int shown = 0;
            CHECK(pixels_against(depth.size, [&](int x, int y) {
                      const JudgedPixel right = judge.at(seen, x, y);
                      const double stored = static_cast<double>(depth.at(x, y));
                      if (!right.surface) return stored == 1;
                      ++shown;
                      const double right_ndc = (right.view_depth - map.light.near_plane) / range;
                      const double step = format == DepthFormat::d16 ? 1 / kD16Steps : 1 / kD24Steps;
                      // Half a step, and roundings of the corners and their plane, more where it is steep.
                      return std::fabs(stored - right_ndc) < 0.5 * step + 4 * 0x1p-24 / right.slant;
                  }) == "");
            CHECK(shown > kSide * kSide / 8);
        }
    }
}

TEST_CASE("shadow lookup: a view's points fall where double finds them, far from the origin too") {
    RandomSequence random(11);
    for (const double away : {0.0, 1e5, 1e7}) {
        const Scene scene = moved_still_life(away);
        const ShadowSettings settings{.size_px = kSide};
        const ShadowMap map{cleared_depth({kSide, kSide}, settings.format, false),
                            light_camera(bounds_shadow_fit(world_bounds(scene)), kSlanting), settings};
        const ShadowLookup lookup = shadow_lookup(map, scene.camera);
        const Axes eye(scene.camera), light(map.light);
        const double range = map.light.far_plane - map.light.near_plane;
        CAPTURE(away);
        for (int i = 0; i < 1000; ++i) {
            const glm::vec3 p{random.between(-4, 4), random.between(-2, 2), random.between(0.5, 9)};
            const auto found = [&](const glm::vec4& row) {
                return row.x * p.x + row.y * p.y + row.z * p.z + row.w;
            };
            const glm::dvec3 wide(p);
            const glm::dvec3 from_light = (scene.camera.eye - map.light.eye) + wide.x * eye.right +
                                          wide.y * eye.up + wide.z * eye.forward;
            const auto texel = [&](double along) { return (along / map.light.ortho_height + 0.5) * kSide; };
            CAPTURE(i);
            // Roundings of four products and their sum, of at most a map's side, or of 1.
            CHECK(std::fabs(found(lookup.column) - texel(glm::dot(from_light, light.right))) <
                  6 * kSide * 0x1p-24);
            CHECK(std::fabs(found(lookup.row) - texel(-glm::dot(from_light, light.up))) <
                  6 * kSide * 0x1p-24);
            CHECK(std::fabs(found(lookup.depth) -
                            (glm::dot(from_light, light.forward) - map.light.near_plane) / range) <
                  6 * 0x1p-24);
        }
    }
}
