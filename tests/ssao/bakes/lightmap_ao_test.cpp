// The baked map: closed forms, no leaks at edges, dilation, lookups, same bits.
#include <doctest/doctest.h>

#include <cmath>
#include <utility>

#include <glm/gtc/matrix_transform.hpp>

#include "rasterizer/base/image_summary.h"
#include "rasterizer/lanes/approx_math.h"
#include "scenes/shapes.h"
#include "tests/tools/baked_scene.h"
#include "tests/tools/every_run.h"
#include "tests/tools/small_scenes.h"
#include "tests/tools/special_floats.h"
#include "tests/tools/still_life.h"

using namespace crevice;

namespace {

// How many texels with points of their own have another value.
int other_values(const Baked& b, float value) {
    int other = 0;
    for (const std::int32_t texel : b.points.texels.pixel)
        other += b.map.ao.at(texel % b.charts.texels, texel / b.charts.texels) != value ? 1 : 0;
    return other;
}

// The inside of a box, each face a cell of its own of the map, with edges through texel centres or not.
Mesh room(float inset_texels, float texels) {
    Mesh mesh = box_mesh({2, 3, 4});
    for (glm::vec3& n : mesh.normals) n = -n;
    for (auto& triangle : mesh.triangles) std::swap(triangle[1], triangle[2]);
    for (std::size_t i = 0; i < mesh.texcoords.size(); ++i) {
        const std::size_t face = i / 4;
        const glm::vec2 cell(static_cast<float>(face % 3), static_cast<float>(face / 3));
        const glm::vec2 low = texels / 4 * cell + inset_texels;
        mesh.texcoords[i] = (low + (texels / 4 - 4) * mesh.texcoords[i]) / texels;
    }
    return mesh;
}

// A floor's strip along a long straight edge, and a very high wall on that edge at `opening` from the floor.
Scene dihedral(double opening) {
    const SineCosine at = sine_cosine(opening);
    const float far = 4096;
    const Mesh floor = quad_mesh({glm::vec3(0, 0, 1), {1, 0, 1}, {1, 0, 0}, {0, 0, 0}}, {0, 1, 0});
    const auto up = static_cast<float>(far * at.sine), out = static_cast<float>(far * at.cosine);
    Mesh wall = quad_mesh({glm::vec3(-far, up, out), {far, up, out}, {far, 0, 0}, {-far, 0, 0}},
                          {0, static_cast<float>(-at.cosine), static_cast<float>(at.sine)});
    Mesh lit = floor;
    for (glm::vec2& uv : lit.texcoords) uv = uv * 0.5f;
    for (glm::vec2& uv : wall.texcoords) uv = glm::vec2(0.75f) + uv * 0.2f;
    return scene_of({lit, wall});
}

}  // namespace

TEST_CASE("lightmap: an open plane and convex bodies are exactly 1, mirrored and stretched too") {
    CHECK(other_values(baked(scene_of({grid_mesh(3, 2, 5, 4)}), {.texels = 64}, 64), 1) == 0);
    for (const glm::vec3 scale : {glm::vec3(1), glm::vec3(-1, 1, 1), glm::vec3(3, -1, 0.25f)}) {
        Scene scene = scene_of({box_mesh({1, 2, 3}, 2)});
        scene.instances[0].world_from_object =
            glm::rotate(glm::scale(glm::mat4(1), scale), 0.5f, glm::vec3(0, 0, 1));
        const Baked b = baked(scene, {.texels = 64}, 64);
        CAPTURE(scale.x);
        CHECK(b.points.texels.points.size() > 1000);
        CHECK(other_values(b, 1) == 0);
    }
}

TEST_CASE("lightmap: normals tell the outer side where the winding tells the other") {
    Mesh box = box_mesh({1, 2, 3});
    for (auto& triangle : box.triangles) std::swap(triangle[1], triangle[2]);
    CHECK(other_values(baked(scene_of({box}), {.texels = 64}, 64), 1) == 0);
    for (glm::vec3& n : box.normals) n = glm::vec3(0);
    CHECK(other_values(baked(scene_of({box}), {.texels = 64}, 64), 0) == 0);
}

TEST_CASE("lightmap: a closed room is exactly 0, whether its edges run through texel centres or not") {
    for (const float inset : {1.0f, 1.5f, 1.25f}) {
        const Baked b = baked(scene_of({room(inset, 64)}), {.texels = 64, .mesh_texcoords = true}, 64);
        CAPTURE(inset);
        CHECK(b.charts.note == "");
        CHECK(other_values(b, 0) == 0);
    }
    CHECK(other_values(baked(scene_of({room(1, 64)}), {.texels = 64}, 64), 0) == 0);
}

