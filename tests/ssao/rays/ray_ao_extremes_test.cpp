// Ray-cast ambient occlusion of scenes and settings at the edge of what can be asked.
#include <cmath>
#include <string>

#include <doctest/doctest.h>
#include <glm/gtc/matrix_transform.hpp>

#include "rasterizer/base/error.h"
#include "scenes/shapes.h"
#include "tests/tools/seen_ao.h"
#include "tests/tools/small_scenes.h"
#include "tests/tools/special_floats.h"
#include "tests/tools/still_life.h"

using namespace crevice;

namespace {

constexpr SurfacePoint kFloorPoint = {{0.75f, 0.5f, -1.25f}, {0, 1, 0}, {0, 1, 0}};

// A floor through kFloorPoint.
Mesh floor_mesh() {
    Mesh floor = grid_mesh(8, 8, 5, 5);
    for (glm::vec3& p : floor.positions) p += kFloorPoint.position;
    return floor;
}

template <class Action>
std::string usage_error_of(const Action& action) {
    try {
        action();
    } catch (const UsageError& error) {
        return error.what();
    }
    return "no error";
}

}  // namespace

TEST_CASE("settings out of their range are named, with their value") {
    const struct {
        int rays;
        float radius;
        const char *name, *value;
    } cases[] = {{0, 1, "rays", "(0)"},
                 {-1, 1, "rays", "(-1)"},
                 {(1 << 20) + 1, 1, "rays", "(1048577)"},
                 {16, 0, "radius", "(0)"},
                 {16, -0.0f, "radius", "(-0)"},
                 {16, -1, "radius", "(-1)"},
                 {16, -kInfinity, "radius", "(-inf)"},
                 {16, kNan, "radius", "nan"}};
    const RayScene scene = ray_scene(scene_of({floor_mesh()}), glm::dvec3(0));
    const std::vector<SurfacePoint> points = {kFloorPoint};
    for (const auto& c : cases) {
        const RayAoSettings settings = few_rays(c.radius, c.rays);
        for (const std::string& message : {
                 usage_error_of([&] { validate(settings); }),
                 usage_error_of([&] { ray_cast_ao(scene, points, settings); }),
                 usage_error_of([&] { ray_cast_reference(scene, points, settings, nullptr); }),
                 usage_error_of([&] { hemisphere_rays(points[0], 0, settings); }),
             }) {
            CAPTURE(message);
            CHECK(message.starts_with(std::string(c.name) + ":"));
            CHECK(message.find(c.value) != std::string::npos);
            CHECK(message.find(';') != std::string::npos);
        }
    }
    CHECK_NOTHROW(validate(few_rays(kInfinity, 1)));
    CHECK_NOTHROW(validate(few_rays(1e-30f, 1 << 20)));
    Run run;
    run.lanes = 3;
    CHECK_THROWS_AS(ray_cast_ao(scene, points, few_rays(1), run), UsageError);
    CHECK_THROWS_AS(ray_cast_reference(scene, points, few_rays(1), nullptr, run), UsageError);
}

TEST_CASE("without triangles everything is open, exactly; without points there is no answer") {
    const RayScene nothing = ray_scene(scene_of({}), glm::dvec3(0));
    const std::vector<SurfacePoint> points(3, kFloorPoint);
    for (const float radius : {1e-20f, 1.0f, kInfinity}) {
        CAPTURE(radius);
        CHECK(ray_cast_ao(nothing, points, few_rays(radius)) == std::vector<float>(3, 1));
        const Fade fade{0, 1};
        const RayAoReference reference = ray_cast_reference(nothing, points, few_rays(radius), &fade);
        for (const AoEstimate& e : reference.hard) CHECK((e.mean == 1 && e.error == 0));
        for (const AoEstimate& e : reference.soft) CHECK((e.mean == 1 && e.error == 0));
    }
    const RayScene floor = ray_scene(scene_of({floor_mesh()}), glm::dvec3(0));
    CHECK(ray_cast_ao(floor, {}, few_rays(1)).empty());
    CHECK(ray_cast_reference(floor, {}, few_rays(1), nullptr).hard.empty());
}

TEST_CASE("a triangle with a corner that is no number is left out, counted, and changes nothing") {
    Scene scene = still_life();
    const SeenAo whole = seen_ao(scene, few_rays(2));
    Mesh broken = facing_quad({0, 0, 3}, 4);  // would hide everything
    broken.positions[0].x = kNan;
    broken.positions[2].y = -kInfinity;
    scene.meshes.push_back(broken);
    scene.instances.push_back({static_cast<int>(scene.meshes.size() - 1), glm::mat4(1)});
    const RayScene rays = ray_scene(scene, scene.camera.eye);
    CHECK(rays.not_finite == 2);
    CHECK(ray_cast_ao(rays, whole.seen.points, few_rays(2)) == whole.open);
}

