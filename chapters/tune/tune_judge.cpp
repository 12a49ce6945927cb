#include "chapters/tune/tune_judge.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "chapters/terminal/stopwatch.h"
#include "rasterizer/base/error.h"
#include "ssao/judge/reference_error.h"

namespace crevice {

namespace {

constexpr double kTooSlow = 4;  // times the budget or the defaults, whichever is more: not waited for
constexpr double kTooSlowWithoutBudget = 16;  // times the defaults
constexpr int kStandardRounds = 9;            // of the defaults, once
constexpr int kHeldOutRounds = 15;
constexpr double kLeastError = 1e-6;  // so that a ratio is one; AO maps are no nearer to any truth

int rounds_of(Effort effort) { return effort == Effort::glance ? 2 : effort == Effort::look ? 4 : 7; }
int seeds_of(Effort effort, int all) {
    return std::min(all, effort == Effort::glance ? 1 : effort == Effort::look ? 2 : all);
}

FrameSettings tuned_settings(const TuneView& view, const std::vector<TuneAxis>& axes,
                             const TuneSetting& setting, std::uint32_t seed) {
    FrameSettings settings;
    settings.method = settings_with(*view.view.method, axes, setting, view.scene->length_unit, seed);
    return settings;
}

// A setting on a view, ready to be timed: what is baked is no part of a frame.
class TuneTimer {
 public:
    TuneTimer(const TuneView& view, const std::vector<TuneAxis>& axes, const TuneSetting& setting,
              std::uint32_t seed, const Run& run)
        : view_(view.view), settings_(tuned_settings(view, axes, setting, seed)), run_(run) {
        if (view_.method->bake) baked_ = with_bake(view_, settings_, run_);
    }

    double ms() const {
        const Clocks before = clocks();
        ao_map_of(baked_ ? *baked_ : view_, settings_, run_);
        return clocks().wall_ms - before.wall_ms;
    }

