#include "chapters/bench/instructions.h"

#include <cstdlib>
#include <ostream>
#include <sstream>

#include "chapters/bench/instruction_figures.h"
#include "chapters/bench/machine.h"
#include "chapters/bench/scratch.h"
#include "chapters/notebook/table.h"
#include "chapters/terminal/child.h"
#include "chapters/terminal/json_text.h"
#include "chapters/terminal/progress.h"
#include "chapters/terminal/stopwatch.h"
#include "rasterizer/base/error.h"
#include "rasterizer/base/file_bytes.h"
#include "rasterizer/base/write_file.h"

namespace crevice {

namespace {

namespace fs = std::filesystem;

constexpr const char* kScenes[] = {"columns", "columns_luna", "cornell"};
constexpr double kLongestRun_s = 58;  // for all scenes: never over a minute
constexpr std::uintmax_t kLargestFile = 64 << 20;

// What callgrind counted between two readings of the clock.
long long counted(const fs::path& dump) {
    std::istringstream lines(read_file(dump, kLargestFile));
    const std::string name = "totals: ";
    std::string line;
    while (std::getline(lines, line)) {
        if (line.starts_with(name)) return std::atoll(line.c_str() + name.size());
    }
    throw InputError(dump.string() + ": callgrind wrote no total; use valgrind 3.19 or newer");
}

// The passes in the order in which they ran, as passes.json has them; the last is the frame.
std::vector<std::string> pass_names(const fs::path& out) {
    const auto json = json_from_text(read_file(out / "passes.json", kLargestFile));
    std::vector<std::string> names;
    for (const auto& pass : json.at("passes")) names.push_back(pass.at("name").get<std::string>());
    return names;
}

// Passes of the scene at rest, which are done before the frame.
bool is_before_frame(const std::string& pass) { return pass == "ray_scene" || pass == "bake"; }

InstructionFigures measured_figures(const fs::path& program) {
    require_valgrind();
    if (!isa_available(Isa::avx2))
        throw InputError(
            "--instructions: this CPU has no AVX2, which the figures are for; use another machine");
    InstructionFigures figures{compiler_name(), {}};
    const double until_ms = clocks().wall_ms + kLongestRun_s * 1e3;
    Progress progress("instructions", std::size(kScenes));
    for (const char* scene : kScenes) {
        const std::vector<InstructionCount> counts = counted_frame(
            program, scene, {"--size", "160x90"}, Isa::avx2, (until_ms - clocks().wall_ms) * 1e-3);
        figures.counts.insert(figures.counts.end(), counts.begin(), counts.end());
        progress.advance();
    }
    return figures;
}

Table table_of(const InstructionFigures& stored, const InstructionFigures& measured) {
    Table table{"instructions", {"scene", "pass", "instructions", "stored", "change_%"}, {}};
    for (const InstructionCount& now : measured.counts) {
        const auto count = static_cast<double>(now.instructions);
        const InstructionCount* const before = find_count(stored, now.scene, now.pass);
        if (before == nullptr) {
            table.rows.push_back({now.scene, now.pass, TableValue(count, 0), TableValue(), TableValue()});
        } else {
            const auto was = static_cast<double>(before->instructions);
            table.rows.push_back(
                {now.scene, now.pass, TableValue(count, 0), TableValue(was, 0), 100 * (count / was - 1)});
        }
    }
    return table;
}

InstructionFigures stored_figures(const fs::path& path) {
    std::error_code ignored;
    if (!fs::exists(path, ignored)) {
        throw InputError(
            path.string() +
            ": no stored figures; run in the repository, or give --figures FILE, which --bless writes");
    }
    return figures_from_text(read_file(path, kLargestFile), path.string());
}

}  // namespace

void require_valgrind() {
    if (!in_path("valgrind")) throw InputError("valgrind: not found; install the package valgrind");
}

std::vector<InstructionCount> counted_frame(const fs::path& program, const std::string& scene,
                                            const std::vector<std::string>& words, Isa isa,
                                            double patience_s) {
    require_valgrind();
    const BenchScratch scratch;
    const fs::path profile = scratch.path() / "profile", out = scratch.path() / "out";
    std::vector<std::string> all = {"--tool=callgrind",
                                    "--callgrind-out-file=" + profile.string(),
                                    "--dump-before=crevice::clocks()",
                                    program.string(),
                                    "render",
                                    scene};
    all.insert(all.end(), words.begin(), words.end());
    all.insert(all.end(), {"--threads", "1", "--isa", isa_name(isa), "--out", out.string()});
    const ChildOutcome outcome =
        run_child({"valgrind", all, {std::string("CREVICE_ISA=") + isa_name(isa)}, patience_s});
    if (outcome.exit_code != 0) {
        throw InputError("valgrind: exit code " + std::to_string(outcome.exit_code) + " on " + scene + " (" +
                         outcome.output.substr(0, outcome.output.find('\n')) +
                         "); count with an optimised build without sanitizers");
    }
    // The clock is read when a frame begins and ends, and when each of its passes does. Before the first
    // reading lies the start-up; dump i lies before reading i.
    std::vector<std::string> passes = pass_names(out);
    passes.pop_back();
    const std::size_t readings = 2 + 2 * passes.size();
    const auto dump = [&](std::size_t reading) { return profile.string() + "." + std::to_string(reading); };
    if (!fs::exists(dump(readings)) || fs::exists(dump(readings + 1))) {
        throw InputError("valgrind: not one frame of " + std::to_string(passes.size()) + " passes in " +
                         scene + "; a pass is timed in another way than stopwatch.h does");
    }
    std::vector<InstructionCount> counts;
    std::size_t reading = 1;  // the next one
    for (const std::string& pass : passes) {
        if (!is_before_frame(pass)) continue;
        counts.push_back({scene, pass, counted(dump(reading + 1))});
        reading += 2;
    }
    long long frame = 0;
    for (const std::string& pass : passes) {
        if (is_before_frame(pass)) continue;
        // Up to where the pass begins, and up to where it ends.
        const long long before = counted(dump(reading + 1)), within = counted(dump(reading + 2));
        counts.push_back({scene, pass, within});
        frame += before + within;
        reading += 2;
    }
    counts.push_back({scene, "frame", frame + counted(dump(readings))});
    return counts;
}

int bench_instructions(const InstructionsOptions& options, std::ostream& out) {
    if (options.bless && std::getenv("CI") != nullptr)
        throw UsageError("--bless: refused where CI is set; bless them on your own machine");
    const InstructionFigures stored = options.bless ? InstructionFigures{} : stored_figures(options.figures);
    const InstructionFigures measured = measured_figures(options.program);
    const BenchReport report{"instructions", {{"compiler", measured.compiler}}, {table_of(stored, measured)}};
    out << facts_text(report.facts) << "\n" << table_text(report.tables.front());
    if (options.out) write_report(report, *options.out, out);
    if (options.bless) {
        write_file_atomically(options.figures, figures_text(measured));
        out << options.figures.string() << ": stored\n";
        return static_cast<int>(ExitCode::done);
    }
    if (stored.compiler != measured.compiler) {
        out << "Not judged: the stored figures are of " << stored.compiler << ", this is "
            << measured.compiler << ".\n";
        // On a developer's machine that is no fault; where CI is set the guard must not fall asleep.
        return static_cast<int>(std::getenv("CI") == nullptr ? ExitCode::done : ExitCode::check_failed);
    }
    const std::vector<std::string> changes = changed_counts(stored, measured);
    for (const std::string& line : changes) out << line << "\n";
    if (changes.empty()) return static_cast<int>(ExitCode::done);
    out << "If this is meant: crevice bench --instructions --bless, and commit " << options.figures.string()
        << "\n";
    return static_cast<int>(ExitCode::check_failed);
}

}  // namespace crevice
