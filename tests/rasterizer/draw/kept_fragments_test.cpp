// Cut-outs: fragments that a shader drops leave no depth, hide nothing, tie with nothing, and are missed by a
// second pass in just the same places.
#include <cmath>

#include <doctest/doctest.h>

#include "rasterizer/base/hash.h"
#include "rasterizer/draw/triangle_pixels.h"
#include "tests/tools/clip_space_scene.h"
#include "tests/tools/every_run.h"
#include "tests/tools/random_sequence.h"

using namespace crevice;

namespace {

// Each triangle of a scene made by add_triangle has three vertices of its own.
std::int32_t triangle_number(const ScreenTriangle& t) { return static_cast<std::int32_t>(t.vertex[0] / 3); }

// Holes in every triangle, each its own: pixels whose hash with the triangle is odd.
bool in_hole(std::int32_t triangle, int x, int y) {
    return (hash_of(static_cast<std::uint32_t>(triangle), static_cast<std::uint32_t>(x),
                    static_cast<std::uint32_t>(y)) &
            64) != 0;
}
// Cuts the pixels out of a triangle for which in_hole(triangle, x, y) holds.
template <class InHole>
Holes cut_where(const InHole& in_hole_of) {
    return [in_hole_of](const FragmentGroup& group) {
        for (int i = 0; i < group.lanes; ++i) {
            if (in_hole_of(group.triangle, group.x + i, group.y)) group.kept[i] = 0;
        }
    };
}
const Holes kHashedHoles =
    cut_where([](const ScreenTriangle& t, int x, int y) { return in_hole(triangle_number(t), x, y); });

// A hole where both perspective-correct coordinates lie below 0.4.
const Holes kCornerHole = cut_where([](const ScreenTriangle& t, int x, int y) {
    const Barycentric<float> here = TrianglePixels<float>({&t, nullptr}, true, x, y).here;
    return here.lambda1 < 0.4f && here.lambda2 < 0.4f;
});

// One pixel in all triangles but the last of many.
constexpr int kLayers = 200;
constexpr glm::ivec2 kHole(40, 23);
const Holes kOnePixelHole = cut_where([](const ScreenTriangle& t, int x, int y) {
    return triangle_number(t) != kLayers && x == kHole.x && y == kHole.y;
});

// Of all triangles but the first what lies before a column.
Holes cut_before(int column) {
    return cut_where(
        [=](const ScreenTriangle& t, int x, int) { return triangle_number(t) != 0 && x < column; });
}

// Triangles of all sizes at depths in steps of 1/16: many tie.
ClipSpaceScene rubble(std::uint64_t seed, Size size, int count) {
    RandomSequence random(seed);
    ClipSpaceScene scene{size, {}, {}};
    for (int i = 0; i < count; ++i) {
        const double z = random.whole(1, 15) / 16.0, reach = std::exp2(random.between(3, 8));
        const double x = random.between(0, size.width), y = random.between(0, size.height);
        glm::vec4 corner[3];
        for (glm::vec4& p : corner) {
            const double px = x + random.between(-reach, reach), py = y + random.between(-reach, reach);
            p = scene.at_screen(px, py, z);
        }
        scene.add_triangle(corner[0], corner[1], corner[2]);
    }
    return scene;
}

// One triangle after the other, each drawn alone without holes; the holes are then left out by hand.
Image<std::int32_t> by_hand(const ClipSpaceScene& scene, DepthFormat format) {
    const std::int32_t clear = depth_code(format, 1.0f, 0.0);
    Image<std::int32_t> codes(scene.size, clear);
    for (std::size_t i = 0; i < scene.triangles.size(); ++i) {
        ClipSpaceScene alone = scene;
        alone.triangles = {scene.triangles[i]};
        const CountedDrawing drawing =
            draw(alone, DepthFunction::always, {.cull_back_faces = false, .format = format});
        for (int y = 0; y < scene.size.height; ++y) {
            for (int x = 0; x < scene.size.width; ++x) {
                const bool kept = drawing.count.at(x, y) == 1 && !in_hole(static_cast<std::int32_t>(i), x, y);
                if (kept) codes.at(x, y) = std::min(codes.at(x, y), drawing.depth.codes.at(x, y));
            }
        }
    }
    return codes;
}

constexpr DepthFormat kFormats[] = {DepthFormat::d16, DepthFormat::d24, DepthFormat::d32f};

}  // namespace

TEST_CASE("cut-outs: depths are those of the kept fragments, for all formats, lanes and tiles") {
    const ClipSpaceScene scene = rubble(1, {75, 51}, 150);
    for (const DepthFormat format : kFormats) {
        const Image<std::int32_t> expected = by_hand(scene, format);
        for (const int lanes : {1, 0}) {
            for (const int tile_size : {16, 64}) {
                for (const KeptWork kept : {KeptWork(), KeptWork::only(Skip::hidden_triangles)}) {
                    const Run run{.threads = 2, .lanes = lanes, .tile_size = tile_size, .kept = kept};
                    const DepthBuffer depth =
                        nearest_depth(geometry_of(scene, {.cull_back_faces = false, .format = format}, run),
                                      format, kHashedHoles, run);
                    CAPTURE(static_cast<int>(format));
                    CAPTURE(lanes);
                    CAPTURE(tile_size);
                    CHECK(differences(depth.codes, expected) == "");
                }
            }
        }
    }
}

