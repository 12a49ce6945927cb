#include "chapters/tune/tune.h"

#include <algorithm>
#include <functional>
#include <ostream>

#include "chapters/bench/machine.h"
#include "chapters/study/methods_study.h"
#include "chapters/terminal/interruption.h"
#include "chapters/terminal/number_text.h"
#include "chapters/terminal/output_directory.h"
#include "chapters/terminal/progress.h"
#include "rasterizer/base/error.h"
#include "rasterizer/base/write_file.h"

namespace crevice {

namespace {

constexpr std::size_t kShownTrials = 10;  // on the terminal; the files have all

std::string interval_text(const MedianInterval& m, int digits) {
    return significant_text(m.median, digits) + " (" + significant_text(m.low, digits) + " .. " +
           significant_text(m.high, digits) + ", " + decimal_text(100 * m.confidence, 0) + " %)";
}

std::string names_of(const std::vector<TuneView>& views) {
    std::string names;
    for (const TuneView& view : views) names += (names.empty() ? "" : "; ") + view.name;
    return names;
}

std::string goal_text(const TuneGoal& goal) {
    return goal.ms ? "the least error within " + significant_text(*goal.ms, 4) + " ms"
                   : "the least time within an error of " + significant_text(*goal.error, 4);
}

std::string axes_text(const std::vector<TuneAxis>& axes) {
    std::string text;
    for (const TuneAxis& axis : axes) {
        text += (text.empty() ? "" : "; ") + axis.name + " ";
        const double low = axis.values.empty() ? axis.low : axis.values.front(),
                     high = axis.values.empty() ? axis.high : axis.values.back();
        text += significant_text(low, 3) + " .. " + significant_text(high, 3);
        if (axis.unit != "-") text += " " + axis.unit;
    }
    return text;
}

std::string words_or_defaults(const std::vector<TuneAxis>& axes, const TuneSetting& setting,
                              double length_unit) {
    const std::string words = param_words(axes, setting, length_unit);
    return words.empty() ? "(the defaults)" : words;
}

Table tried_table(const TuneViews& views, const std::vector<TuneAxis>& axes, const TuneGoal& goal,
                  const TuneOutcome& outcome) {
    Table table{"tried", {"stage", "rmse", "ms", "meets", "setting"}, {}};
    std::vector<const TuneTrial*> order;
    for (const TuneTrial& trial : outcome.tried) order.push_back(&trial);
    const auto hasty = [](const TuneTrial* trial) {
        return trial->stage == std::string("glance") || trial->stage == std::string("look");
    };
    std::ranges::stable_sort(order, [&](const TuneTrial* a, const TuneTrial* b) {
        if (hasty(a) != hasty(b)) return hasty(b);
        if (!a->judged || !b->judged) return a->judged.has_value() && !b->judged;
        return goal.better(*a->judged, *b->judged);
    });
    const double length_unit = views.searched[0].scene->length_unit;
    for (const TuneTrial* trial : order) {
        const std::string words = words_or_defaults(axes, trial->setting, length_unit);
        if (!trial->judged) {
            table.rows.push_back({trial->stage, TableValue(), TableValue(), "left aside", words});
        } else {
            table.rows.push_back({trial->stage, TableValue(trial->judged->error, 5),
                                  TableValue(trial->judged->ms, 3), goal.met(*trial->judged) ? "yes" : "no",
                                  words});
        }
    }
    return table;
}

// `ratio` is the defaults' over the setting's.
std::string gain_sentence(const char* what, const MedianInterval& ratio, bool beyond_noise) {
    const std::string of_defaults = "the defaults have " + interval_text(ratio, 3) + " times as much";
    if (!beyond_noise) return std::string(what) + ": no gain beyond noise; " + of_defaults;
    if (ratio.median > 1) return std::string(what) + ": " + of_defaults;
    const MedianInterval inverse{1 / ratio.median, 1 / ratio.high, 1 / ratio.low, ratio.confidence};
    return std::string(what) + ": " + interval_text(inverse, 3) + " times as much as the defaults";
}

// What to type for each scene: lengths follow its unit.
void add_commands(const TuneOptions& options, const TuneViews& views, const std::vector<TuneAxis>& axes,
                  const TuneSetting& best, std::vector<std::string>& sentences) {
    std::vector<float> told;
    for (const TuneView& view : views.searched) {
        const float unit = view.scene->length_unit;
        if (std::ranges::find(told, unit) != told.end()) continue;
        told.push_back(unit);
        const std::string words = param_words(axes, best, unit);
        sentences.push_back("crevice render " + view.name + " --ao " + options.views.method->name +
                            (words.empty() ? "" : " " + words));
    }
}

void require_tunable(const Method& method, const std::vector<TuneAxis>& axes) {
    if (method.computes_ao() && !axes.empty()) return;
    throw UsageError(std::string("--method: there is nothing to tune (") + method.name +
                     "); give one that computes ambient occlusion");
}

void write_files(const TuneOptions& options, const TuneReport& report, std::ostream& out) {
    if (!options.out) return;
    BenchReport files{"tune", report.facts, {report.tried}};
    for (std::size_t i = 0; i < report.sentences.size(); ++i)
        files.facts.push_back({"result " + std::to_string(i + 1), report.sentences[i]});
    const std::filesystem::path json = *options.out / "tune.json", csv = *options.out / "tune.csv";
    write_file_atomically(json, json_text(files));
    write_file_atomically(csv, csv_text(report.tried));
    out << json.string() << "\n" << csv.string() << "\n";
}

// The search with a bar and the time left.
TuneOutcome searched(const TuneOptions& options, const TuneViews& views, const std::vector<TuneAxis>& axes,
                     const std::function<bool()>& stop) {
    std::optional<Progress> progress;
    TuneJudging judging(views.searched, axes, options.goal, options.seeds, stop, options.views.run,
                        [&](long long steps) { progress->advance(steps); });
    long long steps = 0;
    for (const PlannedJudgements& planned : planned_judgements(axes))
        steps += planned.settings * judging.steps(planned.effort);
    progress.emplace("tune", steps);
    return tune_search(axes, options.goal, std::ref(judging), stop);
}

}  // namespace

TuneReport tune_report(const TuneOptions& options, const TuneViews& views, const std::vector<TuneAxis>& axes,
                       const TuneOutcome& outcome, const HeldOutGain& gain) {
    const TuneGoal& goal = options.goal;
    TuneReport report{machine_facts(options.views.run), tried_table(views, axes, goal, outcome), {}, false};
    report.met = goal.met(outcome.judged);
    const auto range = [&](std::uint32_t first) {
        return ", seeds " + std::to_string(first) + " .. " +
               std::to_string(first + static_cast<std::uint32_t>(options.seeds) - 1);
    };
    report.facts.insert(report.facts.end(),
                        {{"method", options.views.method->name},
                         {"wanted", goal_text(goal)},
                         {"size", size_text(options.views.size)},
                         {"truth", std::string(options.views.truth == TuneTruth::hard ? "hard" : "soft") +
                                       ", radius " + significant_text(kAskedRadius, 3) +
                                       " for a length unit of 1, " + counted(options.views.rays, "ray")},
                         {"searched on", names_of(views.searched) + range(kFirstSearchedSeed)},
                         {"held out", names_of(views.held_out) + range(kFirstHeldOutSeed)},
                         {"searched over", axes_text(axes)},
                         {"tried", counted(static_cast<long long>(outcome.tried.size()), "judgement")}});
    std::vector<std::string>& s = report.sentences;
    if (outcome.interrupted) s.push_back("interrupted: this is the best so far");
    if (!report.met)
        s.push_back("nothing of what was tried meets " + goal_text(goal) + "; the nearest has an error of " +
                    significant_text(outcome.judged.error, 3) + " and takes " +
                    significant_text(outcome.judged.ms, 3) + " ms");
    s.push_back("searched views: error " + significant_text(outcome.judged.error, 3) + ", " +
                significant_text(outcome.judged.ms, 3) + " ms");
    s.push_back("held out: error " + significant_text(gain.standard_error, 3) + " -> " +
                significant_text(gain.error, 3) + "; " + interval_text(gain.standard_ms, 3) + " ms -> " +
                interval_text(gain.ms, 3) + " ms");
    if (goal.ms && report.met && gain.ms.low > *goal.ms)
        s.push_back("held out it takes longer than the " + significant_text(*goal.ms, 4) + " ms that it may");
    if (goal.error && report.met && gain.error > *goal.error)
        s.push_back("held out its error is larger than the " + significant_text(*goal.error, 4) +
                    " that it may be");
    s.push_back(gain_sentence("error, held out", gain.error_ratio, gain.error_beyond_noise));
    s.push_back(gain_sentence("time, held out", gain.time_ratio, gain.time_beyond_noise));
    add_commands(options, views, axes, outcome.best, s);
    return report;
}

int tune(const TuneOptions& options, std::ostream& out) {
    validate(options.views.run);
    const std::vector<TuneAxis> axes = tune_axes(*options.views.method, kAskedRadius);
    require_tunable(*options.views.method, axes);
    if (options.out) try_output_directory(*options.out);
    const TuneViews views = tune_views(options.views);
    const Interruption interruption;
    const TuneOutcome outcome = searched(options, views, axes, [&] { return interruption.asked(); });
    if (outcome.best.empty()) {
        out << "interrupted before anything was judged\n";
        return kInterrupted;
    }
    const HeldOutGain gain =
        held_out_gain(views.held_out, axes, outcome.best, options.seeds, options.views.run);
    TuneReport report = tune_report(options, views, axes, outcome, gain);
    out << facts_text(report.facts) << "\n";
    Table shown = report.tried;
    if (shown.rows.size() > kShownTrials) shown.rows.resize(kShownTrials);
    out << table_text(shown) << "\n";
    for (const std::string& sentence : report.sentences) out << sentence << "\n";
    write_files(options, report, out);
    if (outcome.interrupted) return kInterrupted;
    return static_cast<int>(report.met ? ExitCode::done : ExitCode::check_failed);
}

}  // namespace crevice
