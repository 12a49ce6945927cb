#include "chapters/sweep/results_tables.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "chapters/sweep/results_json.h"
#include "chapters/sweep/time_job.h"
#include "chapters/terminal/number_text.h"

namespace crevice {

namespace {

// All that is known of one setting on one view.
struct SettingRow {
    const SweepView* view = nullptr;
    const SweepSetting* setting = nullptr;
    std::vector<const SweepErrorResult*> errors;  // one a seed whose image is finite
    int failed = 0;                               // seeds whose image is not
    std::vector<const SweepTimeResult*> times;    // one a number of threads
};

std::vector<SettingRow> rows_of(const SweepResults& results) {
    std::vector<SettingRow> rows;
    std::map<std::string, std::size_t> known;
    const auto row_of = [&](const SweepView& view, const SweepSetting& setting) -> SettingRow& {
        const auto [found, is_new] = known.emplace(json_line(view) + json_line(setting), rows.size());
        if (is_new) rows.push_back({&view, &setting, {}, 0, {}});
        return rows[found->second];
    };
    for (const SweepErrorResult& error : results.errors) {
        SettingRow& row = row_of(error.view, error.setting);
        if (error.nan_or_inf > 0) {
            ++row.failed;
        } else {
            row.errors.push_back(&error);
        }
    }
    for (const SweepTimeResult& time : results.times) row_of(time.view, time.setting).times.push_back(&time);
    return rows;
}

std::string parameter_words(const SweepSetting& setting) {
    std::string words;
    for (const auto& [name, word] : setting.parameters)
        words += (words.empty() ? "" : " ") + name + "=" + word;
    return words;
}

// Root of the mean square over the seeds, lowest, highest; nothing without errors. The squares are averaged as they are: near
// the noise each alone may be below 0.
std::array<TableValue, 3> rmse_over_seeds(const std::vector<const SweepErrorResult*>& errors,
                                          SweepError SweepErrorResult::*against) {
    if (errors.empty()) return {};
    double square = 0, lowest = (errors.front()->*against).rmse, highest = lowest;
    for (const SweepErrorResult* error : errors) {
        const SweepError& one = error->*against;
        square += one.mse / static_cast<double>(errors.size());
        lowest = std::min(lowest, one.rmse);
        highest = std::max(highest, one.rmse);
    }
    return {TableValue(std::sqrt(std::max(square, 0.0)), 4), TableValue(lowest, 4), TableValue(highest, 4)};
}

TableValue mean_over_seeds(const std::vector<const SweepErrorResult*>& errors,
                           SweepError SweepErrorResult::*against, double SweepError::*member) {
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

std::vector<TableValue> cells_of(const SettingRow& row, const SweepTimeResult* time) {
    const SweepView& view = *row.view;
    std::vector<TableValue> cells = {view.scene,
                                     view.camera,
                                     TableValue(view.size.width, 0),
                                     TableValue(view.size.height, 0),
                                     TableValue(static_cast<double>(view.triangles), 0),
                                     row.setting->method,
                                     parameter_words(*row.setting),
                                     TableValue(static_cast<double>(row.errors.size()), 0),
                                     TableValue(row.failed, 0)};
    for (SweepError SweepErrorResult::*const against : {&SweepErrorResult::soft, &SweepErrorResult::hard}) {
        for (const TableValue& value : rmse_over_seeds(row.errors, against)) cells.push_back(value);
        for (double SweepError::*const member :
             {&SweepError::rmse_error, &SweepError::bias, &SweepError::mae, &SweepError::p99,
              &SweepError::flip, &SweepError::ssim, &SweepError::reference_error})
            cells.push_back(mean_over_seeds(row.errors, against, member));
    }
    cells.push_back(time == nullptr ? TableValue() : TableValue(time->threads, 0));
    cells.push_back(time == nullptr ? TableValue() : TableValue(time->rounds, 0));
    add_times(cells, time);
    return cells;
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
    for (const SettingRow& row : rows_of(results)) {
        if (row.times.empty()) table.rows.push_back(cells_of(row, nullptr));
        for (const SweepTimeResult* time : row.times) table.rows.push_back(cells_of(row, time));
    }
    return table;
}

std::string results_markdown(const SweepResults& results) {
    std::string text = "# Sweep " + results.plan + "\n\nProgram: crevice " + results.version + "\n";
    if (results.machine) {
        const SweepMachine& machine = *results.machine;
        text += "Times: " + machine.cpu + ", " + std::to_string(machine.cores) + " threads, " + machine.isa +
                ", " + std::to_string(machine.lanes) + " lanes, " + machine.compiler + "\n";
    } else {
        text += "Times: none\n";
    }
    if (!results.missing.empty()) text += "\nMissing:\n\n";
    for (const std::string& words : results.missing) text += "- " + words + "\n";
    text += "\n| view | setting | threads | RMSE | bias | ms | interval |\n|---|---|---|---|---|---|---|\n";
    for (const SettingRow& row : rows_of(results)) {
        const TableValue rmse = rmse_over_seeds(row.errors, &SweepErrorResult::soft)[0],
                         bias = mean_over_seeds(row.errors, &SweepErrorResult::soft, &SweepError::bias);
        const auto shown = [](const TableValue& value) {
            return value.kind == TableValue::Kind::nothing ? "" : decimal_text(value.number, value.decimals);
        };
        const auto add = [&](const std::string& threads, const std::string& times) {
            text += "| " + row.view->scene + " " + row.view->camera + (row.view->camera.empty() ? "" : " ") +
                    size_text(row.view->size) + " | " + row.setting->method + " " +
                    parameter_words(*row.setting) + " | " + threads + " | " + shown(rmse) + " | " +
                    shown(bias) + " | " + times + " |\n";
        };
        if (row.times.empty()) add("", " | ");
        for (const SweepTimeResult* time : row.times) {
            const SweepPassTime* const whole = find_pass(*time, kWholePass);
            if (whole == nullptr) continue;
            add(std::to_string(time->threads), decimal_text(whole->wall.median, 2) + " | " +
                                                   decimal_text(whole->wall.low, 2) + " .. " +
                                                   decimal_text(whole->wall.high, 2));
        }
    }
    return text +
           "\nRMSE and bias are of accessibility against ray-cast truth with the method's own fade; ms is "
           "the median "
           "wall time of AO and blur with the interval that holds it.\n";
}

}  // namespace crevice
