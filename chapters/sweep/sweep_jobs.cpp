#include "chapters/sweep/sweep_jobs.h"

#include <algorithm>
#include <set>

#include "chapters/study/reference_cache.h"
#include "chapters/sweep/error_job.h"
#include "chapters/sweep/results_json.h"
#include "chapters/sweep/scene_key.h"
#include "chapters/sweep/sweep_words.h"
#include "chapters/terminal/json_text.h"
#include "chapters/terminal/number_text.h"
#include "rasterizer/base/float_text.h"

namespace crevice {

namespace {

using Json = JsonFile::Json;

constexpr double kMostJobs = 100'000;

// A new one when an equal job means another result.
constexpr int kJobVersion = 2;

std::string flag_words(const PlannedScene& planned) {
    const CameraFlags& flags = planned.camera;
    std::string words;
    const auto add = [&](const char* flag, const std::optional<std::string>& word) {
        if (word) words += (words.empty() ? "" : " ") + std::string(flag) + " " + *word;
    };
    add("--eye", flags.eye);
    add("--target", flags.target);
    add("--fov-y", flags.fov_y);
    add("--near", flags.near_plane);
    add("--far", flags.far_plane);
    add("--ortho", flags.ortho);
    add("--crease", planned.crease);
    return words;
}

SweepScene loaded_scene(const PlannedScene& planned, const JsonFile& file, const Run& run) {
    const std::optional<double> crease_rad =
        file.at(planned.place, [&] { return crease_angle_of(planned.crease); });
    SweepScene scene{
        load_scene(planned.name, {.surfaces = false, .crease_angle_rad = crease_rad, .run = run}),
        {},
        planned.name,
        flag_words(planned),
        {}};
    if (triangle_count(scene.argument.scene) == 0)
        file.refuse("scenes: nothing to be seen (" + planned.name + " has 0 triangles); leave it away",
                    planned.place);
    scene.camera = file.at(planned.place, [&] { return chosen_camera(scene.argument, planned.camera); });
    scene.key = scene_key(scene.argument.scene);
    return scene;
}

// The question that truth answers, as a word.
std::string question_of(const Method& method, const FrameSettings& settings) {
    const AoQuestion question = method.question(settings.method.ao);
    std::string words = question.cosine_weighted ? "cosine" : "uniform";
    for (const float length : {question.radius, question.fade_start, question.fade_end})
        words += " " + shortest_text(length);
    return words;
}

// "samples: must be at least 1 (0); ..." of the plan's words, where they stand.
FrameSettings checked_settings(const SweepPlan& plan, const PlannedMethod& method,
                               const SweepSetting& setting, const SweepScene& scene) {
    try {
        return frame_settings(setting, plan.seeds.front(), scene.argument.scene.length_unit);
    } catch (const UsageError& error) {
        const std::string refusal = error.what(), member = refusal.substr(0, refusal.find(':'));
        JsonPlace place = method.place;
        for (const PlannedValues& values : method.values) {
            if (values.parameter == member) place = values.place;
        }
        plan.file.refuse(setting.method + ": " + refusal, place);
    }
}

std::string id_of(const SweepJob& job) {
    Json settings = Json::array();
    for (const SweepSetting& setting : job.settings) settings.push_back(json_line(setting));
    const Json canonical = {{"job", kJobVersion},
                            {"timed", job.timed},
                            {"view", json_line(job.view)},
                            {"scene", job.scene->key},
                            {"settings", settings},
                            {"seed", job.seed},
                            {"parts", job.parts},
                            {"threads", job.threads},
                            {"rounds", job.rounds},
                            {"instructions", job.instructions},
                            {"reference_rays", job.reference_rays}};
    ContentKey key;
    key.add_all(json_line(canonical));
    return key.hex();
}

int samples_of(const Method& method, const FrameSettings& settings) {
    return static_cast<int>(value_of(method, settings.method, "samples").value_or(1));
}

double pixels_of(const SweepView& view) { return static_cast<double>(view.size.width) * view.size.height; }

// What all jobs of a view have in common.
SweepJob job_on(const std::shared_ptr<const SweepScene>& scene, Size size, std::uint32_t seed) {
    SweepJob job;
    job.scene = scene;
    job.view = {scene->name, scene->camera_words, size,
                static_cast<long long>(triangle_count(scene->argument.scene))};
    job.seed = seed;
    return job;
}

class JobMaker {
 public:
    JobMaker(const SweepPlan& plan, bool instructions) : plan_(plan), instructions_(instructions) {}

