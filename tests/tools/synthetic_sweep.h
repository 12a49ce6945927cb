// Results of sweeps that nobody ran, with known answers.
#pragma once

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "chapters/notebook/embedded_files.h"
#include "chapters/sweep/sweep_results.h"

namespace crevice {

using SettingParameters = std::vector<std::pair<std::string, std::string>>;

inline SweepSetting with_samples(const std::string& method, int samples) {
    return {method, {{"samples", std::to_string(samples)}}};
}

inline const SweepView kSmallView{"columns", "", {640, 360}, 1200};

// An image with this RMSE, and a standard error of it.
inline SweepErrorResult synthetic_error(const SweepView& view, const SweepSetting& setting, double rmse,
                                        double rmse_error, std::uint32_t seed = 1) {
    SweepErrorResult result;
    std::string id = setting.method;
    for (const auto& [name, value] : setting.parameters) id += "_" + name + value;
    result.id = id + "_" + std::to_string(seed);
    result.view = view;
    result.setting = setting;
    result.seed = seed;
    result.soft = {rmse, rmse_error, -rmse / 4, rmse / 2, rmse * 3, rmse / 5, 1 - rmse, 0.01};
    result.hard = result.soft;
    result.soft.mse = rmse * rmse;
    result.hard.rmse = 2 * rmse;
    result.hard.mse = 4 * rmse * rmse;
    result.limit_mse = rmse * rmse / 4;
    result.parts = {{"depth buffer", -rmse / 8, rmse / 4, rmse * rmse / 10},
                    {"definition", -rmse / 8, rmse / 2, rmse * rmse / 2},
                    {"sampling", 0, rmse, rmse * rmse * 6 / 10},
                    {"blur", 0, rmse / 4, -rmse * rmse * 2 / 10}};
    result.hash = "0123456789abcdef";
    result.picture = "jobs/" + result.id + ".png";
    result.command = "crevice render " + view.scene + " --ao " + setting.method;
    for (const auto& [name, value] : setting.parameters) result.command += " --param " + name + "=" + value;
    return result;
}

// A median with an interval of 2 % on both sides.
inline SweepTimeResult synthetic_time(const SweepView& view, const SweepSetting& setting, int threads,
                                      double ms) {
    const auto around = [](double median) {
        return MedianInterval{median, 0.98 * median, 1.02 * median, 0.96};
    };
    SweepTimeResult result;
    result.id = "time";
    result.view = view;
    result.setting = setting;
    result.threads = threads;
    result.rounds = 15;
    result.passes = {{"ao", around(0.75 * ms), around(0.75 * ms * threads), 0.01 * ms, 0},
                     {"blur", around(0.25 * ms), around(0.25 * ms * threads), 0.01 * ms, 0},
                     {"ao and blur", around(ms), around(ms * threads), 0.01 * ms, 4e6 * ms}};
    result.hash = "0123456789abcdef";
    result.command = "crevice sweep quick --threads " + std::to_string(threads);
    return result;
}

inline SweepMachine synthetic_machine() { return {"a CPU", "avx2", "GCC 12.2.0", "1.0.0 (abc1234)", 2, 8}; }

// A whole plan: three methods over samples and sizes of the AO map, three views, one and two threads, A/A of each method's
// first setting.
inline SweepResults synthetic_sweep() {
    SweepResults results;
    results.plan = "quick";
    results.plan_text = *embedded_file("chapters/sweep/plans/quick.json");
    results.machine = synthetic_machine();
    results.version = results.machine->version;
    struct Law {
        const char* method;
        double floor, noise, ms;  // RMSE with ever more samples, of one sample; ms of one sample at full size
    };
    const Law laws[] = {{"xjun", 0.06, 0.2, 0.5}, {"gtao", 0.02, 0.25, 1.5}, {"vbao", 0.018, 0.25, 1.8}};
    const SweepView views[] = {
        kSmallView, {"cornell", "", {640, 360}, 36}, {"columns", "", {1280, 720}, 1200}};
    for (const SweepView& view : views) {
        for (const Law& law : laws) {
            bool first = true;
            for (const char* const scale : {"0.5", "1"}) {
                for (const int samples : {1, 2, 4, 8, 16}) {
                    const SweepSetting setting{law.method,
                                               {{"samples", std::to_string(samples)}, {"ao_scale", scale}}};
                    const bool half = std::string(scale) == "0.5";
                    const double rmse =
                        std::hypot(law.floor * (half ? 1.3 : 1), law.noise / std::sqrt(samples)) *
                        (view.scene == "cornell" ? 0.7 : 1);
                    for (const std::uint32_t seed : {1u, 2u})
                        results.errors.push_back(synthetic_error(
                            view, setting, rmse * (seed == 1 ? 0.99 : 1.01), rmse / 40, seed));
                    for (const int threads : {1, 2}) {
                        const double ms = (0.4 + law.ms * samples) * (half ? 0.3 : 1) * view.size.width /
                                          640.0 * view.size.width / 640.0 / std::pow(threads, 0.9);
                        results.times.push_back(synthetic_time(view, setting, threads, ms));
                        if (first) results.times.back().same_again = MedianInterval{1.003, 0.98, 1.025, 0.96};
                    }
                    first = false;
                }
            }
        }
    }
    return results;
}

}  // namespace crevice
