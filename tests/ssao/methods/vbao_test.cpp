// The visibility bitmask: its bits and its sectors. What it is for: vbao_fence_test.cpp
#include "ssao/methods/vbao.h"

#include <bit>
#include <bitset>
#include <cmath>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include "rasterizer/base/error.h"
#include "ssao/inputs/pixel_fetch.h"
#include "ssao/methods/sector_bits.h"
#include "ssao/methods/slices.h"
#include "tests/tools/image_checks.h"
#include "tests/tools/plane_inputs.h"

using namespace crevice;

namespace {

// Two planes that meet in a vertical edge in the middle, seen orthographically, a unit a pixel: each falls away from
// the eye by `slope` a pixel towards the edge, and to the left of column `top` nothing of the left one is left but a
// plane that goes no higher.
AoInputs groove(Size size, float slope, int top) {
    AoInputs inputs = plain_inputs(size, 0);
    const float length = std::sqrt(1 + slope * slope), edge = 0.5f * static_cast<float>(size.width);
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
            const float from_edge = static_cast<float>(x < top ? top : x) + 0.5f - edge;
            inputs.view_depth.at(x, y) = 1000 - slope * std::fabs(from_edge);
            inputs.normal.set(x, y, glm::vec3(from_edge < 0 ? slope : -slope, 0, -1) / length);
            inputs.depth_map.at(x + 1, y + 1) = inputs.view_depth.at(x, y);
        }
    }
    return inputs;
}

// The kernel's formula in double: angles by libm, the slice's integral by summing, bits one by one.
class NaiveBitmask {
 public:
    NaiveBitmask(const AoInputs& inputs, const VbaoSettings& settings)
        : inputs_(inputs),
          s_(settings),
          plan_(slice_plan(settings.samples)),
          noise_(settings.seed, plan_.slices) {}

    // Samples reach `wider` sectors further to both sides, for what rounding may do.
    double accessibility(int x, int y, double wider) const {
        const TexelPoint<float> texel = texel_point<float>(inputs_, x, y);
        const glm::dvec3 p(texel.p.x, texel.p.y, texel.p.z), n(texel.n.x, texel.n.y, texel.n.z);
        const float cosine = noise_.cosine.at<float>(x, y), sine = noise_.sine.at<float>(x, y);
        double sum = 0;
        for (int i = 0; i < plan_.slices; ++i) {
            const double turn = std::atan2(static_cast<double>(sine), static_cast<double>(cosine));
            const double angle = kPi * i / plan_.slices + turn;
            const glm::dvec3 across(std::cos(angle), std::sin(angle), 0), v = -glm::normalize(p);
            const glm::dvec3 t = glm::normalize(across - glm::dot(across, v) * v);
            const double length = std::hypot(glm::dot(n, t), glm::dot(n, v));
            const double gamma = std::atan2(glm::dot(n, t), glm::dot(n, v));
            std::bitset<kSectors> closed;
            for (const double side : {1.0, -1.0}) {
                for (int step = 0; step < plan_.steps; ++step)
                    close(closed, p, n, v, across, texel.at, gamma, side, distance_px(i, step, texel), wider);
            }
            const double whole = s_.sectors == Sectors::cosine
                                     ? length * integral(gamma - kPi / 2, gamma + kPi / 2, gamma)
                                     : 1;
            sum += static_cast<double>(closed.count()) / kSectors * whole;
        }
        return 1 - sum / plan_.slices;
    }

 private:
    double distance_px(int slice, int step, const TexelPoint<float>& texel) const {
        const float shift = noise_.step.at<float>(texel.x, texel.y);
        return static_cast<double>(
            step_distance_px(slice, step, plan_, shift, length_px(inputs_, s_.radius, texel.p.z)));
    }

    // Of max(0, cos(angle - gamma)) |sin(angle)| between two angles.
    static double integral(double from, double to, double gamma) {
        constexpr int kParts = 4000;
        double sum = 0;
        for (int i = 0; i < kParts; ++i) {
            const double angle = from + (to - from) * (i + 0.5) / kParts;
            sum += std::fmax(0.0, std::cos(angle - gamma)) * std::fabs(std::sin(angle));
        }
        return sum * (to - from) / kParts;
    }

    // Where an angle from v lies among the sectors, which begin at the horizon on the negative side.
    double sector(double angle, double gamma) const {
        const double low = gamma - kPi / 2, high = gamma + kPi / 2,
                     at = std::fmin(std::fmax(angle, low), high);
        const double share = s_.sectors == Sectors::cosine
                                 ? integral(low, at, gamma) / integral(low, high, gamma)
                                 : (at - low) / kPi;
        return share * kSectors;
    }

