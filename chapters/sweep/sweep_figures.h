// A sweep's results as its tables and its report read them: what belongs to one view stands together, and the errors of
// a setting, over its seeds, beside its times.
// Errors: against soft truth, that is with the method's own fade, unless another is named; of the seeds that did not fail
// Times:  of AO and blur together, median wall time of the rounds
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "chapters/sweep/sweep_results.h"

namespace crevice {

// A number and how far it may be off; from 0 to infinity where that is not known.
struct BarFigure {
    double value = 0, low = 0, high = 0;
};

// So many standard errors on both sides hold a value with 95 %, as order statistics do a median.
inline constexpr double kErrors95 = 1.96;

struct SettingErrors {
    int seeds = 0;
    // Root of the mean square over seeds; kErrors95 standard errors, of pixels and reference, on both sides. 0 where it is below
    // the noise of the reference.
    BarFigure rmse, hard_rmse;
    BarFigure bias, p99, flip;  // mean, lowest and highest of the seeds
    double mae = 0, ssim = 0;
    double reference_error = 0, hard_reference_error = 0;  // standard errors of the references themselves
    std::vector<SweepErrorPart> parts;                     // mean of the seeds that have them
    // Of the method's limit, what ever more samples would leave; none: the plan takes no errors apart.
    std::optional<double> limit_rmse;

    // Half the width of the RMSE's interval; infinite where too little surface is seen to tell.
    double rmse_margin() const { return rmse.high - rmse.value; }
};

struct SettingTime {
    int threads = 1;
    BarFigure ms;  // median and its 95 % interval
    const SweepTimeResult* result = nullptr;
    // Its name in the page: VIEW-ROW, counted from 0, of the view's table of all settings.
    std::string point = "";
};

struct SettingFigures {
    SweepSetting setting;
    std::vector<const SweepErrorResult*> seeds;  // in the plan's order
    std::optional<SettingErrors> errors;         // none: no seed is done, or all have failed
    std::vector<SettingTime> times;              // one a number of threads, ascending
    std::string point = "";                      // of the first of its times, or its own where there is none

    const SettingTime* time(int threads) const;
    // The seeds whose image is finite; of all others nothing is told but that they failed.
    std::vector<const SweepErrorResult*> sound_seeds() const;
    int failed_seeds() const { return static_cast<int>(seeds.size() - sound_seeds().size()); }
};

struct ViewFigures {
    SweepView view;
    std::string id;                        // "v1"
    std::vector<SettingFigures> settings;  // in the plan's order
    std::vector<int> threads;              // for which there are times, ascending

    // A/A: between which ratios two runs of one setting lie, of all that were run twice. None: nothing was.
    std::optional<BarFigure> same_again(int threads) const;
    // The largest of all settings, of one of their references; 0 where there are no errors.
    double largest(double SettingErrors::*reference_error) const;
};

// Views in the order in which they first appear. The figures point into `results`.
std::vector<ViewFigures> view_figures(const SweepResults& results);

// Of each method the setting with the most samples whose error was taken apart, the first of equals.
std::vector<const SettingFigures*> settings_apart(const ViewFigures& view);

// The value of a parameter, the method's default where the setting does not change it. None where the method has no such
// number.
std::optional<double> parameter_value(const SweepSetting& setting, const std::string& parameter);

// In the order in which they first appear: a method has the same place, and colour, in all plots with one line a method.
std::vector<std::string> methods_of(const SweepResults& results);

}  // namespace crevice
