#include "chapters/study/error_study.h"

#include <cmath>
#include <set>

#include <doctest/doctest.h>

#include "chapters/study/error_chain.h"
#include "rasterizer/base/image_summary.h"
#include "ssao/methods/luna_ssao.h"
#include "tests/tools/still_life.h"
#include "tests/tools/tutorial_settings.h"

using namespace crevice;

namespace {

ErrorPlan small_plan() {
    ErrorPlan plan;
    plan.size = {48, 27};
    plan.settings = {{1, 1, 0, false}, {14, 1, 0, false}, {14, 0.5f, 4, true}};
    plan.cast_rays = {4, 64};
    plan.vertex_rays = {16};
    plan.seeds = 2;
    plan.reference_rays = 64;
    plan.limit_seeds = 32;
    return plan;
}

ErrorStudy study_of(const char* method, const Run& run = {}) {
    const Scene scene = still_life();
    return error_study(scene, scene.camera, find_method(method), small_plan(), std::nullopt, false, run);
}

std::vector<std::string> steps_of(const std::vector<ChainImage>& chain) {
    std::vector<std::string> steps;
    for (const ChainImage& image : chain) steps.push_back(image.step);
    return steps;
}

}  // namespace

TEST_CASE("error settings: names, and what they set") {
    CHECK(setting_name({1, 1, 1, false}) == "1 sample, full size, 1 blur, float32");
    CHECK(setting_name({14, 0.5f, 4, true}) == "14 samples, half size, 4 blurs, float16");
    const FrameSettings settings = settings_of(find_method("luna"), {7, 1, 2, true}, 4, 99);
    CHECK(ao_of(settings).samples == 7);
    CHECK(ao_of(settings).ao_scale == 1);
    CHECK(ao_of(settings).seed == 99);
    CHECK(ao_of(settings).radius == 4 * kLunaSettings.radius);
    CHECK(blur_of(settings).iterations == 2);
    for (const BufferFormat format : {ao_of(settings).format, settings.buffers.buffer_format})
        CHECK(format == BufferFormat::float16_toward_zero);
    CHECK(default_setting(find_method("luna")).blur_iterations == 3);
    CHECK(default_setting(find_method("xjun")).blur_iterations == 4);
}

TEST_CASE("error plans: the full one has every combination once, the quick one no others") {
    std::set<std::string> full;
    const Method& xjun = find_method("xjun");
    const ErrorPlan whole_plan = full_error_plan(xjun), quick_plan = quick_error_plan(xjun);
    for (const ErrorSetting& setting : whole_plan.settings) full.insert(setting_name(setting));
    CHECK(full.size() == 6 * 2 * 5 * 2);
    CHECK(full.size() == whole_plan.settings.size());
    for (const ErrorSetting& setting : quick_plan.settings) CHECK(full.count(setting_name(setting)) == 1);
    CHECK(whole_plan.seeds >= 8);
    CHECK(quick_plan.seeds >= 8);
}

TEST_CASE("error chain: one step for each thing that a setting does") {
    const Scene scene = still_life();
    const Method& method = find_method("xjun");
    ReferenceRequest request;
    request.size = {48, 27};
    request.method = &method;
    request.settings = defaults_of(method);
    request.rays.rays = 16;
    request.limit_seeds = 8;
    const References references = make_references(scene, scene.camera, request);
    const MethodView view = method_view(scene, scene.camera, request.size, method, {});
    const auto chain_of = [&](const ErrorSetting& setting) {
        return error_chain(view, references, settings_of(method, setting, 1, 5), 8, {});
    };
    using Steps = std::vector<std::string>;
    CHECK(steps_of(chain_of({14, 1, 0, false})) ==
          Steps{"truth", "depth buffer", "definition", "sampling", "rounding"});
    CHECK(steps_of(chain_of({14, 0.5f, 4, true})) == Steps{"truth", "depth buffer", "definition", "half size",
                                                           "sampling", "rounding", "float16", "blur, bias",
                                                           "blur, noise removed"});
    // It ends with the picture that the setting makes.
    const ErrorSetting setting{14, 0.5f, 4, true};
    const Image<float> picture = ao_picture_of(view, settings_of(method, setting, 1, 5), {});
    CHECK(content_hash(chain_of(setting).back().first) == content_hash(picture));
    // Without seeds of its own left to draw, an image has no second half.
    CHECK(chain_of(setting).back().second.empty());
    CHECK(!chain_of(setting)[3].second.empty());
}

TEST_CASE("error study: rays converge to truth, the method to its limit, and parts add up") {
    for (const char* name : {"xjun", "luna"}) {
        CAPTURE(name);
        const ErrorStudy study = study_of(name);
        REQUIRE(study.points.size() == 6);
        const StudyPoint &one = study.points[0], &fourteen = study.points[1], &four_rays = study.points[3],
                         &many_rays = study.points[4], &baked = study.points[5];
        CHECK(one.method == name);
        CHECK(four_rays.method == "ray_cast");
        CHECK(baked.method == "vertex_bake");
        REQUIRE(one.limit.has_value());
        REQUIRE(fourteen.limit.has_value());
        CHECK(!many_rays.limit.has_value());
        CHECK(fourteen.limit->rmse < 0.6 * one.limit->rmse);
        CHECK(many_rays.truth.rmse < 0.4 * four_rays.truth.rmse);
        CHECK(std::abs(many_rays.truth.bias) < 0.01);
        CHECK(fourteen.truth.rmse > many_rays.truth.rmse);
        for (const StudyPoint& point : study.points) {
            CAPTURE(point.setting);
            CHECK(point.truth.lowest <= point.truth.rmse);
            CHECK(point.truth.rmse <= point.truth.highest);
            CHECK(point.time.runs == 0);
        }
        double bias = 0, share = 0;
        for (const ErrorPart& part : study.parts.parts) {
            bias += part.bias;
            share += part.share;
        }
        CHECK(bias == doctest::Approx(study.parts.total.bias).epsilon(1e-9));
        CHECK(share == doctest::Approx(study.parts.total.share).epsilon(1e-9));
        CHECK(study.fitted_on.size() == 3);  // still_life is none of them
    }
}

TEST_CASE("error study: the same numbers from one thread and one lane") {
    Run run;
    run.threads = 1;
    run.lanes = 1;
    const ErrorStudy a = study_of("luna"), b = study_of("luna", run);
    REQUIRE(a.points.size() == b.points.size());
    for (std::size_t i = 0; i < a.points.size(); ++i) {
        CAPTURE(a.points[i].setting);
        CHECK(a.points[i].truth.rmse == b.points[i].truth.rmse);
        CHECK(a.points[i].screen.bias == b.points[i].screen.bias);
    }
    CHECK(a.fitted_exponent == b.fitted_exponent);
    CHECK(a.parts.total.share == b.parts.total.share);
}
