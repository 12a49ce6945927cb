#include "chapters/bench/peers.h"

#include <algorithm>
#include <limits>
#include <ostream>
#include <utility>

#include "chapters/bench/machine.h"
#include "chapters/bench/peer_duel.h"
#include "chapters/frame/presets.h"
#include "chapters/notebook/picture.h"
#include "chapters/notebook/table.h"
#include "chapters/study/statistics.h"
#include "chapters/terminal/number_text.h"
#include "chapters/terminal/output_directory.h"
#include "rasterizer/base/error.h"
#include "rasterizer/base/image_io.h"

namespace crevice {

namespace {

// How many times as fast as the peer a pass is meant to be. None: told, not judged.
std::optional<double> aim_of(const PeerSubject& subject, const std::string& pass) {
    constexpr std::pair<const char*, double> kPlain[] = {
        {"normal_depth", 8}, {"ao", 15}, {"blur", 150}, {"lit", 10}, {"frame", 25}};
    constexpr double kWholeFrame = 10;
    if (subject.draws == PeerSubject::Draws::whole && pass == "frame") return kWholeFrame;
    if (subject.draws != PeerSubject::Draws::plain) return std::nullopt;
    for (const auto& [name, aim] : kPlain) {
        if (pass == name) return aim;
    }
    return std::nullopt;
}

void add_times(Table& table, const PeerSubject& subject, const PeerDuel& duel) {
    for (std::size_t i = 0; i < duel.ours.passes.size(); ++i) {
        const PassSamples &ours = duel.ours.passes[i], &theirs = duel.theirs.passes[i];
        const PassTime our_time = ours.summary(), their_time = theirs.summary();
        const MedianInterval ratio = ratio_interval(theirs.wall_ms, ours.wall_ms),
                             noise = ratio_interval(duel.again.passes[i].wall_ms, ours.wall_ms);
        const std::optional<double> aim = aim_of(subject, ours.name);
        table.rows.push_back(
            {subject.name, ours.name, TableValue(our_time.wall_ms, 3), TableValue(our_time.wall_ms_mad, 3),
             TableValue(our_time.cpu_ms, 3), their_time.wall_ms, their_time.wall_ms_mad, their_time.cpu_ms,
             ratio.median, ratio.low, ratio.high, TableValue(100 * ratio.confidence, 1), noise.low,
             noise.high, their_time.cpu_ms / our_time.cpu_ms, aim ? TableValue(*aim, 0) : TableValue(),
             aim ? TableValue(verdict_name(verdict(ratio, *aim))) : TableValue()});
    }
}

// False when the two sides did not draw the same picture.
bool add_agreement(Table& table, const PeerSubject& subject, const PeerDuel& duel, std::ostream& out) {
    bool same = duel.first_hash == duel.last_hash;
    if (!same) {
        out << subject.name << ": our first and last picture differ (" << duel.first_hash << ", "
            << duel.last_hash << "); run the tests\n";
    }
    for (const Agreement& a : duel.agreement) {
        same = same && a.holds();
        table.rows.push_back({subject.name, a.buffer, a.measure, TableValue(a.value, 5),
                              a.limit ? TableValue(*a.limit, 5) : TableValue(),
                              !a.limit ? "told" : (a.holds() ? "same" : "DIFFERENT")});
    }
    return same;
}

// As `crevice render` writes ours, with its background, so that `crevice compare` can tell them apart. The lit picture in
// plain colours is none that `render` draws.
void write_buffers(PeerBuffers buffers, bool lit, const std::filesystem::path& directory, std::ostream& out) {
    const Size size = buffers.ndc_depth.size;
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
            if (buffers.ndc_depth.at(x, y) < 1) continue;
            buffers.normal.set(x, y, {0, 0, 0});
            buffers.view_depth.at(x, y) = std::numeric_limits<float>::infinity();
        }
    }
    try_output_directory(directory);
    write_npy(directory / "normal.npy", buffers.normal);
    write_npy(directory / "view_depth.npy", buffers.view_depth);
    write_npy(directory / "ndc_depth.npy", buffers.ndc_depth);
    write_npy(directory / "ao_raw.npy", buffers.ao_raw);
    write_npy(directory / "ao_blurred.npy", buffers.ao_blurred);
    if (lit) {
        write_npy(directory / "lit.npy", buffers.lit);
        write_picture(directory / "lit.png", lit_picture(buffers.lit));
    }
    out << directory.string() << ": the peer's buffers\n";
}