 private:
    const MethodView& view_;
    FrameSettings settings_;
    Run run_;
    std::optional<MethodView> baked_;
};

Image<float> picture_of(const TuneView& view, const std::vector<TuneAxis>& axes, const TuneSetting& setting,
                        std::uint32_t seed, const Run& run) {
    return ao_picture_of(view.view, tuned_settings(view, axes, setting, seed), run);
}

}  // namespace

TuneJudging::TuneJudging(const std::vector<TuneView>& views, const std::vector<TuneAxis>& axes,
                         const TuneGoal& goal, int seeds, std::function<bool()> stop, Run run,
                         std::function<void(long long)> on_steps)
    : views_(views),
      axes_(axes),
      standard_(standard_setting(axes)),
      seeds_(seeds),
      stop_(std::move(stop)),
      run_(run),
      on_steps_(std::move(on_steps)) {
    double slowest = 0;
    for (const TuneView& view : views_) {
        const TuneTimer standard(view, axes_, standard_, kFirstSearchedSeed, run_);
        std::vector<double> ms;
        for (int round = -1; round < kStandardRounds; ++round) {
            const double once = standard.ms();
            if (round >= 0) ms.push_back(once);
        }
        standard_ms_.push_back(median(std::move(ms)));
        slowest = std::max(slowest, standard_ms_.back());
    }
    slowest_ms_ = goal.ms ? kTooSlow * std::max(*goal.ms, slowest) : kTooSlowWithoutBudget * slowest;
}

long long TuneJudging::steps(Effort effort) const { return rounds_of(effort) + seeds_of(effort, seeds_); }

bool TuneJudging::valid(const TuneSetting& setting) const {
    const Method& method = *views_[0].view.method;
    try {
        for (const TuneView& view : views_)
            validate(method,
                     settings_with(method, axes_, setting, view.scene->length_unit, kFirstSearchedSeed));
        return true;
    } catch (const UsageError&) {
        return false;  // numbers that do not go together, such as a fade that ends before it starts
    }
}

std::vector<std::optional<double>> TuneJudging::times(std::span<const TuneSetting> settings, int rounds) {
    std::vector<std::optional<double>> ms(settings.size(), 0);
    for (std::size_t i = 0; i < settings.size(); ++i) {
        if (!valid(settings[i])) ms[i].reset();
    }
    for (std::size_t v = 0; v < views_.size(); ++v) {
        const TuneTimer standard(views_[v], axes_, standard_, kFirstSearchedSeed, run_);
        std::vector<std::optional<TuneTimer>> timed(settings.size());
        std::vector<std::vector<double>> ratios(settings.size());
        for (int round = 0; round < rounds; ++round) {
            for (std::size_t k = 0; k < settings.size(); ++k) {
                // There and back again, so that a machine that slows down favours nobody.
                const std::size_t i = round % 2 == 0 ? k : settings.size() - 1 - k;
                if (v == 0) on_steps_(1);
                if (!ms[i]) continue;
                if (stop_()) return std::vector<std::optional<double>>(settings.size());
                if (!timed[i]) timed[i].emplace(views_[v], axes_, settings[i], kFirstSearchedSeed, run_);
                const double before = standard.ms(), own = timed[i]->ms();
                ratios[i].push_back(own / before);
                if (own > slowest_ms_ && settings[i] != standard_) ms[i].reset();
            }
        }
        for (std::size_t i = 0; i < settings.size(); ++i) {
            if (ms[i]) ms[i] = std::max(*ms[i], standard_ms_[v] * median(ratios[i]));
        }
    }
    return ms;
}

std::optional<double> TuneJudging::error_of(const TuneSetting& setting, int seeds) const {
    double square = 0;
    for (const TuneView& view : views_) {
        for (int k = 0; k < seeds; ++k) {
            if (stop_()) return std::nullopt;
            const Image<float> picture =
                picture_of(view, axes_, setting, kFirstSearchedSeed + static_cast<std::uint32_t>(k), run_);
            square += mean_error(picture, view.truth.image, view.kinds, Region::surface).squared.mean;
        }
    }
    return std::sqrt(std::max(square / (static_cast<double>(views_.size()) * seeds), 0.0));
}

std::vector<std::optional<Judged>> TuneJudging::operator()(std::span<const TuneSetting> settings,
                                                           Effort effort) {
    const std::vector<std::optional<double>> ms = times(settings, rounds_of(effort));
    std::vector<std::optional<Judged>> judged(settings.size());
    for (std::size_t i = 0; i < settings.size(); ++i) {
        const int seeds = seeds_of(effort, seeds_);
        on_steps_(seeds);
        if (!ms[i]) continue;
        const std::optional<double> error = error_of(settings[i], seeds);
        if (error) judged[i] = {*error, *ms[i]};
    }
    return judged;
}

HeldOutGain held_out_gain(const std::vector<TuneView>& views, const std::vector<TuneAxis>& axes,
                          const TuneSetting& setting, int seeds, const Run& run) {
    HeldOutGain gain;
    const TuneSetting standard = standard_setting(axes);
    std::vector<double> standard_errors, errors, standard_ms, ms;
    double standard_square = 0, square = 0, difference = 0, difference_error = 0;
    for (const TuneView& view : views) {
        for (int k = 0; k < seeds; ++k) {
            const std::uint32_t seed = kFirstHeldOutSeed + static_cast<std::uint32_t>(k);
            const Image<float> before = picture_of(view, axes, standard, seed, run),
                               after = picture_of(view, axes, setting, seed, run);
            const auto squared = [&](const Image<float>& picture) {
                return mean_error(picture, view.truth.image, view.kinds, Region::surface).squared;
            };
            const DebiasedSquare of_before = squared(before), of_after = squared(after);
            standard_square += of_before.mean;
            square += of_after.mean;
            standard_errors.push_back(std::max(of_before.root(), kLeastError));
            errors.push_back(std::max(of_after.root(), kLeastError));
            const MseDifference apart =
                mse_difference(after, before, view.truth.image, view.kinds, Region::surface);
            difference += apart.mean;
            difference_error += apart.error;  // of one truth, and so no less over many images
        }
        const TuneTimer of_standard(view, axes, standard, kFirstHeldOutSeed, run),
            of_setting(view, axes, setting, kFirstHeldOutSeed, run);
        for (int round = -1; round < kHeldOutRounds; ++round) {
            const double first = of_standard.ms(), second = of_setting.ms();
            if (round < 0) continue;
            standard_ms.push_back(first);
            ms.push_back(second);
        }
    }
    const auto images = static_cast<double>(views.size()) * seeds;
    gain.standard_error = std::sqrt(std::max(standard_square / images, 0.0));
    gain.error = std::sqrt(std::max(square / images, 0.0));
    gain.error_ratio = ratio_interval(standard_errors, errors);
    gain.time_ratio = ratio_interval(standard_ms, ms);
    gain.standard_ms = median_interval(std::move(standard_ms));
    gain.ms = median_interval(std::move(ms));
    // Fewer than five images bound nothing.
    constexpr double kSomeConfidence = 0.9;
    const auto leaves_out_1 = [](const MedianInterval& ratio) {
        return ratio.confidence >= kSomeConfidence && (ratio.low > 1 || ratio.high < 1);
    };
    gain.error_beyond_noise = leaves_out_1(gain.error_ratio) && std::fabs(difference) > 3 * difference_error;
    gain.time_beyond_noise = leaves_out_1(gain.time_ratio);
    return gain;
}

}  // namespace crevice