    void close(std::bitset<kSectors>& closed, glm::dvec3 p, glm::dvec3 n, glm::dvec3 v, glm::dvec3 across,
               Screen2<float> at, double gamma, double side, double along_px, double wider) const {
        const double x = std::floor(static_cast<double>(at.x) + side * along_px * across.x),
                     y = std::floor(static_cast<double>(at.y) - side * along_px * across.y);
        const Size picture = inputs_.picture;
        if (x < 0 || y < 0 || x >= picture.width || y >= picture.height) return;
        const double z = inputs_.depth_map.at(static_cast<int>(x) + 1, static_cast<int>(y) + 1);
        const double slope_x = inputs_.rays.ray_scale.x, slope_y = inputs_.rays.ray_scale.y;
        const glm::dvec3 r(z * slope_x * (2 * (x + 0.5) / picture.width - 1),
                           z * slope_y * (1 - 2 * (y + 0.5) / picture.height), z);
        const glm::dvec3 front = r - p, back = front - static_cast<double>(s_.thickness) * v;
        if (glm::length(front) > static_cast<double>(s_.radius)) return;
        // The plane beneath the pixel, which is beside the slice by part of a pixel, ends at another angle.
        const glm::dvec3 e = glm::normalize(front - glm::dot(front, v) * v);
        const double beside = kPi / 2 + std::atan2(glm::dot(n, e), glm::dot(n, v));
        const auto sector_of = [&](glm::dvec3 d) {
            const double above = beside - std::atan2(glm::dot(d, e), glm::dot(d, v));
            return sector(side * (side * gamma + kPi / 2 - above), gamma);
        };
        const double front_at = sector_of(front), back_at = sector_of(back);
        const double low = std::fmin(front_at, back_at) - wider, high = std::fmax(front_at, back_at) + wider;
        for (int i = 0; i < kSectors; ++i) {
            const bool hit = s_.closed == ClosedSectors::middle ? low <= i + 0.5 && i + 0.5 < high
                                                                : low < i + 1 && i < high;
            if (hit) closed.set(static_cast<std::size_t>(i));
        }
    }

    const AoInputs& inputs_;
    VbaoSettings s_;
    SlicePlan plan_;
    SliceNoise noise_;
};

}  // namespace

TEST_CASE("sector bits: runs, what is new and the count, against the bits one by one") {
    for (std::int32_t first = 0; first <= kSectors; ++first) {
        for (std::int32_t end = first; end <= kSectors; ++end) {
            std::uint32_t expected = 0;
            for (std::int32_t i = first; i < end; ++i) expected |= 1u << i;
            const std::int32_t bits = bits_between(first, end);
            CHECK(static_cast<std::uint32_t>(bits) == expected);
            CHECK(bit_count(bits) == std::popcount(expected));
            CHECK(bit_count(WideInt<4>(bits))[3] == std::popcount(expected));
            for (const std::uint32_t mask : {0u, ~0u, 0x80000000u, 0x7fffffffu, 0x5a5aa5a5u, 0xa5a55a5au}) {
                const std::int32_t fresh = bits_outside(bits, static_cast<std::int32_t>(mask));
                CHECK(static_cast<std::uint32_t>(fresh) == (expected & ~mask));
                CHECK(bit_count(fresh) == std::popcount(expected & ~mask));
            }
        }
    }
}

TEST_CASE("vbao: a plane at any tilt is open to the last bit, unless sectors count that are only touched") {
    const Size size{64, 48};
    for (const Sectors sectors : {Sectors::cosine, Sectors::angle}) {
        for (const float slope : {0.0f, 0.25f, 1.0f, 4.0f}) {
            CAPTURE(slope);
            const AoInputs inputs = tilted_inputs(size, slope, 0.25f);
            CHECK(other_than(vbao(inputs, {.radius = 12, .thickness = 3, .sectors = sectors}).ao, 1) == "");
        }
        // Seen in perspective, where what lies between pixels is not quite on the plane.
        const Mesh floor =
            quad_mesh({glm::vec3(-40, -1, 60), {40, -1, 60}, {40, -1, 1}, {-40, -1, 1}}, {0, 1, 0});
        const Scene scene = scene_of({floor});
        const GBuffer g = normal_depth(scene, scene.camera, size);
        VbaoSettings settings{.ao_scale = sectors == Sectors::cosine ? 0.5f : 1, .sectors = sectors};
        CHECK(other_than(vbao(ao_inputs(g, scene.camera, pixel_fetch(settings)), settings).ao, 1) == "");
        settings.closed = ClosedSectors::touched;
        CHECK(other_than(vbao(ao_inputs(g, scene.camera, pixel_fetch(settings)), settings).ao, 1) != "");
    }
}

