#include "chapters/stability/stability.h"

#include <algorithm>
#include <cmath>
#include <ostream>
#include <set>

#include "chapters/bench/machine.h"
#include "chapters/notebook/table.h"
#include "chapters/stability/rounding.h"
#include "chapters/stability/stability_page.h"
#include "chapters/terminal/exit_code.h"
#include "chapters/terminal/output_directory.h"
#include "chapters/terminal/parse.h"
#include "chapters/terminal/progress.h"
#include "rasterizer/base/no_such.h"
#include "rasterizer/base/write_file.h"

namespace crevice {

namespace {

Table table_of(const std::vector<StabilityCell>& cells) {
    Table table{"stability",
                {"case", "method", "question", "answer", "measured", "verdict", "warning", "command"},
                {}};
    for (const StabilityCell& cell : cells) {
        table.rows.push_back({cell.stiff->name, cell.method->name, cell.stiff->question,
                              stated_answer(*cell.stiff), TableValue(cell.measured, 6), word_of(cell.verdict),
                              cell.warning, command_of(cell)});
    }
    return table;
}

// One line a method: how many cells of each verdict.
Table summary_of(const std::vector<StabilityCell>& cells) {
    Table table{"verdicts", {"method", "exact", "within", "warned", "wrong"}, {}};
    for (const Method& method : ao_methods()) {
        std::array<int, 4> counts{};
        for (const StabilityCell& cell : cells) {
            if (cell.method == &method) ++counts[static_cast<std::size_t>(cell.verdict)];
        }
        if (counts == std::array<int, 4>{}) continue;
        std::vector<TableValue> row = {method.name};
        for (const int count : counts) row.push_back(TableValue(count, 0));
        table.rows.push_back(std::move(row));
    }
    return table;
}

// The cases that are asked for by name; all where `name` is empty.
template <class Case>
std::vector<Case> chosen_of(std::vector<Case> cases, const std::string& name) {
    if (!name.empty()) std::erase_if(cases, [&](const Case& one) { return one.name != name; });
    return cases;
}

[[noreturn]] void refuse_case(const StabilityOptions& options) {
    std::set<std::string> names;
    for (const StiffCase& one : stiff_cases(options.quick)) names.insert(one.name);
    for (const RoundingCase& one : rounding_cases(options.quick)) names.insert(one.name);
    throw no_such("--case", "case", options.only_case, {names.begin(), names.end()});
}

}  // namespace

const char* word_of(StabilityVerdict verdict) {
    static constexpr const char* kWords[] = {"exact", "within", "warned", "wrong"};
    return kWords[static_cast<std::size_t>(verdict)];
}

int stability(const StabilityOptions& options, std::ostream& out) {
    validate(options.run);
    const std::vector<StiffCase> stiff = chosen_of(stiff_cases(options.quick), options.only_case);
    const std::vector<RoundingCase> judged = chosen_of(rounding_cases(options.quick), options.only_case);
    if (stiff.empty() && judged.empty()) refuse_case(options);
    const Method* const only = options.only_method.empty() ? nullptr : named_as({{"method", "--ao"}}, [&] {
        return &find_method(options.only_method);
    });
    try_output_directory(options.out);
    std::vector<StabilityCell> cells;
    std::vector<CaseRounding> rounding;
    {
        Progress progress("stability", static_cast<long long>(stiff.size() + judged.size()));
        for (const StiffCase& one : stiff) {
            for (const Method& method : ao_methods()) {
                if (method.computes_ao() && (only == nullptr || only == &method))
                    cells.push_back(stability_cell(one, method, options.run));
            }
            progress.advance(1);
        }
        for (const RoundingCase& one : judged) {
            rounding.push_back(case_rounding(one, only, options.run));
            progress.advance(1);
        }
    }
    BenchReport report{
        "stability",
        machine_facts(options.run),
        {summary_of(cells), table_of(cells), pass_rounding_table(rounding), method_rounding_table(rounding)}};
    out << table_text(report.tables[0]) << table_text(report.tables[2]);
    for (const StabilityCell& cell : cells) {
        if (cell.verdict == StabilityVerdict::wrong)
            out << "wrong: " << cell.method->name << ", " << cell.stiff->name << ": " << cell.stiff->question
                << "; replay: " << command_of(cell) << "\n";
    }
    write_report(report, options.out, out);
    const std::filesystem::path page = options.out / "stability.html";
    write_file_atomically(page, stability_page(report, cells, rounding));
    out << page.string() << "\n";
    const bool wrong = std::ranges::any_of(
        cells, [](const StabilityCell& cell) { return cell.verdict == StabilityVerdict::wrong; });
    return static_cast<int>(wrong ? ExitCode::check_failed : ExitCode::done);
}

}  // namespace crevice
