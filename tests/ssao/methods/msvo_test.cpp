// One scale written anew in double, what the scales do together, and what the switches change.
#include "ssao/methods/msvo.h"

#include <cmath>

#include <doctest/doctest.h>

#include "rasterizer/base/error.h"
#include "rasterizer/base/image_summary.h"
#include "ssao/inputs/depth_inputs.h"
#include "ssao/methods/msvo_scales.h"
#include "tests/tools/ao_cases.h"
#include "tests/tools/flat_scenes.h"
#include "tests/tools/image_checks.h"

using namespace crevice;

namespace {

constexpr Size kSize = {160, 96};

AoInputs inputs_of(const Scene& scene, float scale = 1, Size size = kSize) {
    return depth_inputs(normal_depth(scene, scene.camera, size), scene.camera, scale);
}

// The smallest value of a map further than `border` from its edges.
float darkest(const Image<float>& ao, int border = 0) {
    float least = 1;
    for (int y = border; y < ao.size.height - border; ++y) {
        for (int x = border; x < ao.size.width - border; ++x) least = std::fmin(least, ao.at(x, y));
    }
    return least;
}

// MiniEngine's TestSamplePair for two shares of a chord.
double pair_by_miniengine(double a, double b, double thickness) {
    const auto pseudo = [&](double o) { return std::fmin(std::fmax(-o / thickness, 0), 1); };
    return std::fmin(std::fmax(a, pseudo(b)), 1) + std::fmin(std::fmax(b, pseudo(a)), 1) -
           pseudo(a) * pseudo(b);
}

// One ball over texel (x, y) of the map, at most as open as a plane leaves it.
double ball_by_miniengine(const AoInputs& inputs, const MsvoSettings& s, int x, int y) {
    const auto z_at = [&](int i, int j) {
        return static_cast<double>(inputs.view_depth.at(std::clamp(i, 0, inputs.size().width - 1),
                                                        std::clamp(j, 0, inputs.size().height - 1)));
    };
    const double z = z_at(x, y), radius = s.radius,
                 pixels = static_cast<double>(inputs.picture.height) / 2 /
                          static_cast<double>(inputs.rays.ray_scale.y) / (inputs.rays.perspective ? z : 1),
                 spacing = radius / 5 * pixels * static_cast<double>(inputs.fetch.scale);
    double taken = 0, total = 0;
    for (int j = 0; j <= 4; ++j) {
        for (int i = -4; i <= 4; ++i) {
            // A chessboard without its middle and its rim; of each two opposite places one.
            if ((i + j) % 2 != 0 || i * i + j * j >= 25 || (j == 0 && i <= 0)) continue;
            const int di = (i < 0 ? -1 : 1) * static_cast<int>(std::floor(std::abs(i) * spacing + 0.5)),
                      dj = static_cast<int>(std::floor(j * spacing + 0.5));
            const double away = std::hypot(di, dj) / (5 * spacing),
                         half = std::sqrt(std::fmax(0, 1 - away * away));
            if (half == 0) continue;
            const auto share = [&](double other) {
                return (other - z) / (2 * radius * std::fmax(half, 1e-3)) + 0.5;
            };
            double open =
                pair_by_miniengine(share(z_at(x + di, y + dj)), share(z_at(x - di, y - dj)), s.thickness);
            const auto outside = [&](int px, int py) {
                return px < 0 || py < 0 || px >= inputs.size().width || py >= inputs.size().height;
            };
            if (s.pairs == MsvoPairs::plane && (outside(x + di, y + dj) || outside(x - di, y - dj))) open = 1;
            taken += half * (1 - (s.pairs == MsvoPairs::plane ? std::fmin(open, 1) : open));
            total += half;
        }
    }
    return std::fmin(std::fmax(1 - static_cast<double>(s.intensity) * taken / total, 0), 1);
}

// A sheet facing the eye at depth 40, one scene unit a pixel, its left half `step` nearer.
AoInputs stepped(float step) {
    AoInputs inputs = plain_inputs({129, 129}, 40);
    for (int y = 0; y < 129; ++y) {
        for (int x = 0; x < 64; ++x) inputs.view_depth.at(x, y) = 40 - step;
    }
    return inputs;
}

}  // namespace

