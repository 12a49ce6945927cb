#include "rasterizer/scene/camera.h"

#include <functional>
#include <limits>
#include <string>
#include <vector>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include "rasterizer/base/error.h"
#include "rasterizer/lanes/approx_math.h"
#include "rasterizer/spaces.h"

using namespace crevice;

namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

// The message of the refusal; "" when the camera is accepted.
std::string refusal_of(const std::function<void(Camera&)>& spoil, Size size = {64, 48}) {
    Camera camera;
    spoil(camera);
    try {
        camera_matrices(camera, size);
    } catch (const UsageError& error) {
        return error.what();
    }
    return "";
}

glm::dvec3 ndc_of(const CameraMatrices& m, glm::dvec3 p_view) {
    const glm::dvec4 clip = glm::dmat4(m.clip_from_view) * glm::dvec4(p_view, 1);
    return glm::dvec3(clip) / clip.w;
}

void check_near(const glm::dvec3& actual, const glm::dvec3& expected, double tolerance) {
    INFO("is " << actual.x << " " << actual.y << " " << actual.z);
    INFO("expected " << expected.x << " " << expected.y << " " << expected.z);
    CHECK(glm::distance(actual, expected) <= tolerance);
}

}  // namespace

TEST_CASE("the spaces: left-handed, +z forward, y up in ndc and down on the screen") {
    Camera camera;  // at (0, 0, -10), looking along +z
    const CameraMatrices m = camera_matrices(camera, {64, 64});
    const auto p_view = [&](glm::dvec3 p_world) {
        return glm::dvec3(glm::dmat4(m.view_from_world) * glm::dvec4(p_world, 1));
    };
    check_near(p_view({0, 0, 0}), {0, 0, 10}, 1e-6);
    check_near(p_view({1, 0, -10}), {1, 0, 0}, 1e-6);
    check_near(p_view({0, 1, -10}), {0, 1, 0}, 1e-6);
    // World x goes right on the screen, world y up; row 0 is the top.
    const glm::dvec3 right = ndc_of(m, {1, 0, 10}), above = ndc_of(m, {0, 1, 10});
    CHECK(right.x > 0);
    CHECK(above.y > 0);
    CHECK(screen_x_from_ndc(right.x, 64.0) > 32);
    CHECK(screen_y_from_ndc(above.y, 64.0) < 32);
    CHECK(screen_x_from_ndc(-1.0, 64.0) == 0);
    CHECK(screen_y_from_ndc(1.0, 64.0) == 0);
    CHECK(screen_y_from_ndc(-1.0, 64.0) == 64);
    // Looking along +x with y up, +z is on the left: left-handed.
    camera.eye = {0, 0, 0};
    camera.target = {5, 0, 0};
    const CameraMatrices turned = camera_matrices(camera, {64, 64});
    check_near(glm::dvec3(glm::dmat4(turned.view_from_world) * glm::dvec4(0, 0, 1, 1)), {-1, 0, 0}, 1e-6);
}

TEST_CASE(
    "near is depth 0 and far 1, the other way round with reversed z, and the field of view fills the "
    "picture") {
    for (const Projection projection : {Projection::perspective, Projection::orthographic}) {
        for (const bool reversed_z : {false, true}) {
            CAPTURE(static_cast<int>(projection));
            CAPTURE(reversed_z);
            Camera camera;
            camera.projection = projection;
            camera.reversed_z = reversed_z;
            camera.near_plane = 0.5;
            camera.far_plane = 200;
            camera.fov_y_rad = radians(50);
            camera.ortho_height = 6;
            const CameraMatrices m = camera_matrices(camera, {96, 64});
            const double at_near = reversed_z ? 1 : 0;
            check_near(ndc_of(m, {0, 0, 0.5}), {0, 0, at_near}, 2e-7);
            check_near(ndc_of(m, {0, 0, 200}), {0, 0, 1 - at_near}, 2e-7);
            for (const double z : {0.5, 3.0, 200.0}) {
                CAPTURE(z);
                const double top = projection == Projection::perspective ? z * tangent(radians(25)) : 3;
                const glm::dvec3 corner = ndc_of(m, {1.5 * top, -top, z});
                CHECK(std::abs(corner.x - 1) < 1e-6);
                CHECK(std::abs(corner.y + 1) < 1e-6);
            }
        }
    }
}

TEST_CASE("rays and depths lead back to the view-space position") {
    for (const Projection projection : {Projection::perspective, Projection::orthographic}) {
        for (const bool reversed_z : {false, true}) {
            CAPTURE(static_cast<int>(projection));
            CAPTURE(reversed_z);
            Camera camera;
            camera.projection = projection;
            camera.reversed_z = reversed_z;
            camera.far_plane = 50;
            const Size size = {80, 60};
            const CameraMatrices m = camera_matrices(camera, size);
            const ViewRays rays{m.ray_scale, size, projection == Projection::perspective};
            for (const glm::dvec3 p : {glm::dvec3(0, 0, 1), {0.3, -0.2, 2}, {-3, 4, 20}, {1, 1, 50}}) {
                const glm::dvec3 ndc = ndc_of(m, p);
                const double u = screen_x_from_ndc(ndc.x, 1.0), v = screen_y_from_ndc(ndc.y, 1.0);
                const Vec3<double> back = rays.p_view(u, v, p.z);
                check_near({back.x, back.y, back.z}, p, 1e-5);
                const Screen2<double> screen = rays.p_screen(Vec3<double>{p.x, p.y, p.z}, 1 / p.z);
                CHECK(std::abs(screen.x - 80 * u) < 1e-4);
                CHECK(std::abs(screen.y - 60 * v) < 1e-4);
                const double depth =
                    static_cast<double>(m.depth_a) +
                    static_cast<double>(m.depth_b) * (projection == Projection::perspective ? 1 / p.z : p.z);
                CHECK(std::abs(depth - ndc.z) < 1e-6);
            }
        }
    }
}

