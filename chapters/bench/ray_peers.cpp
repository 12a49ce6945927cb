#include "chapters/bench/ray_peers.h"

#include <algorithm>
#include <cmath>
#include <ostream>
#include <utility>

#include <nlohmann/json.hpp>

#include "chapters/bench/machine.h"
#include "chapters/bench/peers.h"
#include "chapters/bench/threads.h"
#include "chapters/study/statistics.h"
#include "chapters/terminal/child.h"
#include "chapters/terminal/json_text.h"
#include "chapters/terminal/number_text.h"
#include "chapters/terminal/progress.h"
#include "rasterizer/base/error.h"

namespace crevice {

namespace {

using PeerLine = nlohmann::ordered_json;

// How many times as fast as each of Embree's ways ours is meant to be.
constexpr double kRayAim = 1;
// Means of the same thing are further apart once in 16,000 times.
constexpr double kMostErrors = 4;

// All rounds of one way to trace rays of one length.
struct Traced {
    std::string length, tracer;
    int threads = 0;
    double rays = 0;
    std::vector<double> ms, cpu_ms;
    double differing1 = 0, differing8 = 0;

    double million_rays_a_second() const { return rays / median_interval(ms).median * 1e-3; }
};

std::string length_text(const PeerLine& length) {
    return length.is_string() ? length.get<std::string>() : significant_text(length.get<double>(), 6);
}

Traced traced(const PeerLine& line) {
    return {length_text(line.at("length")),
            line.at("tracer").get<std::string>(),
            line.at("threads").get<int>(),
            line.at("rays").get<double>(),
            line.at("ms").get<std::vector<double>>(),
            line.at("cpu_ms").get<std::vector<double>>(),
            line.at("differing_embree1").get<double>(),
            line.at("differing_embree8").get<double>()};
}

// Ratio, low, high and whether that meets an aim.
void add_ratio(std::vector<TableValue>& row, const MedianInterval& ratio, std::optional<double> aim) {
    row.insert(row.end(), {TableValue(ratio.median), TableValue(ratio.low), TableValue(ratio.high)});
    if (aim) row.push_back(verdict_name(verdict(ratio, *aim)));
}

const Traced& find_traced(const std::vector<Traced>& all, const Traced& like, const std::string& tracer,
                          int threads) {
    const auto found = std::find_if(all.begin(), all.end(), [&](const Traced& t) {
        return t.length == like.length && t.tracer == tracer && t.threads == threads;
    });
    if (found == all.end())
        throw InputError("embree_peer: no times of " + tracer + " at length " + like.length +
                         "; build both programs anew");
    return *found;
}

Table rays_table(const std::string& scene, const std::vector<Traced>& all) {
    Table table{"rays",
                {"scene", "length", "threads", "ours_Mray/s", "embree1_Mray/s", "embree8_Mray/s",
                 "ours/embree1", "low", "high", "verdict", "ours/embree8", "low8", "high8", "verdict8",
                 "noise_low", "noise_high", "unlike1", "unlike8"},
                {}};
    for (const Traced& ours : all) {
        if (ours.tracer != "ours") continue;
        const Traced &again = find_traced(all, ours, "ours_again", ours.threads),
                     &single = find_traced(all, ours, "embree1", ours.threads),
                     &packet = find_traced(all, ours, "embree8", ours.threads);
        const MedianInterval noise = ratio_interval(again.ms, ours.ms);
        std::vector<TableValue> row = {scene,
                                       ours.length,
                                       TableValue(ours.threads, 0),
                                       TableValue(ours.million_rays_a_second(), 1),
                                       TableValue(single.million_rays_a_second(), 1),
                                       TableValue(packet.million_rays_a_second(), 1)};
        add_ratio(row, ratio_interval(single.ms, ours.ms), kRayAim);
        add_ratio(row, ratio_interval(packet.ms, ours.ms), kRayAim);
        row.insert(row.end(), {TableValue(noise.low), TableValue(noise.high), TableValue(ours.differing1, 0),
                               TableValue(ours.differing8, 0)});
        table.rows.push_back(row);
    }
    return table;
}

// What more threads give to each way to trace.
Table threads_table(const std::string& scene, const std::vector<Traced>& all) {
    Table table{
        "ray_threads", {"scene", "length", "tracer", "threads", "ratio_to_1", "low", "high", "verdict"}, {}};
    for (const Traced& many : all) {
        if (many.threads == 1 || many.tracer == "ours_again") continue;
        const Traced& one = find_traced(all, many, many.tracer, 1);
        std::vector<TableValue> row = {scene, many.length, many.tracer, TableValue(many.threads, 0)};
        const bool judged = many.tracer == "ours" && many.threads == 2;
        add_ratio(row, ratio_interval(one.ms, many.ms),
                  judged ? std::optional<double>(kTwoThreadAim) : std::nullopt);
        if (!judged) row.push_back(TableValue());
        table.rows.push_back(row);
    }
    return table;
}

std::vector<TableValue> build_row(const std::string& scene, const PeerLine& line) {
    const auto ours = line.at("ours_ms").get<std::vector<double>>(),
               embree = line.at("embree_ms").get<std::vector<double>>();
    std::vector<TableValue> row = {scene, TableValue(line.at("threads").get<int>(), 0),
                                   TableValue(median_interval(ours).median),
                                   TableValue(median_interval(embree).median)};
    add_ratio(row, ratio_interval(embree, ours), std::nullopt);
    return row;
}

std::vector<TableValue> agreement_row(const std::string& scene, const PeerLine& line) {
    const auto number = [&](const char* name) { return line.at(name).get<double>(); };
    const double same_rays = number("same_rays_errors"), own_rays = number("own_rays_errors");
    const bool same = std::abs(same_rays) < kMostErrors && std::abs(own_rays) < kMostErrors;
    return {scene,
            length_text(line.at("radius")),
            TableValue(number("points"), 0),
            TableValue(number("rays"), 0),
            TableValue(number("differing"), 0),
            TableValue(number("ours"), 5),
            TableValue(number("embree_same_rays"), 5),
            TableValue(number("embree_own_rays"), 5),
            TableValue(number("error"), 6),
            TableValue(same_rays, 3),
            TableValue(own_rays, 2),
            TableValue(number("point_rms_errors"), 3),
            same ? "same" : "DIFFERENT"};
}

std::vector<std::string> ask_peer(const std::string& scene, const RayPeersOptions& options) {
    ChildCommand command{options.program,
                         {scene, "--rounds", std::to_string(options.rounds), "--threads",
                          std::to_string(thread_count(options.run))},
                         {},
                         options.patience_s};
    const CameraFlags& c = options.camera;
    const std::pair<const char*, const std::optional<std::string>&> flags[] = {
        {"--eye", c.eye},         {"--target", c.target}, {"--fov-y", c.fov_y},
        {"--near", c.near_plane}, {"--far", c.far_plane}, {"--ortho", c.ortho}};
    for (const auto& [flag, word] : flags) {
        if (word) command.arguments.insert(command.arguments.end(), {flag, *word});
    }
    Child peer(command);
    std::vector<std::string> lines;
    do {
        lines.push_back(peer.read_line());
    } while (lines.back() != R"({"kind":"end"})");
    return lines;
}

struct Answers {
    std::vector<Traced> traces;
    Table builds{
        "ray_builds", {"scene", "threads", "ours_ms", "embree_ms", "embree/ours", "low", "high"}, {}};
    Table agreement{
        "ray_agreement",
        {"scene", "radius", "points", "rays", "unlike", "ours", "embree_same_rays", "embree_own_rays",
         "error", "difference_same_rays_errors", "difference_own_rays_errors", "point_rms_errors", "verdict"},
        {}};
};

Answers answers_of(const std::string& scene, const std::vector<std::string>& lines) {
    Answers answers;
    for (const std::string& text : lines) {
        try {
            const PeerLine line = json_from_text(text);
            const auto kind = line.at("kind").get<std::string>();
            if (kind == "trace") answers.traces.push_back(traced(line));
            if (kind == "build") answers.builds.rows.push_back(build_row(scene, line));
            if (kind == "agreement") answers.agreement.rows.push_back(agreement_row(scene, line));
        } catch (const PeerLine::exception&) {
            throw InputError("embree_peer: not an answer (" + text.substr(0, 60) +
                             "); build both programs anew");
        }
    }
    return answers;
}

// Whether other programs took our time while ours traced.
std::string busy_traces_note(const std::vector<Traced>& traces) {
    for (const Traced& t : traces) {
        if (t.tracer != "ours") continue;
        const std::string note = busy_note(PassSamples{"rays", t.ms, t.cpu_ms}.summary(), t.threads);
        if (!note.empty()) return note;
    }
    return {};
}

}  // namespace

std::filesystem::path ray_peer_program() { return own_program().parent_path() / "embree_peer"; }

std::vector<Table> ray_tables(const std::string& scene, const std::vector<std::string>& lines) {
    const Answers answers = answers_of(scene, lines);
    return {rays_table(scene, answers.traces), threads_table(scene, answers.traces), answers.builds,
            answers.agreement};
}

int bench_ray_peers(const RayPeersOptions& options, std::ostream& out) {
    validate(options.run);
    std::error_code ignored;
    if (!std::filesystem::exists(options.program, ignored)) {
        out << "Rays: not compared with Embree, whose peer was not built; install libembree-dev and run "
               "./crevice.sh test, which builds it.\n";
        return static_cast<int>(ExitCode::done);
    }
    BenchReport report{"ray_peers", machine_facts(options.run), {}};
    report.facts.push_back({"rounds", std::to_string(options.rounds)});
    bool same = true;
    for (const std::string& scene : options.scenes) {
        const std::vector<std::string> lines = ask_peer(scene, options);
        report.facts.push_back({scene, lines.front()});
        const std::vector<Table> tables = ray_tables(scene, lines);
        for (const std::vector<TableValue>& row : tables.back().rows)
            same = same && row.back().text == "same";
        const std::string note = busy_traces_note(answers_of(scene, lines).traces);
        if (!note.empty()) out << scene << ": " << note << "\n";
        if (report.tables.empty()) {
            report.tables = tables;
            continue;
        }
        for (std::size_t i = 0; i < tables.size(); ++i) {
            auto& rows = report.tables[i].rows;
            rows.insert(rows.end(), tables[i].rows.begin(), tables[i].rows.end());
        }
    }
    out << facts_text(report.facts);
    for (const Table& table : report.tables) out << "\n" << table_text(table);
    if (!same) out << "The two sides do not find the same ambient occlusion: their times do not compare.\n";
    if (options.out) write_report(report, *options.out, out);
    return static_cast<int>(same ? ExitCode::done : ExitCode::check_failed);
}

}  // namespace crevice