TEST_CASE("msvo: each texel of a single scale is MiniEngine's sum over the pairs of its taps") {
    for (const MsvoPairs pairs : {MsvoPairs::plane, MsvoPairs::all}) {
        for (const float thickness : {1.0f, 4.0f}) {
            const MsvoSettings settings{
                .samples = 36, .intensity = 1.5f, .thickness = thickness, .pairs = pairs};
            const AoInputs inputs = inputs_of(still_life());
            const Image<float> ao = msvo(inputs, settings).ao;
            int darker = 0, at_a_rounding = 0;
            CHECK(pixels_against(kSize, [&](int x, int y) {
                      if (inputs.view_depth.at(x, y) == kInfinity) return ao.at(x, y) == 1;
                      darker += ao.at(x, y) < 0.9f ? 1 : 0;
                      const double expected = ball_by_miniengine(inputs, settings, x, y);
                      const bool same = std::fabs(expected - static_cast<double>(ao.at(x, y))) < 1e-4;
                      // A tap may be half way between two texels.
                      at_a_rounding += same ? 0 : 1;
                      return same || at_a_rounding < 10;
                  }) == "");
            CHECK(darker > 500);
        }
    }
}

TEST_CASE("msvo: the taps are MiniEngine's 36, and their chords stand for the whole ball") {
    // Beside a step of h the left half of each pair is closed by h over its chord, up to all of its front half.
    for (const float step : {3.0f, 10.0f}) {
        const MsvoSettings settings{.samples = 36, .radius = 40, .thickness = 10};
        const double ao = msvo(stepped(step), settings).ao.at(64, 64);
        double taken = 0, total = 0;
        for (int j = -200; j <= 200; ++j) {
            for (int i = 1; i <= 200; ++i) {
                const double squared = (i * i + j * j) / 40000.0;
                if (squared >= 1) continue;
                const double half = std::sqrt(1 - squared),
                             share = 0.5 - static_cast<double>(step) / (80 * half);
                taken += half * (1 - pair_by_miniengine(share, 0.5, 10));
                total += half;
            }
        }
        CAPTURE(step);
        CHECK(ao == doctest::Approx(1 - taken / total).epsilon(0.02));
    }
}

TEST_CASE("msvo: an open plane is open at any slant, at both sizes") {
    for (const MsvoPairs pairs : {MsvoPairs::plane, MsvoPairs::all}) {
        for (const float degrees : {0.0f, 30.0f, 60.0f, 75.0f}) {
            for (const float scale : {0.5f, 1.0f}) {
                CAPTURE(degrees);
                CAPTURE(scale);
                const AoInputs inputs = inputs_of(tilted_plane(degrees), scale);
                CHECK(darkest(msvo(inputs, {.radius = 0.5f, .ao_scale = scale, .pairs = pairs}).ao, 24) >
                      0.9999f);
            }
        }
    }
}

TEST_CASE("msvo: a wall that is higher leaves less of the floor in front of it open") {
    double before = 1.1;
    for (const float height : {0.0625f, 0.25f, 0.5f, 1.0f}) {
        const AoInputs inputs = inputs_of(wall_on_floor(height));
        const Image<float> ao = msvo(inputs, {.radius = 1}).ao;
        const double mean = mean_where(ao, 0, [&](int x, int y) {
            const float z = inputs.view_depth.at(x, y);
            return z < 5.95f && z > 5 && y > kSize.height / 2;
        });
        CAPTURE(height);
        CHECK(mean < before);
        before = mean;
    }
    CHECK(before < 0.95);
}

TEST_CASE("msvo: what is far in front takes nothing; with a thickness of more it does") {
    AoInputs inputs = stepped(0);
    // A post, further in front of the sheet than the ball is wide, beside the texel.
    for (int y = 0; y < 129; ++y) {
        for (int x = 66; x < 80; ++x) inputs.view_depth.at(x, y) = 10;
    }
    double before = 1.01;
    for (const float thickness : {1.0f, 3.0f, 10.0f}) {
        const double ao = msvo(inputs, {.samples = 36, .radius = 10, .thickness = thickness}).ao.at(63, 64);
        CAPTURE(thickness);
        CHECK((thickness == 1 ? ao > 0.999 : ao < before - 0.05));
        before = ao;
    }
}

TEST_CASE("msvo: pairs that open to the full make up for what rises on the other side of an edge") {
    // Beside the texel a step up; the sheet is a shelf that ends above and below it.
    AoInputs inputs = stepped(4);
    for (int y = 0; y < 129; ++y) {
        for (int x = 64; x < 129; ++x) {
            if (y < 61 || y > 67) inputs.view_depth.at(x, y) = 100;
        }
    }
    MsvoSettings settings{.samples = 36, .radius = 20};
    const float cured = msvo(inputs, settings).ao.at(64, 64);
    settings.pairs = MsvoPairs::all;
    CHECK(cured < 0.99f);
    CHECK(msvo(inputs, settings).ao.at(64, 64) == 1);
    const AoInputs corner = inputs_of(still_life());
    CHECK(mean_inside(msvo(corner, {.pairs = MsvoPairs::all}).ao, corner) >
          mean_inside(msvo(corner, {}).ao, corner) + 0.005);
}

