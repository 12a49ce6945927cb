#include "chapters/study/error_study.h"

#include <algorithm>
#include <cmath>

#include "chapters/study/candidates.h"
#include "chapters/study/error_chain.h"
#include "ssao/bakes/vertex_ao_picture.h"
#include "ssao/judge/fitted_power.h"

namespace crevice {

namespace {

class Study {
 public:
    Study(const Scene& scene, const Camera& camera, const Method& method, const ErrorPlan& plan,
          const Run& run, const StudyProgress& progress)
        : scene_(scene), run_(run), progress_(progress) {
        study.method = &method;
        study.camera = camera;
        study.plan = plan;
        view_ = method_view(scene, camera, plan.size, method, run);
        rays_ = ray_scene(scene, camera.eye, run);
    }

    void make_references_for(const std::optional<std::filesystem::path>& cache) {
        ReferenceRequest request;
        request.size = study.plan.size;
        request.method = study.method;
        request.settings = defaults_of(*study.method, scene_.length_unit);
        study.cast = rays_asking(study.method->question(request.settings.ao));
        request.rays = study.cast;
        request.rays.rays = study.plan.reference_rays;
        request.limit_seeds = study.plan.limit_seeds;
        request.cache = cache;
        request.run = run_;
        study.references = make_references(scene_, view_.camera, request);
        kinds_ = surface_kinds(study.references.gbuffer, view_.camera);
    }

    std::vector<Candidate> candidates() {
        std::vector<Candidate> all;
        for (const ErrorSetting& setting : study.plan.settings) all.push_back(of_method(setting));
        for (const int rays : study.plan.cast_rays) all.push_back(ray_cast(rays));
        for (const int rays : study.plan.vertex_rays) all.push_back(vertex_bake(rays));
        return all;
    }

    void judge(Candidate& candidate) const {
        std::vector<MeanError> truth, screen, limit, fitted;
        const References& r = study.references;
        for (int i = 0; i < study.plan.seeds; ++i) {
            const Image<float> picture = candidate.picture(kFirstStudySeed + static_cast<std::uint32_t>(i));
            const auto against = [&](const Image<float>& image, const Reference& reference) {
                return mean_error(image, reference.image, kinds_, Region::surface);
            };
            truth.push_back(against(picture, r.soft));
            screen.push_back(against(picture, r.screen));
            if (!candidate.of_method) continue;
            limit.push_back(against(picture, r.limit));
            fitted.push_back(against(to_power(picture, study.fitted_exponent), r.soft));
        }
        candidate.point.truth = spread_of(truth);
        candidate.point.screen = spread_of(screen);
        if (!candidate.of_method) return;
        candidate.point.limit = spread_of(limit);
        candidate.point.fitted_rmse = spread_of(fitted).rmse;
    }

    void report(const char* stage, long long done, long long total) const {
        if (progress_) progress_(stage, done, total);
    }

    ErrorStudy study;

    void take_apart() {
        study.parts_setting = default_setting(*study.method);
        study.parts_setting.half_floats = true;
        const FrameSettings settings =
            settings_of(*study.method, study.parts_setting, scene_.length_unit, kFirstStudySeed);
        const std::vector<ChainImage> chain =
            error_chain(view_, study.references, settings, study.plan.limit_seeds, run_);
        study.parts = error_parts(chain, region_mask(kinds_, Region::surface));
    }

 private:
    Candidate of_method(const ErrorSetting& setting) const {
        const auto settings = [this, setting](std::uint32_t seed) {
            return settings_of(*study.method, setting, scene_.length_unit, seed);
        };
        Candidate candidate;
        candidate.point.method = study.method->name;
        candidate.point.setting = setting_name(setting);
        candidate.point.of = setting;
        candidate.of_method = true;
        candidate.picture = [=, this](std::uint32_t seed) {
            return ao_picture_of(view_, settings(seed), run_);
        };
        candidate.timed = [=, this] { ao_map_of(view_, settings(kFirstStudySeed), run_); };
        return candidate;
    }

    RayAoSettings cast_settings(int rays, std::uint32_t seed) const {
        RayAoSettings settings = study.cast;
        settings.rays = rays;
        settings.seed = seed;
        return settings;
    }

    static std::string ray_count(int rays, const char* of_what) {
        return std::to_string(rays) + (rays == 1 ? " ray a " : " rays a ") + of_what;
    }

    Candidate ray_cast(int rays) const {
        const auto cast = [=, this](std::uint32_t seed) {
            return ray_cast_ao(rays_, study.references.points.points, cast_settings(rays, seed), run_);
        };
        Candidate candidate;
        candidate.point.method = "ray_cast";
        candidate.point.setting = ray_count(rays, "pixel");
        candidate.picture = [=, this](std::uint32_t seed) {
            return picture_of(study.references.points, cast(seed));
        };
        candidate.timed = [=] { cast(kFirstStudySeed); };
        return candidate;
    }

    Candidate vertex_bake(int rays) const {
        const auto baked = [=, this](std::uint32_t seed) {
            return vertex_ao_from_corners(scene_, rays_, cast_settings(rays, seed), run_);
        };
        Candidate candidate;
        candidate.point.method = "vertex_bake";
        candidate.point.setting = ray_count(rays, "vertex");
        candidate.picture = [=, this](std::uint32_t seed) {
            return vertex_ao_picture(scene_, view_.camera, view_.size, rays_, baked(seed), run_);
        };
        candidate.timed = [=] { baked(kFirstStudySeed); };
        return candidate;
    }

    const Scene& scene_;
    const Run& run_;
    const StudyProgress& progress_;
    MethodView view_;
    RayScene rays_;
    Image<SurfaceKind> kinds_;
};

}  // namespace

ErrorStudy error_study(const Scene& scene, const Camera& camera, const Method& method, const ErrorPlan& plan,
                       const std::optional<std::filesystem::path>& cache, bool timed, const Run& run,
                       const StudyProgress& progress) {
    Study maker(scene, camera, method, plan, run, progress);
    maker.make_references_for(cache);
    const FittedElsewhere fitted = fitted_elsewhere(method, scene.name, run);
    maker.study.fitted_exponent = fitted.exponent;
    maker.study.fitted_on = fitted.scenes;
    maker.take_apart();
    std::vector<Candidate> candidates = maker.candidates();
    for (std::size_t i = 0; i < candidates.size(); ++i) {
        maker.judge(candidates[i]);
        maker.report("images", static_cast<long long>(i) + 1, static_cast<long long>(candidates.size()));
    }
    if (timed) time_in_turns(candidates, plan.rounds, plan.slow_rounds, progress);
    for (Candidate& candidate : candidates) maker.study.points.push_back(std::move(candidate.point));
    return std::move(maker.study);
}

}  // namespace crevice
