#include "chapters/report/report_sections.h"

#include <algorithm>
#include <set>

#include "chapters/report/report_summary.h"
#include "chapters/report/scene_paragraph.h"
#include "chapters/report/setting_words.h"
#include "chapters/report/sweep_plots.h"
#include "chapters/report/sweep_tables.h"
#include "chapters/study/error_points.h"
#include "chapters/terminal/number_text.h"

namespace crevice {

namespace {

constexpr int kTabledThreads[] = {1, 2};  // said to be missing where they were not measured

std::string made_by(const SweepResults& results) {
    return "Made by " + as_code(sweep_command(results)) + ".";
}

ReportBlock plots_block(const ViewFigures& view, int threads, const SweepResults& results,
                        std::span<const std::string> methods) {
    ReportBlock block;
    block.id = view.id + "-" + std::to_string(threads);
    block.heading = "Error over time, " + counted(threads, "thread");
    block.threads = threads;
    for (DrawingOutput& plot : error_over_time(view, threads, methods)) {
        plot.caption.en =
            made_by(results) + " Each point's own command is in the table of all settings." + plot.caption.en;
        block.outputs.push_back(std::move(plot));
    }
    for (const ErrorMeasure& measure : kErrorMeasures) block.choices.push_back(measure.name);
    return block;
}

ReportBlock budgets_block(const ViewFigures& view, int threads, const SweepResults& results) {
    ReportBlock block;
    block.heading = "Equal time and equal error, " + counted(threads, "thread");
    block.threads = threads;
    const std::vector<ErrorPoint> points = best_of_each(error_points(view, threads, kErrorMeasures[0]));
    if (points.empty()) {
        block.prose = "Not measured by this plan.";
        return block;
    }
    TableOutput time = equal_time_output(points), error = equal_error_output(points);
    time.caption.en = "The least RMSE of each method within so many ms. " + made_by(results);
    error.caption.en = "The least time, in ms, in which each method comes to an RMSE. " + made_by(results);
    block.outputs = {std::move(time), std::move(error)};
    return block;
}

ReportBlock convergence_block(const ViewFigures& view, const SweepResults& results,
                              std::span<const std::string> methods) {
    ReportBlock block{.heading = "How errors fall with samples"};
    const std::vector<FittedSeries> series = convergence(view);
    if (series.empty()) {
        block.prose = "Samples were not varied by this plan.";
        return block;
    }
    block.prose =
        "The exponent *e* of RMSE ∝ samples*ᵉ*, by least squares of the logarithms, with its standard error. "
        "Independent "
        "samples give −0.5; a method that nears its floor falls more slowly. Drawn is, of each method, the "
        "series that ends lowest.";
    DrawingOutput plot = convergence_plot(view, series, methods);
    TableOutput table = convergence_table(series);
    plot.caption.en = made_by(results) + " So is the table below.";
    block.outputs = {std::move(plot), std::move(table)};
    return block;
}

ReportBlock floors_block(const ViewFigures& view, const SweepResults& results) {
    ReportBlock block{.heading = "Where the error comes from"};
    if (settings_apart(view).empty()) {
        block.prose = "Errors were not taken apart by this plan.";
        return block;
    }
    block.prose =
        "From truth (T) to what the depth buffer holds (S), from there to the method's own limit (C), and on "
        "to the frame: the "
        "shares of these steps add up to the mean squared error of the frame. A share below 0 takes error "
        "away. The floor is "
        "what ever more samples would leave, the error of C: its bias is the sum of the first two steps', "
        "and its RMSE was measured as that of the frame, without the noise of either. Of each method, its "
        "setting with the most samples.";
    DrawingOutput plot = error_parts_plot(view);
    TableOutput table = floors_table(view);
    plot.caption.en = made_by(results) + " So is the table below.";
    block.outputs = {std::move(plot), std::move(table)};
    return block;
}

ReportSection view_section(const ViewFigures& view, const SweepResults& results,
                           std::span<const std::string> methods) {
    ReportSection section{view.id, view_words(view.view), view.view.scene};
    section.blocks.push_back({.prose = scene_paragraph(view)});
    for (const int threads : view.threads)
        section.blocks.push_back(plots_block(view, threads, results, methods));
    std::set<int> tabled(view.threads.begin(), view.threads.end());
    if (!results.times.empty()) tabled.insert(std::begin(kTabledThreads), std::end(kTabledThreads));
    for (const int threads : tabled) section.blocks.push_back(budgets_block(view, threads, results));
    section.blocks.push_back(convergence_block(view, results, methods));
    section.blocks.push_back(floors_block(view, results));
    section.blocks.push_back({.id = view.id + "-points",
                              .heading = "All settings, with the command of each",
                              .outputs = {points_table(view)},
                              .folded = true});
    if (!view.threads.empty())
        section.blocks.push_back({.heading = "All passes", .outputs = {passes_table(view)}, .folded = true});
    return section;
}

ReportSection cost_section(const std::vector<ViewFigures>& views, const SweepResults& results,
                           std::span<const std::string> methods) {
    ReportSection section{"cost", "What it costs"};
    if (results.times.empty()) {
        section.blocks.push_back({.prose = "Nothing was timed."});
        return section;
    }
    TableOutput table = cost_table(views, methods);
    table.caption.en = made_by(results);
    section.blocks.push_back({.prose = "The exponent *e* of time ∝ *xᵉ*, with its standard error, along the "
                                       "longest series of settings in which nothing "
                                       "but *x* changes. Scenes differ in more than their triangles: "
                                       "screen-space methods see only pixels.",
                              .outputs = {std::move(table)}});
    for (const CostVariable& variable : kCostVariables) {
        const std::vector<FittedSeries> series = cost_series(views, variable);
        if (series.empty()) continue;
        DrawingOutput plot = cost_plot(variable, series, methods);
        plot.caption.en = made_by(results);
        section.blocks.push_back(
            {.heading = std::string("Time over ") + variable.name, .outputs = {std::move(plot)}});
    }
    return section;
}

}  // namespace

std::vector<ReportSection> report_sections(const SweepResults& results) {
    const std::vector<ViewFigures> views = view_figures(results);
    const std::vector<std::string> methods = methods_of(results);
    std::vector<ReportSection> sections = {summary_section(results)};
    for (const ViewFigures& view : views) sections.push_back(view_section(view, results, methods));
    sections.push_back(cost_section(views, results, methods));
    sections.push_back({"plan", "The plan"});
    sections.back().blocks.push_back(
        {.heading = results.plan,
         .prose = "It stands in `plan.json` beside the jobs:\n\n```json\n" + results.plan_text + "\n```",
         .folded = true});
    return sections;
}

}  // namespace crevice