TEST_CASE("msvo: the largest ball has the radius, whatever the number of scales; more scales are darker") {
    const AoInputs inputs = stepped(2);
    double before = 1;
    for (const int samples : {36, 72, 108, 144}) {
        const MsvoSettings settings{.samples = samples, .radius = 32};
        const Image<float> ao = msvo(inputs, settings).ao;
        CAPTURE(samples);
        // Four spacings of 6.4 away, and four texels more for the grid of the coarser scales.
        CHECK(ao.at(64 + 24, 64) < 1);
        CHECK(ao.at(64 + 34, 64) > 0.999f);
        CHECK(ao.at(64, 64) < before);
        before = ao.at(64, 64);
        CHECK(
            msvo(inputs, {.samples = samples, .radius = 32, .combine = MsvoCombine::minimum}).ao.at(64, 64) >=
            ao.at(64, 64));
    }
    CHECK(msvo(inputs, {.radius = 32, .combine = MsvoCombine::minimum}).ao.at(64, 64) > before + 0.05);
    CHECK(msvo(inputs, {.radius = 32, .intensity = 0}).ao.at(64, 64) == 1);
}

TEST_CASE(
    "msvo: an upsampled texel is the mean of four, nine to three to three to one, of those of like depth") {
    AoInputs inputs = plain_inputs({8, 8}, 40);
    Image<float> open(Size{4, 4}, 1);
    open.at(1, 1) = 0.2f;
    const auto of_column_row = [&](int x, int y) {
        const DepthGrid fine(inputs, 0, 0, {}), coarse(inputs, 1, 0, {});
        return upsampled(open, coarse, fine, {}).at(x, y);
    };
    CHECK(of_column_row(2, 2) == doctest::Approx((9 * 0.2 + 7) / 16).epsilon(1e-3));
    CHECK(of_column_row(4, 2) == doctest::Approx((3 * 0.2 + 13) / 16).epsilon(1e-3));
    CHECK(of_column_row(4, 4) == doctest::Approx((1 * 0.2 + 15) / 16).epsilon(1e-3));
    CHECK(of_column_row(6, 6) == 1);
    // The cell's depth is that of texel (2, 2): another one there keeps it out elsewhere, and is open itself.
    inputs.view_depth.at(2, 2) = 20;
    CHECK(of_column_row(4, 4) > 0.998f);
    CHECK(of_column_row(2, 2) == doctest::Approx(0.2).epsilon(0.05));
    // Among background alone a surface is open.
    for (const auto& [x, y] : {std::pair{2, 2}, {4, 2}, {2, 4}, {4, 4}})
        inputs.view_depth.at(x, y) = kInfinity;
    CHECK(of_column_row(3, 3) == 1);
}

TEST_CASE("msvo: a seed picks other texels of the coarser grids, and changes no single scale") {
    const AoInputs inputs = inputs_of(still_life());
    const auto hash = [&](int samples, std::uint32_t seed) {
        return content_hash(msvo(inputs, {.samples = samples, .seed = seed}).ao);
    };
    CHECK(hash(36, 0) == hash(36, 1));
    CHECK(hash(144, 0) != hash(144, 1));
    CHECK(hash(144, 1) != hash(144, 2));
    const DepthGrid plain(inputs, 2, 0, {});
    CHECK(pixels_against(plain.size(), [&](int x, int y) {
              return plain.at(x, y) == inputs.view_depth.at(4 * x, 4 * y);
          }) == "");
}

TEST_CASE("msvo: settings out of range are refused by name") {
    const auto refused = [](auto change, const char* name) {
        MsvoSettings wrong;
        change(wrong);
        CHECK_THROWS_WITH_AS(validate(wrong), doctest::Contains(name), UsageError);
    };
    refused([](auto& s) { s.samples = 35; }, "samples");
    refused([](auto& s) { s.samples = 0; }, "samples");
    refused([](auto& s) { s.samples = 180; }, "samples");
    refused([](auto& s) { s.radius = -1; }, "radius");
    refused([](auto& s) { s.intensity = 5; }, "intensity");
    refused([](auto& s) { s.thickness = 0.5f; }, "thickness");
    refused([](auto& s) { s.exponent = kNan; }, "exponent");
    refused([](auto& s) { s.ao_scale = 2; }, "ao_scale");
}
