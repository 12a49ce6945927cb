// Ray-cast ambient occlusion gives the same bits however it is run, wherever the scene lies, in whatever
// unit.
#include <cmath>
#include <string>
#include <vector>

#include <doctest/doctest.h>
#include <glm/common.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "tests/tools/every_run.h"
#include "tests/tools/seen_ao.h"
#include "tests/tools/small_scenes.h"
#include "tests/tools/still_life.h"

using namespace crevice;

namespace {

// The still life with all positions and the eye on multiples of 1/16.
Scene still_life_on_grid() {
    Scene scene = still_life();
    for (Mesh& mesh : scene.meshes) {
        for (glm::vec3& p : mesh.positions) p = glm::round(p * 16.0f) / 16.0f;
    }
    return scene;
}

bool same(const AoEstimate& a, const AoEstimate& b) {
    return a.mean == b.mean && a.error == b.error && a.half == b.half;
}

}  // namespace

TEST_CASE("scene and camera far away on a grid give the same bits") {
    Scene scene = still_life_on_grid();
    const SeenAo here = seen_ao(scene, few_rays(0.5f));
    const glm::dvec3 shift(0x1p18, -0x1p18, 0x1p17);
    for (Instance& instance : scene.instances)
        instance.world_from_object = glm::translate(instance.world_from_object, glm::vec3(shift));
    scene.camera.eye += shift;
    scene.camera.target += shift;
    const SeenAo there = seen_ao(scene, few_rays(0.5f));
    CHECK(here.seen.pixel == there.seen.pixel);
    REQUIRE(here.open.size() > 100);
    CHECK(here.open == there.open);
}

TEST_CASE("scene, camera and radius in other units give the same bits") {
    const SeenAo expected = seen_ao(still_life(), few_rays(0.5f));
    REQUIRE(expected.open.size() > 100);
    for (int k = -20; k <= 20; ++k) {
        CAPTURE(k);
        const SeenAo other = seen_ao(scaled(still_life(), k), few_rays(std::ldexp(0.5f, k)));
        CHECK(other.seen.pixel == expected.seen.pixel);
        CHECK(other.open == expected.open);
    }
}

TEST_CASE("lanes, instruction sets and threads give the same bits") {
    const Scene scene = still_life();
    const GBuffer g = normal_depth(scene, scene.camera, {30, 20});
    const SurfacePoints seen = surface_points(scene, scene.camera, g);
    const RayScene rays = ray_scene(scene, scene.camera.eye);
    const Fade fade{0.2f, 1};
    for (const RaySequence sequence : {RaySequence::sobol, RaySequence::independent}) {
        RayAoSettings settings = few_rays(0.75f, 60);  // no multiple of eight
        settings.sequence = sequence;
        settings.weight = sequence == RaySequence::sobol ? RayWeight::cosine : RayWeight::uniform;
        RayAoSettings faded = settings;
        faded.fade = fade;
        const std::vector<float> hard = ray_cast_ao(rays, seen.points, settings),
                                 soft = ray_cast_ao(rays, seen.points, faded);
        const RayAoReference expected = ray_cast_reference(rays, seen.points, settings, &fade);
        std::size_t partly_open = 0;
        for (const float a : hard) partly_open += a > 0 && a < 1 ? 1 : 0;
        CHECK(partly_open > 50);
        CHECK(soft != hard);
        for_every_run({.threads = {1, 2, 7}}, [&](const Run& run) {
            CHECK(ray_cast_ao(rays, seen.points, settings, run) == hard);
            CHECK(ray_cast_ao(rays, seen.points, faded, run) == soft);
            const RayAoReference reference = ray_cast_reference(rays, seen.points, settings, &fade, run);
            for (std::size_t i = 0; i < hard.size(); ++i) {
                const bool all_same =
                    same(reference.hard[i], expected.hard[i]) && same(reference.soft[i], expected.soft[i]);
                if (!all_same) FAIL_CHECK("point " << i);
            }
        });
    }
}
