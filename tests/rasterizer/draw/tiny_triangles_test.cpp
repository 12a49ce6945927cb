// Triangles of a few pixels: drawn one a lane they leave what they leave when they are drawn one after the other, as
// they are where somebody asks for holes.
#include <doctest/doctest.h>

#include "rasterizer/draw/tiny_triangles.h"
#include "tests/tools/clip_space_scene.h"
#include "tests/tools/random_sequence.h"

using namespace crevice;

namespace {

constexpr DepthFunction kFunctions[] = {
    DepthFunction::never,   DepthFunction::less,      DepthFunction::equal,         DepthFunction::less_equal,
    DepthFunction::greater, DepthFunction::not_equal, DepthFunction::greater_equal, DepthFunction::always};

// Triangles of up to six pixels, many on top of each other, at few depths: they tie. One in eight is large.
ClipSpaceScene gravel(RandomSequence& random, Size size, int count) {
    ClipSpaceScene scene{size, {}, {}};
    for (int i = 0; i < count; ++i) {
        const double x = random.between(-2, size.width + 2), y = random.between(-2, size.height + 2),
                     reach = random.whole(0, 7) == 0 ? 40 : random.between(0.2, 3),
                     z = random.whole(1, 3) / 4.0, slope = random.whole(0, 1) * 0.2;
        const auto corner = [&] {
            return scene.at_screen(x + random.between(-reach, reach), y + random.between(-reach, reach),
                                   z + random.between(-slope, slope));
        };
        const glm::vec4 a = corner(), b = corner(), c = corner();
        scene.add_triangle(a, b, c);
    }
    return scene;
}

// Cuts nothing out, so that no triangle counts as tiny.
void no_hole(const FragmentGroup&) {}

// How many are left out as hidden, of two layers of 32 triangles and an incomplete one behind.
int hidden_of_layers(Size size, const Run& run) {
    // Two triangles a square of 4 x 4 pixels, at one depth.
    ClipSpaceScene scene{size, {}, {}};
    const auto add_square = [&](int number, double z) {
        const double x = number % 4 * 4, y = number / 4 * 4;
        const auto corner = [&](double right, double down) {
            return scene.at_screen(x + right, y + down, z);
        };
        scene.add_triangle(corner(0, 0), corner(4, 0), corner(0, 4));
        scene.add_triangle(corner(4, 0), corner(4, 4), corner(0, 4));
    };
    // The first reading of depths comes with the 64th triangle, in the middle of a group of lanes.
    for (int i = 0; i < 15; ++i) add_square(i, 0.75);
    for (int i = 0; i < 16; ++i) add_square(i, 0.25);
    for (int i = 0; i < 16; ++i) add_square(i, 0.5);
    const ScreenGeometry geometry = geometry_of(scene, {.cull_back_faces = false}, run);
    const DepthBuffer cleared = cleared_depth(size, DepthFormat::d32f, false);
    const Visibility seen = drawn_over(cleared, geometry, DepthFunction::less, {}, run);
    int hidden = 0;
    for (const TileRecord& tile : seen.tiles) hidden += static_cast<int>(tile.hidden);
    return hidden;
}

}  // namespace

TEST_CASE("tiny triangles: depths, triangles and ties are those of one triangle after the other") {
    std::size_t tied_tiles = 0;
    for (std::uint64_t seed = 0; seed < 24; ++seed) {
        RandomSequence random(seed);
        const ClipSpaceScene scene = gravel(random, {70, 50}, 700);
        const DepthFormat format = seed % 3 == 0   ? DepthFormat::d16
                                   : seed % 3 == 1 ? DepthFormat::d24
                                                   : DepthFormat::d32f;
        const DepthBias bias = seed % 4 == 3 ? DepthBias{.constant = 1, .slope = 0.5f} : DepthBias{};
        const SetupSettings setup{.cull_back_faces = false, .format = format, .bias = bias};
        for (const DepthFunction test : kFunctions) {
            for_every_run({.threads = {2}}, [&](const Run& run) {
                INFO("seed " << seed << ", function " << static_cast<int>(test) << ", lanes " << run.lanes);
                const ScreenGeometry geometry = geometry_of(scene, setup, run);
                DepthBuffer before = cleared_depth(scene.size, format, false);
                before = drawn_over(before, geometry, DepthFunction::less, no_hole, run).depth;
                if (test != DepthFunction::equal) before = cleared_depth(scene.size, format, seed % 2 == 1);
                const Visibility asked = drawn_over(before, geometry, test, no_hole, run),
                                 unasked = drawn_over(before, geometry, test, {}, run);
                CHECK(differences(asked.depth.codes, unasked.depth.codes) == "");
                int other = 0;
                for (int y = 0; y < scene.size.height; ++y) {
                    for (int x = 0; x < scene.size.width; ++x)
                        other += asked.triangle.at(x, y) != unasked.triangle.at(x, y);
                }
                // Pixels that no triangle has reached hold anything.
                if (test == DepthFunction::less || test == DepthFunction::always) CHECK(other == 0);
                for (std::size_t i = 0; i < asked.tiles.size(); ++i) {
                    CHECK(asked.tiles[i].tied.empty() == unasked.tiles[i].tied.empty());
                    CHECK(asked.tiles[i].hidden == unasked.tiles[i].hidden);
                    tied_tiles += unasked.tiles[i].tied.empty() ? 0 : 1;
                }
            });
        }
    }
    CHECK(tied_tiles > 100);
}

TEST_CASE("tiny triangles: what lies behind them is left out at every lane count, padded rows or not") {
    for_every_run({.threads = {1}}, [](const Run& run) {
        CHECK(hidden_of_layers({16, 16}, run) == 31);
        CHECK(hidden_of_layers({15, 16}, run) == 31);
    });
}

TEST_CASE("tiny triangles: only those that lie in the tile as a whole, with a bias or without") {
    ScreenTriangle t{};
    t.bounds = {10, 20, 14, 24};
    const PixelRect tile = {8, 16, 16, 24};
    CHECK(TinyTriangles<float>::has(t, tile));
    CHECK_FALSE(TinyTriangles<float>::has(t, {8, 16, 13, 24}));
    CHECK_FALSE(TinyTriangles<float>::has(t, {11, 16, 16, 24}));
    CHECK_FALSE(TinyTriangles<float>::has(t, {8, 21, 16, 24}));
    CHECK_FALSE(TinyTriangles<float>::has(t, {8, 16, 16, 23}));
    t.bounds.x1 = 15;
    CHECK_FALSE(TinyTriangles<float>::has(t, tile));
    t.bounds.x1 = 14;
    t.depth_bias = 1e-9;
    CHECK(TinyTriangles<float>::has(t, tile));
}
