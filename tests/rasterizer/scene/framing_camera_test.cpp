#include "rasterizer/scene/framing_camera.h"

#include <cmath>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

using namespace crevice;

namespace {

// Two triangles that span the parallelogram of two sides.
Scene sheet(const glm::vec3& u, const glm::vec3& v) {
    Scene scene;
    Mesh mesh;
    mesh.positions = {glm::vec3(0), u, u + v, v};
    mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
    scene.meshes.push_back(mesh);
    scene.instances.push_back({});
    return scene;
}

// How much of a sheet's area is seen: the cosine between its normal and the way to the eye.
double seen_share(const Scene& scene, const glm::vec3& u, const glm::vec3& v) {
    const Camera camera = framing_camera(scene);
    return std::fabs(
        glm::dot(glm::normalize(glm::dvec3(glm::cross(u, v))), glm::normalize(camera.eye - camera.target)));
}

}  // namespace

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

TEST_CASE("framing_camera: flat models are seen from where they are wide") {
    for (const float scale : {1e-12f, 1.0f, 1e12f}) {
        CAPTURE(scale);
        const glm::vec3 x(scale, 0, 0), y(0, scale, 0), z(0, 0, scale);
        CHECK(seen_share(sheet(x, z), x, z) > 0.7);  // a floor
        CHECK(seen_share(sheet(y, z), y, z) > 0.7);  // a wall seen from the side
        CHECK(seen_share(sheet(x, y), x, y) > 0.7);  // a wall seen from the front
        // Perpendicular to the sheet that the front sees edge-on, which no axis tells.
        const glm::vec3 along(0.45f * scale, 0.35f * scale, -scale), across(scale, 0, 0.45f * scale);
        CHECK(seen_share(sheet(along, across), along, across) > 0.3);
    }
}

TEST_CASE("framing_camera: what is as large from everywhere is seen from the front") {
    Scene box = sheet({1, 0, 0}, {0, 1, 0});
    for (const auto& [u, v] :
         {std::pair<glm::vec3, glm::vec3>{{0, 1, 0}, {0, 0, 1}}, {{0, 0, 1}, {1, 0, 0}}}) {
        box.meshes.push_back(sheet(u, v).meshes[0]);
        box.instances.push_back({static_cast<int>(box.meshes.size()) - 1});
    }
    CHECK(framing_camera(box).eye == framing_camera(world_bounds(box)).eye);
    CHECK(framing_camera(Scene{}).eye == Camera{}.eye);
}

TEST_CASE("with_planes_around: wherever the eye stands, what lies in front of it lies between near and far") {
    Bounds bounds;
    bounds.empty = false;
    bounds.low = {-1, -2, -3};
    bounds.high = {4, 2, 1};
    const glm::dvec3 centre = 0.5 * (bounds.low + bounds.high);
    const double radius = 0.5 * glm::length(bounds.high - bounds.low);
    for (const double distance : {0.1, 1.0, 5.0, 50.0, 1e6, 1e12}) {
        for (const double aside : {-2.0, 0.0, 0.5}) {  // -2: most of the box lies behind
            Camera camera;
            camera.eye = centre + distance * radius * glm::normalize(glm::dvec3(1, 2, -3));
            camera.target = centre + aside * distance * radius * glm::dvec3(1, 0, 0);
            const Camera fitted = with_planes_around(camera, bounds);
            CAPTURE(distance);
            CAPTURE(aside);
            validate(fitted);
            CHECK(fitted.eye == camera.eye);
            CHECK(fitted.target == camera.target);
            const double depth = glm::dot(centre - camera.eye, glm::normalize(camera.target - camera.eye));
            CHECK(fitted.far_plane > depth + radius);
            CHECK(fitted.near_plane <= std::fmax(depth - radius, fitted.far_plane / kPlanesRatio));
            // No further than they must be.
            CHECK(fitted.far_plane <= 1.001 * (std::fmax(depth, 0) + 2 * radius));
            CHECK(fitted.near_plane >= std::fmin(depth - 1.2 * radius, 0.499 * fitted.far_plane));
            CHECK(static_cast<float>(fitted.near_plane) < static_cast<float>(fitted.far_plane));
        }
    }
    CHECK(with_planes_around(Camera{}, Bounds{}) == Camera{});
    // The planes of the framing camera are those of its place.
    const Camera framed = framing_camera(bounds), again = with_planes_around(framed, bounds);
    CHECK(again.near_plane == doctest::Approx(framed.near_plane));
    CHECK(again.far_plane == doctest::Approx(framed.far_plane));
}
