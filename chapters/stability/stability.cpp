#include "chapters/stability/stability.h"

#include <algorithm>
#include <cmath>
#include <ostream>

#include "chapters/bench/machine.h"
#include "chapters/notebook/table.h"
#include "chapters/stability/stability_page.h"
#include "chapters/terminal/exit_code.h"
#include "chapters/terminal/output_directory.h"
#include "chapters/terminal/progress.h"
#include "rasterizer/base/error.h"
#include "rasterizer/base/write_file.h"

namespace crevice {

namespace {

// Those of the words that the method knows; the others ask for nothing that it has.
std::vector<std::string> known_words(const Method& method, const std::vector<std::string>& words) {
    std::vector<std::string> known;
    for (const std::string& word : words) {
        const std::string name = word.substr(0, word.find('='));
        for (const Parameter<FrameSettings>& parameter : frame_parameters(method)) {
            if (parameter.name == name) known.push_back(word);
        }
    }
    return known;
}

Frame frame_of(const StiffView& view, const Method& method, const Run& run) {
    FrameRequest request;
    request.size = view.size;
    request.method = &method;
    request.settings = settings_of(method, known_words(method, view.params), view.scene.length_unit);
    request.wanted = {"ao_raw", "ao_blurred"};
    request.run = run;
    return render_frame(view.scene, view.camera, request);
}

// What a map holds of surfaces, and whether all of it is a number in [0,1].
struct MapFigures {
    double below_one = 0;  // the mean of 1 - AO
    double largest_below = 0;
    bool in_range = true;
};
MapFigures figures_of(const Image<float>& ao) {
    MapFigures figures;
    const double count = static_cast<double>(ao.size.width) * ao.size.height;
    for (int y = 0; y < ao.size.height; ++y) {
        for (int x = 0; x < ao.size.width; ++x) {
            const float value = ao.at(x, y);
            figures.in_range = figures.in_range && value >= 0 && value <= 1;
            figures.below_one += (1 - static_cast<double>(value)) / count;
            figures.largest_below = std::max(figures.largest_below, 1 - static_cast<double>(value));
        }
    }
    return figures;
}

double largest_difference(const Image<float>& a, const Image<float>& b) {
    if (!(a.size == b.size)) return 1;
    double largest = 0;
    for (int y = 0; y < a.size.height; ++y) {
        for (int x = 0; x < a.size.width; ++x)
            largest = std::max(largest,
                               std::fabs(static_cast<double>(a.at(x, y)) - static_cast<double>(b.at(x, y))));
    }
    return largest;
}

std::string first_warning(const Frame& frame) {
    for (const PrecisionLoss& loss : frame.precision) {
        if (!loss.warning.empty()) return loss.warning;
    }
    return "";
}

StabilityVerdict verdict_of(bool in_range, double off, double stated, bool warned) {
    if (!in_range) return StabilityVerdict::wrong;
    if (off == 0) return StabilityVerdict::exact;
    if (off <= stated) return StabilityVerdict::within;
    return warned ? StabilityVerdict::warned : StabilityVerdict::wrong;
}

Table table_of(const std::vector<StabilityCell>& cells) {
    Table table{"stability", {"case", "method", "question", "measured", "verdict", "warning", "command"}, {}};
    for (const StabilityCell& cell : cells) {
        table.rows.push_back({cell.stiff->name, cell.method->name, cell.stiff->question,
                              TableValue(cell.measured, 6), word_of(cell.verdict), cell.warning,
                              command_of(cell)});
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

}  // namespace

const char* word_of(StabilityVerdict verdict) {
    static constexpr const char* kWords[] = {"exact", "within", "warned", "wrong"};
    return kWords[static_cast<std::size_t>(verdict)];
}

StabilityCell stability_cell(const StiffCase& stiff, const Method& method, const Run& run) {
    const Frame frame = frame_of(stiff.view(), method, run);
    StabilityCell cell;
    cell.stiff = &stiff;
    cell.method = &method;
    cell.warning = first_warning(frame);
    cell.ao = ao_picture(frame.ao_raw);
    const MapFigures raw = figures_of(frame.ao_raw), smooth = figures_of(frame.ao_blurred);
    const bool in_range = raw.in_range && smooth.in_range;
    double stated = 0;
    switch (stiff.answer) {
        case Answer::open:
            cell.measured = std::max(raw.below_one, smooth.below_one);
            stated = kStatedBias;
            break;
        case Answer::same:
            cell.measured = largest_difference(frame.ao_raw, frame_of(stiff.same_as(), method, run).ao_raw);
            break;
        case Answer::background: cell.measured = std::max(raw.largest_below, smooth.largest_below); break;
        case Answer::in_range: cell.measured = 0; break;
    }
    cell.verdict = verdict_of(in_range, cell.measured, stated, !cell.warning.empty());
    return cell;
}

int stability(const StabilityOptions& options, std::ostream& out) {
    validate(options.run);
    const std::vector<StiffCase> cases = stiff_cases(options.quick);
    std::vector<const StiffCase*> chosen;
    for (const StiffCase& stiff : cases) {
        if (options.only_case.empty() || options.only_case == stiff.name) chosen.push_back(&stiff);
    }
    if (chosen.empty()) {
        std::string known;
        for (const StiffCase& stiff : cases) known += (known.empty() ? "" : ", ") + stiff.name;
        throw UsageError("--case: there is no such case (" + options.only_case + "); give one of " + known);
    }
    const Method* const only = options.only_method.empty() ? nullptr : &find_method(options.only_method);
    try_output_directory(options.out);
    std::vector<StabilityCell> cells;
    {
        Progress progress("stability", static_cast<long long>(chosen.size()));
        for (const StiffCase* stiff : chosen) {
            for (const Method& method : ao_methods()) {
                if (method.computes_ao() && (only == nullptr || only == &method))
                    cells.push_back(stability_cell(*stiff, method, options.run));
            }
            progress.advance(1);
        }
    }
    BenchReport report{"stability", machine_facts(options.run), {summary_of(cells), table_of(cells)}};
    out << table_text(report.tables.front());
    for (const StabilityCell& cell : cells) {
        if (cell.verdict == StabilityVerdict::wrong)
            out << "wrong: " << cell.method->name << ", " << cell.stiff->name << ": " << cell.stiff->question
                << "; replay: " << command_of(cell) << "\n";
    }
    write_report(report, options.out, out);
    const std::filesystem::path page = options.out / "stability.html";
    write_file_atomically(page, stability_page(report, cells));
    out << page.string() << "\n";
    const bool wrong = std::ranges::any_of(
        cells, [](const StabilityCell& cell) { return cell.verdict == StabilityVerdict::wrong; });
    return static_cast<int>(wrong ? ExitCode::check_failed : ExitCode::done);
}

}  // namespace crevice
