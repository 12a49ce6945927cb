// `crevice tune SCENE... --method M --ms T | --error E`: settings of a method that err least within a time, or take least
// time within an error; found on some views and seeds, and judged on others.
#pragma once

#include <filesystem>
#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include "chapters/notebook/table.h"
#include "chapters/tune/tune_judge.h"

namespace crevice {

struct TuneOptions {
    TuneViewsRequest views;
    TuneGoal goal;
    int seeds = 6;  // images of each setting and view, [1, 64]; from 6 on the gain's interval holds with 95 %
    std::optional<std::filesystem::path> out = {};  // the directory for tune.json and tune.csv
};

// What there is to tell of a search.
struct TuneReport {
    Facts facts;
    Table tried;  // every judgement, those by all first, the best first
    std::vector<std::string> sentences;
    bool met = false;
};
TuneReport tune_report(const TuneOptions& options, const TuneViews& views, const std::vector<TuneAxis>& axes,
                       const TuneOutcome& outcome, const HeldOutGain& gain);

// Returns 0; 1 where nothing meets the goal, which names the nearest; kInterrupted after Ctrl-C, with the best so far.
// Throws UsageError (a method without AO or without numbers), and as tune_views(); OutputError.
int tune(const TuneOptions& options, std::ostream& out);

}  // namespace crevice