TEST_CASE("lightmap: on a floor below a wall that stands at an angle, sin^2(angle / 2)") {
    for (const double degrees : {30.0, 60.0, 90.0, 135.0}) {
        constexpr int kRays = 1024;
        const Baked b = baked(dihedral(radians(degrees)), {.texels = 32, .mesh_texcoords = true}, kRays);
        REQUIRE(b.charts.note == "");
        const double sine = sine_cosine(radians(degrees) / 2).sine, expected = sine * sine;
        const double noise = 4 * std::sqrt(expected * (1 - expected) / kRays);
        double sum = 0;
        for (int y = 0; y < 16; ++y) {
            for (int x = 0; x < 16; ++x) {
                const double open = b.map.ao.at(x, y);
                sum += open;
                CAPTURE(degrees);
                CAPTURE(x);
                CAPTURE(y);
                CHECK(b.map.kind.at(x, y) == TexelKind::centre);
                CHECK(std::abs(open - expected) < noise);
            }
        }
        CHECK(std::abs(sum / 256 - expected) < 2e-3);
    }
}

TEST_CASE("dilation: the mean of what was there before the round, and nothing else changes") {
    LightmapAo map{Image<float>({5, 3}, 1.0f), Image<TexelKind>({5, 3}, TexelKind::empty)};
    map.ao.at(0, 0) = 0.25f;
    map.kind.at(0, 0) = TexelKind::centre;
    map.ao.at(2, 0) = 0.75f;
    map.kind.at(2, 0) = TexelKind::touched;
    CHECK(dilated(map, 0).count(TexelKind::dilated) == 0);
    const LightmapAo once = dilated(map, 1), twice = dilated(map, 2);
    CHECK(once.ao.at(1, 0) == 0.5f);
    CHECK(once.ao.at(1, 1) == 0.5f);
    CHECK(once.ao.at(0, 1) == 0.25f);
    CHECK(once.ao.at(3, 1) == 0.75f);
    CHECK(once.ao.at(4, 0) == 1);
    CHECK(once.ao.at(0, 2) == 1);
    CHECK(once.kind.at(0, 0) == TexelKind::centre);
    CHECK(once.kind.at(2, 0) == TexelKind::touched);
    CHECK(once.count(TexelKind::dilated) == 6);
    CHECK(once.count(TexelKind::empty) == 7);
    CHECK(twice.ao.at(4, 0) == 0.75f);
    CHECK(twice.ao.at(0, 2) == 0.375f);
    CHECK(twice.ao.at(0, 0) == 0.25f);
    CHECK(twice.count(TexelKind::empty) == 0);
}

TEST_CASE("lookup: texel centres exactly, linear between, clamped outside") {
    Image<float> map({4, 2}, 0);
    for (int y = 0; y < 2; ++y) {
        for (int x = 0; x < 4; ++x) map.at(x, y) = float(x + 10 * y);
    }
    CHECK(lightmap_at(map, {0.125f, 0.25f}) == 0);
    CHECK(lightmap_at(map, {0.625f, 0.75f}) == 12);
    CHECK(lightmap_at(map, {0.5f, 0.25f}) == 1.5f);
    CHECK(lightmap_at(map, {0.375f, 0.5f}) == 6);
    CHECK(lightmap_at(map, {-1, 0}) == 0);
    CHECK(lightmap_at(map, {1, 1}) == 13);
    CHECK(lightmap_at(map, {7, 0.5f}) == 8);
}

TEST_CASE("lightmap: what was cast is told, and a far-away scene is warned of") {
    Scene scene = scene_of({grid_mesh(2, 2, 2, 2)});
    long long done = 0;
    const Baked b = baked(scene, {.texels = 32}, 5);
    const auto points = static_cast<long long>(b.points.texels.points.size());
    const LightmapAo again = lightmap_ao(b.rays, b.charts, b.points, {.rays = 5, .radius = kInfinity}, {},
                                         [&](long long texels) { done += texels; });
    CHECK(done == points);
    CHECK(again.rays_cast == 5 * points);
    CHECK(again.lifted_far == 0);
    CHECK(again.ao.pixels == b.map.ao.pixels);
    scene.instances[0].world_from_object = glm::translate(glm::mat4(1), glm::vec3(1e6f, 0, 0));
    const Baked far = baked(scene, {.texels = 32}, 1);
    const LightmapAo warned = lightmap_ao(far.rays, far.charts, far.points, {.rays = 1, .radius = 1});
    CHECK(warned.lifted_far == far.points.texels.points.size());
}

TEST_CASE("lightmap: the same bits at every thread count, lane count, instruction set and tile size") {
    const Scene scene = still_life();
    const auto hash = [&](const Run& run) {
        return content_hash(baked(scene, {.texels = 96}, 16, run).map.ao);
    };
    const std::string expected = hash({});
    for_every_run({.threads = {1, 2, 7}, .tile_sizes = {16, 64}},
                  [&](const Run& run) { CHECK(hash(run) == expected); });
    Run kept;
    kept.kept = KeptWork::all();
    CHECK(hash(kept) == expected);
}