TEST_CASE("a floor that is there twice is open, exactly") {
    for (const double slope : {0.0, 0.3, 1.2}) {
        CAPTURE(slope);
        Scene scene = scene_of({floor_mesh(), floor_mesh()});
        const glm::mat4 tilt = glm::rotate(glm::mat4(1), static_cast<float>(slope), glm::vec3(1, 0, 0));
        for (Instance& instance : scene.instances) instance.world_from_object = tilt;
        scene.camera.eye = glm::dvec3(tilt * glm::vec4(1, 4, -3, 1));
        scene.camera.target = glm::dvec3(tilt * glm::vec4(kFloorPoint.position, 1));
        scene.camera.near_plane = 0.25;
        scene.camera.far_plane = 100;
        RayAoSettings settings = few_rays(kInfinity, 1024);
        for (const RayWeight weight : {RayWeight::cosine, RayWeight::uniform}) {
            settings.weight = weight;
            const SeenAo ao = seen_ao(scene, settings);
            REQUIRE(ao.open.size() > 100);
            for (std::size_t i = 0; i < ao.open.size(); ++i) {
                if (ao.open[i] != 1) FAIL_CHECK("point " << i << ": " << ao.open[i]);
            }
        }
    }
}

TEST_CASE("an eye inside a closed box sees nothing open, and open again where rays end before the walls") {
    Scene scene = scene_of({cube()});
    scene.two_sided = true;
    scene.camera.eye = {0.1, 0.2, -0.3};
    scene.camera.target = {0.7, -0.4, 1};
    scene.camera.near_plane = 0.01;
    scene.camera.far_plane = 10;
    const SeenAo closed = seen_ao(scene, few_rays(kInfinity, 256));
    REQUIRE(closed.open.size() == 24 * 16);
    CHECK(closed.open == std::vector<float>(closed.open.size(), 0));
    // The box is two units wide: no ray of it is longer than its diagonal.
    const SeenAo diagonal = seen_ao(scene, few_rays(2 * std::sqrt(3.0f), 256));
    CHECK(diagonal.open == closed.open);
    const SeenAo shorter = seen_ao(scene, few_rays(0.5f, 256));
    for (std::size_t i = 0; i < shorter.open.size(); ++i) {
        CAPTURE(i);
        CHECK(shorter.open[i] > 0.2f);  // in a corner a quarter and more
    }
    scene.two_sided = false;  // all of it is culled
    CHECK(seen_ao(scene, few_rays(kInfinity)).open.empty());
}

TEST_CASE("points that are lifted further than a hundredth of the radius are counted") {
    const RayScene nothing = ray_scene(scene_of({}), glm::dvec3(0));
    std::vector<SurfacePoint> points;
    for (const float x : {1.0f, 1e3f, 1e4f, 2e4f, 1e5f}) {
        points.push_back(kFloorPoint);
        points.back().position = {1, 2, -x};
    }
    // Lifts are 2^-21 of the largest coordinate: 1e-6, 4.8e-4, .0048, .0095, .048
    const struct {
        float radius;
        std::size_t count;
    } cases[] = {{0.5f, 2}, {0.4f, 3}, {10, 0}, {1e-5f, 5}, {kInfinity, 0}};
    for (const auto& c : cases) {
        CAPTURE(c.radius);
        CHECK(lifted_far(points, c.radius) == c.count);
        CHECK(ray_cast_reference(nothing, points, few_rays(c.radius, 8), nullptr).lifted_far == c.count);
    }
}

TEST_CASE(
    "directions below the triangle's plane are blocked about a vertex normal, and not drawn about its own") {
    const RayScene nothing = ray_scene(scene_of({}), glm::dvec3(0));
    SurfacePoint leaning = kFloorPoint;
    leaning.normal = {0.6f, 0.8f, 0};
    RayAoSettings settings = few_rays(1, 4096);
    const float about_vertex = ray_cast_ao(nothing, std::vector{leaning}, settings)[0];
    CHECK(about_vertex == doctest::Approx(0.9).epsilon(0.001));
    const std::vector<Ray> rays = hemisphere_rays(leaning, 0, settings);
    CHECK(static_cast<float>(rays.size()) == about_vertex * 4096);
    for (const Ray& ray : rays) CHECK(ray.direction.y > 0);
    settings.hemisphere = Hemisphere::geometric;
    CHECK(ray_cast_ao(nothing, std::vector{leaning}, settings)[0] == 1);
    const std::vector<Ray> about_own = hemisphere_rays(leaning, 0, settings);
    CHECK(about_own.size() == 4096);
    for (const Ray& ray : about_own) CHECK(ray.direction.y > 0);
}

TEST_CASE("every point and every seed has rays of its own") {
    const auto half_wall =
        ray_scene(scene_of({facing_quad(kFloorPoint.position + glm::vec3(0, 0, 1), 2)}), glm::dvec3(0));
    for (const RaySequence sequence : {RaySequence::sobol, RaySequence::independent}) {
        RayAoSettings settings = few_rays(kInfinity, 67);
        settings.sequence = sequence;
        const std::vector<SurfacePoint> points(16, kFloorPoint);
        const std::vector<float> open = ray_cast_ao(half_wall, points, settings);
        settings.seed = 2;
        CHECK(ray_cast_ao(half_wall, points, settings) != open);
        CHECK(open != std::vector<float>(16, open[0]));
    }
}
