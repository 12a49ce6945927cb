#include "chapters/sweep/error_job.h"

#include <cmath>
#include <utility>

#include "chapters/study/error_chain.h"
#include "chapters/sweep/results_json.h"
#include "chapters/sweep/sweep_words.h"
#include "rasterizer/base/error.h"
#include "rasterizer/base/float_text.h"
#include "rasterizer/base/image_summary.h"
#include "ssao/light/widened_ao.h"

namespace crevice {

namespace {

constexpr int kWidestPicture_px = 320;

// Of the method's limit, which has full size and as many samples as the method has by default.
MethodSettings limit_settings(const Method& method, const MethodSettings& settings) {
    MethodSettings limit = settings;
    const MethodSettings defaults = defaults_of(method);
    for (const char* name : {"samples", "seed"}) {
        if (const std::optional<double> value = value_of(method, defaults, name))
            limit = with_value(method, limit, name, *value);
    }
    return with_value(method, limit, "ao_scale", 1);
}

std::string words_of_limit(const Method& method, const MethodSettings& settings) {
    std::string words = method.name;
    for (const auto& parameter : method.parameters) words += " " + shortest_text(parameter.get(settings.ao));
    return words;
}

}  // namespace

SweepError sweep_error(const ReferenceError& error) {
    const RegionError& surface = error.over(Region::surface);
    SweepError kept;
    kept.rmse = surface.rmse();
    // Below the noise the root has no slope: its square is within its error of 0.
    kept.rmse_error =
        kept.rmse > 0 ? surface.squared.error / (2 * kept.rmse) : std::sqrt(surface.squared.error);
    kept.bias = surface.bias;
    kept.mae = surface.mae;
    kept.p99 = surface.p99;
    kept.flip = error.flip_mean.value_or(0);
    kept.ssim = error.ssim;
    kept.reference_error = surface.reference_error;
    kept.mse = surface.squared.mean;
    kept.mse_error = surface.squared.error;
    return kept;
}

std::vector<SweepErrorPart> sweep_parts(const ErrorParts& parts) {
    std::vector<SweepErrorPart> kept;
    for (const ErrorPart& part : parts.parts) kept.push_back({part.step, part.bias, part.rmse, part.share});
    return kept;
}

Image<float> small_picture(const Image<float>& image) {
    const int step = (image.size.width + kWidestPicture_px - 1) / kWidestPicture_px;
    Image<float> small({(image.size.width + step - 1) / step, (image.size.height + step - 1) / step}, 1.0f);
    for (int y = 0; y < small.size.height; ++y) {
        for (int x = 0; x < small.size.width; ++x) small.at(x, y) = image.at(x * step, y * step);
    }
    return small;
}

void ErrorJudge::look_at(const SweepJob& job, const Method& method, const FrameSettings& settings) {
    const Scene& scene = job.scene->argument.scene;
    const std::string seen = job.scene->key + json_line(job.view);
    const std::string asked = seen + job.asks + " " + std::to_string(job.reference_rays);
    if (seen != seen_) view_ = method_view(scene, job.scene->camera, job.view.size, method, run_);
    view_ = for_method(*view_, method, run_);
    seen_ = seen;
    // Only who takes errors apart asks what the depth buffer knows.
    const bool lacks_screen = job.parts && references_.screen.image.mean.empty();
    if (asked == asked_ && !lacks_screen) return;
    request_ = {};
    request_.size = job.view.size;
    request_.method = &method;
    request_.settings = settings.method;
    request_.rays = rays_asking(method.question(settings.method.ao));
    request_.rays.rays = job.reference_rays;
    request_.limit_seeds = 0;
    request_.wants_screen = job.parts;
    request_.shows_progress = false;
    request_.cache = cache_;
    request_.run = run_;
    references_ = make_references(scene, job.scene->camera, request_);
    if (references_.points.pixel.empty())
        throw UsageError(words_of(job.view) + ": no surface is seen; look somewhere else");
    kinds_ = surface_kinds(references_.gbuffer, job.scene->camera);
    asked_ = asked;
    limited_.clear();
}

void ErrorJudge::take_apart(const MethodView& view, const FrameSettings& settings, SweepErrorResult& result) {
    const Method& method = *view.method;
    const MethodSettings limit = limit_settings(method, settings.method);
    const std::string limited = words_of_limit(method, limit);
    if (limited != limited_) {
        request_.method = &method;
        request_.settings = limit;
        request_.limit_seeds = kPartsSeeds;
        FrameSettings in_float32;
        in_float32.method = limit;
        references_.limit = make_limit(ao_view_of(view, in_float32), references_.points, request_);
        limited_ = limited;
    }
    const std::vector<ChainImage> chain = error_chain(view, references_, settings, kPartsSeeds, run_);
    const Image<std::uint8_t> counted = region_mask(kinds_, Region::surface);
    result.parts = sweep_parts(error_parts(chain, counted));
    const auto halves = [](const char* step, const Reference& of) {
        return ChainImage{step, of.image.half[0], of.image.half[1]};
    };
    const ChainImage to_limit[] = {halves("truth", references_.soft), halves("limit", references_.limit)};
    result.limit_mse = error_parts(to_limit, counted).total.mse;
}

ErrorJudge::JudgedImage ErrorJudge::judge(const SweepJob& job) {
    const SweepSetting& setting = job.settings.front();
    const Method& method = find_method(setting.method);
    const FrameSettings settings = frame_settings(setting, job.seed, job.scene->argument.scene.length_unit);
    look_at(job, method, settings);
    const MethodView view = with_bake(*view_, settings, run_);
    const Image<float> map = ao_map_of(view, settings, run_);
    const Image<float> image = ao_at_picture_size(map, view.size, run_);
    const ReferenceError soft = reference_error(image, references_.soft.image, kinds_);
    JudgedImage judged;
    SweepErrorResult& result = judged.result;
    result.id = job.id;
    result.view = job.view;
    result.setting = setting;
    result.seed = job.seed;
    result.nan_or_inf = soft.over(Region::surface).nan_or_inf;
    result.soft = sweep_error(soft);
    result.hard = sweep_error(reference_error(image, references_.hard.image, kinds_));
    if (job.parts && !soft.failed()) take_apart(view, settings, result);
    result.hash = content_hash(map);
    result.command = command_of(job.view, setting, job.seed, 0);
    judged.picture = small_picture(image);
    return judged;
}

}  // namespace crevice
