// What a sweep makes of an AO image and its reference: images of known errors come out as what they are.
#include "chapters/sweep/error_job.h"

#include <cmath>
#include <limits>

#include <doctest/doctest.h>

#include "chapters/frame/frame.h"
#include "chapters/sweep/results_json.h"
#include "chapters/sweep/shards.h"
#include "chapters/sweep/sweep_words.h"
#include "rasterizer/base/image_summary.h"
#include "tests/tools/noisy_images.h"
#include "tests/tools/sweep_plans.h"

using namespace crevice;

namespace {

constexpr Size kSize{96, 64};
constexpr float kSigma = 0.08f;

// A slope from 0.3 to 0.7, `bias` higher.
Image<float> slope(float bias) {
    return image_of(kSize,
                    [&](int x, int) { return 0.3f + 0.4f * static_cast<float>(x) / kSize.width + bias; });
}

SweepError judged(const Image<float>& image, const ReferenceImage& reference) {
    return sweep_error(reference_error(image, reference, all_flat(kSize)));
}

}  // namespace

TEST_CASE("sweep error: a known bias") {
    const SweepError error = judged(slope(0.125f), exact_reference(slope(0)));
    for (const double value : {error.bias, error.rmse, error.mae, error.p99})
        CHECK(value == doctest::Approx(0.125).epsilon(1e-5));
    CHECK(error.mse == doctest::Approx(0.125 * 0.125).epsilon(1e-5));
    CHECK(error.flip > 0.05);
    CHECK(error.rmse_error < 1e-6);
}

TEST_CASE("sweep error: known noise, in the image and in the reference") {
    const Image<float> image = with_noise(slope(0), kSigma, 1);
    const SweepError clean = judged(image, exact_reference(slope(0)));
    CHECK(clean.rmse == doctest::Approx(kSigma).epsilon(0.03));
    CHECK(std::abs(clean.bias) < 0.005);
    CHECK(clean.rmse_error > 0);
    CHECK(std::abs(clean.rmse - kSigma) < 4 * clean.rmse_error);
    // The noise of the reference is not the image's.
    const SweepError noisy = judged(image, noisy_reference(slope(0), kSigma, 2));
    CHECK(std::abs(noisy.rmse - kSigma) < 4 * noisy.rmse_error);
    CHECK(noisy.rmse_error > clean.rmse_error);
    CHECK(noisy.reference_error == doctest::Approx(kSigma / std::sqrt(2.0)).epsilon(1e-4));
}

TEST_CASE("sweep error: an identical pair, and one that only the reference's noise tells apart") {
    const SweepError same = judged(slope(0), exact_reference(slope(0)));
    for (const double value :
         {same.rmse, same.rmse_error, same.bias, same.mae, same.p99, same.flip, same.reference_error})
        CHECK(value == 0);
    CHECK(same.ssim == doctest::Approx(1));
    const SweepError close = judged(slope(0), noisy_reference(slope(0), kSigma, 2));
    CHECK(close.rmse < 0.25 * kSigma);
    CHECK(close.rmse_error > 0);
    CHECK(close.rmse_error < kSigma);
}

TEST_CASE("sweep error: a NaN is left out of all numbers and noticed") {
    Image<float> broken = slope(0.125f);
    broken.at(5, 7) = std::numeric_limits<float>::quiet_NaN();
    const ReferenceError error = reference_error(broken, exact_reference(slope(0)), all_flat(kSize));
    CHECK(error.over(Region::surface).nan_or_inf == 1);
    const SweepError kept = sweep_error(error);
    CHECK(kept.bias == doctest::Approx(0.125).epsilon(1e-5));
    CHECK(kept.rmse == doctest::Approx(0.125).epsilon(1e-5));
    CHECK(std::isfinite(kept.flip));
}

