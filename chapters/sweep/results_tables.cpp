#include "chapters/sweep/results_tables.h"

#include <algorithm>
#include <array>

#include "chapters/sweep/sweep_figures.h"
#include "chapters/terminal/number_text.h"

namespace crevice {

namespace {

// "samples=4 ao_scale=0.5"
std::string assignments(const SweepSetting& setting) {
    std::string words;
    for (const auto& [name, word] : setting.parameters)
        words += (words.empty() ? "" : " ") + name + "=" + word;
    return words;
}

using Seeds = std::vector<const SweepErrorResult*>;

// Root of the mean square over the seeds, and the lowest and the highest of them; nothing without errors.
std::array<TableValue, 3> rmse_over_seeds(const SettingFigures& figures, BarFigure SettingErrors::*rmse,
                                          SweepError SweepErrorResult::*against) {
    if (!figures.errors) return {};
    const Seeds seeds = figures.sound_seeds();
    const auto [lowest, highest] = std::minmax_element(
        seeds.begin(), seeds.end(), [against](const SweepErrorResult* a, const SweepErrorResult* b) {
            return (a->*against).rmse < (b->*against).rmse;
        });
    return {TableValue(((*figures.errors).*rmse).value, 4), TableValue(((*lowest)->*against).rmse, 4),
            TableValue(((*highest)->*against).rmse, 4)};
}

TableValue mean_over_seeds(const Seeds& errors, SweepError SweepErrorResult::*against,
                           double SweepError::*member) {
    if (errors.empty()) return {};
    double sum = 0;
    for (const SweepErrorResult* error : errors) sum += (error->*against).*member;
    return {sum / static_cast<double>(errors.size()), 4};
}

const SweepPassTime* find_pass(const SweepTimeResult& time, const char* name) {
    const auto found = std::ranges::find(time.passes, name, &SweepPassTime::pass);
    return found == time.passes.end() ? nullptr : &*found;
}

void add_times(std::vector<TableValue>& cells, const SweepTimeResult* time) {
    for (const char* pass : {"ao", "blur", kWholePass}) {
        const SweepPassTime* const found = time == nullptr ? nullptr : find_pass(*time, pass);
        cells.push_back(found == nullptr ? TableValue() : TableValue(found->wall.median));
        if (pass != kWholePass) continue;
        if (found == nullptr) {
            cells.resize(cells.size() + 5);
            continue;
        }
        for (const double value : {found->wall.low, found->wall.high, found->wall_mad, found->cpu.median})
            cells.emplace_back(value);
        cells.push_back(found->instructions > 0 ? TableValue(found->instructions, 0) : TableValue());
    }
    const bool twice = time != nullptr && time->same_again.has_value();
    cells.push_back(twice ? TableValue(time->same_again->low, 3) : TableValue());
    cells.push_back(twice ? TableValue(time->same_again->high, 3) : TableValue());
}

std::vector<TableValue> cells_of(const SweepView& view, const SettingFigures& row,
                                 const SweepTimeResult* time) {
    const Seeds sound = row.sound_seeds();
    std::vector<TableValue> cells = {view.scene,
                                     view.camera,
                                     TableValue(view.size.width, 0),
                                     TableValue(view.size.height, 0),
                                     TableValue(static_cast<double>(view.triangles), 0),
                                     row.setting.method,
                                     assignments(row.setting),
                                     TableValue(static_cast<double>(sound.size()), 0),
                                     TableValue(row.failed_seeds(), 0)};
    for (const auto& [against, rmse] : {std::pair(&SweepErrorResult::soft, &SettingErrors::rmse),
                                        {&SweepErrorResult::hard, &SettingErrors::hard_rmse}}) {
        for (const TableValue& value : rmse_over_seeds(row, rmse, against)) cells.push_back(value);
        for (double SweepError::*const member :
             {&SweepError::rmse_error, &SweepError::bias, &SweepError::mae, &SweepError::p99,
              &SweepError::flip, &SweepError::ssim, &SweepError::reference_error})
            cells.push_back(mean_over_seeds(sound, against, member));
    }
    cells.push_back(time == nullptr ? TableValue() : TableValue(time->threads, 0));
    cells.push_back(time == nullptr ? TableValue() : TableValue(time->rounds, 0));
    add_times(cells, time);
    return cells;
}

// One number of threads a line; one without times where there are none.
std::string markdown_rows(const SweepView& view, const SettingFigures& row) {
    const TableValue rmse = rmse_over_seeds(row, &SettingErrors::rmse, &SweepErrorResult::soft)[0],
                     bias = mean_over_seeds(row.sound_seeds(), &SweepErrorResult::soft, &SweepError::bias);
    const auto shown = [](const TableValue& value) {
        return value.kind == TableValue::Kind::nothing ? "" : decimal_text(value.number, value.decimals);
    };
    const auto line = [&](const std::string& threads, const std::string& times) {
        return "| " + view.scene + " " + view.camera + (view.camera.empty() ? "" : " ") +
               size_text(view.size) + " | " + row.setting.method + " " + assignments(row.setting) + " | " +
               threads + " | " + shown(rmse) + " | " + shown(bias) + " | " + times + " |\n";
    };
    if (row.times.empty()) return line("", " | ");
    std::string lines;
    for (const SettingTime& time : row.times) {
        lines += line(std::to_string(time.threads), decimal_text(time.ms.value, 2) + " | " +
                                                        decimal_text(time.ms.low, 2) + " .. " +
                                                        decimal_text(time.ms.high, 2));
    }
    return lines;
}

}  // namespace

Table results_table(const SweepResults& results) {
    Table table{
        "results",
        {"scene", "camera", "width", "height", "triangles", "method", "parameters", "seeds", "failed_seeds"},
        {}};
    for (const std::string against : {"soft", "hard"}) {
        for (const char* name : {"rmse", "rmse_lowest", "rmse_highest", "rmse_error", "bias", "mae", "p99",
                                 "flip", "ssim", "reference_error"})
            table.columns.push_back(against + "_" + name);
    }
    for (const char* name :
         {"threads", "rounds", "ao_ms", "blur_ms", "wall_ms", "wall_ms_low", "wall_ms_high", "wall_ms_mad",
          "cpu_ms", "instructions", "same_again_low", "same_again_high"})
        table.columns.emplace_back(name);
    for (const ViewFigures& view : view_figures(results)) {
        for (const SettingFigures& row : view.settings) {
            if (row.times.empty()) table.rows.push_back(cells_of(view.view, row, nullptr));
            for (const SettingTime& time : row.times)
                table.rows.push_back(cells_of(view.view, row, time.result));
        }
    }
    return table;
}

std::string results_markdown(const SweepResults& results) {
    std::string text = "# Sweep " + results.plan + "\n\nProgram: crevice " + results.version + "\n";
    if (results.machine) {
        const SweepMachine& machine = *results.machine;
        text += "Times: " + machine.cpu + ", " + counted(machine.cores, "thread") + ", " + machine.isa +
                ", " + counted(machine.lanes, "lane") + ", " + machine.compiler + "\n";
    } else {
        text += "Times: none\n";
    }
    if (!results.missing.empty()) text += "\nMissing:\n\n";
    for (const std::string& words : results.missing) text += "- " + words + "\n";
    text += "\n| view | setting | threads | RMSE | bias | ms | interval |\n|---|---|---|---|---|---|---|\n";
    for (const ViewFigures& view : view_figures(results)) {
        for (const SettingFigures& row : view.settings) text += markdown_rows(view.view, row);
    }
    return text +
           "\nRMSE and bias are of accessibility against ray-cast truth with the method's own fade; ms is "
           "the median wall time of AO and blur with the interval that holds it.\n";
}

}  // namespace crevice
