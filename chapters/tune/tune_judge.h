// How wrong and how slow settings of a method are, on the views of a search.
// Error: RMSE against the truth without the truth's own noise (reference_error.h), over the pixels that show a surface;
//        the root of the mean square over views and seeds
// Time:  of the AO pass and its blur, inputs included, as in error_study.h; on the slowest view. Right before each timing
//        the defaults are timed: what is kept is the ratio, so that the machine's moods do not choose. Milliseconds are that
//        ratio times the median of the defaults, taken once
#pragma once

#include <functional>

#include "chapters/study/statistics.h"
#include "chapters/tune/tune_search.h"
#include "chapters/tune/tune_views.h"

namespace crevice {

class TuneJudging {
 public:
    // Views and axes must outlive it; `seeds` images of each view and setting. `stop` is asked between images;
    // `on_steps` is told how many of steps() are done.
    TuneJudging(
        const std::vector<TuneView>& views, const std::vector<TuneAxis>& axes, const TuneGoal& goal,
        int seeds, std::function<bool()> stop, Run run,
        std::function<void(long long)> on_steps = [](long long) {});

    // Timings and images of one setting.
    long long steps(Effort effort) const;

    std::vector<std::optional<Judged>> operator()(std::span<const TuneSetting> settings, Effort effort);

 private:
    bool valid(const TuneSetting& setting) const;
    std::vector<std::optional<double>> times(std::span<const TuneSetting> settings, int rounds);
    std::optional<double> error_of(const TuneSetting& setting, int seeds) const;

    const std::vector<TuneView>& views_;
    const std::vector<TuneAxis>& axes_;
    TuneSetting standard_;
    int seeds_;
    std::function<bool()> stop_;
    Run run_;
    std::function<void(long long)> on_steps_;
    std::vector<double> standard_ms_;  // of each view
    double slowest_ms_ = 0;            // what takes longer is not waited for
};

// A setting against the defaults on views that the search has not seen, with seeds that it has not seen.
struct HeldOutGain {
    double standard_error = 0, error = 0;  // RMSE
    MedianInterval error_ratio;            // the defaults' over the setting's, image by image; > 1 is a gain
    // The interval leaves out 1, and the images differ by more than the truth's noise.
    bool error_beyond_noise = false;
    MedianInterval standard_ms, ms;
    MedianInterval time_ratio;  // the defaults' over the setting's, turn by turn; > 1 is a gain
    bool time_beyond_noise = false;
};
HeldOutGain held_out_gain(const std::vector<TuneView>& views, const std::vector<TuneAxis>& axes,
                          const TuneSetting& setting, int seeds, const Run& run);

// Seeds of images: none of a truth's, none in both.
inline constexpr std::uint32_t kFirstSearchedSeed = 1000, kFirstHeldOutSeed = 5000;

}  // namespace crevice