TEST_CASE("sweep error: parts keep what they add up to") {
    const std::vector<ChainImage> chain = {
        {"truth", slope(0)}, {"definition", slope(-0.25f)}, {"sampling", slope(-0.125f)}};
    const std::vector<SweepErrorPart> parts = sweep_parts(error_parts(chain));
    REQUIRE(parts.size() == 2);
    CHECK(parts[0].step == "definition");
    CHECK(parts[0].bias == doctest::Approx(-0.25));
    CHECK(parts[1].bias == doctest::Approx(0.125));
    CHECK(parts[1].rmse == doctest::Approx(0.125));
    CHECK(parts[0].share + parts[1].share == doctest::Approx(0.125 * 0.125));
}

TEST_CASE("sweep: a small picture has at most 320 columns and all of the image") {
    CHECK(small_picture(Image<float>({320, 180}, 0.5f)).size == Size{320, 180});
    CHECK(small_picture(Image<float>({321, 180}, 0.5f)).size == Size{161, 90});
    CHECK(small_picture(Image<float>({1280, 720}, 0.5f)).size == Size{320, 180});
    Image<float> image({640, 2}, 0.0f);
    for (int x = 0; x < 640; ++x) image.at(x, 0) = static_cast<float>(x);
    const Image<float> small = small_picture(image);
    CHECK(small.size == Size{320, 1});
    CHECK(small.at(319, 0) == 638);
}

TEST_CASE(
    "error job: the image that render makes, the same on any number of threads and after any other job") {
    const std::string plan = plan_with("\"reference_rays\": 16", "\"reference_rays\": 16, \"parts\": true");
    const std::vector<SweepJob> jobs = jobs_of(plan);
    ErrorJudge together(std::nullopt, {.threads = 1});
    for (const SweepJob& job : jobs) {
        CAPTURE(words_of(job));
        const SweepErrorResult result = together.judge(job).result;
        ErrorJudge alone(std::nullopt, {.threads = 2});
        FinishedJob once{job.id, "", result, {}, {}}, again{job.id, "", alone.judge(job).result, {}, {}};
        CHECK(job_json(once) == job_json(again));
        CHECK(result.id == job.id);
        CHECK(result.parts.empty() == (job.seed != 1000));
        double share = 0;
        for (const SweepErrorPart& part : result.parts) share += part.share;
        CHECK(result.limit_mse.has_value() == !result.parts.empty());
        if (!result.parts.empty())
            CHECK(share == doctest::Approx(result.soft.rmse * result.soft.rmse).epsilon(0.05));
        FrameRequest request;
        request.size = job.view.size;
        request.method = &find_method(result.setting.method);
        request.settings = frame_settings(result.setting, job.seed, job.scene->argument.scene.length_unit);
        request.wanted = {"ao_blurred"};
        const Frame frame = render_frame(job.scene->argument.scene, job.scene->camera, request);
        CHECK(result.hash == content_hash(frame.ao_blurred));
    }
}

TEST_CASE("error job: every method can be judged and taken apart") {
    const std::string all =
        plan_with("[\"xjun\", {\"method\": \"gtao\", \"parameters\": {\"samples\": [4, 8]}}]", "\"all\"",
                  plan_with("\"reference_rays\": 16", "\"reference_rays\": 16, \"parts\": true",
                            plan_with("[1000, 1001]", "[1000]",
                                      plan_with("[0.5, 1]", "[0.5]", plan_with("[48, 27]", "[32, 18]")))));
    ErrorJudge judge(std::nullopt, {});
    for (const SweepJob& job : dealt(jobs_of(all), {})) {
        CAPTURE(words_of(job));
        const SweepErrorResult result = judge.judge(job).result;
        CHECK(result.nan_or_inf == 0);
        CHECK(result.soft.rmse > 0);
        CHECK(result.soft.rmse < 0.6);
        REQUIRE(result.parts.size() >= 3);
        // No mean square lies below the square of its mean, but for noise.
        const double bias = result.parts[0].bias + result.parts[1].bias;
        CHECK(*result.limit_mse > bias * bias - 0.005);
    }
}

TEST_CASE("error job: a view without any surface is refused") {
    const std::string plan =
        plan_with("\"cornell\"", R"({"scene": "cornell", "eye": [0, 0, -9000], "target": [0, 0, -9001]})");
    ErrorJudge judge(std::nullopt, {});
    CHECK_THROWS_AS(judge.judge(jobs_of(plan).front()), UsageError);
}
