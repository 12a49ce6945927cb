#include "rasterizer/draw/depth_buffer.h"

#include <initializer_list>
#include <limits>

#include <doctest/doctest.h>

#include "tests/tools/clip_space_scene.h"

using namespace crevice;

namespace {

constexpr DepthFormat kFormats[] = {DepthFormat::d16, DepthFormat::d24, DepthFormat::d32f};

std::int32_t last_code(DepthFormat format) { return depth_code(format, 1.0f, 0.0); }

// How many of all codes do not come back when the depth they stand for is encoded again, by `encode`(Wide<8>
// z).
template <class Encode>
int failed_round_trips(DepthFormat format, const Encode& encode) {
    int failures = 0;
    for (std::int32_t first = 0; first <= last_code(format); first += 8) {
        const WideInt<8> codes = WideInt<8>(first) + lane_index<Wide<8>>();
        const WideInt<8> back = encode(depth_from_code<Wide<8>>(format, codes));
        for (int lane = 0; lane < 8; ++lane) failures += back[lane] != first + lane;
    }
    return failures;
}

// A full-screen quad of 256x8 pixels whose depth runs from z_left to z_right.
ClipSpaceScene ramp(float z_left, float z_right) {
    ClipSpaceScene scene{{256, 8}, {}, {}};
    scene.add_quad({-1, 1, z_left, 1}, {1, 1, z_right, 1}, {1, -1, z_right, 1}, {-1, -1, z_left, 1});
    return scene;
}

SetupSettings biased(DepthFormat format, DepthBias bias) { return {false, format, bias}; }

Image<std::int32_t> codes_of(const ClipSpaceScene& scene, DepthFormat format, DepthBias bias) {
    return draw(scene, DepthFunction::always, biased(format, bias)).depth.codes;
}

Image<std::int32_t> plus(Image<std::int32_t> codes, std::int32_t step) {
    for (std::int32_t& code : codes.pixels) code += step;
    return codes;
}

}  // namespace

TEST_CASE("known codes, by one lane and by eight") {
    const auto check = [](DepthFormat format, float z, std::int32_t expected) {
        CAPTURE(static_cast<int>(format));
        CAPTURE(z);
        CHECK(depth_code(format, z, 0.0) == expected);
        CHECK(depth_code(format, Wide<8>(z), 0.0)[7] == expected);
    };
    check(DepthFormat::d16, 0.5f, 32768);
    check(DepthFormat::d24, 0.5f, 8388608);
    check(DepthFormat::d16, 0.3f, 19661);
    check(DepthFormat::d24, 0.3f, 5033165);
    check(DepthFormat::d32f, 0.3f, 0x3e99999a);
    const float nan = std::numeric_limits<float>::quiet_NaN(), inf = std::numeric_limits<float>::infinity();
    const std::int32_t ones[] = {65535, 16777215, 0x3f800000};
    for (const DepthFormat format : kFormats) {
        for (const float low : {0.0f, -0.0f, -1.0f, -inf, nan, -nan}) check(format, low, 0);
        for (const float high : {1.0f, 1.5f, 1e30f, inf}) check(format, high, ones[static_cast<int>(format)]);
    }
}

TEST_CASE("every code of D16 and D24 comes back from its depth") {
    for (const DepthFormat format : {DepthFormat::d16, DepthFormat::d24}) {
        CAPTURE(static_cast<int>(format));
        CHECK(failed_round_trips(
                  format, [&](Wide<8> z)
                              __attribute__((always_inline)) { return depth_code(format, z, 0.0); }) == 0);
        int failures = 0;
        for (std::int32_t code = 0; code <= last_code(format); code += format == DepthFormat::d16 ? 1 : 13) {
            failures += depth_code(format, depth_from_code<float>(format, code), 0.0) != code;
        }
        CHECK(failures == 0);
    }
    for (std::int32_t code = 0; code <= last_code(DepthFormat::d32f); code += 400009) {
        CAPTURE(code);
        CHECK(depth_code(DepthFormat::d32f, depth_from_code<float>(DepthFormat::d32f, code), 0.0) == code);
    }
}

