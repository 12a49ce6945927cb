#include "ssao/judge/fitted_power.h"

#include <cmath>

#include <doctest/doctest.h>

#include "rasterizer/base/error.h"
#include "tests/tools/about.h"
#include "tests/tools/image_checks.h"
#include "tests/tools/noise.h"
#include "tests/tools/special_floats.h"

using namespace crevice;

namespace {

constexpr Size kSize = {40, 30};
const Image<std::uint8_t> kAll(kSize, 1);

Image<float> raised(const Image<float>& image, double exponent) {
    Image<float> result = image;
    for (float& value : result.pixels)
        value = static_cast<float>(std::pow(static_cast<double>(value), exponent));
    return result;
}

FittedPower fit(const Image<float>& image, const Image<float>& reference,
                const Image<std::uint8_t>& counted = kAll) {
    const PowerExample example{image, reference, counted};
    return fitted_power(std::span(&example, 1));
}

double mean_square(const Image<float>& image, const Image<float>& reference, double exponent) {
    double sum = 0;
    for (int y = 0; y < kSize.height; ++y) {
        for (int x = 0; x < kSize.width; ++x) {
            const double off = std::pow(static_cast<double>(image.at(x, y)), exponent) - reference.at(x, y);
            sum += off * off;
        }
    }
    return sum / (kSize.width * kSize.height);
}

}  // namespace

TEST_CASE("fitted power finds the exponent that an image was raised to") {
    const Image<float> image = noise_image(kSize, 1);
    for (const double exponent : {0.05, 0.25, 1 / 2.2, 1.0, 1.5, 4.0, 6.0, 20.0}) {
        CAPTURE(exponent);
        const FittedPower fitted = fit(image, raised(image, exponent));
        CHECK(fitted.exponent == about(exponent, 1e-5));
        CHECK(fitted.rmse < 1e-6);
        CHECK(!fitted.at_bound);
    }
}

TEST_CASE("fitted power is the minimum, and no worse than no power") {
    for (std::uint32_t stream = 0; stream < 6; ++stream) {
        CAPTURE(stream);
        const Image<float> image = noise_image(kSize, 20 + stream);
        Image<float> reference = raised(image, 0.3 + 0.5 * stream);
        for (int y = 0; y < kSize.height; ++y)
            for (int x = 0; x < kSize.width; ++x)
                reference.at(x, y) += 0.3f * (noise(40 + stream, x, y) - 0.5f);
        const FittedPower fitted = fit(image, reference);
        const double smallest = mean_square(image, reference, fitted.exponent);
        CHECK(fitted.rmse == about(std::sqrt(smallest), 1e-9));
        CHECK(fitted.rmse_before == about(std::sqrt(mean_square(image, reference, 1)), 1e-9));
        CHECK(fitted.rmse <= fitted.rmse_before);
        for (const double factor : {0.5, 0.9, 0.999, 1.001, 1.1, 2.0}) {
            CAPTURE(factor);
            CHECK(smallest <= mean_square(image, reference, fitted.exponent * factor));
        }
    }
}

TEST_CASE("fitted power stops at its bounds and says so") {
    const Image<float> half(kSize, 0.5f);
    const FittedPower open = fit(half, Image<float>(kSize, 1.0f)),
                      closed = fit(half, Image<float>(kSize, 0.0f));
    CHECK(open.at_bound);
    CHECK(open.exponent == about(kLowestExponent, 1e-12));
    CHECK(closed.at_bound);
    CHECK(closed.exponent == about(kHighestExponent, 1e-12));
}

TEST_CASE("fitted power is 1 where no exponent changes anything") {
    Image<float> image(kSize, 1.0f);
    for (int x = 0; x < 20; ++x) image.at(x, 4) = 0;
    const FittedPower fitted = fit(image, Image<float>(kSize, 0.25f));
    CHECK(fitted.exponent == 1);
    CHECK(fitted.rmse == fitted.rmse_before);
    CHECK(!fitted.at_bound);
}

TEST_CASE("fitted power fits all examples at once, and only where they count") {
    const Image<float> a = noise_image(kSize, 1), b = noise_image(kSize, 2);
    const Image<float> ra = raised(a, 2), rb = raised(b, 4);
    const PowerExample examples[] = {{a, ra, kAll}, {b, rb, kAll}};
    const double both = fitted_power(examples).exponent;
    CHECK(both > 2.1);
    CHECK(both < 3.9);

    Image<std::uint8_t> left(kSize, 0);
    Image<float> mixed = ra;
    for (int y = 0; y < kSize.height; ++y) {
        for (int x = 0; x < kSize.width; ++x) {
            if (x < 20) left.at(x, y) = 1;
            if (x >= 20) mixed.at(x, y) = kNan;  // where it does not count, it does not matter
        }
    }
    CHECK(fit(a, mixed, left).exponent == about(2, 1e-5));
}

TEST_CASE("fitted power refuses what has no answer") {
    const Image<float> image = noise_image(kSize, 1);
    Image<float> broken = image;
    broken.at(3, 4) = kNan;
    CHECK_THROWS_WITH_AS(fit(image, broken),
                         "no exponent can be fitted to a NaN or infinity (pixel 3, 4); mend the image or the "
                         "reference first",
                         InputError);
    CHECK_THROWS_AS(fit(image, Image<float>({40, 29}, 1.0f)), InputError);
    CHECK_THROWS_AS(fit(image, image, Image<std::uint8_t>({40, 29}, 1)), InputError);
    CHECK_THROWS_AS(fit(image, image, Image<std::uint8_t>(kSize, 0)), UsageError);
    CHECK_THROWS_AS(fitted_power({}), UsageError);
}

TEST_CASE("to_power: 0 and 1 stay, the rest is raised, nothing leaves [0,1]") {
    Image<float> image = noise_image(kSize, 1);
    image.at(0, 0) = 0;
    image.at(1, 0) = 1;
    image.at(2, 0) = 1.25f;
    image.at(3, 0) = -1;
    image.at(4, 0) = kNan;
    const Image<float> squared = to_power(image, 2);
    CHECK(squared.at(0, 0) == 0);
    CHECK(squared.at(1, 0) == 1);
    CHECK(squared.at(2, 0) == 1);
    CHECK(squared.at(3, 0) == 0);
    CHECK(squared.at(4, 0) == 0);
    CHECK(outside_unit_interval(squared) == "");
    CHECK(squared.at(7, 9) == about(double(image.at(7, 9)) * image.at(7, 9), 1e-5));
}
