#include "chapters/study/methods_study.h"

#include <memory>

#include "chapters/study/candidates.h"
#include "chapters/study/method_view.h"

namespace crevice {

namespace {

std::vector<int> samples_of(const Method& method, bool all) {
    const std::vector<int>& samples = method.samples_to_try;
    if (all || samples.size() <= 3) return samples;
    return {samples.front(), samples[(samples.size() - 1) / 2], samples.back()};
}

std::string setting_of(int samples, float scale) {
    return std::to_string(samples) + (samples == 1 ? " sample" : " samples") +
           (scale < 1 ? ", half size" : ", full size");
}

// The method's pictures, each with its denoiser.
void add_candidates(const std::shared_ptr<const MethodView>& view, const MethodsPlan& plan, float radius,
                    const Run& run, std::vector<Candidate>& all) {
    const Method& method = *view->method;
    for (const float scale : plan.scales) {
        for (const int samples : samples_of(method, plan.all_samples)) {
            const auto settings = [=, &method](std::uint32_t seed) {
                FrameSettings frame = settings_for_study(method, view->length_unit, radius);
                for (const auto& [name, value] : {std::pair<const char*, double>{"samples", samples},
                                                  {"ao_scale", scale},
                                                  {"seed", seed}})
                    frame.method = with_value(method, frame.method, name, value);
                return frame;
            };
            Candidate candidate;
            candidate.point.method = method.name;
            candidate.point.setting = setting_of(samples, scale);
            candidate.of_method = true;
            candidate.picture = [=](std::uint32_t seed) { return ao_picture_of(*view, settings(seed), run); };
            // A bake is no part of a frame: it is made in the first round, which does not count.
            const auto baked = std::make_shared<std::optional<MethodView>>();
            candidate.timed = [=] {
                if (!*baked) *baked = with_bake(*view, settings(kFirstStudySeed), run);
                ao_map_of(**baked, settings(kFirstStudySeed), run);
            };
            all.push_back(std::move(candidate));
        }
    }
}

}  // namespace

MethodsPlan full_methods_plan() { return {}; }

MethodsPlan quick_methods_plan() {
    MethodsPlan plan;
    plan.size = {320, 180};
    plan.all_samples = false;
    plan.seeds = 1;
    plan.rounds = 5;
    return plan;
}

MethodsTruth methods_truth(const Scene& scene, const Camera& camera, Size size, int rays,
                           const std::optional<std::filesystem::path>& cache, const Run& run) {
    const float radius = kAskedRadius * scene.length_unit;
    ReferenceRequest request;
    request.size = size;
    request.method = &find_method("gtao");
    request.settings = with_value(*request.method, defaults_of(*request.method), "radius", radius);
    request.rays = rays_asking(request.method->question(request.settings.ao));
    request.rays.rays = rays;
    request.limit_seeds = 0;
    request.cache = cache;
    request.run = run;
    References references = make_references(scene, camera, request);
    return {radius, std::move(references.hard), surface_kinds(references.gbuffer, camera)};
}

FrameSettings settings_for_study(const Method& method, float length_unit, float radius) {
    FrameSettings settings;
    settings.method = with_value(method, defaults_of(method, length_unit), "radius", radius);
    return settings;
}

MethodsStudy methods_study(const Scene& scene, const Camera& camera, const MethodsPlan& plan,
                           const std::optional<std::filesystem::path>& cache, bool timed, const Run& run,
                           const StudyProgress& progress) {
    MethodsTruth truth = methods_truth(scene, camera, plan.size, plan.reference_rays, cache, run);
    MethodsStudy study{plan, truth.radius, {}, {}};
    std::vector<Candidate> candidates;
    for (const Method& method : ao_methods()) {
        if (!method.computes_ao()) continue;
        add_candidates(std::make_shared<const MethodView>(method_view(scene, camera, plan.size, method, run)),
                       plan, study.radius, run, candidates);
    }
    for (std::size_t i = 0; i < candidates.size(); ++i) {
        std::vector<MeanError> errors;
        for (int k = 0; k < plan.seeds; ++k) {
            const Image<float> picture =
                candidates[i].picture(kFirstStudySeed + static_cast<std::uint32_t>(k));
            errors.push_back(mean_error(picture, truth.reference.image, truth.kinds, Region::surface));
        }
        candidates[i].point.truth = spread_of(errors);
        if (progress)
            progress("images", static_cast<long long>(i) + 1, static_cast<long long>(candidates.size()));
    }
    if (timed) time_in_turns(candidates, plan.rounds, plan.slow_rounds, progress);
    for (Candidate& candidate : candidates) study.points.push_back(std::move(candidate.point));
    study.truth = std::move(truth.reference);
    return study;
}

}  // namespace crevice