TEST_CASE("the check above finds the encoder that works in float") {
    const int failures = failed_round_trips(
        DepthFormat::d24, [](Wide<8> z) __attribute__((always_inline)) {
            return to_int(z * Wide<8>(16777215.0f) + Wide<8>(0.5f));
        });
    CHECK(failures > 4000000);
}

TEST_CASE("codes grow with depth") {
    for (const DepthFormat format : kFormats) {
        CAPTURE(static_cast<int>(format));
        int previous = 0;
        for (int i = 0; i <= 100000; ++i) {
            const std::int32_t code = depth_code(format, static_cast<float>(i) / 100000, 0.0);
            if (code < previous) FAIL("code falls at step " << i);
            previous = code;
        }
    }
}

TEST_CASE("the eight depth functions") {
    // Columns: the fragment is nearer than, as far as, or further than what is stored.
    const std::int32_t stored = 1000;
    const std::int32_t codes[] = {999, 1000, 1001};
    const struct {
        DepthFunction function;
        bool passes[3];
    } table[] = {
        {DepthFunction::never, {false, false, false}},       {DepthFunction::less, {true, false, false}},
        {DepthFunction::equal, {false, true, false}},        {DepthFunction::less_equal, {true, true, false}},
        {DepthFunction::greater, {false, false, true}},      {DepthFunction::not_equal, {true, false, true}},
        {DepthFunction::greater_equal, {false, true, true}}, {DepthFunction::always, {true, true, true}},
    };
    for (const auto& row : table) {
        for (int i = 0; i < 3; ++i) {
            CAPTURE(static_cast<int>(row.function));
            CAPTURE(codes[i]);
            CHECK(depth_passes<float>(row.function, codes[i], stored) == row.passes[i]);
            CHECK(depth_passes<Wide<8>>(row.function, WideInt<8>(codes[i]), WideInt<8>(stored))[3] ==
                  row.passes[i]);
            // And drawn: a plane at the depth of the stored code, one nearer, one further.
            const ClipSpaceScene plane = ramp(0.5f, 0.5f);
            const DepthBuffer depth = draw(plane, DepthFunction::always, biased(DepthFormat::d16, {})).depth;
            const std::int32_t before = depth.codes.at(0, 0);
            const ScreenGeometry moved = geometry_of(plane, biased(DepthFormat::d16, {.constant = i - 1}));
            const CountedDrawing over = counted(moved, row.function, depth);
            CHECK(differences(over.count, row.passes[i]) == "");
            CHECK(differences(over.depth.codes, row.passes[i] ? before + i - 1 : before) == "");
        }
    }
}

TEST_CASE("a constant bias of 1 is one code everywhere, and -1 makes LESS pass everywhere") {
    for (const DepthFormat format : {DepthFormat::d16, DepthFormat::d24}) {
        CAPTURE(static_cast<int>(format));
        for (const glm::vec2 ends : {glm::vec2(0.3f, 0.5f),
                                     {0.5f, 0.5f},
                                     {0.25f, 0.75f},
                                     {0.0f, 1.0f},
                                     {0.99f, 0.1f},
                                     {0.1f, 0.1f},
                                     {0.7f, 0.7f},
                                     {1e-6f, 0.9f}}) {
            CAPTURE(ends.x);
            CAPTURE(ends.y);
            const ClipSpaceScene scene = ramp(ends.x, ends.y);
            const CountedDrawing plain = draw(scene, DepthFunction::always, biased(format, {}));
            for (const int constant : {1, -1, 7, 100}) {
                CAPTURE(constant);
                Image<std::int32_t> expected = plus(plain.depth.codes, constant);
                for (std::int32_t& code : expected.pixels) code = clamp_int(code, 0, last_code(format));
                CHECK(differences(codes_of(scene, format, {.constant = constant}), expected) == "");
            }
            const ScreenGeometry nearer = geometry_of(scene, biased(format, {.constant = -1}));
            if (ends.x > 0.001f)
                CHECK(differences(counted(nearer, DepthFunction::less, plain.depth).count, 1) == "");
        }
    }
}