TEST_CASE("relative space is world space as seen from the eye, and its rotation has no scale") {
    Camera camera;
    camera.eye = {3, 4, -5};
    camera.target = {-1, 2, 7};
    const CameraMatrices m = camera_matrices(camera, {64, 64});
    const glm::dmat4 turn = m.relative_from_view * m.view_from_relative;
    for (int column = 0; column < 4; ++column) {
        for (int row = 0; row < 4; ++row) {
            CAPTURE(column);
            CAPTURE(row);
            CHECK(std::abs(turn[column][row] - (row == column ? 1 : 0)) < 3e-7);
        }
    }
    CHECK(std::abs(glm::determinant(glm::dmat3(glm::dmat4(m.view_from_relative))) - 1) < 3e-7);
    const glm::dvec3 p_world(1, -2, 3);
    const glm::dvec3 p_view(glm::dmat4(m.view_from_world) * glm::dvec4(p_world, 1));
    check_near(glm::dvec3(glm::dmat4(m.view_from_relative) * glm::dvec4(p_world - camera.eye, 1)), p_view,
               1e-5);
    const glm::dvec4 clip = glm::dmat4(m.clip_from_relative) * glm::dvec4(p_world - camera.eye, 1);
    check_near(glm::dvec3(clip) / clip.w, ndc_of(m, p_view), 1e-5);
}

TEST_CASE("every bad camera is refused by name") {
    const struct {
        std::function<void(Camera&)> spoil;
        const char* named;
    } cases[] = {
        {[](Camera& c) { c.near_plane = c.far_plane; }, "far_plane: "},
        {[](Camera& c) { c.far_plane = 0.5; }, "far_plane: "},
        {[](Camera& c) { c.far_plane = kNan; }, "far_plane: "},
        {[](Camera& c) { c.far_plane = kInfinity; }, "far_plane: "},
        {[](Camera& c) { c.near_plane = 0; }, "near_plane: "},
        {[](Camera& c) { c.near_plane = -1; }, "near_plane: "},
        {[](Camera& c) { c.near_plane = kNan; }, "near_plane: "},
        {[](Camera& c) { c.fov_y_rad = 0; }, "fov_y_rad: "},
        {[](Camera& c) { c.fov_y_rad = kPi; }, "fov_y_rad: "},
        {[](Camera& c) { c.fov_y_rad = 1e-6; },
         "fov_y_rad: the vertical field of view must lie between 0.006 and"},
        {[](Camera& c) { c.fov_y_rad = -1; }, "fov_y_rad: "},
        {[](Camera& c) { c.fov_y_rad = kNan; }, "fov_y_rad: "},
        {[](Camera& c) { c.target = c.eye; }, "target: "},
        {[](Camera& c) { c.up = glm::dvec3(0, 0, 2); }, "target: "},
        {[](Camera& c) { c.up = glm::dvec3(0, 0, -1e-3); }, "target: "},
        {[](Camera& c) { c.up = glm::dvec3(0, 0, 0); }, "target: "},
        {[](Camera& c) { c.eye.x = kNan; }, "eye: "},
        {[](Camera& c) { c.target.y = kInfinity; }, "target: "},
        {[](Camera& c) { c.up.z = kNan; }, "up: "},
    };
    for (const auto& c : cases) {
        const auto index = &c - cases;
        CAPTURE(index);
        const std::string message = refusal_of(c.spoil);
        CAPTURE(message);
        CHECK(message.find(c.named) != std::string::npos);
        CHECK(message.find("; ") != std::string::npos);
    }
    for (const double height : {0.0, -2.0, kNan, kInfinity}) {
        CAPTURE(height);
        const auto spoil = [&](Camera& c) {
            c.projection = Projection::orthographic;
            c.ortho_height = height;
        };
        CHECK(refusal_of(spoil).find("ortho_height: ") != std::string::npos);
    }
    CHECK(refusal_of([](Camera&) {}) == "");
    // What one projection does not use may be anything.
    CHECK(refusal_of([](Camera& c) { c.ortho_height = kNan; }) == "");
    CHECK(refusal_of([](Camera& c) {
              c.projection = Projection::orthographic;
              c.fov_y_rad = 0;
          }) == "");
    for (const Size size : {Size{0, 48}, {64, 0}, {-1, 48}, {0, 0}}) {
        const std::string message = refusal_of([](Camera&) {}, size);
        CAPTURE(message);
        CHECK(message.starts_with("size: "));
    }
}
