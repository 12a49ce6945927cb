#include "ssao/judge/metrics.h"

#include <cmath>
#include <cstdint>

#include <doctest/doctest.h>

#include "rasterizer/base/error.h"
#include "tests/tools/noisy_images.h"
#include "tests/tools/special_floats.h"

using namespace crevice;

namespace {

bool near(double value, double expected, double tolerance) {
    return std::fabs(value - expected) <= tolerance;
}

}  // namespace

TEST_CASE("identical images: nothing differs, SSIM is exactly 1") {
    for (const Size size : {Size{1, 1}, Size{10, 40}, Size{11, 11}, Size{37, 23}}) {
        CAPTURE(size.width);
        CAPTURE(size.height);
        const Image<float> image = image_of(size, [](int x, int y) { return noise(1, x, y); });
        const ImageError error = compare_images(image, image);
        CHECK(error.identical());
        CHECK(error.rmse == 0);
        CHECK(error.max_abs == 0);
        CHECK(error.bias == 0);
        CHECK(error.p99 == 0);
        CHECK(error.ssim == 1);
        CHECK(error.pixels == size.width * size.height);
        CHECK(error.compared_pixels == error.pixels);
    }
}

TEST_CASE("an image 0.1 brighter has bias 0.1, and every other error follows") {
    const Size size{40, 30};
    const Image<float> b = image_of(size, [](int x, int y) { return 0.5f * noise(2, x, y); });
    const Image<float> a = image_of(size, [&](int x, int y) { return b.at(x, y) + 0.1f; });
    const ImageError error = compare_images(a, b);
    // a is rounded to float, so each difference is 0.1 within half an ulp of 1.
    CHECK(near(error.bias, 0.1, 6e-8));
    CHECK(near(error.mae, 0.1, 6e-8));
    CHECK(near(error.rmse, 0.1, 6e-8));
    CHECK(near(error.max_abs, 0.1, 6e-8));
    CHECK(near(error.p99, 0.1, 6e-8));
    CHECK(error.differing_pixels == 1200);
    CHECK(!error.failed());
    CHECK(!error.identical());
    CHECK(near(compare_images(b, a).bias, -0.1, 6e-8));
}

TEST_CASE("hand-counted numbers on four pixels") {
    Image<float> a({4, 1}, 0.0f), b({4, 1}, 0.0f);
    a.at(1, 0) = 3;
    b.at(2, 0) = 4;
    const ImageError error = compare_images(a, b);  // differences 0, 3, -4, 0
    CHECK(error.bias == -0.25);
    CHECK(error.mae == 1.75);
    CHECK(error.rmse == 2.5);
    CHECK(error.max_abs == 4);
    CHECK(error.differing_pixels == 2);
}

TEST_CASE("p99 is the smallest error that 99 of 100 values do not exceed") {
    // |a - b| is 1, 2 ... n in another order.
    const auto p99_of = [](int n) {
        Image<float> a({n, 1}, 0.0f);
        for (int x = 0; x < n; ++x)
            a.at(x, 0) = static_cast<float>((x * 7) % n + 1);  // n is no multiple of 7
        return compare_images(a, Image<float>({n, 1}, 0.0f)).p99;
    };
    CHECK(p99_of(1) == 1);
    CHECK(p99_of(99) == 99);  // 98/99 is less than 99 %
    CHECK(p99_of(100) == 99);
    CHECK(p99_of(101) == 100);
    CHECK(p99_of(1000) == 990);
}

TEST_CASE("a NaN or infinity fails, is counted, and is left out of the means") {
    const Size size{30, 20};
    const Image<float> b = image_of(size, [](int x, int y) { return noise(3, x, y); });
    for (const float broken : {kNan, kInfinity, -kInfinity}) {
        CAPTURE(broken);
        Image<float> a = b;
        a.at(29, 19) = broken;
        const ImageError error = compare_images(a, b);
        CHECK(error.failed());
        CHECK(!error.identical());
        CHECK(error.nan_or_inf == 1);
        CHECK(error.compared_pixels == 599);
        CHECK(error.differing_pixels == 1);
        CHECK(error.rmse == 0);
        CHECK(error.ssim == 1);
    }
    Image<float> both = b;
    both.at(3, 3) = kNan;
    CHECK(compare_images(both, both).failed());
    CHECK(compare_images(both, both).differing_pixels == 0);
    Image<float> other_sign = both;
    both.at(3, 3) = kInfinity;
    other_sign.at(3, 3) = -kInfinity;
    CHECK(compare_images(both, other_sign).failed());
}

