#include "chapters/bench/peers.h"

#include <algorithm>
#include <limits>
#include <ostream>
#include <utility>

#include "chapters/bench/agreement.h"
#include "chapters/bench/frames.h"
#include "chapters/bench/machine.h"
#include "chapters/notebook/table.h"
#include "chapters/study/statistics.h"
#include "chapters/terminal/number_text.h"
#include "chapters/terminal/output_directory.h"
#include "chapters/terminal/progress.h"
#include "rasterizer/base/error.h"
#include "rasterizer/base/image_io.h"
#include "rasterizer/base/image_summary.h"

namespace crevice {

namespace {

constexpr std::size_t kPassCount = kPeerPasses.size();
// How many times as fast as the peer each pass is meant to be; DESIGN, section 10.
constexpr std::array<double, kPassCount> kAims = {8, 15, 150, 10, 25};

using FrameClock = std::array<PassClock, kPassCount>;

// The times of all frames of one side, pass by pass.
struct Side {
    std::array<PassSamples, kPassCount> passes;

    void add(const FrameClock& frame) {
        for (std::size_t i = 0; i < kPassCount; ++i) {
            passes[i].wall_ms.push_back(frame[i].wall_ms);
            passes[i].cpu_ms.push_back(frame[i].cpu_ms);
        }
    }
};

struct Duel {
    Side ours, theirs;
    std::string renderer, first_hash, last_hash;  // hashes of our lit image
    std::vector<Agreement> agreement;
    PeerBuffers their_buffers;
};

FrameClock times_of(const Frame& frame, const std::string& scene) {
    FrameClock times;
    for (std::size_t i = 0; i < kPassCount; ++i) {
        const auto pass = std::find_if(frame.passes.begin(), frame.passes.end(),
                                       [&](const PassTime& time) { return time.name == kPeerPasses[i]; });
        if (pass == frame.passes.end()) {
            throw UsageError(scene + ": we have nothing to do in one pass (" + kPeerPasses[i] +
                             "); compare with a scene that needs all of them");
        }
        times[i] = {pass->wall_ms, pass->cpu_ms};
    }
    return times;
}

Duel fight(const SceneArgument& argument, const std::string& name, PeerSession& peer,
           const PeersOptions& options) {
    const FrameRequest request = bench_request(argument.scene, options.size, options.run);
    const Camera camera = chosen_camera(argument, options.camera);

    Duel duel;
    Progress progress(name, options.pairs + 1);
    duel.renderer = peer.load(peer_scene(argument.scene, camera, options.size, request.settings));
    for (int pair = 0; pair <= options.pairs; ++pair) {
        // Each goes first in every second pair.
        FrameClock theirs;
        if (pair % 2 == 1) theirs = peer.frame();
        const Frame frame = render_frame(argument.scene, camera, request);
        const FrameClock ours = times_of(frame, name);
        if (pair % 2 == 0) theirs = peer.frame();
        if (pair == 0) {
            duel.first_hash = content_hash(frame.lit);
        } else {
            duel.ours.add(ours);
            duel.theirs.add(theirs);
        }
        if (pair == options.pairs) {
            duel.last_hash = content_hash(frame.lit);
            duel.their_buffers = peer.buffers();
            duel.agreement = agreement(argument.scene, request, frame, duel.their_buffers);
        }
        progress.advance();
    }
    return duel;
}

// Frames 0, 2, 4 ... over frames 1, 3, 5 ...
MedianInterval noise_floor(const std::vector<double>& wall_ms) {
    std::vector<double> even, odd;
    for (std::size_t i = 0; i + 1 < wall_ms.size(); i += 2) {
        even.push_back(wall_ms[i]);
        odd.push_back(wall_ms[i + 1]);
    }
    return ratio_interval(even, odd);
}

void add_times(Table& table, const std::string& scene, const Duel& duel) {
    for (std::size_t i = 0; i < kPassCount; ++i) {
        const PassSamples &ours = duel.ours.passes[i], &theirs = duel.theirs.passes[i];
        const PassTime our_time = ours.summary(), their_time = theirs.summary();
        const MedianInterval ratio = ratio_interval(theirs.wall_ms, ours.wall_ms);
        table.rows.push_back({scene, kPeerPasses[i], TableValue(our_time.wall_ms, 3),
                              TableValue(our_time.wall_ms_mad, 3), TableValue(our_time.cpu_ms, 3),
                              their_time.wall_ms, their_time.wall_ms_mad, their_time.cpu_ms, ratio.median,
                              ratio.low, ratio.high, TableValue(100 * ratio.confidence, 1),
                              TableValue(kAims[i], 0), verdict_name(verdict(ratio, kAims[i]))});
    }
    const PassSamples& frames = duel.ours.passes.back();
    const MedianInterval floor = noise_floor(frames.wall_ms);
    table.rows.push_back({scene, "frame, ours/ours", TableValue(frames.summary().wall_ms, 3), TableValue(),
                          TableValue(), TableValue(), TableValue(), TableValue(), TableValue(floor.median, 3),
                          TableValue(floor.low, 3), TableValue(floor.high, 3),
                          TableValue(100 * floor.confidence, 1), TableValue(), TableValue()});
}

// False when the two sides did not draw the same picture.
bool add_agreement(Table& table, const std::string& scene, const Duel& duel, std::ostream& out) {
    bool same = duel.first_hash == duel.last_hash;
    if (!same) {
        out << scene << ": our first and last picture differ (" << duel.first_hash << ", " << duel.last_hash
            << "); run the tests\n";
    }
    for (const Agreement& a : duel.agreement) {
        same = same && a.holds();
        table.rows.push_back({scene, a.buffer, a.measure, TableValue(a.value, 5),
                              a.limit ? TableValue(*a.limit, 5) : TableValue(),
                              !a.limit ? "told" : (a.holds() ? "same" : "DIFFERENT")});
    }
    return same;
}

// As `crevice render` writes ours, with its background, so that `crevice compare` can tell them apart. The lit picture
// is none that `render` draws: the peer knows no textures.
void write_buffers(PeerBuffers buffers, const std::filesystem::path& directory, std::ostream& out) {
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
    out << directory.string() << ": the peer's buffers\n";
}

}  // namespace

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
    PeerSession peer(options.program, thread_count(options.run), options.patience_s);
    BenchReport report{"peers", machine_facts(options.run), {}};
    Table times{"peers",
                {"scene", "pass", "ours_ms", "ours_mad", "ours_cpu", "peer_ms", "peer_mad", "peer_cpu",
                 "ratio", "low", "high", "confidence_%", "aim", "verdict"},
                {}};
    Table pictures{"agreement", {"scene", "buffer", "measure", "value", "limit", "verdict"}, {}};
    report.facts.push_back({"size", size_text(options.size)});
    report.facts.push_back({"pairs", std::to_string(options.pairs)});
    bool same = true;
    for (const std::string& name : options.scenes) {
        const SceneArgument argument = load_scene(name, {.surfaces = false});
        const std::size_t triangles = triangle_count(argument.scene);
        if (triangles == 0) throw UsageError(name + ": no triangles to compare; choose another --scene");
        Duel duel = fight(argument, name, peer, options);
        if (&name == &options.scenes.front()) report.facts.push_back({"peer", duel.renderer});
        report.facts.push_back({name, std::to_string(triangles) + " triangles, lit image " + duel.last_hash});
        add_times(times, name, duel);
        same = add_agreement(pictures, name, duel, out) && same;
        const std::string note = busy_note(duel.ours.passes.back().summary(), thread_count(options.run));
        if (!note.empty()) out << name << ": " << note << "\n";
        if (options.out)
            write_buffers(std::move(duel.their_buffers),
                          *options.out / (std::filesystem::path(name).stem().string() + "_peer"), out);
    }
    out << facts_text(report.facts) << "\n" << table_text(times) << "\n" << table_text(pictures);
    if (!same) out << "The two sides did not draw the same picture: their times do not compare.\n";
    report.tables = {times, pictures};
    if (options.out) write_report(report, *options.out, out);
    return static_cast<int>(same ? ExitCode::done : ExitCode::check_failed);
}

}  // namespace crevice
