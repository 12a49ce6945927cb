#include "chapters/sweep/sweep_figures.h"

#include <algorithm>
#include <cmath>

#include "chapters/terminal/number_text.h"
#include "ssao/ao_methods.h"

namespace crevice {

namespace {

// The place in `list` of what `same` says is this one; added at the end where there is none.
template <class T, class Same, class Make>
T& found_or_added(std::vector<T>& list, const Same& same, const Make& make) {
    const auto found = std::find_if(list.begin(), list.end(), same);
    return found != list.end() ? *found : list.emplace_back(make());
}

ViewFigures& view_in(std::vector<ViewFigures>& views, const SweepView& view) {
    return found_or_added(
        views, [&](const ViewFigures& known) { return known.view == view; },
        [&] {
            return ViewFigures{view, "v" + std::to_string(views.size() + 1), {}, {}};
        });
}

SettingFigures& setting_in(ViewFigures& view, const SweepSetting& setting) {
    return found_or_added(
        view.settings, [&](const SettingFigures& known) { return known.setting == setting; },
        [&] {
            return SettingFigures{setting, {}, {}, {}};
        });
}

// Of a root mean square, from the values of the seeds. They share their reference and most of their pixels, so that more
// seeds do not make it surer.
BarFigure root_figure(const std::vector<const SweepErrorResult*>& seeds,
                      SweepError SweepErrorResult::*truth) {
    // The squares are averaged as they are: near the noise each alone may be below 0.
    double square = 0, variance = 0;
    for (const SweepErrorResult* const seed : seeds) {
        const SweepError& error = seed->*truth;
        square += error.mse / static_cast<double>(seeds.size());
        variance += error.rmse_error * error.rmse_error / static_cast<double>(seeds.size());
    }
    const double root = std::sqrt(std::max(square, 0.0)), margin = kErrors95 * std::sqrt(variance);
    return {root, std::max(0.0, root - margin), root + margin};
}

BarFigure mean_figure(const std::vector<const SweepErrorResult*>& seeds, double SweepError::*member) {
    BarFigure figure{0, INFINITY, -INFINITY};
    for (const SweepErrorResult* const seed : seeds) {
        const double value = seed->soft.*member;
        figure.value += value / static_cast<double>(seeds.size());
        figure.low = std::min(figure.low, value);
        figure.high = std::max(figure.high, value);
    }
    return figure;
}

// Of the seeds whose errors were taken apart.
std::vector<SweepErrorPart> mean_parts(std::vector<const SweepErrorResult*> seeds) {
    std::erase_if(seeds, [](const SweepErrorResult* seed) { return seed->parts.empty(); });
    std::vector<SweepErrorPart> parts;
    for (const SweepErrorResult* const seed : seeds) {
        for (const SweepErrorPart& part : seed->parts) {
            SweepErrorPart& mean = found_or_added(
                parts, [&](const SweepErrorPart& known) { return known.step == part.step; },
                [&] {
                    return SweepErrorPart{part.step, 0, 0, 0};
                });
            const auto n = static_cast<double>(seeds.size());
            mean.bias += part.bias / n;
            mean.rmse += part.rmse / n;
            mean.share += part.share / n;
        }
    }
    return parts;
}

// Of the seeds that have it.
std::optional<double> limit_rmse(const std::vector<const SweepErrorResult*>& seeds) {
    double square = 0;
    int count = 0;
    for (const SweepErrorResult* const seed : seeds) {
        if (!seed->limit_mse) continue;
        square += *seed->limit_mse;
        ++count;
    }
    if (count == 0) return std::nullopt;
    return std::sqrt(std::max(square / count, 0.0));
}

std::optional<SettingErrors> errors_of(const SettingFigures& figures) {
    const std::vector<const SweepErrorResult*> sound = figures.sound_seeds();
    if (sound.empty()) return std::nullopt;
    SettingErrors errors;
    errors.seeds = static_cast<int>(sound.size());
    errors.rmse = root_figure(sound, &SweepErrorResult::soft);
    errors.hard_rmse = root_figure(sound, &SweepErrorResult::hard);
    errors.bias = mean_figure(sound, &SweepError::bias);
    errors.p99 = mean_figure(sound, &SweepError::p99);
    errors.flip = mean_figure(sound, &SweepError::flip);
    errors.mae = mean_figure(sound, &SweepError::mae).value;
    errors.ssim = mean_figure(sound, &SweepError::ssim).value;
    for (const SweepErrorResult* const seed : sound) {
        errors.reference_error = std::max(errors.reference_error, seed->soft.reference_error);
        errors.hard_reference_error = std::max(errors.hard_reference_error, seed->hard.reference_error);
    }
    errors.parts = mean_parts(sound);
    errors.limit_rmse = limit_rmse(sound);
    return errors;
}

// Of AO and blur together; of a setting that has no such sum, its last pass. None where it took no measurable time.
std::optional<BarFigure> time_figure(const SweepTimeResult& result) {
    const SweepPassTime* timed = nullptr;
    for (const SweepPassTime& pass : result.passes) {
        timed = &pass;
        if (pass.pass == kWholePass) break;
    }
    if (timed == nullptr || !(timed->wall.median > 0)) return std::nullopt;
    return BarFigure{timed->wall.median, timed->wall.low, timed->wall.high};
}

// Names as many points as the table of all settings has rows: one a time, or one for a setting without.
void name_points(ViewFigures& view) {
    std::size_t row = 0;
    for (SettingFigures& setting : view.settings) {
        setting.point = view.id + "-" + std::to_string(row);
        for (SettingTime& time : setting.times) time.point = view.id + "-" + std::to_string(row++);
        if (setting.times.empty()) ++row;
    }
}

}  // namespace

const SettingTime* SettingFigures::time(int threads) const {
    for (const SettingTime& time : times) {
        if (time.threads == threads) return &time;
    }
    return nullptr;
}

std::vector<const SweepErrorResult*> SettingFigures::sound_seeds() const {
    std::vector<const SweepErrorResult*> sound = seeds;
    std::erase_if(sound, [](const SweepErrorResult* seed) { return seed->nan_or_inf > 0; });
    return sound;
}

std::optional<BarFigure> ViewFigures::same_again(int of_threads) const {
    std::optional<BarFigure> noise;
    for (const SettingFigures& setting : settings) {
        const SettingTime* const time = setting.time(of_threads);
        if (time == nullptr || !time->result->same_again) continue;
        const MedianInterval& ratio = *time->result->same_again;
        if (!noise) noise = BarFigure{1, 1, 1};
        noise->low = std::min(noise->low, ratio.low);
        noise->high = std::max(noise->high, ratio.high);
    }
    return noise;
}

double ViewFigures::largest(double SettingErrors::*reference_error) const {
    double error = 0;
    for (const SettingFigures& setting : settings) {
        if (setting.errors) error = std::max(error, (*setting.errors).*reference_error);
    }
    return error;
}

std::vector<ViewFigures> view_figures(const SweepResults& results) {
    std::vector<ViewFigures> views;
    for (const SweepErrorResult& error : results.errors)
        setting_in(view_in(views, error.view), error.setting).seeds.push_back(&error);
    for (const SweepTimeResult& time : results.times) {
        ViewFigures& view = view_in(views, time.view);
        if (const std::optional<BarFigure> ms = time_figure(time)) {
            setting_in(view, time.setting).times.push_back({time.threads, *ms, &time});
            view.threads.push_back(time.threads);
        }
    }
    for (ViewFigures& view : views) {
        std::sort(view.threads.begin(), view.threads.end());
        view.threads.erase(std::unique(view.threads.begin(), view.threads.end()), view.threads.end());
        for (SettingFigures& setting : view.settings) {
            setting.errors = errors_of(setting);
            std::stable_sort(
                setting.times.begin(), setting.times.end(),
                [](const SettingTime& a, const SettingTime& b) { return a.threads < b.threads; });
        }
        name_points(view);
    }
    return views;
}

std::vector<const SettingFigures*> settings_apart(const ViewFigures& view) {
    const auto samples = [](const SettingFigures* of) {
        return parameter_value(of->setting, "samples").value_or(0);
    };
    std::vector<const SettingFigures*> chosen;
    for (const SettingFigures& figures : view.settings) {
        if (!figures.errors || figures.errors->parts.empty()) continue;
        const SettingFigures*& most = found_or_added(
            chosen,
            [&](const SettingFigures* known) { return known->setting.method == figures.setting.method; },
            [&] { return &figures; });
        if (samples(&figures) > samples(most)) most = &figures;
    }
    return chosen;
}

std::optional<double> parameter_value(const SweepSetting& setting, const std::string& parameter) {
    for (const auto& [name, value] : setting.parameters) {
        if (name == parameter) return number_in(value);
    }
    for (const Method& method : ao_methods()) {
        if (setting.method == method.name) return value_of(method, defaults_of(method), parameter);
    }
    return std::nullopt;
}

std::vector<std::string> methods_of(const SweepResults& results) {
    std::vector<std::string> methods;
    const auto add = [&](const std::string& method) {
        if (std::find(methods.begin(), methods.end(), method) == methods.end()) methods.push_back(method);
    };
    for (const SweepErrorResult& error : results.errors) add(error.setting.method);
    for (const SweepTimeResult& time : results.times) add(time.setting.method);
    return methods;
}

}  // namespace crevice