TEST_CASE("cut-outs: the far triangle shows through the hole of the near one, whichever is drawn first") {
    // Both coordinates are 0 in the topmost corner: the near one's is the picture's upper left corner, the
    // far one's is far above the picture.
    const Size size = {64, 64};
    for (const bool near_first : {true, false}) {
        ClipSpaceScene scene{size, {}, {}};
        const auto corner = [&](double x, double y, double z) { return scene.at_screen(x, y, z); };
        const auto add_near = [&] {
            scene.add_triangle(corner(0, 0, 0.25), corner(128, 0, 0.25), corner(0, 128, 0.25));
        };
        const auto add_far = [&] {
            scene.add_triangle(corner(32, -2000, 0.75), corner(2000, 100, 0.75), corner(-2000, 100, 0.75));
        };
        if (near_first) add_near();
        add_far();
        if (!near_first) add_near();
        const DepthBuffer depth =
            nearest_depth(geometry_of(scene), DepthFormat::d32f, kCornerHole, kPlainRun);
        CAPTURE(near_first);
        for (int y = 0; y < size.height; ++y) {
            for (int x = 0; x < size.width; ++x) {
                const bool hole = x + 0.5 < 0.4 * 128 && y + 0.5 < 0.4 * 128;
                CAPTURE(x);
                CAPTURE(y);
                REQUIRE(depth_from_code<float>(DepthFormat::d32f, depth.codes.at(x, y)) ==
                        (hole ? 0.75f : 0.25f));
            }
        }
    }
}

TEST_CASE("cut-outs: a triangle with holes does not hide what is behind them") {
    // Far more layers than HiddenTriangles waits for, then one triangle behind all of them.
    const Size size = {64, 64};
    ClipSpaceScene scene{size, {}, {}};
    const auto add = [&](double z) {
        scene.add_triangle(scene.at_screen(-1, -1, z), scene.at_screen(200, -1, z),
                           scene.at_screen(-1, 200, z));
    };
    for (int i = 0; i < kLayers; ++i) add(0.25 + 0.001 * i);
    add(0.75);
    const ScreenGeometry geometry = geometry_of(scene);
    const Visibility seen = visibility(geometry, DepthFormat::d32f, false, kOnePixelHole, kPlainRun);
    const DepthBuffer& depth = seen.depth;
    CHECK(depth_from_code<float>(DepthFormat::d32f, depth.codes.at(kHole.x, kHole.y)) == 0.75f);
    CHECK(depth_from_code<float>(DepthFormat::d32f, depth.codes.at(kHole.x - 1, kHole.y)) == 0.25f);
    // Later layers could pass in the hole, for all that is known of their square: none is left out.
    CHECK(seen.tiles.at(0).hidden == 0);
    // Without the hole, all layers after the first reading are.
    CHECK(visibility(geometry, DepthFormat::d32f, false, {}, kPlainRun).tiles.at(0).hidden > kLayers / 2);
}

TEST_CASE("cut-outs: only kept fragments tie") {
    const Size size = {32, 16};
    ClipSpaceScene scene{size, {}, {}};
    for (int i = 0; i < 2; ++i) {
        scene.add_triangle(scene.at_screen(0, 0), scene.at_screen(64, 0), scene.at_screen(0, 64));
    }
    const ScreenGeometry geometry = geometry_of(scene);
    const auto tied = [&](int from) {
        return visibility(geometry, DepthFormat::d32f, false, cut_before(from), kPlainRun).tiles.at(0).tied;
    };
    CHECK(tied(32).empty());
    CHECK(tied(20) == PixelRect{kRowAlignment, 0, 32, 16});
    CHECK(tied(0) == PixelRect{0, 0, 32, 16});
}

TEST_CASE("cut-outs: EQUAL finds what the first pass left, and nothing in the holes") {
    const ClipSpaceScene scene = rubble(2, {75, 51}, 25);
    const ScreenGeometry geometry = geometry_of(scene);
    const Visibility seen = visibility(geometry, DepthFormat::d32f, false, kHashedHoles, kPlainRun);
    const DepthBuffer& depth = seen.depth;
    const auto drawn_with = [&](const Holes& holes) {
        return drawn_again(geometry, depth, DepthFunction::equal, holes, kPlainRun);
    };
    const Image<std::int32_t> again = drawn_with(kHashedHoles), careless = drawn_with({});
    const std::int32_t clear = depth_code(DepthFormat::d32f, 1.0f, 0.0);
    int surface = 0, background = 0, lit_holes = 0;
    for (int y = 0; y < scene.size.height; ++y) {
        for (int x = 0; x < scene.size.width; ++x) {
            const bool drawn = depth.codes.at(x, y) != clear;
            CAPTURE(x);
            CAPTURE(y);
            CHECK((again.at(x, y) != kNoTriangle) == drawn);
            CHECK((seen.triangle.at(x, y) != kNoTriangle) == drawn);
            lit_holes += careless.at(x, y) != again.at(x, y);
            (drawn ? surface : background) += 1;
        }
    }
    CHECK(surface > 2000);
    CHECK(background > 10);
    // A second pass that forgets the holes lights fragments that the first one dropped.
    CHECK(lit_holes > 0);
}
