// Hierarchical depth: triangles that are left out change neither a depth nor a normal nor how many fragments
// pass.
#include <array>
#include <cmath>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include "rasterizer/base/image_summary.h"
#include "rasterizer/draw/normal_depth.h"
#include "tests/tools/clip_space_scene.h"
#include "tests/tools/image_checks.h"
#include "tests/tools/random_sequence.h"
#include "tests/tools/small_scenes.h"
#include "tests/tools/special_floats.h"

using namespace crevice;

namespace {

constexpr DepthFormat kFormats[] = {DepthFormat::d16, DepthFormat::d24, DepthFormat::d32f};
constexpr DepthFunction kFunctions[] = {
    DepthFunction::never,   DepthFunction::less,      DepthFunction::equal,         DepthFunction::less_equal,
    DepthFunction::greater, DepthFunction::not_equal, DepthFunction::greater_equal, DepthFunction::always};

struct Drawn {
    Image<std::int32_t> count;
    DepthBuffer depth;
    std::uint32_t hidden = 0;
};

Drawn drawn_over(const DepthBuffer& before, const ScreenGeometry& geometry, DepthFunction test, Run run,
                 bool leaves_out) {
    if (!leaves_out) run.kept = KeptWork::only(Skip::hidden_triangles);
    Drawn drawn{Image<std::int32_t>(geometry.size, 0), {}, 0};
    Visibility seen = drawn_over(before, geometry, test, counting(drawn.count), run);
    drawn.depth = std::move(seen.depth);
    for (const TileRecord& record : seen.tiles) drawn.hidden += record.hidden;
    return drawn;
}

// Triangles that nearly fill the picture and are nearly parallel to it, `count` layers from z 0.05 to 0.95.
ClipSpaceScene stack(RandomSequence& random, Size size, int count, bool nearest_first) {
    ClipSpaceScene scene{size, {}, {}};
    for (int i = 0; i < count; ++i) {
        const double at = (i + 0.5) / count, z = 0.05 + 0.9 * (nearest_first ? at : 1 - at);
        const auto corner = [&](double x, double y) {
            const double px = size.width * (x + random.between(-0.3, 0.3)),
                         py = size.height * (y + random.between(-0.3, 0.3));
            const double depth = z + random.between(-0.2, 0.2) / count;
            return scene.at_screen(px, py, depth, random.between(0.5, 2));
        };
        const glm::vec4 a = corner(-0.7, -0.3), b = corner(1.7, -0.3), c = corner(0.5, 2.2);
        scene.add_triangle(a, b, c);
    }
    return scene;
}

// Triangles of all sizes that face the eye, at few depths: many tie, and squares hold near and far pixels.
ClipSpaceScene rubble(RandomSequence& random, Size size, int count) {
    ClipSpaceScene scene{size, {}, {}};
    for (int i = 0; i < count; ++i) {
        const double z = random.whole(1, 7) / 8.0, reach = std::exp2(random.between(2, 9));
        const double x = random.between(0, size.width), y = random.between(0, size.height);
        const auto corner = [&] {
            const double px = x + random.between(-reach, reach), py = y + random.between(-reach, reach);
            return scene.at_screen(px, py, z);
        };
        const glm::vec4 a = corner(), b = corner(), c = corner();
        scene.add_triangle(a, b, c);
    }
    return scene;
}

std::string inequality(const Drawn& a, const Drawn& b) {
    return differences(a.depth.codes, b.depth.codes) + differences(a.count, b.count);
}

}  // namespace

TEST_CASE("hidden triangles: stacks drawn with and without leaving out, all functions, formats and biases") {
    const Size size = {83, 61};
    for (std::uint64_t seed = 0; seed < 96; ++seed) {
        RandomSequence random(seed);
        const DepthFunction test = kFunctions[seed % 8];
        const SetupSettings setup{false,
                                  kFormats[seed / 8 % 3],
                                  {.constant = random.whole(-1, 1) * 40,
                                   .slope = static_cast<float>(random.between(-2, 2)),
                                   .clamp = seed % 5 == 0 ? 0.01f : 0.0f}};
        const bool nearest_first = seed / 24 % 2 == 0;
        const Run run{.threads = 1, .lanes = seed % 3 == 0 ? 1 : 0, .tile_size = 16 << seed % 4};
        INFO("seed " << seed << ", function " << static_cast<int>(test));
        const ClipSpaceScene scene = stack(random, size, 400, nearest_first);
        const ScreenGeometry geometry = geometry_of(scene, setup, run);
        // Nothing passes GREATER against a cleared buffer: from 0 on, as reversed z does.
        const bool from_zero = test == DepthFunction::greater || test == DepthFunction::greater_equal;
        DepthBuffer before = cleared_depth(size, setup.format, from_zero);
        if (test == DepthFunction::equal) before = draw(scene, DepthFunction::less, setup, run).depth;
        const Drawn all = drawn_over(before, geometry, test, run, false);
        const Drawn some = drawn_over(before, geometry, test, run, true);
        REQUIRE(inequality(some, all) == "");
        CHECK(all.hidden == 0);
        const bool ordered = test != DepthFunction::always && test != DepthFunction::not_equal;
        if (!ordered) CHECK(some.hidden == 0);
        // The first layers hide the rest: nearest first for LESS, farthest first for GREATER.
        if (test == DepthFunction::never || test == DepthFunction::equal || nearest_first != from_zero) {
            if (ordered) CHECK(some.hidden > 0);
        }
    }
}

