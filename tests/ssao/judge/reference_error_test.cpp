#include "ssao/judge/reference_error.h"

#include <cmath>

#include <doctest/doctest.h>

#include "rasterizer/base/error.h"
#include "ssao/judge/metrics.h"
#include "tests/tools/about.h"
#include "tests/tools/noise.h"
#include "tests/tools/noisy_images.h"
#include "tests/tools/special_floats.h"

using namespace crevice;

TEST_CASE("reference error: an image 0.1 brighter has bias 0.1, and every other error follows") {
    const Size size{40, 24};
    const Image<float> truth = image_of(size, [](int x, int y) { return 0.5f * noise(2, x, y); });
    const Image<float> image = image_of(size, [&](int x, int y) { return truth.at(x, y) + 0.1f; });
    const ReferenceError error = reference_error(image, exact_reference(truth), all_flat(size));
    const RegionError& all = error.over(Region::all);
    // Rounded to float, each difference is 0.1 within half an ulp of 1.
    for (const double value :
         {all.bias, all.mae, all.rmse_raw, all.rmse(), all.p50, all.p95, all.p99, all.max_abs}) {
        CHECK(std::fabs(value - 0.1) < 6e-8);
    }
    CHECK(all.reference_error == 0);
    CHECK(all.pixels == 960);
    CHECK(!error.failed());
    CHECK(error.ssim < 1);
    CHECK(*error.flip_mean > 0.1);
    CHECK(*error.flip_p99 >= *error.flip_mean);
}

TEST_CASE("reference error: identical images give 0, SSIM 1 and FLIP 0") {
    const Size size{33, 21};
    const Image<float> truth = noise_image(size, 4);
    const ReferenceError error = reference_error(truth, exact_reference(truth), stripes(size));
    for (const Region region : kRegions) {
        CAPTURE(region_name(region));
        const RegionError& over = error.over(region);
        CHECK(over.pixels > 0);
        for (const double value : {over.bias, over.mae, over.rmse_raw, over.rmse(), over.rel_mse,
                                   over.max_abs, over.squared.mean, over.squared.error}) {
            CHECK(value == 0);
        }
        CHECK(!over.squared.below_noise());
    }
    CHECK(error.ssim == 1);
    CHECK(*error.flip_mean == 0);
    CHECK(*error.flip_p99 == 0);
}

TEST_CASE("reference error: hand-counted numbers, region by region") {
    // Kinds sky, edge, crease, flat, flat; a - r is 1, -.5, .25, 0, .5.
    const Size size{5, 1};
    Image<float> image({5, 1}, 0), r1 = image, r2 = image, own({5, 1}, 0.5f);
    const float values[] = {1, 0, 0.5f, 0.25f, 1}, first[] = {0, 0.25f, 0.25f, 0.25f, 0.5f},
                second[] = {0, 0.75f, 0.25f, 0.25f, 0.5f};
    Image<SurfaceKind> kinds(size, SurfaceKind::flat);
    for (int x = 0; x < 5; ++x) {
        image.at(x, 0) = values[x];
        r1.at(x, 0) = first[x];
        r2.at(x, 0) = second[x];
        kinds.at(x, 0) = static_cast<SurfaceKind>(std::min(x, 3));
    }
    own.at(0, 0) = 0;
    const ReferenceError error = reference_error(image, {r1, own, {r1, r2}}, kinds);
    const RegionError &all = error.over(Region::all), &surface = error.over(Region::surface),
                      &edge = error.over(Region::edge), &crease = error.over(Region::crease),
                      &flat = error.over(Region::flat);
    CHECK(all.pixels == 5);
    CHECK(surface.pixels == 4);
    CHECK(edge.pixels == 1);
    CHECK(crease.pixels == 1);
    CHECK(flat.pixels == 2);
    CHECK(all.bias == (1 - 0.5 + 0.25 + 0.5) / 5);
    CHECK(all.mae == 2.25 / 5);
    CHECK(all.rmse_raw == std::sqrt((1 + 0.25 + 0.0625 + 0.25) / 5));
    CHECK(all.max_abs == 1);
    CHECK(all.p50 == 0.5);  // of 0 .25 .5 .5 1
    CHECK(all.p95 == 1);
    CHECK(surface.bias == 0.25 / 4);
    CHECK(edge.bias == -0.5);
    CHECK(edge.squared.mean == 0.25 * 0.75);  // (0 - .25)(0 - .75), not .5^2
    CHECK(edge.rel_mse == about(0.25 / 0.26, 1e-12));
    CHECK(edge.rmse() == std::sqrt(0.1875));
    CHECK(crease.mae == 0.25);
    CHECK(flat.bias == 0.25);
    CHECK(flat.reference_error == 0.5);
    CHECK(all.reference_error == about(std::sqrt(0.2), 1e-12));
    // All in one block: nothing is known of its spread.
    CHECK(std::isinf(all.squared.error));
}

