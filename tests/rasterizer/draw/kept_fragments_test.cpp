// Cut-outs: fragments that a shader drops leave no depth, hide nothing, tie with nothing, and are missed by a
// second pass in just the same places.
#include <cmath>

#include <doctest/doctest.h>

#include "rasterizer/base/hash.h"
#include "rasterizer/draw/depth_only.h"
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
struct HashedHoles {
    template <class F>
    CREVICE_INLINE Mask<F> kept(const ScreenGeometry&, const ScreenTriangle& t, const Fragment<F>& f) const {
        std::int32_t open[kLanes<F>];
        for (int i = 0; i < kLanes<F>; ++i) open[i] = in_hole(triangle_number(t), f.x + i, f.y) ? 1 : 0;
        return load<F>(open) == Int<F>(0);
    }
};

// A hole where both perspective-correct coordinates lie below 0.4.
struct CornerHole {
    template <class F>
    CREVICE_INLINE Mask<F> kept(const ScreenGeometry&, const ScreenTriangle&, const Fragment<F>& f) const {
        return !((f.here.lambda1 < F(0.4f)) & (f.here.lambda2 < F(0.4f)));
    }
};

// One pixel in all triangles but the last of many.
constexpr int kLayers = 200;
constexpr glm::ivec2 kHole(40, 23);
struct OnePixelHole {
    template <class F>
    CREVICE_INLINE Mask<F> kept(const ScreenGeometry&, const ScreenTriangle& t, const Fragment<F>& f) const {
        const Int<F> column = lane_index<F>() + Int<F>(f.x);
        const auto last = Int<F>(triangle_number(t)) == Int<F>(kLayers);
        return last | (column != Int<F>(kHole.x)) | (Int<F>(f.y) != Int<F>(kHole.y));
    }
};

// All of triangle 0, of the others what lies from a column on.
struct FromColumn {
    int column;
    template <class F>
    CREVICE_INLINE Mask<F> kept(const ScreenGeometry&, const ScreenTriangle& t, const Fragment<F>& f) const {
        const auto first = Int<F>(triangle_number(t)) == Int<F>(0);
        return first | (lane_index<F>() + Int<F>(f.x) >= Int<F>(column));
    }
};

// A second pass of the same geometry, holes and all.
template <class Cutouts>
struct CountingKept : CountingShader {
    const ScreenGeometry& geometry;
    const Cutouts& cutouts;
    CountingKept(Image<std::int32_t>& target, const ScreenGeometry& g, const Cutouts& c)
        : CountingShader{target}, geometry(g), cutouts(c) {}
    template <class F>
    CREVICE_INLINE Mask<F> kept(const ScreenTriangle& t, const Fragment<F>& f) const {
        return cutouts.template kept<F>(geometry, t, f);
    }
};

static_assert(!DropsFragments<CountingShader> && !DropsFragments<DepthOnlyShader>);
static_assert(DropsFragments<CountingKept<HashedHoles>> && DropsFragments<CutDepthShader<CornerHole>>);

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
            for (const int tile_size : {8, 64}) {
                for (const KeptWork kept : {KeptWork(), KeptWork::only(Skip::hidden_triangles)}) {
                    const Run run{.threads = 2, .lanes = lanes, .tile_size = tile_size, .kept = kept};
                    const DepthBuffer depth =
                        draw_depth(geometry_of(scene, {.cull_back_faces = false, .format = format}, run),
                                   format, HashedHoles{}, run);
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
        const DepthBuffer depth = draw_depth(geometry_of(scene), DepthFormat::d32f, CornerHole{}, kPlainRun);
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
    DepthBuffer depth = cleared_depth(size, DepthFormat::d32f, false);
    const OnePixelHole holes{};
    const CutDepthShader<OnePixelHole> shader(depth, geometry, holes);
    const auto records = rasterize(geometry, DepthFunction::less, depth, shader, kPlainRun);
    CHECK(depth_from_code<float>(DepthFormat::d32f, depth.codes.at(kHole.x, kHole.y)) == 0.75f);
    CHECK(depth_from_code<float>(DepthFormat::d32f, depth.codes.at(kHole.x - 1, kHole.y)) == 0.25f);
    // Later layers could pass in the hole, for all that is known of their square: none is left out.
    CHECK(records.at(0).hidden == 0);
    // Without the hole, all layers after the first reading are.
    DepthBuffer whole = cleared_depth(size, DepthFormat::d32f, false);
    CHECK(rasterize(geometry, DepthFunction::less, whole, DepthOnlyShader{whole}, kPlainRun).at(0).hidden >
          kLayers / 2);
}

TEST_CASE("cut-outs: only kept fragments tie") {
    const Size size = {16, 16};
    ClipSpaceScene scene{size, {}, {}};
    for (int i = 0; i < 2; ++i) {
        scene.add_triangle(scene.at_screen(0, 0), scene.at_screen(32, 0), scene.at_screen(0, 32));
    }
    const ScreenGeometry geometry = geometry_of(scene);
    const auto tied = [&](int from) {
        DepthBuffer depth = cleared_depth(size, DepthFormat::d32f, false);
        const FromColumn holes{from};
        const CutDepthShader<FromColumn> shader(depth, geometry, holes);
        return rasterize(geometry, DepthFunction::less, depth, shader, kPlainRun).at(0).tied;
    };
    CHECK(tied(16).empty());
    CHECK(tied(8) == PixelRect{8, 0, 16, 16});
    CHECK(tied(0) == PixelRect{0, 0, 16, 16});
}

TEST_CASE("cut-outs: EQUAL finds what the first pass left, and nothing in the holes") {
    const ClipSpaceScene scene = rubble(2, {75, 51}, 25);
    const ScreenGeometry geometry = geometry_of(scene);
    const DepthBuffer depth = draw_depth(geometry, DepthFormat::d32f, HashedHoles{}, kPlainRun);
    const HashedHoles holes{};
    const auto count_with = [&](const auto& shader_for) {
        Image<std::int32_t> count(scene.size, 0);
        rasterize(geometry, DepthFunction::equal, depth, shader_for(count), kPlainRun);
        return count;
    };
    const Image<std::int32_t> count =
        count_with([&](Image<std::int32_t>& c) { return CountingKept<HashedHoles>(c, geometry, holes); });
    const Image<std::int32_t> careless = count_with([](Image<std::int32_t>& c) { return CountingShader{c}; });
    const std::int32_t clear = depth_code(DepthFormat::d32f, 1.0f, 0.0);
    int surface = 0, background = 0;
    for (int y = 0; y < scene.size.height; ++y) {
        for (int x = 0; x < scene.size.width; ++x) {
            const bool drawn = depth.codes.at(x, y) != clear;
            CAPTURE(x);
            CAPTURE(y);
            CHECK((count.at(x, y) >= 1) == drawn);
            (drawn ? surface : background) += 1;
        }
    }
    CHECK(surface > 2000);
    CHECK(background > 10);
    // A second pass that forgets the holes lights fragments that the first one dropped.
    CHECK(total(careless) > total(count));
}
