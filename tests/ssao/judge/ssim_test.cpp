// The structural similarity that compare_images reports.
#include <cmath>
#include <cstdint>
#include <limits>

#include <doctest/doctest.h>

#include "ssao/judge/metrics.h"
#include "tests/tools/noisy_images.h"

using namespace crevice;

namespace {

bool near(double value, double expected, double tolerance) {
    return std::fabs(value - expected) <= tolerance;
}

// SSIM by its definition, one window at a time, with the exponential of the C library.
double slow_ssim(const Image<float>& a, const Image<float>& b) {
    double total = 0;
    int windows = 0;
    for (int top = 0; top + 11 <= a.size.height; ++top) {
        for (int left = 0; left + 11 <= a.size.width; ++left, ++windows) {
            double weights = 0, mean_a = 0, mean_b = 0, var_a = 0, var_b = 0, covariance = 0;
            const auto each = [&](auto visit) {
                for (int j = 0; j < 11; ++j) {
                    for (int i = 0; i < 11; ++i) {
                        const double weight = std::exp(-((i - 5) * (i - 5) + (j - 5) * (j - 5)) / 4.5);
                        visit(weight, static_cast<double>(a.at(left + i, top + j)),
                              static_cast<double>(b.at(left + i, top + j)));
                    }
                }
            };
            each([&](double w, double va, double vb) { weights += w, mean_a += w * va, mean_b += w * vb; });
            mean_a /= weights, mean_b /= weights;
            each([&](double w, double va, double vb) {
                var_a += w / weights * (va - mean_a) * (va - mean_a);
                var_b += w / weights * (vb - mean_b) * (vb - mean_b);
                covariance += w / weights * (va - mean_a) * (vb - mean_b);
            });
            total += (2 * mean_a * mean_b + 1e-4) * (2 * covariance + 9e-4) /
                     ((mean_a * mean_a + mean_b * mean_b + 1e-4) * (var_a + var_b + 9e-4));
        }
    }
    return total / windows;
}

}  // namespace

TEST_CASE("SSIM of constant images is its closed form") {
    struct Greys {
        double a, b;
    };
    for (const Size size : {Size{16, 16}, Size{5, 5}}) {
        for (const Greys grey : {Greys{0.25, 0.75}, Greys{0, 1}, Greys{0.5, 0.5}}) {
            CAPTURE(size.width);
            CAPTURE(grey.a);
            CAPTURE(grey.b);
            const double expected = (2 * grey.a * grey.b + 1e-4) / (grey.a * grey.a + grey.b * grey.b + 1e-4);
            const Image<float> a(size, static_cast<float>(grey.a)), b(size, static_cast<float>(grey.b));
            CHECK(near(compare_images(a, b).ssim, expected, 1e-12));
        }
    }
}

TEST_CASE("SSIM equals its definition, window by window") {
    const Size size{23, 17};
    const Image<float> a = image_of(size, [](int x, int y) { return noise(5, x, y); });
    const Image<float> b =
        image_of(size, [&](int x, int y) { return 0.6f * a.at(x, y) + 0.3f * noise(6, x, y); });
    const double expected = slow_ssim(a, b);
    REQUIRE(expected > 0.5);
    REQUIRE(expected < 0.95);
    CHECK(near(compare_images(a, b).ssim, expected, 1e-12));
    // A structure turned around is worse than none.
    const Image<float> turned = image_of(size, [&](int x, int y) { return 1 - a.at(x, y); });
    CHECK(compare_images(a, turned).ssim < 0);
}

TEST_CASE("SSIM leaves out every window with a pixel left out") {
    const Image<float> a = image_of({12, 11}, [](int x, int y) { return noise(7, x, y); });
    const Image<float> b = image_of({12, 11}, [](int x, int y) { return noise(8, x, y); });
    const auto cropped = [](const Image<float>& image) {
        return image_of({11, 11}, [&](int x, int y) { return image.at(x + 1, y); });
    };
    Image<float> sky_a = a, sky_b = b;
    sky_a.at(0, 5) = sky_b.at(0, 5) = std::numeric_limits<float>::infinity();
    const double expected = compare_images(cropped(a), cropped(b)).ssim;
    CHECK(compare_images(sky_a, sky_b).ssim == expected);
    CHECK(compare_images(a, b).ssim != expected);
}
