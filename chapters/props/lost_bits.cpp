#include "chapters/props/lost_bits.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "chapters/notebook/svg.h"
#include "rasterizer/base/hash.h"

namespace crevice {

namespace {

// An estimate of 1 / sqrt(a) is good to 1.5 * 2^-12; which of the numbers that are, differs between makers. One keeps twelve
// bits rounded, another twelve bits cut off. One step of Newton's doubles the digits.
float refined(float estimate, float a) { return estimate * (1.5f - 0.5f * a * estimate * estimate); }
float inverse_root(float a) { return static_cast<float>(1 / std::sqrt(static_cast<double>(a))); }

// What all samples of a texel take together, and the AO that becomes of it.
struct Occlusion {
    float sum = 0, ao = 1;
};

// The tutorials' estimator, written down once more with these operations.
Occlusion occlusion_of_texel(const LunaKernel& kernel, const RandomMap& random, int x, int y,
                             const Arithmetic& with) {
    const LunaPoint<float> at = kernel.point_at<float>(random, x, y);
    if (!at.surface) return {};
    std::array<float, kCubeVectors> terms{};
    for (std::size_t i = 0; i < kCubeVectors; ++i) {
        const Vec3<float> q = kernel.sample_point(at.p, at.n, at.random, kernel.offsets[i]);
        const float inverse_z = kernel.inverse_depth(q.z);
        const float r_z = kernel.depth_at(kernel.inputs.rays.p_screen(q, inverse_z));
        const Vec3<float> from_p = kernel.inputs.rays.at_depth(q, inverse_z, r_z) - at.p;
        const float squared = with.dot(from_p, from_p), along = with.dot(at.n, from_p);
        const float radius = kernel.settings.radius;
        const bool counts = squared > radius * radius * 1e-12f && kernel.visible(q.z) && along > 0;
        if (counts) terms[i] = with.divide(along, squared) * kernel.occlusion(at.p.z - r_z, at.p.z);
    }
    const float sum = with.sum(terms), access = kernel.accessibility_of_sum(sum);
    return {sum, saturate(with.power(max_of(access, 0.0f), kernel.settings.exponent))};
}

double exact_square(Vec3<float> v) {
    const double x = v.x, y = v.y, z = v.z;
    return x * x + y * y + z * z;
}

}  // namespace

float rounded_dot(Vec3<float> a, Vec3<float> b) { return dot(a, b); }
// What GCC makes of the same line where the machine has fused multiply-adds and nobody forbids them, ...
float fused_dot(Vec3<float> a, Vec3<float> b) { return std::fma(a.z, b.z, std::fma(a.y, b.y, a.x * b.x)); }
// ... and what another compiler may just as well.
float otherwise_fused_dot(Vec3<float> a, Vec3<float> b) {
    return std::fma(a.z, b.z, std::fma(a.x, b.x, a.y * b.y));
}

float divided(float along, float squared) { return along / square_root(squared); }
float by_rounded_estimate(float along, float squared) {
    const float estimate = float_from_bits((float_bits(inverse_root(squared)) + 0x400) & ~0x7ff);
    return along * refined(estimate, squared);
}
float by_cut_estimate(float along, float squared) {
    return along * refined(float_from_bits(float_bits(inverse_root(squared)) & ~0x7ff), squared);
}

float sum_in_order(std::span<const float> terms) {
    float sum = 0;
    for (const float term : terms) sum += term;
    return sum;
}
// As four lanes of a register do, which are added up at the end.
float sum_of_four(std::span<const float> terms) {
    std::array<float, 4> sums{};
    for (std::size_t i = 0; i < terms.size(); ++i) sums[i % 4] += terms[i];
    return (sums[0] + sums[2]) + (sums[1] + sums[3]);
}

float own_power(float base, float exponent) { return power(base, exponent); }
float by_products(float base, float) { return (base * base) * (base * base); }

OcclusionMaps maps_with(const LunaKernel& kernel, const RandomMap& random, const Arithmetic& arithmetic) {
    OcclusionMaps maps{Image<float>(kernel.inputs.size(), 0.0f), Image<float>(kernel.inputs.size(), 1.0f)};
    for (int y = 0; y < maps.ao.size.height; ++y) {
        for (int x = 0; x < maps.ao.size.width; ++x) {
            const Occlusion texel = occlusion_of_texel(kernel, random, x, y, arithmetic);
            maps.sum.at(x, y) = texel.sum;
            maps.ao.at(x, y) = texel.ao;
        }
    }
    return maps;
}

BitsApart bits_apart(const Image<float>& a, const Image<float>& b) {
    BitsApart apart;
    apart.steps = Image<float>(a.size, 0.0f);
    for (int y = 0; y < a.size.height; ++y) {
        for (int x = 0; x < a.size.width; ++x) {
            const int steps = std::abs(float_bits(a.at(x, y)) - float_bits(b.at(x, y)));
            apart.texels += steps != 0 ? 1 : 0;
            apart.most = std::max(apart.most, std::fabs(a.at(x, y) - b.at(x, y)));
            apart.steps.at(x, y) = static_cast<float>(steps);
        }
    }
    return apart;
}

ThreeWays three_ways(const LunaKernel& kernel) {
    const AoInputs& inputs = kernel.inputs;
    ThreeWays found;
    for (int y = inputs.size().height / 2; y < inputs.size().height; ++y) {
        for (int x = 0; x < inputs.size().width; ++x) {
            const float u = (static_cast<float>(x) + 0.5f) / static_cast<float>(inputs.size().width),
                        v = (static_cast<float>(y) + 0.5f) / static_cast<float>(inputs.size().height);
            if (!std::isfinite(inputs.view_depth.at(x, y))) continue;
            const Vec3<float> p = inputs.rays.p_view(u, v, inputs.view_depth.at(x, y));
            found = {p, exact_square(p), rounded_dot(p, p), fused_dot(p, p), otherwise_fused_dot(p, p)};
            if (found.rounded != found.fused && found.fused != found.otherwise_fused &&
                found.rounded != found.otherwise_fused)
                return found;
        }
    }
    return found;
}

std::string number_line(const ThreeWays& ways) {
    constexpr double kMiddle = 300, kStep = 90, kAxis = 100;
    const double step =
        static_cast<double>(std::nextafter(ways.rounded, 1e30f)) - static_cast<double>(ways.rounded);
    const auto x = [&](double value) {
        return kMiddle + kStep * (value - static_cast<double>(ways.rounded)) / step;
    };
    std::string svg = svg_line({10, kAxis}, {590, kAxis}, kSvgInk);
    for (int i = -3; i <= 3; ++i)
        svg += svg_line({kMiddle + kStep * i, kAxis - 8}, {kMiddle + kStep * i, kAxis + 8}, kSvgInk);
    const auto mark = [&](double value, double height, const std::string& words, std::string_view colour) {
        svg +=
            svg_line({x(value), kAxis}, {x(value), kAxis + height}, colour) +
            svg_dot({x(value), kAxis}, 4.5, colour) +
            svg_text({x(value), kAxis + height + (height > 0 ? 16 : -6)}, words, TextAnchor::middle, colour);
    };
    mark(ways.exact, -40, "exact", kSvgPoint);
    mark(static_cast<double>(ways.rounded), 24, "each rounded", kSvgInk);
    mark(static_cast<double>(ways.fused), 44, "fused", kSvgOpen);
    mark(static_cast<double>(ways.otherwise_fused), 64, "fused otherwise", kSvgOccluded);
    return svg_picture("The square of one length, computed in three ways", 600, 200, svg);
}

float sum_of_rows(const Image<float>& ao, std::span<const int> order) {
    float sum = 0;
    for (const int y : order) sum += sum_in_order({ao.row(y), static_cast<std::size_t>(ao.size.width)});
    return sum;
}
std::vector<int> order_of_threads(int rows, std::uint32_t seed, std::uint32_t which) {
    std::vector<int> order(static_cast<std::size_t>(rows));
    for (int i = 0; i < rows; ++i) order[static_cast<std::size_t>(i)] = i;
    for (std::uint32_t i = static_cast<std::uint32_t>(rows) - 1; which > 0 && i > 0; --i)
        std::swap(order[i], order[hash_of(seed, which, i) % (i + 1)]);
    return order;
}

std::int32_t to_int_of_x86(float a) {
    return a > -2147483904.0f && a < 2147483648.0f ? static_cast<std::int32_t>(a) : INT32_MIN;
}
std::int32_t to_int_of_arm(float a) {
    if (std::isnan(a)) return 0;
    return a >= 2147483648.0f ? INT32_MAX : to_int_of_x86(a);
}
Image<float> as_bytes(const Image<float>& view_depth, float farthest, ToInt to_int_of_machine) {
    Image<float> bytes(view_depth.size, 0.0f);
    for (int y = 0; y < bytes.size.height; ++y) {
        for (int x = 0; x < bytes.size.width; ++x)
            bytes.at(x, y) = static_cast<float>(
                std::clamp(to_int_of_machine(view_depth.at(x, y) * (255 / farthest)), 0, 255));
    }
    return bytes;
}

Image<float> narrow(const Image<float>& ao, float padding) {
    const int width = round_up(ao.size.width, kRowAlignment) - kRowAlignment - 5;
    Image<float> copy({width, ao.size.height}, padding);
    for (int y = 0; y < ao.size.height; ++y) std::copy(ao.row(y), ao.row(y) + width, copy.row(y));
    return copy;
}
std::uint32_t memory_hash(const Image<float>& image) {
    std::uint32_t hash = 2166136261u;
    for (const float value : image.pixels)
        hash = (hash ^ static_cast<std::uint32_t>(float_bits(value))) * 16777619u;
    return hash;
}

}  // namespace crevice