    void add_view(const PlannedScene& planned, const std::shared_ptr<const SweepScene>& scene, Size size) {
        SweepJob timed = job_on(scene, size, plan_.seeds.front());
        if (!views_.insert(json_line(timed.view)).second)
            plan_.file.refuse("scenes: given twice (" + words_of(timed.view) + "); leave one away",
                              planned.place);
        timed.timed = true;
        timed.rounds = plan_.repetitions;
        timed.instructions = instructions_;
        for (const PlannedMethod& method : plan_.methods) {
            for (const SweepSetting& setting : settings_of(method)) {
                const FrameSettings settings = checked_settings(plan_, method, setting, *scene);
                add_errors(scene, size, *method.method, setting, settings);
                timed.settings.push_back(setting);
                timed.work += samples_of(*method.method, settings) * pixels_of(timed.view) * timed.rounds;
            }
        }
        if (timed.rounds == 0) return;
        for (const int threads : plan_.threads) {
            timed.threads = threads;
            timed.id = id_of(timed);
            times_.push_back(timed);
        }
    }

    std::vector<SweepJob> jobs() && {
        errors_.insert(errors_.end(), times_.begin(), times_.end());
        return std::move(errors_);
    }

 private:
    void add_errors(const std::shared_ptr<const SweepScene>& scene, Size size, const Method& method,
                    const SweepSetting& setting, const FrameSettings& settings) {
        for (const std::uint32_t seed : plan_.seeds) {
            SweepJob job = job_on(scene, size, seed);
            job.settings = {setting};
            job.parts = plan_.parts && seed == plan_.seeds.front();
            job.asks = question_of(method, settings);
            job.reference_rays = plan_.reference_rays;
            const int images = job.parts ? 1 + kPartsImages : 1;
            job.work = (samples_of(method, settings) * images + kMeasures) * pixels_of(job.view);
            job.truth_work = kRay * job.reference_rays * (job.parts ? 2 : 1) * pixels_of(job.view);
            job.id = id_of(job);
            errors_.push_back(std::move(job));
        }
    }

    // Of three limits (error_chain.h).
    static constexpr int kPartsImages = 3 * kPartsSeeds;
    // Measured: judging an image takes about as long as so many samples of it, a ray as long as so many samples.
    static constexpr double kMeasures = 800, kRay = 28;

    const SweepPlan& plan_;
    const bool instructions_;
    std::set<std::string> views_;
    std::vector<SweepJob> errors_, times_;
};

// Before any of them is made: lists of values multiply.
void require_fewer_jobs(const SweepPlan& plan) {
    double settings = 0;
    for (const PlannedMethod& method : plan.methods) {
        double of_method = 1;
        for (const PlannedValues& values : method.values)
            of_method *= static_cast<double>(values.words.size());
        settings += of_method;
    }
    const double views = static_cast<double>(plan.scenes.size() * plan.sizes.size()),
                 jobs = views * (settings * static_cast<double>(plan.seeds.size()));
    if (jobs > kMostJobs)
        plan.file.refuse(
            "methods: too many images, " + decimal_text(views, 0) + " views of " + decimal_text(settings, 0) +
                " settings with " + counted(static_cast<long long>(plan.seeds.size()), "seed") + " (" +
                decimal_text(jobs, 0) + ", at most " + decimal_text(kMostJobs, 0) + "); make several plans",
            {"methods"});
}

}  // namespace

std::vector<SweepJob> sweep_jobs(const SweepPlan& plan, bool instructions, const Run& run) {
    require_fewer_jobs(plan);
    JobMaker maker(plan, instructions);
    for (const PlannedScene& planned : plan.scenes) {
        const auto scene = std::make_shared<const SweepScene>(loaded_scene(planned, plan.file, run));
        for (const Size size : plan.sizes) maker.add_view(planned, scene, size);
    }
    return std::move(maker).jobs();
}

}  // namespace crevice
