#include "chapters/sweep/time_job.h"

#include <algorithm>
#include <memory>
#include <optional>
#include <utility>

#include "chapters/bench/instructions.h"
#include "chapters/study/method_view.h"
#include "chapters/sweep/results_json.h"
#include "chapters/sweep/sweep_words.h"
#include "rasterizer/base/error.h"
#include "rasterizer/base/image_summary.h"

namespace crevice {

namespace {

const PassSamples& whole_pass(const Stopwatch& watch) {
    return *std::ranges::find(watch.samples(), kWholePass, &PassSamples::name);
}

// The setting's work, its map compared after the clocks have been read.
TimedWork watched(const TimedSetting& setting, std::string& hash) {
    return [&setting, &hash](Stopwatch& watch) {
        const std::string found = content_hash(setting.map(watch));
        if (hash.empty()) hash = found;
        if (found != hash)
            throw Error(ExitCode::check_failed,
                        words_of(setting.setting) + ": made another image while it was timed (" + found +
                            ", not " + hash + "); report this, results must not depend on threads or order");
    };
}

TimedSetting timed_setting(const MethodView& of_method, const SweepJob& job, const SweepSetting& setting,
                           const Run& run) {
    const FrameSettings settings = frame_settings(setting, job.seed, job.scene->argument.scene.length_unit);
    // A bake is made once of a scene at rest, and is no part of a frame.
    const MethodView view = with_bake(of_method, settings, run);
    return {setting, "", [=](Stopwatch& watch) {
                Image<float> map;
                watch.time(kWholePass, [&] {
                    RawAo raw;
                    watch.time("ao", [&] { raw = raw_ao_of(view, settings, run); });
                    if (has_blur(*view.method, settings)) {
                        watch.time("blur", [&] { map = map_of_raw(view, std::move(raw), settings, run); });
                    } else {
                        map = std::move(raw.ao);
                    }
                });
                return map;
            }};
}

}  // namespace

SweepPassTime pass_time(const PassSamples& samples) {
    return {samples.name, median_interval(samples.wall_ms), median_interval(samples.cpu_ms),
            median_deviation(samples.wall_ms)};
}

MedianInterval same_again(const PassSamples& once, const PassSamples& again) {
    return ratio_interval(once.wall_ms, again.wall_ms);
}

std::vector<SweepTimeResult> timed_in_turns(const std::vector<TimedSetting>& settings, int rounds,
                                            std::uint32_t seed, const std::function<void()>& on_round) {
    std::vector<std::string> hashes;
    std::vector<std::optional<std::size_t>> twins(
        settings.size());  // which work is the setting's second entry
    std::size_t entered = settings.size();
    for (std::size_t i = 0; i < settings.size(); ++i) {
        hashes.push_back(settings[i].expected_hash);
        const auto same_method = [&](const TimedSetting& s) {
            return s.setting.method == settings[i].setting.method;
        };
        if (&*std::ranges::find_if(settings, same_method) == &settings[i]) twins[i] = entered++;
    }
    std::vector<TimedWork> works;
    for (std::size_t i = 0; i < settings.size(); ++i) works.push_back(watched(settings[i], hashes[i]));
    for (std::size_t i = 0; i < settings.size(); ++i) {
        if (twins[i]) works.push_back(watched(settings[i], hashes[i]));
    }
    const std::vector<Stopwatch> watches = take_turns(works, {.rounds = rounds, .seed = seed}, on_round);
    std::vector<SweepTimeResult> results;
    for (std::size_t i = 0; i < settings.size(); ++i) {
        SweepTimeResult result;
        result.setting = settings[i].setting;
        result.rounds = rounds;
        for (const PassSamples& samples : watches[i].samples()) result.passes.push_back(pass_time(samples));
        if (twins[i]) result.same_again = same_again(whole_pass(watches[i]), whole_pass(watches[*twins[i]]));
        result.hash = hashes[i];
        results.push_back(std::move(result));
    }
    return results;
}

void count_instructions(std::vector<SweepTimeResult>& results, const SweepJob& job,
                        const std::filesystem::path& program) {
    constexpr double kLongestFrame_s = 600;
    for (SweepTimeResult& result : results) {
        std::vector<std::string> words = render_words(job.view, result.setting, job.seed);
        words.erase(words.begin(), words.begin() + 2);  // "render", SCENE
        const std::vector<InstructionCount> counts =
            counted_frame(program, job.view.scene, words, best_isa(), kLongestFrame_s);
        double sum = 0;
        for (SweepPassTime& time : result.passes) {
            const auto found = std::ranges::find(counts, time.pass, &InstructionCount::pass);
            if (found != counts.end()) sum += time.instructions = static_cast<double>(found->instructions);
            if (time.pass == kWholePass) time.instructions = sum;
        }
    }
}

std::vector<SweepTimeResult> timed(const SweepJob& job, const std::map<std::string, std::string>& hashes,
                                   const std::function<void()>& on_round) {
    Run run;
    run.threads = job.threads;
    const Method& any = find_method(job.settings.front().method);
    MethodView view = method_view(job.scene->argument.scene, job.scene->camera, job.view.size, any, run);
    std::vector<TimedSetting> settings;
    for (const SweepSetting& setting : job.settings) {
        view = for_method(view, find_method(setting.method), run);
        settings.push_back(timed_setting(view, job, setting, run));
        const auto known = hashes.find(json_line(setting));
        if (known != hashes.end()) settings.back().expected_hash = known->second;
    }
    std::vector<SweepTimeResult> results = timed_in_turns(settings, job.rounds, job.seed, on_round);
    for (SweepTimeResult& result : results) {
        result.id = job.id;
        result.view = job.view;
        result.threads = job.threads;
        result.command = command_of(job.view, result.setting, job.seed, job.threads);
    }
    return results;
}

}  // namespace crevice
