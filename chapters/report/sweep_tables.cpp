#include "chapters/report/sweep_tables.h"

#include <algorithm>

#include "chapters/report/setting_words.h"
#include "chapters/sweep/error_terms.h"
#include "chapters/terminal/number_text.h"

namespace crevice {

namespace {

constexpr int kErrorDecimals = 4, kTimeDecimals = 3;

BookText text(const std::string& words) { return {words, ""}; }
BookText error_text(double value) { return text(decimal_text(value, kErrorDecimals)); }
BookText time_text(double value) { return text(decimal_text(value, kTimeDecimals)); }

TableOutput with_header(const std::vector<std::string>& columns) {
    TableOutput table;
    for (const std::string& column : columns) table.header.push_back(text(column));
    return table;
}

std::string shown(const TableValue& value) {
    return value.kind == TableValue::Kind::number ? decimal_text(value.number, value.decimals) : value.text;
}

void add_rows(TableOutput& table, const Table& from) {
    for (const std::vector<TableValue>& row : from.rows) {
        std::vector<BookText>& cells = table.rows.emplace_back();
        for (const TableValue& value : row) cells.push_back(text(shown(value)));
    }
}

// The first seed that has not failed, for its picture and command; the first where all have.
const SweepErrorResult* shown_seed(const SettingFigures& figures) {
    for (const SweepErrorResult* const seed : figures.seeds) {
        if (seed->nan_or_inf == 0) return seed;
    }
    return figures.seeds.empty() ? nullptr : figures.seeds.front();
}

std::vector<BookText> point_row(const SettingFigures& figures, const SettingTime* time) {
    std::vector<BookText> row = {text(figures.setting.method), text(setting_words(figures.setting))};
    if (time != nullptr) {
        row.insert(row.end(), {text(std::to_string(time->threads)), time_text(time->ms.value),
                               time_text(time->ms.low), time_text(time->ms.high)});
    } else {
        row.insert(row.end(), 4, text(""));
    }
    if (const auto& errors = figures.errors) {
        row.insert(row.end(), {error_text(errors->rmse.value), text(margin_words(errors->rmse_margin())),
                               error_text(errors->hard_rmse.value), error_text(errors->bias.value),
                               error_text(errors->mae), error_text(errors->p99.value),
                               error_text(errors->flip.value), error_text(errors->ssim)});
    } else {
        row.insert(row.end(), 8, text(""));
    }
    const SweepErrorResult* const seed = shown_seed(figures);
    row.push_back(
        text(std::to_string(figures.seeds.size() - static_cast<std::size_t>(figures.failed_seeds())) +
             " of " + std::to_string(figures.seeds.size())));
    row.push_back(text(seed == nullptr ? "" : seed->picture));
    row.push_back(text(seed == nullptr ? "" : seed->command));
    row.push_back(text(time == nullptr ? "" : time->result->command));
    return row;
}

}  // namespace

TableOutput equal_time_output(std::span<const ErrorPoint> points) {
    TableOutput table = with_header({"method"});
    for (const double budget : kBudgets_ms) {
        table.header.push_back(text("within " + significant_text(budget, 6) + " ms"));
        table.header.push_back(text("ms"));
        table.header.push_back(text("RMSE"));
    }
    add_rows(table, equal_time_table(points, kBudgets_ms));
    return table;
}

TableOutput equal_error_output(std::span<const ErrorPoint> points) {
    TableOutput table = with_header({"method"});
    for (const double level : kErrorLevels) {
        table.header.push_back(text("RMSE " + significant_text(level, 6) + " with"));
        table.header.push_back(text("ms"));
    }
    add_rows(table, equal_error_table(points, kErrorLevels));
    return table;
}

TableOutput points_table(const ViewFigures& view) {
    TableOutput table =
        with_header({"method", "setting", "threads", "ms", "ms low", "ms high", "RMSE", "RMSE ±", "RMSE hard",
                     "bias", "MAE", "p99", "FLIP", "SSIM", "seeds", "picture", "command", "timed by"});
    for (const SettingFigures& figures : view.settings) {
        for (const SettingTime& time : figures.times) table.rows.push_back(point_row(figures, &time));
        if (figures.times.empty()) table.rows.push_back(point_row(figures, nullptr));
    }
    return table;
}

TableOutput passes_table(const ViewFigures& view) {
    TableOutput table = with_header({"method", "setting", "threads", "pass", "wall ms", "low", "high", "MAD",
                                     "CPU ms", "million instructions", "rounds"});
    for (const SettingFigures& figures : view.settings) {
        for (const SettingTime& time : figures.times) {
            for (const SweepPassTime& pass : time.result->passes) {
                table.rows.push_back(
                    {text(figures.setting.method), text(setting_words(figures.setting)),
                     text(std::to_string(time.threads)), text(pass.pass), time_text(pass.wall.median),
                     time_text(pass.wall.low), time_text(pass.wall.high), time_text(pass.wall_mad),
                     time_text(pass.cpu.median),
                     text(pass.instructions > 0 ? decimal_text(pass.instructions * 1e-6, 2) : ""),
                     text(std::to_string(time.result->rounds))});
            }
        }
    }
    return table;
}

TableOutput convergence_table(std::span<const FittedSeries> series) {
    TableOutput table =
        with_header({"method", "setting", "samples", "RMSE at the fewest", "at the most", "exponent"});
    for (const FittedSeries& one : series) {
        table.rows.push_back(
            {text(one.method), text(one.rest),
             text(significant_text(one.x.front(), 6) + " to " + significant_text(one.x.back(), 6)),
             error_text(one.y.front().value), error_text(one.y.back().value), text(exponent_text(one.law))});
    }
    return table;
}

TableOutput floors_table(const ViewFigures& view) {
    TableOutput table = with_header({"method", "setting", "RMSE", "floor of RMSE", "floor of bias",
                                     "T to S alone", "S to C alone", "floor made by", "share T to S",
                                     "share S to C", "share C to frame", "largest share"});
    for (const SettingFigures* const figures : settings_apart(view)) {
        const ErrorTerms terms = error_terms(figures->errors->parts);
        const SweepErrorPart* const largest = largest_part(figures->errors->parts);
        const auto share = [](double value) { return text(significant_text(value, 3)); };
        const std::optional<double>& floor = figures->errors->limit_rmse;
        table.rows.push_back({text(figures->setting.method), text(setting_words(figures->setting)),
                              error_text(figures->errors->rmse.value), floor ? error_text(*floor) : text("-"),
                              error_text(terms.floor_bias()), error_text(terms.screen_rmse),
                              error_text(terms.limit_rmse),
                              text(terms.screen_rmse > terms.limit_rmse ? "depth buffer" : "definition"),
                              share(terms.screen_share), share(terms.limit_share), share(terms.frame_share),
                              text(largest == nullptr ? "-" : largest->step)});
    }
    return table;
}

TableOutput cost_table(std::span<const ViewFigures> views, std::span<const std::string> methods) {
    TableOutput table = with_header({"method"});
    for (const std::string& method : methods) table.rows.push_back({text(method)});
    for (const CostVariable& variable : kCostVariables) {
        const std::vector<FittedSeries> all = cost_series(views, variable);
        table.header.push_back(text(variable.name));
        table.header.push_back(text("along"));
        for (std::size_t i = 0; i < methods.size(); ++i) {
            const auto series = std::find_if(
                all.begin(), all.end(), [&](const FittedSeries& one) { return one.method == methods[i]; });
            const bool varied = series != all.end();
            table.rows[i].push_back(text(varied ? exponent_text(series->law) : "not varied by this plan"));
            table.rows[i].push_back(text(varied ? series->rest : ""));
        }
    }
    return table;
}

}  // namespace crevice