TEST_CASE("vbao: a wall as high as the radius is as dark as its closed form, and a lower one less") {
    const Size size{128, 32};
    const double radius = 40;
    // Both planes stand at 45 degrees; the floor is the right one. Without an end things close all below them.
    double before = 1;
    const auto mean_of_column = [&](const AoInputs& inputs, int x) {
        const Image<float> ao = vbao(inputs, {.samples = 192, .radius = 40, .thickness = 1e30f}).ao;
        double sum = 0;
        for (int y = 0; y < size.height; ++y) sum += static_cast<double>(ao.at(x, y));
        return sum / size.height;
    };
    for (const int top : {64, 60, 52, 40}) {
        const double mean = mean_of_column(groove(size, 1, top), 70);
        CAPTURE(top);
        CHECK(mean < before - 0.02);
        before = mean;
    }
    // Three steps to a side miss the highest point within reach, but where the wall is close.
    for (const int x : {64, 66, 72, 80, 88}) {
        CAPTURE(x);
        const double c = (x + 0.5 - 64) * std::sqrt(2.0) / radius;
        const double expected = 1 - (std::acos(c) - c * std::sqrt(1 - c * c)) / kPi,
                     mean = mean_of_column(groove(size, 1, 0), x);
        CHECK(mean > expected - 0.01);
        CHECK(mean < expected + (x == 64 ? 0.07 : 0.2));
    }
}

TEST_CASE("vbao: a texel's formula, evaluated in double, for every choice of sectors") {
    const PreparedStillLife still(kTutorialMethods[0]);
    for (const Sectors sectors : {Sectors::cosine, Sectors::angle}) {
        for (const ClosedSectors closed : {ClosedSectors::middle, ClosedSectors::touched}) {
            CAPTURE(static_cast<int>(sectors));
            CAPTURE(static_cast<int>(closed));
            const VbaoSettings settings{
                .thickness = 0.2f, .ao_scale = 1, .sectors = sectors, .closed = closed};
            const AoInputs inputs = ao_inputs(still.g, still.scene.camera, pixel_fetch(settings));
            const Image<float> ao = vbao(inputs, settings).ao;
            const NaiveBitmask naive(inputs, settings);
            int texels = 0, within = 0, tight = 0, dark = 0;
            for (int y = 1; y < inputs.size().height; y += 2) {
                for (int x = 1; x < inputs.size().width; x += 3) {
                    if (inputs.view_depth.at(x, y) == kInfinity) continue;
                    const auto clamped = [](double a) { return std::fmin(std::fmax(a, 0.0), 1.0); };
                    const double low = clamped(naive.accessibility(x, y, 2e-3)) - 1e-5,
                                 high = clamped(naive.accessibility(x, y, -2e-3)) + 1e-5,
                                 actual = ao.at(x, y);
                    ++texels;
                    within += low <= actual && actual <= high ? 1 : 0;
                    tight += high - low < 1e-4 ? 1 : 0;
                    dark += high < 0.9 ? 1 : 0;
                }
            }
            CHECK(texels > 300);
            CHECK(dark > 25);
            CHECK(within > 0.98 * texels);  // a sample may fall to either side of a border between two pixels
            // Whether a plane is touched is a matter of rounding.
            if (closed == ClosedSectors::middle) CHECK(tight > 0.8 * texels);
        }
    }
}

TEST_CASE("vbao: settings out of range are refused by name") {
    const auto refused = [](const VbaoSettings& settings, const char* member) {
        CHECK_THROWS_WITH_AS(validate(settings), doctest::Contains(member), UsageError);
    };
    CHECK_NOTHROW(validate(VbaoSettings{}));
    refused({.samples = 5}, "samples");
    refused({.radius = -1}, "radius");
    refused({.thickness = -0.1f}, "thickness");
    refused({.thickness = kInfinity}, "thickness");
    refused({.exponent = 65}, "exponent");
    refused({.ao_scale = 0.3f}, "ao_scale");
}
