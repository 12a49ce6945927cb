// A first pass that fills the depth buffer and a second that draws where depths are EQUAL: every pixel must
// pass, whatever the depth format and however each of the two passes is run.
#include <algorithm>
#include <array>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "rasterizer/draw/normal_depth.h"
#include "tests/tools/clip_space_scene.h"
#include "tests/tools/every_run.h"
#include "tests/tools/random_sequence.h"

using namespace crevice;

namespace {

constexpr DepthFormat kFormats[] = {DepthFormat::d16, DepthFormat::d24, DepthFormat::d32f};

// 72 triangles of ordinary shape and 72 narrow ones (CTS es3fShaderInvarianceTests), some cut by the near
// plane.
ClipSpaceScene random_triangles(std::uint64_t seed, Size size) {
    RandomSequence random(seed);
    ClipSpaceScene scene{size, {}, {}};
    const auto vertex = [&](glm::dvec2 p_ndc) {
        const double w = random.between(0.2, 5);
        return glm::vec4(p_ndc.x * w, p_ndc.y * w, random.between(-0.05, 1) * w, w);
    };
    const auto anywhere = [&] { return glm::dvec2{random.between(-1.2, 1.2), random.between(-1.2, 1.2)}; };
    for (int i = 0; i < 72; ++i) {
        const glm::vec4 a = vertex(anywhere()), b = vertex(anywhere()), c = vertex(anywhere());
        scene.add_triangle(a, b, c);
    }
    for (int i = 0; i < 72; ++i) {
        const glm::dvec2 a = anywhere(), b = anywhere();
        const glm::dvec2 c = b + 0.02 * (anywhere() - b);
        const glm::vec4 at_a = vertex(a), at_b = vertex(b), at_c = vertex(c);
        scene.add_triangle(at_a, at_b, at_c);
    }
    return scene;
}

// A mesh of separate triangles in the unit ball, drawn as three turned and stretched instances.
Scene random_scene(std::uint64_t seed) {
    RandomSequence random(seed);
    Mesh mesh;
    for (std::uint32_t i = 0; i < 600; ++i) {
        mesh.positions.push_back(
            glm::vec3{random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)});
        mesh.normals.push_back(glm::normalize(glm::vec3(0.3f, 1, -0.2f)));
        if (i % 3 == 2) mesh.triangles.push_back({i - 2, i - 1, i});
    }
    mesh.parts = {{0, 200, 0}};
    Scene scene;
    scene.meshes = {mesh};
    scene.materials = {Material{}};
    scene.two_sided = true;
    for (int i = 0; i < 3; ++i) {
        const glm::dvec3 axis{random.between(-1, 1), random.between(-1, 1), random.between(0.1, 1)};
        const glm::dmat4 turn = glm::rotate(glm::dmat4(1), random.between(0, 6), glm::normalize(axis));
        const glm::dvec3 place{random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)};
        const glm::dvec3 stretch{random.between(0.3, 2), random.between(0.3, 2), random.between(0.3, 2)};
        scene.instances.push_back(
            {0, glm::mat4(glm::scale(glm::translate(glm::dmat4(1), place) * turn, stretch))});
    }
    Camera& camera = scene.camera;
    camera.eye = {random.between(-4, 4), random.between(-4, 4), random.between(-5, -3)};
    camera.target = {random.between(-0.5, 0.5), random.between(-0.5, 0.5), 0};
    camera.near_plane = 0.5;
    camera.far_plane = 50;
    camera.reversed_z = seed % 2 == 1;
    camera.projection = seed % 3 == 2 ? Projection::orthographic : Projection::perspective;
    camera.ortho_height = 5;
    return scene;
}

// 1 where a second pass passes EQUAL at least once, or where the first pass drew nothing.
Image<std::int32_t> settled(const ScreenGeometry& second, const DepthBuffer& depth, std::int32_t clear_code,
                            const Run& run) {
    Image<std::int32_t> passed = drawn_again(second, depth, DepthFunction::equal, {}, run);
    for (int y = 0; y < passed.size.height; ++y) {
        for (int x = 0; x < passed.size.width; ++x) {
            passed.at(x, y) = passed.at(x, y) != kNoTriangle || depth.codes.at(x, y) == clear_code;
        }
    }
    return passed;
}

std::int64_t drawn_pixels(const DepthBuffer& depth, std::int32_t clear_code) {
    std::int64_t drawn = 0;
    for (int y = 0; y < depth.size().height; ++y) {
        for (int x = 0; x < depth.size().width; ++x) drawn += depth.codes.at(x, y) != clear_code;
    }
    return drawn;
}

const RunChoices kChoices{.threads = {1, 2, 7}, .tile_sizes = {16, 32, 64}};

}  // namespace

TEST_CASE("72 ordinary and 72 narrow triangles: every pixel of the first pass is EQUAL in the second") {
    const Size size = {200, 150};
    const std::vector<Run> runs = every_run(kChoices);
    for (std::uint64_t seed = 0; seed < 9; ++seed) {
        CAPTURE(seed);
        const DepthFormat format = kFormats[seed % 3];
        const SetupSettings setup{false, format, {}};
        const ClipSpaceScene scene = random_triangles(seed, size);
        const Run first_run = runs[seed % runs.size()], second_run = runs[(7 * seed + 5) % runs.size()];
        const DepthBuffer depth = draw(scene, DepthFunction::less, setup, first_run).depth;
        const std::int32_t clear_code = depth_code(format, 1.0f, 0.0);
        CHECK(drawn_pixels(depth, clear_code) > 20000);
        CHECK(differences(settled(geometry_of(scene, setup, second_run), depth, clear_code, second_run), 1) ==
              "");
    }
}

