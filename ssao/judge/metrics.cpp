#include "ssao/judge/metrics.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "rasterizer/base/error.h"
#include "rasterizer/lanes/wide.h"
#include "ssao/judge/percentile.h"

namespace crevice {

namespace {

using PlaneList = std::vector<const Image<float>*>;

// exp(-d^2 / (2 * 1.5^2)) for d = -5..5, divided by their sum.
constexpr std::array<double, 11> kGaussian = {0.00102838008447911,  0.007598758135239185, 0.03600077212843083,
                                              0.10936068950970002,  0.2130055377112537,   0.26601172486179436,
                                              0.2130055377112537,   0.10936068950970002,  0.03600077212843083,
                                              0.007598758135239185, 0.00102838008447911};
constexpr int kWindow = static_cast<int>(kGaussian.size());
constexpr double kC1 = 0.01 * 0.01, kC2 = 0.03 * 0.03;  // (K1 L)^2 and (K2 L)^2 with L = 1

std::string shape_of(const PlaneList& planes) {
    if (planes.empty()) return "nothing";
    const Size size = planes[0]->size;
    return std::to_string(size.width) + "x" + std::to_string(size.height) + "x" +
           std::to_string(planes.size());
}

void check_alike(const PlaneList& a, const PlaneList& b) {
    const bool alike = a.size() == b.size() && !a.empty() && !a[0]->empty() && a[0]->size == b[0]->size;
    if (alike) return;
    throw InputError("images cannot be compared (" + shape_of(a) + " and " + shape_of(b) +
                     ", width x height x components); give two of the same shape with at least one pixel");
}

bool same_bits(float a, float b) { return float_bits(a) == float_bits(b); }

bool differs_at(const PlaneList& a, const PlaneList& b, int x, int y) {
    for (std::size_t c = 0; c < a.size(); ++c) {
        if (!same_bits(a[c]->at(x, y), b[c]->at(x, y))) return true;
    }
    return false;
}

enum class PixelKind { compared, same_infinity, broken };

PixelKind kind_of(const PlaneList& a, const PlaneList& b, int x, int y) {
    PixelKind kind = PixelKind::compared;
    for (std::size_t c = 0; c < a.size(); ++c) {
        const float va = a[c]->at(x, y), vb = b[c]->at(x, y);
        if (std::isfinite(va) && std::isfinite(vb)) continue;
        if (std::isnan(va) || std::isnan(vb) || va != vb) return PixelKind::broken;
        kind = PixelKind::same_infinity;
    }
    return kind;
}

// Weighted means of a, b, a^2, b^2 and ab: all that SSIM asks of a window.
struct Moments {
    double a = 0, b = 0, aa = 0, bb = 0, ab = 0;