TEST_CASE("the same infinity on both sides is equal background") {
    const Size size{30, 20};
    Image<float> a = image_of(size, [](int x, int y) { return noise(4, x, y); });
    for (int x = 0; x < 30; ++x) a.at(x, 0) = kInfinity;
    CHECK(compare_images(a, a).identical());
    CHECK(compare_images(a, a).compared_pixels == 570);
    Image<float> b = a;
    b.at(4, 7) += 0.5f;
    const ImageError error = compare_images(a, b);
    CHECK(!error.failed());
    CHECK(error.bias == -0.5 / 570);
    CHECK(signed_difference(planes_of(a), planes_of(b))[0].at(0, 0) == 0);
    CHECK(signed_difference(planes_of(a), planes_of(b))[0].at(4, 7) == -0.5f);
    const Image<float> sky(size, kInfinity);
    CHECK(compare_images(sky, sky).identical());
    CHECK(compare_images(sky, sky).compared_pixels == 0);
}

TEST_CASE("noise of known spread is measured as that") {
    const Size size{256, 256};
    const Image<float> truth(size, 0.5f);
    // The sum of 12 uniform numbers minus 6 has sigma 1.
    const auto noisy = [&](std::uint32_t seed) {
        return image_of(size, [seed](int x, int y) {
            float sum = -6;
            for (std::uint32_t k = 0; k < 12; ++k) sum += noise(seed + 1000 * k, x, y);
            return 0.5f + 0.05f * sum;
        });
    };
    const Image<float> a = noisy(1), b = noisy(2);
    const double n = 256 * 256, sigma = 0.05;
    const ImageError error = compare_images(a, truth);
    CHECK(near(error.rmse, sigma, 4 * sigma / std::sqrt(2 * n)));
    CHECK(near(error.bias, 0, 4 * sigma / std::sqrt(n)));
    CHECK(near(error.mae, sigma * 0.7979, 4 * sigma / std::sqrt(n)));
    CHECK(near(error.p99, sigma * 2.55, 0.06 * sigma));  // of this sum; 2.576 of a Gaussian
    // Two independent noises: their squares add.
    CHECK(near(compare_images(a, b).rmse, sigma * std::sqrt(2.0), 6 * sigma / std::sqrt(2 * n)));
}

TEST_CASE("three components are pooled; one that differs makes the pixel differ") {
    Image3 a({3, 1}, {1, 2, 3}), b = a;
    b.z.at(1, 0) = 6;
    const ImageError error = compare_images(a, b);
    CHECK(error.differing_pixels == 1);
    CHECK(error.mae == 3.0 / 9);
    CHECK(error.rmse == std::sqrt(9.0 / 9));
    CHECK(error.bias == -3.0 / 9);
    CHECK(error.max_abs == 3);
    a.x.at(2, 0) = kNan;
    CHECK(compare_images(a, b).nan_or_inf == 1);
    CHECK(compare_images(a, b).compared_pixels == 2);
    CHECK(compare_images(a, b).mae == 3.0 / 6);
}

TEST_CASE("bits decide: -0 differs from 0, though by nothing") {
    const Image<float> zero({12, 12}, 0.0f), minus_zero({12, 12}, -0.0f);
    const ImageError error = compare_images(zero, minus_zero);
    CHECK(error.differing_pixels == 144);
    CHECK(error.max_abs == 0);
    CHECK(!error.identical());
}

TEST_CASE("the first differing pixels come in row order, as many as asked for") {
    const Planes a = planes_of(Image<float>({5, 4}, 1.0f));
    Planes b = a;
    b[0].at(4, 0) = 2;
    b[0].at(1, 2) = 2;
    b[0].at(0, 3) = kNan;
    const auto found = first_differing_pixels(a, b, 10);
    REQUIRE(found.size() == 3);
    CHECK(found[0].x == 4);
    CHECK(found[0].y == 0);
    CHECK(found[1].x == 1);
    CHECK(found[1].y == 2);
    CHECK(found[2].y == 3);
    CHECK(first_differing_pixels(a, b, 2).size() == 2);
    CHECK(first_differing_pixels(a, a, 10).empty());
}

TEST_CASE("images of unlike shapes are refused by name") {
    const Image<float> a({4, 3}, 0.0f), b({3, 4}, 0.0f);
    const char* const both =
        "images cannot be compared (4x3x1 and 3x4x1, width x height x components); give two of the "
        "same shape with at least one pixel";
    CHECK_THROWS_WITH_AS(compare_images(a, b), both, InputError);
    CHECK_THROWS_AS(compare_images(Image<float>(), Image<float>()), InputError);
    CHECK_THROWS_AS(compare_images(planes_of(a), planes_of(Image3({4, 3}, {0, 0, 0}))), InputError);
    CHECK_THROWS_AS(compare_images(Planes{}, Planes{}), InputError);
}