TEST_CASE(
    "hidden triangles: rubble that ties drawn with and without leaving out, all functions and formats") {
    const Size size = {83, 61};
    std::array<std::uint32_t, std::size(kFunctions)> hidden{};
    for (std::uint64_t seed = 0; seed < 144; ++seed) {
        RandomSequence random(seed);
        const std::size_t function = seed % 8;
        const SetupSettings setup{false, kFormats[seed / 8 % 3], {}};
        const Run run{.threads = 1, .lanes = seed % 5 == 0 ? 1 : 0, .tile_size = 16 << random.whole(0, 3)};
        INFO("seed " << seed << ", function " << static_cast<int>(kFunctions[function]));
        const ScreenGeometry geometry = geometry_of(rubble(random, size, 500), setup, run);
        // Over other rubble, so that every function has something to pass and to fail.
        const DepthBuffer before = draw(rubble(random, size, 30), DepthFunction::always, setup, run).depth;
        const Drawn all = drawn_over(before, geometry, kFunctions[function], run, false);
        const Drawn some = drawn_over(before, geometry, kFunctions[function], run, true);
        REQUIRE(inequality(some, all) == "");
        hidden[function] += some.hidden;
    }
    for (std::size_t function = 0; function < std::size(kFunctions); ++function) {
        CAPTURE(function);
        const bool ordered =
            kFunctions[function] != DepthFunction::always && kFunctions[function] != DepthFunction::not_equal;
        CHECK((hidden[function] > 0) == ordered);
    }
}

TEST_CASE("hidden triangles: none where each layer lies in front of all before") {
    for (const int tile_size : {16, 64, 128}) {
        RandomSequence random(7);
        const ClipSpaceScene scene = stack(random, {83, 61}, 400, false);
        const Run run{.threads = 1, .tile_size = tile_size};
        const ScreenGeometry geometry = geometry_of(scene, {.cull_back_faces = false}, run);
        const DepthBuffer before = cleared_depth(scene.size, DepthFormat::d32f, false);
        const Drawn drawn = drawn_over(before, geometry, DepthFunction::less, run, true);
        CHECK(drawn.hidden == 0);
        CHECK(total(drawn.count) > 300 * 83 * 61);
    }
}

TEST_CASE(
    "hidden triangles: a mesh behind a mesh keeps normals, depths and materials, both depth directions") {
    for (std::uint64_t seed = 0; seed < 12; ++seed) {
        CAPTURE(seed);
        RandomSequence random(seed);
        Mesh mesh;
        for (int i = 0; i < 600; ++i) {
            const auto first = static_cast<std::uint32_t>(mesh.positions.size());
            const double z = 2 + i / 100.0;
            for (int k = 0; k < 3; ++k) {
                mesh.positions.push_back(
                    {random.between(-6, 6), random.between(-6, 6), z + random.between(-0.1, 0.1)});
                mesh.normals.push_back(
                    glm::normalize(glm::vec3(random.between(-1, 1), random.between(-1, 1), -1)));
            }
            mesh.triangles.push_back({first, first + 1, first + 2});
        }
        mesh.parts = {{0, 250, 0}, {250, 350, 1}};
        Scene scene = scene_of({mesh});
        scene.materials.resize(2);
        scene.two_sided = true;
        scene.camera.near_plane = 0.5;
        scene.camera.far_plane = 20;
        scene.camera.reversed_z = seed % 2 == 1;
        const NormalDepthSettings settings{.depth_format = kFormats[seed % 3], .with_material = true};
        Run run{.threads = 1, .tile_size = 16 << seed % 4};
        const Size size = {71, 45};
        const GBuffer some = normal_depth(scene, scene.camera, size, settings, run);
        run.kept = KeptWork::only(Skip::hidden_triangles);
        const GBuffer all = normal_depth(scene, scene.camera, size, settings, run);
        CHECK(content_hash(some.normal) == content_hash(all.normal));
        CHECK(content_hash(some.view_depth) == content_hash(all.view_depth));
        CHECK(differences(some.depth.codes, all.depth.codes) == "");
        CHECK(pixels_against(size, [&](int x, int y) {
                  return all.view_depth.at(x, y) == kInfinity ||
                         some.material.at(x, y) == all.material.at(x, y);
              }) == "");
        std::uint32_t hidden = 0;
        for (const TileRecord& record : some.tiles) hidden += record.hidden;
        CHECK(hidden > 0);
    }
}