TEST_CASE("a slope bias of 1 on a slope of .2 over 256 pixels adds 7.8125e-4; a flat triangle gets none") {
    const double slope = (static_cast<double>(0.5f) - static_cast<double>(0.3f)) / 256;
    CHECK(std::abs(slope - 7.8125e-4) < 1e-9);
    for (const DepthFormat format : kFormats) {
        CAPTURE(static_cast<int>(format));
        for (const ClipSpaceScene& scene : {ramp(0.3f, 0.5f), ramp(0.5f, 0.3f)}) {
            const Image<std::int32_t> plain = codes_of(scene, format, {}),
                                      sloped = codes_of(scene, format, {.slope = 1});
            // Both are rounded to a code, of D16 or finer.
            const double tolerance = format == DepthFormat::d16 ? 1.6e-5 : 1.3e-7;
            for (int x = 0; x < scene.size.width; ++x) {
                CAPTURE(x);
                const double z = static_cast<double>(depth_from_code<float>(format, plain.at(x, 4)));
                const double z_sloped = static_cast<double>(depth_from_code<float>(format, sloped.at(x, 4)));
                CHECK(std::abs(z_sloped - z - slope) < tolerance);
            }
        }
        for (const float z : {0.0f, 0.3f, 0.5f, 1.0f}) {
            CAPTURE(z);
            const ClipSpaceScene flat = ramp(z, z);
            CHECK(differences(codes_of(flat, format, {.slope = 1000}), codes_of(flat, format, {})) == "");
        }
    }
    CHECK(differences(codes_of(ramp(0.3f, 0.5f), DepthFormat::d24, {.slope = 1}),
                      codes_of(ramp(0.3f, 0.5f), DepthFormat::d24, {.slope = 1, .clamp = 1})) == "");
}

TEST_CASE("the bias is clamped, and depth stays within [0, 1]") {
    for (const DepthFormat format : kFormats) {
        CAPTURE(static_cast<int>(format));
        const ClipSpaceScene scene = ramp(0.3f, 0.5f);
        for (const float sign : {1.0f, -1.0f}) {
            const DepthBias clamped = {.slope = sign * 1e6f, .clamp = 0.125f};
            const float plain = depth_from_code<float>(format, codes_of(scene, format, {}).at(9, 3));
            const float moved = depth_from_code<float>(format, codes_of(scene, format, clamped).at(9, 3));
            CHECK(absolute(moved - plain - sign * 0.125f) < 1.6e-5f);
        }
        CHECK(differences(codes_of(scene, format, {.slope = 1e9f}), last_code(format)) == "");
        CHECK(differences(codes_of(scene, format, {.slope = -1e9f}), 0) == "");
        CHECK(differences(codes_of(scene, format, {.constant = std::numeric_limits<int>::max()}),
                          last_code(format)) == "");
        CHECK(differences(codes_of(scene, format, {.constant = -std::numeric_limits<int>::max()}), 0) == "");
        // Pushed beyond the far end, nothing is further than what is stored there.
        const DepthBuffer full = draw(ramp(1, 1), DepthFunction::always, biased(format, {})).depth;
        const ScreenGeometry beyond = geometry_of(ramp(1, 1), biased(format, {.constant = 1000}));
        CHECK(total(counted(beyond, DepthFunction::greater, full).count) == 0);
    }
}

TEST_CASE("the unit of a float bias is the last bit of the largest depth") {
    for (const float z : {0.3f, 0.5f, 0.7f, 0.999f, 1e-3f, 1e-7f}) {
        CAPTURE(z);
        const Image<std::int32_t> plain = codes_of(ramp(z, z), DepthFormat::d32f, {});
        for (const int constant : {1, -1, 1000}) {
            CAPTURE(constant);
            if (z == 0.5f && constant < 0) continue;  // below a power of two the last bit is half as large
            CHECK(differences(codes_of(ramp(z, z), DepthFormat::d32f, {.constant = constant}),
                              plus(plain, constant)) == "");
        }
    }
    CHECK(differences(codes_of(ramp(0.5f, 0.5f), DepthFormat::d32f, {.constant = -1}), 0x3f000000 - 2) == "");
}

TEST_CASE("cleared buffers") {
    for (const DepthFormat format : kFormats) {
        CAPTURE(static_cast<int>(format));
        for (const bool reversed_z : {false, true}) {
            const Image<float> depth = ndc_depth(cleared_depth({13, 3}, format, reversed_z));
            for (int x = 0; x < 13; ++x) CHECK(depth.at(x, 2) == (reversed_z ? 0.0f : 1.0f));
        }
    }
}
