// The sky pass: exactly where nothing was drawn, in the direction of each pixel's line of sight.
#include "ssao/light/sky.h"

#include <cmath>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "rasterizer/base/error.h"
#include "rasterizer/base/image_summary.h"
#include "rasterizer/draw/normal_depth.h"
#include "tests/tools/every_run.h"
#include "tests/tools/image_checks.h"
#include "tests/tools/special_floats.h"
#include "tests/tools/still_life.h"

using namespace crevice;

namespace {

const glm::vec3 kLitColour(7, 8, 9);  // none of the sky's

CubeMap directions() {
    return build_cube_map(64, [](glm::vec3 d) { return 0.5f * d + 0.5f; });
}

// The world direction through a pixel's centre, from the camera's own numbers.
glm::dvec3 line_of_sight(const Camera& camera, Size size, int x, int y) {
    const glm::dvec3 forward = glm::normalize(camera.target - camera.eye),
                     right = glm::normalize(glm::cross(camera.up, forward)), up = glm::cross(forward, right);
    if (camera.projection == Projection::orthographic) return forward;
    const double half = std::tan(0.5 * camera.fov_y_rad);
    return glm::normalize(forward + half * (2 * x + 1 - size.width) / size.height * right -
                          half * (2 * y + 1 - size.height) / size.height * up);
}

Camera turned_camera(bool reversed_z) {
    Camera camera = still_life().camera;
    camera.eye = {1, 1.5, -1};
    camera.target = {0.3, 0, 4};
    camera.reversed_z = reversed_z;
    return camera;
}

}  // namespace

TEST_CASE("sky: exactly where no surface is, and there the cube map's colour") {
    const Scene scene = still_life();
    const CubeMap sky = directions();
    const Size size = {83, 61};
    for (const DepthFormat format : {DepthFormat::d16, DepthFormat::d24, DepthFormat::d32f}) {
        for (const bool reversed_z : {false, true}) {
            for (const Projection projection : {Projection::perspective, Projection::orthographic}) {
                Camera camera = turned_camera(reversed_z);
                camera.projection = projection;
                const GBuffer g = normal_depth(scene, camera, size, {.depth_format = format});
                const Image3 picture = with_sky(Image3(size, kLitColour), g.depth, camera, sky);
                int open = 0, covered = 0;
                for (int y = 0; y < size.height; ++y) {
                    for (int x = 0; x < size.width; ++x) {
                        CAPTURE(static_cast<int>(format));
                        CAPTURE(reversed_z);
                        CAPTURE(x);
                        CAPTURE(y);
                        if (g.view_depth.at(x, y) < kInfinity) {
                            ++covered;
                            REQUIRE(picture.at(x, y) == kLitColour);
                            continue;
                        }
                        ++open;
                        const glm::dvec3 expected = 0.5 * line_of_sight(camera, size, x, y) + 0.5;
                        REQUIRE(glm::length(glm::dvec3(picture.at(x, y)) - expected) < 2e-3);
                    }
                }
                CHECK(open > 300);
                CHECK(covered > 300);
            }
        }
    }
}

TEST_CASE(
    "sky: LESS_EQUAL at depth 1: what lies exactly on the far plane is overdrawn, one step nearer is not") {
    const CubeMap sky = directions();
    const Size size = {9, 2};
    for (const DepthFormat format : {DepthFormat::d16, DepthFormat::d24, DepthFormat::d32f}) {
        for (const bool reversed_z : {false, true}) {
            DepthBuffer depth = cleared_depth(size, format, !reversed_z);  // nearest everywhere
            const std::int32_t far_code = depth_code(format, reversed_z ? 0.0f : 1.0f, 0.0);
            depth.codes.at(4, 1) = far_code;
            depth.codes.at(5, 1) = far_code + (reversed_z ? 1 : -1);
            const Image3 picture = with_sky(Image3(size, kLitColour), depth, turned_camera(reversed_z), sky);
            for (int y = 0; y < size.height; ++y) {
                for (int x = 0; x < size.width; ++x) {
                    CAPTURE(reversed_z);
                    CAPTURE(x);
                    CAPTURE(y);
                    CHECK((picture.at(x, y) == kLitColour) == !(x == 4 && y == 1));
                }
            }
        }
    }
}

TEST_CASE("sky: an orthographic camera sees one colour") {
    Camera camera = turned_camera(false);
    camera.projection = Projection::orthographic;
    const Size size = {17, 9};
    const Image3 picture = with_sky(Image3(size, kLitColour), cleared_depth(size, DepthFormat::d32f, false),
                                    camera, directions());
    CHECK(picture.at(0, 0) != kLitColour);
    CHECK(pixels_against(size, [&](int x, int y) { return picture.at(x, y) == picture.at(0, 0); }) == "");
}

TEST_CASE("sky: where the eye stands does not matter, only where it looks") {
    const CubeMap sky = directions();
    const Size size = {33, 21};
    const DepthBuffer depth = cleared_depth(size, DepthFormat::d24, false);
    Camera camera = turned_camera(false);
    const std::string here = content_hash(with_sky(Image3(size, kLitColour), depth, camera, sky));
    camera.eye += glm::dvec3(1048576, -4096, 512);
    camera.target += glm::dvec3(1048576, -4096, 512);
    CHECK(content_hash(with_sky(Image3(size, kLitColour), depth, camera, sky)) == here);
    camera.target.x += 1;
    CHECK(content_hash(with_sky(Image3(size, kLitColour), depth, camera, sky)) != here);
}

TEST_CASE("sky: the same bits for all lanes, threads and instruction sets, odd sizes too") {
    const Scene scene = still_life();
    const CubeMap sky = directions();
    const Camera camera = turned_camera(false);
    for (const Size size : {Size{1, 1}, {37, 23}, {161, 91}}) {
        const GBuffer g = normal_depth(scene, camera, size);
        const auto hash = [&](const Run& run) {
            return content_hash(with_sky(Image3(size, kLitColour), g.depth, camera, sky, run));
        };
        const std::string plain = hash(kOneLane);
        CAPTURE(size.width);
        for_every_run({}, [&](const Run& run) { CHECK(hash(run) == plain); });
        CHECK(hash({.kept = KeptWork::all()}) == plain);
    }
}

TEST_CASE("sky: picture and depths of unlike sizes are refused") {
    CHECK_THROWS_AS(with_sky(Image3({4, 4}, kLitColour), cleared_depth({5, 4}, DepthFormat::d24, false),
                             turned_camera(false), directions()),
                    UsageError);
}