TEST_CASE("reference error: percentiles of a hundred errors") {
    const Size size{10, 10};
    const Image<float> image =
        image_of(size, [](int x, int y) { return static_cast<float>((37 * (10 * y + x)) % 100 + 1); });
    const RegionError all =
        reference_error(image, exact_reference(Image<float>(size, 0.0f)), all_flat(size)).over(Region::all);
    CHECK(all.p50 == 50);
    CHECK(all.p95 == 95);
    CHECK(all.p99 == 99);
    CHECK(all.max_abs == 100);
}

TEST_CASE("reference error: one NaN or infinity fails, is counted, and is left out") {
    const Size size{24, 16};
    const Image<float> truth(size, 0.5f), image(size, 0.75f);
    for (const float broken : {kNan, kInfinity, -kInfinity}) {
        for (int where = 0; where < 4; ++where) {
            CAPTURE(broken);
            CAPTURE(where);
            Image<float> a = image;
            ReferenceImage reference = exact_reference(truth);
            Image<float>* const places[] = {&a, &reference.half[0], &reference.half[1], &reference.error};
            places[where]->at(5, 3) = broken;  // an edge of the stripes
            const ReferenceError error = reference_error(a, reference, stripes(size));
            CHECK(error.failed());
            CHECK(error.over(Region::all).nan_or_inf == 1);
            CHECK(error.over(Region::edge).nan_or_inf == 1);
            CHECK(error.over(Region::flat).nan_or_inf == 0);
            CHECK(error.over(Region::edge).bias == 0.25);
            CHECK(error.over(Region::all).max_abs == 0.25);
            CHECK(!error.flip_mean);
            CHECK(!error.flip_p99);
        }
    }
}

TEST_CASE("reference error agrees with compare_images on what both report") {
    const Size size{50, 40};
    const Image<float> a = noise_image(size, 21);
    const ReferenceImage reference = noisy_reference(noise_image(size, 22), 0.05f, 23);
    const ImageError plain = compare_images(a, reference.mean);
    const ReferenceError error = reference_error(a, reference, all_flat(size));
    const RegionError& all = error.over(Region::all);
    CHECK(all.bias == about(plain.bias, 1e-6));
    CHECK(all.mae == about(plain.mae, 1e-6));
    CHECK(all.rmse_raw == about(plain.rmse, 1e-6));
    CHECK(all.p99 == about(plain.p99, 1e-6));
    CHECK(all.max_abs == about(plain.max_abs, 1e-6));
    CHECK(error.ssim == plain.ssim);
}

TEST_CASE("mean_error: the two numbers of reference_error, alone") {
    const Size size{50, 40};
    const Image<float> a = noise_image(size, 31), truth = noise_image(size, 32);
    const ReferenceImage reference = noisy_reference(truth, 0.05f, 33);
    const ReferenceError whole = reference_error(a, reference, stripes(size));
    for (const Region region : kRegions) {
        CAPTURE(region_name(region));
        const MeanError found = mean_error(a, reference, stripes(size), region);
        CHECK(found.bias == about(whole.over(region).bias, 1e-9));
        CHECK(found.squared.mean == whole.over(region).squared.mean);
        CHECK(found.squared.error == whole.over(region).squared.error);
    }
    Image<float> broken = a;
    broken.at(7, 2) = kNan;
    CHECK_THROWS_AS(mean_error(broken, reference, stripes(size), Region::all), InputError);
    CHECK_THROWS_AS(mean_error(a, reference, stripes({50, 39}), Region::all), InputError);
}

TEST_CASE("a region without pixels has zeros and says so") {
    const Size size{20, 20};
    const RegionError edge =
        reference_error(noise_image(size, 1), exact_reference(noise_image(size, 2)), all_flat(size))
            .over(Region::edge);
    CHECK(edge.pixels == 0);
    CHECK(edge.max_abs == 0);
    CHECK(edge.squared.error == 0);
}

TEST_CASE("reference error refuses what cannot be compared") {
    const Size size{20, 20};
    const Image<float> image(size, 0.5f), other({20, 19}, 0.5f);
    const ReferenceImage reference = exact_reference(image);
    CHECK_THROWS_AS(reference_error(other, reference, all_flat(size)), InputError);
    CHECK_THROWS_AS(reference_error(image, reference, all_flat({19, 20})), InputError);
    CHECK_THROWS_AS(reference_error(image, {image, image, {image, other}}, all_flat(size)), InputError);
    CHECK_THROWS_AS(reference_error(image, {image, other, {image, image}}, all_flat(size)), InputError);
    CHECK_THROWS_AS(mse_difference(image, other, reference, all_flat(size), Region::all), InputError);
    Image<float> broken = image;
    broken.at(7, 2) = kNan;
    CHECK_THROWS_WITH_AS(mse_difference(image, broken, reference, all_flat(size), Region::all),
                         "errors cannot be compared at a NaN or infinity (pixel 7, 2); mend the image or the "
                         "reference first",
                         InputError);
    CHECK_NOTHROW(mse_difference(image, broken, reference, all_flat(size), Region::edge));
}
