// Triangles of a few pixels: the set-up knows which they cover, and drawn pixel by pixel they leave what they leave when
// they are drawn group by group, as they are where somebody asks for holes.
#include "rasterizer/draw/tiny_triangles.h"

#include <doctest/doctest.h>

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

// Cuts nothing out, so that no triangle is drawn as a tiny one.
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
    // The first reading of depths comes with the 64th triangle.
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

TEST_CASE(
    "tiny triangles: beside cut-outs, those of whole materials leave what they leave when holes are asked of "
    "all") {
    constexpr std::int32_t kCut = 1, kMaterials = 3;
    const auto cut = [](const FragmentGroup& group) {
        for (int i = 0; i < group.lanes; ++i) {
            if (group.triangle.material == kCut && (group.x + i + group.y) % 3 == 0) group.kept[i] = 0;
        }
    };
    const auto only_the_cut = [&](const FragmentGroup& group) {
        CHECK(group.triangle.material == kCut);
        cut(group);
    };
    for (std::uint64_t seed = 0; seed < 24; ++seed) {
        RandomSequence random(seed);
        const ClipSpaceScene scene = gravel(random, {70, 50}, 700);
        for_every_run({.threads = {1}}, [&](const Run& run) {
            CAPTURE(seed);
            ScreenGeometry geometry = geometry_of(scene, {.cull_back_faces = false}, run);
            std::int32_t material = 0;
            for (TriangleBlock& block : geometry.blocks) {
                for (ScreenTriangle& t : block.triangles) t.material = material++ % kMaterials;
            }
            const Visibility all = visibility(geometry, DepthFormat::d32f, false, cut, run),
                             some = visibility(geometry, DepthFormat::d32f, false,
                                               {only_the_cut, {true, false, true}}, run);
            CHECK(differences(all.depth.codes, some.depth.codes) == "");
            CHECK(differences(all.triangle, some.triangle) == "");
            for (std::size_t i = 0; i < all.tiles.size(); ++i) {
                CHECK(all.tiles[i].tied.empty() == some.tiles[i].tied.empty());
                CHECK(all.tiles[i].hidden == some.tiles[i].hidden);
            }
        });
    }
}

TEST_CASE("tiny triangles: what lies behind them is left out at every lane count, padded rows or not") {
    for_every_run({.threads = {1}}, [](const Run& run) {
        CHECK(hidden_of_layers({16, 16}, run) == 31);
        CHECK(hidden_of_layers({15, 16}, run) == 31);
    });
}

TEST_CASE("tiny triangles: the set-up knows the covered pixels, and drops those that cover none") {
    int covering = 0, dropped = 0, larger = 0;
    for (std::uint64_t seed = 0; seed < 20000; ++seed) {
        RandomSequence random(seed);
        // On a coarse grid in one of two, so that centres lie on edges and corners.
        const int step = random.whole(0, 1) == 0 ? 1 : kSubpixelSteps / 4,
                  reach = random.whole(1, 5) * kSubpixelSteps;
        const std::int32_t left = random.whole(-4000, 4000) * step, top = random.whole(-4000, 4000) * step;
        std::array<ProjectedVertex, 3> corners{};
        for (ProjectedVertex& v : corners) {
            v.x = left + random.whole(0, reach / step) * step;
            v.y = top + random.whole(0, reach / step) * step;
            v.inverse_w = 1;
        }
        // Twice the area of the triangle of corners a and b and a point, positive inside where a, b, c are clockwise.
        const auto side = [&](std::size_t a, std::size_t b, std::int64_t x, std::int64_t y) {
            return std::int64_t{corners[b].x - corners[a].x} * (y - corners[a].y) -
                   std::int64_t{corners[b].y - corners[a].y} * (x - corners[a].x);
        };
        if (side(0, 1, corners[2].x, corners[2].y) < 0) std::swap(corners[1], corners[2]);
        const std::int64_t area = side(0, 1, corners[2].x, corners[2].y);
        const auto covers = [&](int px, int py) {
            for (std::size_t a = 0; a < 3; ++a) {
                const std::size_t b = (a + 1) % 3;
                const std::int64_t e = side(a, b, px * kSubpixelSteps + kSubpixelSteps / 2,
                                            py * kSubpixelSteps + kSubpixelSteps / 2);
                const bool owns = corners[b].y < corners[a].y ||
                                  (corners[b].y == corners[a].y && corners[b].x > corners[a].x);
                if (e < 0 || (e == 0 && !owns)) return false;
            }
            return area > 0;
        };
        CAPTURE(seed);
        const auto set_up = set_up_triangle({&corners[0], &corners[1], &corners[2]}, {});
        int expected = 0, actual = 0;
        for (int y = top / kSubpixelSteps - 1; y < top / kSubpixelSteps + 8; ++y) {
            for (int x = left / kSubpixelSteps - 1; x < left / kSubpixelSteps + 8; ++x)
                expected += covers(x, y);
        }
        if (!set_up) {
            REQUIRE(expected == 0);
            ++dropped;
            continue;
        }
        const ScreenTriangle& t = set_up->triangle;
        const bool tiny =
            t.bounds.x1 - t.bounds.x0 <= kTinyTriangle_px && t.bounds.y1 - t.bounds.y0 <= kTinyTriangle_px;
        if (!tiny) {
            REQUIRE(t.covered == 0);
            ++larger;
            continue;
        }
        tiny_fragments(t, [&](int x, int y, float) {
            REQUIRE(covers(x, y));
            ++actual;
        });
        REQUIRE(expected > 0);
        REQUIRE(actual == expected);
        ++covering;
    }
    CHECK(covering > 5000);
    CHECK(dropped > 2000);
    CHECK(larger > 500);
}
