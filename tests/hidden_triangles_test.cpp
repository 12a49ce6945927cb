// Hierarchical depth: which triangles may be left out as a whole, at equality above all; and that leaving them out
// changes neither a depth nor a normal nor a count.
#include "rasterizer/hidden_triangles.h"

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include "rasterizer/image_summary.h"
#include "tests/clip_space_scene.h"
#include "tests/test_scenes.h"

using namespace crevice;

namespace {

constexpr DepthFormat kFormats[] = {DepthFormat::d16, DepthFormat::d24, DepthFormat::d32f};
constexpr DepthFunction kFunctions[] = {
    DepthFunction::never,   DepthFunction::less,      DepthFunction::equal,         DepthFunction::less_equal,
    DepthFunction::greater, DepthFunction::not_equal, DepthFunction::greater_equal, DepthFunction::always};
constexpr int kFirstReading = 64, kSecondReading = 128;  // triangles

// What is known of a tile after `triangles` triangles were drawn over these codes.
template <class F>
HiddenTriangles known_after(int triangles, const Image<std::int32_t>& codes, PixelRect tile) {
    HiddenTriangles hidden(tile);
    for (int i = 0; i < triangles; ++i) hidden.count_triangle<F>(codes);
    return hidden;
}

ScreenTriangle between(float z_low, float z_high) {
    ScreenTriangle t{};
    t.z_low = z_low;
    t.z_high = z_high;
    return t;
}

struct Drawn {
    Image<std::int32_t> count;
    DepthBuffer depth;
    std::uint32_t hidden = 0;
};

Drawn drawn_over(const DepthBuffer& before, const ScreenGeometry& geometry, DepthFunction test, Run run,
                 bool leaves_out) {
    if (!leaves_out) run.kept = KeptWork::only(Skip::hidden_triangles);
    Drawn drawn{Image<std::int32_t>(geometry.size, 0), before, 0};
    for (const TileRecord& record : rasterize(geometry, test, drawn.depth, CountingShader{drawn.count}, run))
        drawn.hidden += record.hidden;
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

std::string inequality(const Drawn& a, const Drawn& b) {
    return differences(a.depth.codes, b.depth.codes) + differences(a.count, b.count);
}

}  // namespace

TEST_CASE("hidden triangles: left out exactly when none of their codes passes against any stored code") {
    constexpr int kSpread = 5;
    const Size size = {16, 16};
    for (const DepthFormat format : kFormats) {
        const std::int32_t base = depth_code(format, 0.6f, 0.0);
        for (int stored = 0; stored < kSpread * kSpread; ++stored) {
            const int stored_low = stored % kSpread, stored_high = stored / kSpread;
            if (stored_low > stored_high) continue;
            Image<std::int32_t> codes(size, base + stored_low);
            codes.at(13, 9) = base + stored_high;
            const auto hidden = known_after<float>(kFirstReading, codes, {0, 0, 16, 16});
            for (int of_triangle = 0; of_triangle < kSpread * kSpread; ++of_triangle) {
                const int low = of_triangle % kSpread, high = of_triangle / kSpread;
                if (low > high) continue;
                const ScreenTriangle t = between(depth_from_code<float>(format, base + low),
                                                 depth_from_code<float>(format, base + high));
                REQUIRE(depth_code(format, t.z_low, 0.0) == base + low);
                REQUIRE(depth_code(format, t.z_high, 0.0) == base + high);
                for (const DepthFunction test : kFunctions) {
                    // One stored code is enough to be passed; every code between the bounds may be the triangle's.
                    bool passes = false, ties = false;
                    for (int code = low; code <= high; ++code) {
                        for (int at = stored_low; at <= stored_high; ++at) {
                            passes = passes || depth_passes<float>(test, code, at);
                            ties = ties || code == at;
                        }
                    }
                    const auto verdict = hidden.verdict(test, format, t, {0, 0, 16, 16});
                    INFO("format " << static_cast<int>(format) << ", function " << static_cast<int>(test)
                                   << ", stored " << stored_low << ".." << stored_high << ", triangle " << low
                                   << ".." << high);
                    // NOT_EQUAL hides only what equals a flat square: not worth a test.
                    if (test != DepthFunction::not_equal) REQUIRE(verdict.hidden == !passes);
                    if (passes) REQUIRE(!verdict.hidden);
                    if (verdict.hidden) REQUIRE(verdict.tied == ties);
                }
            }
        }
    }
}

TEST_CASE("hidden triangles: the bias counts, in codes") {
    for (const DepthFormat format : {DepthFormat::d16, DepthFormat::d24}) {
        const double code = 1 / (format == DepthFormat::d16 ? kD16Steps : kD24Steps);
        const std::int32_t stored = depth_code(format, 0.25f, 0.0);
        const auto hidden =
            known_after<float>(kFirstReading, Image<std::int32_t>({8, 8}, stored), {0, 0, 8, 8});
        ScreenTriangle t = between(0.25f, 0.25f);
        for (const int bias : {-2, -1, 0, 1, 2}) {
            t.depth_bias = bias * code;
            CAPTURE(bias);
            const auto is_hidden = [&](DepthFunction test) {
                return hidden.verdict(test, format, t, {0, 0, 8, 8}).hidden;
            };
            CHECK(is_hidden(DepthFunction::less) == (bias >= 0));
            CHECK(is_hidden(DepthFunction::less_equal) == (bias > 0));
            CHECK(is_hidden(DepthFunction::equal) == (bias != 0));
            CHECK(is_hidden(DepthFunction::greater) == (bias <= 0));
            CHECK(is_hidden(DepthFunction::greater_equal) == (bias < 0));
        }
    }
}

TEST_CASE_TEMPLATE("hidden triangles: one open pixel keeps its own square visible and no other", F, float,
                   Wide<8>) {
    RandomSequence random(3);
    const std::int32_t near_code = 100, far_code = 900;
    for (const PixelRect tile :
         {PixelRect{0, 0, 128, 128}, {128, 0, 173, 37}, {64, 32, 96, 64}, {8, 120, 16, 128}, {0, 0, 1, 1}}) {
        const Size size = {tile.x1, tile.y1};
        for (int i = 0; i < 60; ++i) {
            const glm::ivec2 open{random.whole(tile.x0, tile.x1 - 1), random.whole(tile.y0, tile.y1 - 1)};
            Image<std::int32_t> codes(size, near_code);
            codes.at(open.x, open.y) = far_code;
            const auto hidden = known_after<F>(kFirstReading, codes, tile);
            const int x = random.whole(tile.x0, tile.x1 - 1), y = random.whole(tile.y0, tile.y1 - 1);
            const PixelRect rect{x, y, random.whole(x + 1, tile.x1), random.whole(y + 1, tile.y1)};
            const auto square = [](int at, int from) { return (at - from) / HiddenTriangles::kSquare_px; };
            const bool reaches = square(open.x, tile.x0) >= square(rect.x0, tile.x0) &&
                                 square(open.x, tile.x0) <= square(rect.x1 - 1, tile.x0) &&
                                 square(open.y, tile.y0) >= square(rect.y0, tile.y0) &&
                                 square(open.y, tile.y0) <= square(rect.y1 - 1, tile.y0);
            INFO("open pixel (" << open.x << ", " << open.y << "), rectangle " << rect.x0 << "," << rect.y0
                                << " to " << rect.x1 << "," << rect.y1);
            const ScreenTriangle t = between(float_from_bits(500), float_from_bits(600));
            REQUIRE(hidden.verdict(DepthFunction::less, DepthFormat::d32f, t, rect).hidden == !reaches);
        }
    }
}

TEST_CASE("hidden triangles: nothing is known before the first reading, and old readings still hold") {
    const PixelRect tile{0, 0, 16, 16};
    const ScreenTriangle t = between(float_from_bits(500), float_from_bits(500));
    const auto is_hidden = [&](const HiddenTriangles& hidden) {
        return hidden.verdict(DepthFunction::less, DepthFormat::d32f, t, tile).hidden;
    };
    const Image<std::int32_t> far_away({16, 16}, 900), near_by({16, 16}, 100);
    CHECK(!is_hidden(known_after<float>(kFirstReading - 1, near_by, tile)));
    HiddenTriangles hidden = known_after<float>(kFirstReading, far_away, tile);
    for (int i = kFirstReading; i < kSecondReading; ++i) {
        CHECK(!is_hidden(hidden));
        hidden.count_triangle<float>(near_by);
    }
    CHECK(is_hidden(hidden));
}

TEST_CASE("hidden triangles: stacks drawn with and without leaving out, all functions, formats and biases") {
    const Size size = {83, 61};
    for (std::uint64_t seed = 0; seed < 96; ++seed) {
        RandomSequence random(seed);
        const DepthFunction test = kFunctions[seed % 8];
        const SetupSettings setup{false, kFormats[seed / 8 % 3],
                                  {.constant = random.whole(-1, 1) * 40,
                                   .slope = static_cast<float>(random.between(-2, 2)),
                                   .clamp = seed % 5 == 0 ? 0.01f : 0.0f}};
        const bool nearest_first = seed / 24 % 2 == 0;
        const Run run{.threads = 1, .lanes = seed % 3 == 0 ? 1 : 8, .tile_size = 16 << seed % 4};
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

TEST_CASE("hidden triangles: none where each layer lies in front of all before") {
    for (const int tile_size : {8, 64, 128}) {
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
