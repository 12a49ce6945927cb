#include "rasterizer/scene/framing_camera.h"

#include <cmath>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

using namespace crevice;

TEST_CASE("framing_camera: the sphere around the box is in the picture, between near and far") {
    for (const double scale : {1e-6, 1.0, 1e9}) {
        for (const double shift : {0.0, 1e3}) {
            Bounds bounds;
            bounds.empty = false;
            bounds.low = scale * (glm::dvec3(-1, -2, -3) + shift);
            bounds.high = scale * (glm::dvec3(4, 2, 1) + shift);
            const Camera camera = framing_camera(bounds);
            CAPTURE(scale);
            CAPTURE(shift);
            validate(camera);
            const double radius = 0.5 * glm::length(bounds.high - bounds.low);
            const glm::dvec3 centre = 0.5 * (bounds.high + bounds.low);
            const double distance = glm::length(camera.eye - centre);
            CHECK(glm::length(camera.target - centre) <= 1e-9 * radius + 1e-12 * glm::length(centre));
            CHECK(std::asin(radius / distance) < camera.fov_y_rad / 2);
            CHECK(std::asin(1.2 * radius / distance) > camera.fov_y_rad / 2);
            CHECK(camera.near_plane < distance - radius);
            CHECK(camera.near_plane > distance - 1.2 * radius);
            CHECK(camera.far_plane > distance + radius);
            CHECK(camera.eye.x > centre.x);
            CHECK(camera.eye.y > centre.y);
            CHECK(camera.eye.z < centre.z);
        }
    }
    CHECK(framing_camera(Bounds{}).eye == Camera{}.eye);
    validate(framing_camera({glm::dvec3(3), glm::dvec3(3), false}));
}