    void add(double weight, const Moments& other) {
        a += weight * other.a;
        b += weight * other.b;
        aa += weight * other.aa;
        bb += weight * other.bb;
        ab += weight * other.ab;
    }
    static Moments of(double va, double vb) { return {va, vb, va * va, vb * vb, va * vb}; }
};

double ssim_of(const Moments& m) {
    const double variance_a = m.aa - m.a * m.a, variance_b = m.bb - m.b * m.b, covariance = m.ab - m.a * m.b;
    return (2 * m.a * m.b + kC1) * (2 * covariance + kC2) /
           ((m.a * m.a + m.b * m.b + kC1) * (variance_a + variance_b + kC2));
}

struct SsimSum {
    double sum = 0;
    long long windows = 0;
};

// Sums SSIM over the windows of one component, `compared` saying which pixels count. Columns first, then
// rows: the window's weights are a product.
SsimSum ssim_sum(const Image<float>& a, const Image<float>& b, const Image<std::uint8_t>& compared) {
    const int width = a.size.width;
    SsimSum total;
    std::vector<Moments> columns(static_cast<std::size_t>(width));
    std::vector<int> left_out(static_cast<std::size_t>(width));
    for (int top = 0; top + kWindow <= a.size.height; ++top) {
        for (int x = 0; x < width; ++x) {
            Moments column;
            int missing = 0;
            for (int k = 0; k < kWindow; ++k) {
                if (compared.at(x, top + k) == 0) {
                    ++missing;
                    continue;
                }
                const double va = static_cast<double>(a.at(x, top + k)),
                             vb = static_cast<double>(b.at(x, top + k));
                column.add(kGaussian[static_cast<std::size_t>(k)], Moments::of(va, vb));
            }
            columns[static_cast<std::size_t>(x)] = column;
            left_out[static_cast<std::size_t>(x)] = missing;
        }
        for (int left = 0; left + kWindow <= width; ++left) {
            Moments window;
            int missing = 0;
            for (int k = 0; k < kWindow; ++k) {
                window.add(kGaussian[static_cast<std::size_t>(k)],
                           columns[static_cast<std::size_t>(left + k)]);
                missing += left_out[static_cast<std::size_t>(left + k)];
            }
            if (missing > 0) continue;
            total.sum += ssim_of(window);
            ++total.windows;
        }
    }
    return total;
}

// Plain sums over all compared values, row by row.
struct DifferenceSums {
    double difference = 0, absolute = 0, squared = 0;
    Moments moments;
    std::vector<double> magnitudes;  // |a - b| of every compared value
};

DifferenceSums sum_differences(const PlaneList& a, const PlaneList& b, const Image<std::uint8_t>& compared) {
    DifferenceSums sums;
    for (int y = 0; y < compared.size.height; ++y) {
        for (int x = 0; x < compared.size.width; ++x) {
            if (compared.at(x, y) == 0) continue;
            for (std::size_t c = 0; c < a.size(); ++c) {
                const double va = static_cast<double>(a[c]->at(x, y)),
                             vb = static_cast<double>(b[c]->at(x, y));
                const double difference = va - vb;
                sums.difference += difference;
                sums.absolute += std::fabs(difference);
                sums.squared += difference * difference;
                sums.moments.add(1, Moments::of(va, vb));
                sums.magnitudes.push_back(std::fabs(difference));
            }
        }
    }
    return sums;
}

double mean_ssim(const PlaneList& a, const PlaneList& b, const Image<std::uint8_t>& compared,
                 const DifferenceSums& sums) {
    SsimSum total;
    for (std::size_t c = 0; c < a.size(); ++c) {
        const SsimSum plane = ssim_sum(*a[c], *b[c], compared);
        total.sum += plane.sum;
        total.windows += plane.windows;
    }
    if (total.windows > 0) return total.sum / static_cast<double>(total.windows);
    Moments whole;
    whole.add(1 / static_cast<double>(sums.magnitudes.size()), sums.moments);
    return ssim_of(whole);
}

ImageError compare_planes(const PlaneList& a, const PlaneList& b) {
    check_alike(a, b);
    const Size size = a[0]->size;
    ImageError error;
    error.pixels = static_cast<long long>(size.width) * size.height;
    Image<std::uint8_t> compared(size, 0);
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
            error.differing_pixels += differs_at(a, b, x, y);
            const PixelKind kind = kind_of(a, b, x, y);
            error.nan_or_inf += kind == PixelKind::broken;
            error.compared_pixels += kind == PixelKind::compared;
            compared.at(x, y) = kind == PixelKind::compared;
        }
    }
    if (error.compared_pixels == 0) return error;
    DifferenceSums sums = sum_differences(a, b, compared);
    const double values = static_cast<double>(sums.magnitudes.size());
    error.rmse = std::sqrt(sums.squared / values);
    error.mae = sums.absolute / values;
    error.bias = sums.difference / values;
    error.max_abs = *std::max_element(sums.magnitudes.begin(), sums.magnitudes.end());
    error.ssim = mean_ssim(a, b, compared, sums);
    error.p99 = percentile(std::move(sums.magnitudes), 99);
    return error;
}

PlaneList list(const Planes& planes) {
    PlaneList result;
    for (const Image<float>& plane : planes) result.push_back(&plane);
    return result;
}

}  // namespace

void check_same_size(const Image<float>& a, const Image<float>& b) { check_alike({&a}, {&b}); }

ImageError compare_images(const Image<float>& a, const Image<float>& b) { return compare_planes({&a}, {&b}); }

ImageError compare_images(const Image3& a, const Image3& b) {
    return compare_planes({&a.x, &a.y, &a.z}, {&b.x, &b.y, &b.z});
}

ImageError compare_images(const Planes& a, const Planes& b) { return compare_planes(list(a), list(b)); }

std::vector<PixelPosition> first_differing_pixels(const Planes& a, const Planes& b, std::size_t limit) {
    const PlaneList list_a = list(a), list_b = list(b);
    check_alike(list_a, list_b);
    std::vector<PixelPosition> found;
    for (int y = 0; y < a[0].size.height && found.size() < limit; ++y) {
        for (int x = 0; x < a[0].size.width && found.size() < limit; ++x) {
            if (differs_at(list_a, list_b, x, y)) found.push_back({x, y});
        }
    }
    return found;
}

Planes signed_difference(const Planes& a, const Planes& b) {
    check_alike(list(a), list(b));
    Planes difference;
    for (std::size_t c = 0; c < a.size(); ++c) {
        Image<float> plane(a[c].size, 0.0f);
        for (int y = 0; y < plane.size.height; ++y) {
            for (int x = 0; x < plane.size.width; ++x) {
                const float va = a[c].at(x, y), vb = b[c].at(x, y);
                plane.at(x, y) = std::isinf(va) && va == vb ? 0 : va - vb;
            }
        }
        difference.push_back(std::move(plane));
    }
    return difference;
}

}  // namespace crevice
