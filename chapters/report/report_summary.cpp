#include "chapters/report/report_summary.h"

#include <algorithm>

#include "chapters/notebook/embedded_files.h"
#include "chapters/report/setting_words.h"
#include "chapters/terminal/number_text.h"

namespace crevice {

namespace {

constexpr double kConfidence = 0.95;     // of the intervals of times
constexpr std::size_t kMostListed = 20;  // of what is missing or broken

TableOutput facts_table(const SweepResults& results) {
    TableOutput table{{{"plan", ""}, {results.plan, ""}}, {}, {}};
    const auto add = [&](const char* name, const std::string& value) {
        table.rows.push_back({{name, ""}, {value, ""}});
    };
    add("made by", sweep_command(results));
    add("errors", "of " + counted(static_cast<long long>(results.errors.size()), "image"));
    add("times", counted(static_cast<long long>(results.times.size()), "median") +
                     ", each of a setting on a view with a number of threads");
    if (!results.version.empty()) add("version", results.version);
    if (results.machine) {
        add("processor", results.machine->cpu + ", " + counted(results.machine->cores, "core"));
        add("instruction set", results.machine->isa + ", " + counted(results.machine->lanes, "lane"));
        add("compiler", results.machine->compiler);
    }
    return table;
}

// As a list, the first of them where there are many.
std::string bullets(const std::vector<std::string>& items) {
    std::string list;
    for (std::size_t i = 0; i < std::min(items.size(), kMostListed); ++i) list += "- " + items[i] + "\n";
    if (items.size() > kMostListed) list += "- and " + std::to_string(items.size() - kMostListed) + " more\n";
    return list;
}

std::string missing_prose(const SweepResults& results) {
    std::vector<std::string> items;
    for (const std::string& words : results.missing) items.push_back(escaped_markdown(words));
    if (items.empty()) return "";
    const bool one = items.size() == 1;
    return "**This sweep is not whole.** " + counted(static_cast<long long>(items.size()), "job") +
           " of its plan " + (one ? "is" : "are") + " missing, and everything below is without " +
           (one ? "it" : "them") + ":\n\n" + bullets(items);
}

std::string broken_prose(const SweepResults& results) {
    std::vector<std::string> items;
    for (const SweepErrorResult& error : results.errors) {
        if (error.nan_or_inf == 0) continue;
        items.push_back(escaped_markdown(setting_phrase(error.setting) + ", seed " +
                                         std::to_string(error.seed) + ", on " + view_words(error.view)) +
                        ": " + counted(error.nan_or_inf, "pixel") + ", made by " + as_code(error.command));
    }
    if (items.empty()) return "";
    const bool one = items.size() == 1;
    return "**" + counted(static_cast<long long>(items.size()), "image") + (one ? " is" : " are") +
           " broken.** Some of the pixels are NaN or infinite, so that the numbers below leave " +
           (one ? "it" : "them") + " out:\n\n" + bullets(items);
}

// The least that is known of how often the intervals of times hold what they are of; 0.95 or more where there are enough
// repetitions.
double least_confidence(const SweepResults& results) {
    double least = 1;
    for (const SweepTimeResult& time : results.times) {
        for (const SweepPassTime& pass : time.passes) least = std::min(least, pass.wall.confidence);
        if (time.same_again) least = std::min(least, time.same_again->confidence);
    }
    return least;
}

std::string how_sure(const SweepResults& results) {
    const double least = least_confidence(results);
    if (least >= kConfidence) return "";
    const std::string sure = least > 0 ? "only " + percent_text(least) : "nothing";
    return "**Too few repetitions.** The intervals of times and of A/A hold " + sure +
           ", not 95 %, so that what is said below of who is faster may be chance; six repetitions are "
           "enough.\n\n";
}

constexpr const char* kHowToRead =
    "A point is one setting of a method. Errors are of the pixels that show a surface, against what rays "
    "find: *soft* truth "
    "lets occluders fade with distance as the method itself does, *hard* truth counts all of them up to the "
    "radius. RMSE is "
    "debiased: the noise of the reference is taken out of it. Bars hold 95 %: across, the order-statistic "
    "interval of the "
    "median time; upright, 1.96 standard errors of the RMSE, and for the other measures the lowest and "
    "highest seed. The dashed "
    "level line is the noise of the reference itself; the bar at the lower left is as long as the same "
    "setting timed twice "
    "differs from itself. A method's line goes through those of its settings that no other of them beats, "
    "and the rings mark the "
    "Pareto front: what no setting of any method beats.";

}  // namespace

std::string sweep_command(const SweepResults& results) {
    // A plan of one's own may have any name; a sweep keeps it as plan.json beside its jobs.
    const bool built_in =
        embedded_file("chapters/sweep/plans/" + results.plan + ".json") == results.plan_text;
    return "crevice sweep " + (built_in ? results.plan : "plan.json") + " && crevice merge out/sweep_" +
           results.plan;
}

ReportSection summary_section(const SweepResults& results) {
    ReportSection section{"summary", "Summary"};
    if (const std::string prose = missing_prose(results); !prose.empty())
        section.blocks.push_back({.id = "missing", .prose = prose});
    if (const std::string prose = broken_prose(results); !prose.empty())
        section.blocks.push_back({.id = "broken", .prose = prose});
    if (results.errors.empty() && results.times.empty())
        section.blocks.push_back({.prose = "There are no results: no job of the plan is done yet."});
    else if (results.times.empty())
        section.blocks.push_back({.prose = "Nothing was timed, so that there are errors only."});
    else if (results.errors.empty())
        section.blocks.push_back({.prose = "No image was judged, so that there are times only."});
    section.blocks.push_back({.outputs = {facts_table(results)}});
    section.blocks.push_back({.heading = "How to read it", .prose = how_sure(results) + kHowToRead});
    return section;
}

}  // namespace crevice