TEST_CASE("scenes under random cameras: every pixel of the first pass is EQUAL in the second") {
    const Size size = {120, 90};
    const std::vector<Run> runs = every_run(kChoices);
    for (std::uint64_t seed = 0; seed < 18; ++seed) {
        CAPTURE(seed);
        const Scene scene = random_scene(seed);
        const NormalDepthSettings settings{.depth_format = kFormats[seed % 3]};
        const Run first_run = runs[(5 * seed) % runs.size()], second_run = runs[(7 * seed + 5) % runs.size()];
        const GBuffer g = normal_depth(scene, scene.camera, size, settings, first_run);
        const std::int32_t clear_code =
            depth_code(settings.depth_format, scene.camera.reversed_z ? 0.0f : 1.0f, 0.0);
        CHECK(drawn_pixels(g.depth, clear_code) > 500);
        const ScreenGeometry second =
            screen_geometry(scene, scene.camera, size,
                            {.with_normals = false, .depth_format = settings.depth_format}, second_run);
        CHECK(differences(settled(second, g.depth, clear_code, second_run), 1) == "");
    }
}

TEST_CASE("passes that multiply their matrices in another order lose pixels under a turned camera") {
    const Size size = {160, 120};
    const Scene scene = random_scene(4);
    const std::array<PositionOrder, 3> orders = {PositionOrder::relative, PositionOrder::premultiplied,
                                                 PositionOrder::view_first};
    for (std::size_t i = 0; i < 3; ++i) {
        const PositionOrder first = orders[i], second = orders[(i + 1) % 3];
        const DepthBuffer depth =
            normal_depth(scene, scene.camera, size, {.position_order = first}, kPlainRun).depth;
        const std::int32_t clear_code = depth_code(DepthFormat::d32f, 1.0f, 0.0);
        const std::int64_t drawn = drawn_pixels(depth, clear_code);
        const ScreenGeometry other =
            screen_geometry(scene, scene.camera, size, {.position_order = second}, kPlainRun);
        const Image<std::int32_t> passed = settled(other, depth, clear_code, kPlainRun);
        const std::int64_t lost = std::int64_t{size.width} * size.height - total(passed);
        CAPTURE(static_cast<int>(first));
        CAPTURE(static_cast<int>(second));
        CAPTURE(drawn);
        CAPTURE(lost);
        CHECK(lost > drawn / 100);
        CHECK(lost < drawn);
        // The same order again loses none.
        const ScreenGeometry again =
            screen_geometry(scene, scene.camera, size, {.position_order = first}, kPlainRun);
        CHECK(differences(settled(again, depth, clear_code, kPlainRun), 1) == "");
    }
}

TEST_CASE("coverage and depth have the same bits for all lanes, instruction sets, threads and tile sizes") {
    for (const Size size : {Size{131, 67}, {7, 5}}) {
        const ClipSpaceScene scene = random_triangles(11, size);
        const SetupSettings setup{false, DepthFormat::d24, {.constant = 3, .slope = 0.5f}};
        const CountedDrawing expected = draw(scene, DepthFunction::less, setup, kOneLane);
        for (const Run& run : every_run(kChoices)) {
            INFO(run_text(run));
            const CountedDrawing actual = draw(scene, DepthFunction::less, setup, run);
            CHECK(differences(actual.count, expected.count) == "");
            CHECK(differences(actual.depth.codes, expected.depth.codes) == "");
        }
    }
}

TEST_CASE(
    "normals and depths of a scene have the same bits for all lanes, instruction sets, threads and tile "
    "sizes") {
    const Size size = {131, 67};
    const auto bits_of = [&](const Image<float>& image) {
        Image<std::int32_t> bits(image.size, 0);
        for (int y = 0; y < size.height; ++y) {
            for (int x = 0; x < size.width; ++x) bits.at(x, y) = float_bits(image.at(x, y));
        }
        return bits;
    };
    for (const std::uint64_t seed : {5u, 6u, 8u}) {
        CAPTURE(seed);
        const Scene scene = random_scene(seed);
        const NormalDepthSettings settings{.depth_format = kFormats[seed % 3],
                                           .buffer_format = BufferFormat::float16_nearest_even};
        const auto render = [&](const Run& run) {
            return normal_depth(scene, scene.camera, size, settings, run);
        };
        const GBuffer expected = render(kOneLane);
        for (const Run& run : every_run(kChoices)) {
            INFO(run_text(run));
            const GBuffer actual = render(run);
            CHECK(differences(actual.depth.codes, expected.depth.codes) == "");
            CHECK(differences(bits_of(actual.view_depth), bits_of(expected.view_depth)) == "");
            CHECK(differences(bits_of(actual.normal.x), bits_of(expected.normal.x)) == "");
            CHECK(differences(bits_of(actual.normal.y), bits_of(expected.normal.y)) == "");
            CHECK(differences(bits_of(actual.normal.z), bits_of(expected.normal.z)) == "");
        }
    }
}