// What buffers of this subject are written into: "preset luna" becomes preset_luna_peer.
std::string directory_name(const std::string& subject) {
    std::string name = std::filesystem::path(subject).stem().string();
    std::replace(name.begin(), name.end(), ' ', '_');
    return name + "_peer";
}

}  // namespace

PeerSubject plain_subject(const std::string& scene) { return {.scene = scene, .name = scene}; }

PeerSubject preset_subject(const std::string& preset) {
    const Preset& found = find_preset(preset);
    return {.scene = found.scene,
            .method = found.method,
            .draws = PeerSubject::Draws::whole,
            .params = found.words,
            .name = "preset " + preset};
}

PeerSubject ao_subject(const std::string& scene, const std::string& method) {
    return {.scene = scene, .method = method, .draws = PeerSubject::Draws::ao, .name = scene + " " + method};
}

std::vector<PeerSubject> all_peer_subjects() {
    std::vector<PeerSubject> all = {plain_subject("columns"), plain_subject("columns_luna"),
                                    preset_subject("luna"), preset_subject("xjun2022")};
    for (const char* method : {"hemisphere", "sao", "gtao"})
        all.push_back(ao_subject("columns_luna", method));
    return all;
}

void validate(const PeersOptions& options) {
    validate(options.run);
    if (options.pairs < kFewestPairs || options.pairs > kMostPairs) {
        throw UsageError("--pairs: not in " + std::to_string(kFewestPairs) + ".." +
                         std::to_string(kMostPairs) + " (" + std::to_string(options.pairs) + "); choose one");
    }
    if (options.size.width < kSmallestCompared.width || options.size.height < kSmallestCompared.height) {
        throw UsageError("--size: too small to compare with the peer (" + size_text(options.size) +
                         "); give at least " + size_text(kSmallestCompared));
    }
}

int bench_peers(const PeersOptions& options, std::ostream& out) {
    validate(options);
    BenchReport report{"peers", machine_facts(options.run), {}};
    Table times{
        "peers",
        {"scene", "pass", "ours_ms", "ours_mad", "ours_cpu", "peer_ms", "peer_mad", "peer_cpu", "ratio",
         "low", "high", "confidence_%", "noise_low", "noise_high", "cpu_ratio", "aim", "verdict"},
        {}};
    Table pictures{"agreement", {"scene", "buffer", "measure", "value", "limit", "verdict"}, {}};
    report.facts.push_back({"size", size_text(options.size)});
    report.facts.push_back({"pairs", std::to_string(options.pairs)});
    bool same = true;
    for (const PeerSubject& subject : options.subjects) {
        const std::string& name = subject.name;
        const bool whole = subject.draws == PeerSubject::Draws::whole;
        const SceneArgument argument = load_scene(subject.scene, {.surfaces = whole, .run = options.run});
        const std::size_t triangles = triangle_count(argument.scene);
        if (triangles == 0) throw UsageError(name + ": no triangles to compare; choose another --scene");
        PeerDuel duel = peer_duel(subject, argument, options);
        if (&subject == &options.subjects.front()) report.facts.push_back({"peer", duel.renderer});
        report.facts.push_back({name, counted(static_cast<long long>(triangles), "triangle") +
                                          ", last image " + duel.last_hash});
        add_times(times, subject, duel);
        same = add_agreement(pictures, subject, duel, out) && same;
        const std::string note = busy_note(duel.ours.passes.back().summary(), thread_count(options.run));
        if (!note.empty()) out << name << ": " << note << "\n";
        if (options.out)
            write_buffers(std::move(duel.their_buffers), whole, *options.out / directory_name(name), out);
    }
    out << facts_text(report.facts) << "\n" << table_text(times) << "\n" << table_text(pictures);
    if (!same) out << "The two sides did not draw the same picture: their times do not compare.\n";
    report.tables = {times, pictures};
    if (options.out) write_report(report, *options.out, out);
    return static_cast<int>(same ? ExitCode::done : ExitCode::check_failed);
}

}  // namespace crevice
