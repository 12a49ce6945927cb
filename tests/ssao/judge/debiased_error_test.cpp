// What a noisy reference can and cannot tell: debiased errors, their standard errors, which image is better.
#include <cmath>

#include <doctest/doctest.h>

#include "tests/tools/about.h"
#include "tests/tools/noise.h"
#include "tests/tools/noisy_images.h"

using namespace crevice;

TEST_CASE("noise of known sigma debiases to the true error, within its standard error") {
    const Size size{192, 160};
    const double pixels = 192.0 * 160;
    const Image<float> truth = image_of(size, [](int x, int y) { return 0.3f + 0.4f * noise(1, x, y); });
    for (const float off : {0.0f, 0.02f}) {
        for (const float sigma : {0.01f, 0.1f}) {
            CAPTURE(off);
            CAPTURE(sigma);
            const Image<float> image = image_of(size, [&](int x, int y) { return truth.at(x, y) + off; });
            const RegionError all =
                reference_error(image, noisy_reference(truth, sigma, 50), all_flat(size)).over(Region::all);
            const double square = double(off) * off, variance = double(sigma) * sigma;
            // (a - r1)(a - r2) = off^2 - off (n1 + n2) + n1 n2, so its variance is known.
            const double expected_error = std::sqrt((2 * square * variance + variance * variance) / pixels);
            CHECK(all.squared.error == about(expected_error, 0.2));
            CHECK(std::fabs(all.squared.mean - square) < 4 * all.squared.error);
            CHECK(all.rmse_raw == about(std::sqrt(square + variance / 2), 0.02));
            CHECK(all.reference_error == about(sigma / std::sqrt(2.0), 1e-6));
        }
    }
}

TEST_CASE("a debiased square below zero is said to be so, and its root is 0") {
    const Size size{64, 64};
    const Image<float> truth(size, 0.5f);
    bool seen_below = false;
    for (std::uint32_t stream = 0; stream < 8; ++stream) {
        const RegionError all =
            reference_error(truth, noisy_reference(truth, 0.1f, 3 * stream), all_flat(size))
                .over(Region::all);
        CAPTURE(stream);
        CHECK(all.squared.below_noise() == (all.squared.mean < 0));
        CHECK((all.rmse() == 0) == all.squared.below_noise());
        CHECK(all.rmse_raw > 0.05);
        seen_below = seen_below || all.squared.below_noise();
    }
    CHECK(seen_below);
}

TEST_CASE("the standard error knows that neighbouring pixels go together") {
    // Errors that are the same all over a block are one observation a block, not 256.
    const Size size{256, 256};
    const Image<float> truth(size, 0.5f);
    const Image<float> blocks = image_of(size, [](int x, int y) {
        return 0.5f + 0.1f * unit_noise(7, x / kErrorBlock_px, y / kErrorBlock_px);
    });
    const Image<float> pixels =
        image_of(size, [](int x, int y) { return 0.5f + 0.1f * unit_noise(7, x, y); });
    const auto error_of = [&](const Image<float>& image) {
        return reference_error(image, exact_reference(truth), all_flat(size)).over(Region::all).squared.error;
    };
    CHECK(error_of(blocks) == about(kErrorBlock_px * error_of(pixels), 0.25));
}

TEST_CASE("the standard error of two blocks, counted by hand; a block without pixels is none") {
    // Errors .1 and .3: squares .01 and .09, mean .05; of two, the standard error is half the difference.
    for (const bool sideways : {true, false}) {
        CAPTURE(sideways);
        const Size size =
            sideways ? Size{3 * kErrorBlock_px, kErrorBlock_px} : Size{kErrorBlock_px, 3 * kErrorBlock_px};
        const auto block = [=](int x, int y) { return (sideways ? x : y) / kErrorBlock_px; };
        const Image<float> truth(size, 0.5f),
            image = image_of(size, [&](int x, int y) { return block(x, y) == 0 ? 0.6f : 0.8f; });
        Image<SurfaceKind> kinds(size, SurfaceKind::flat);
        for (int y = 0; y < size.height; ++y)
            for (int x = 0; x < size.width; ++x)
                if (block(x, y) == 2) kinds.at(x, y) = SurfaceKind::sky;
        const DebiasedSquare found =
            reference_error(image, exact_reference(truth), kinds).over(Region::surface).squared;
        CHECK(found.mean == about(0.05, 1e-6));
        CHECK(found.error == about(0.04, 1e-6));
    }
}

TEST_CASE("better is claimed for images that are, not for noise; what is common cancels") {
    const Size size{128, 96};
    const Image<float> truth = noise_image(size, 11);
    const ReferenceImage reference = noisy_reference(truth, 0.2f, 60);
    const Image<SurfaceKind> kinds = stripes(size);
    const auto difference = [&](const Image<float>& a, const Image<float>& b, Region region) {
        return mse_difference(a, b, reference, kinds, region);
    };
    const Image<float> near = with_noise(truth, 0.05f, 70), far = with_noise(truth, 0.06f, 80),
                       also_near = with_noise(truth, 0.05f, 90);
    const MseDifference better = difference(near, far, Region::all);
    CHECK(better.mean == about(0.05 * 0.05 - 0.06 * 0.06, 0.5));
    CHECK(better.a_is_better());
    CHECK(!better.b_is_better());
    CHECK(difference(far, near, Region::all).b_is_better());
    CHECK(!difference(near, also_near, Region::all).a_is_better());
    CHECK(!difference(near, also_near, Region::all).b_is_better());
    // Not paired, the noise of the reference would hide it: its own error is larger than the difference.
    const double unpaired = reference_error(near, reference, kinds).over(Region::all).squared.error;
    CHECK(better.error < 0.8 * unpaired);
    CHECK(difference(near, near, Region::all).mean == 0);
    CHECK(!difference(near, near, Region::all).a_is_better());
    // It is the difference of the two MSEs, in every region.
    for (const Region region : kRegions) {
        CAPTURE(region_name(region));
        const double a = reference_error(near, reference, kinds).over(region).squared.mean,
                     b = reference_error(far, reference, kinds).over(region).squared.mean;
        CHECK(difference(near, far, region).mean == about(a - b, 1e-9));
    }
}
