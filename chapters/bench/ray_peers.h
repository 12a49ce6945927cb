// `crevice bench --peers`, the part about rays: ours against Embree's, in one run.
// How:  the peer program (tests/peers/embree_peer.cpp) links both. It makes the rays that ambient occlusion
//       shoots from a picture's pixels, sorted as ray_cast_ao() sorts them, and traces the very same ones in
//       turns of random order: ours a point after the other, twice, Embree one by one (rtcOccluded1) and in packets of eight
//       (rtcOccluded8). The first round is thrown away.
// Says: rays per second, and the median of the paired ratios with its order-statistic interval (ours against ours
//       again is the noise), for rays of length 0.5, 2 (in the tutorials' units) and unbounded, on one thread and on
//       all; how many rays are answered unlike; both trees' build times; what more threads give; and whether both
//       find the same ambient occlusion, with the same rays and with rays of their own.
#pragma once

#include <filesystem>
#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include "chapters/frame/scene_argument.h"
#include "chapters/notebook/table.h"
#include "rasterizer/base/run.h"

namespace crevice {

// The peer program, beside our own.
std::filesystem::path ray_peer_program();

struct RayPeersOptions {
    std::vector<std::string> scenes = {"columns_luna"};
    CameraFlags camera;
    int rounds = 15;  // [kFewestPairs, kMostPairs] of peers.h
    Run run;
    std::optional<std::filesystem::path> out;  // the directory for tables, if any
    std::filesystem::path program = ray_peer_program();
    double patience_s = 300;  // for one answer of the peer
};

// What the peer answered, one line of JSON each, as tables: rays, ray_threads, ray_builds, ray_agreement. The
// last cell of each row of ray_agreement is "same" or "DIFFERENT". Throws InputError for lines that are no
// answers.
std::vector<Table> ray_tables(const std::string& scene, const std::vector<std::string>& lines);

// Prints and writes the tables, or only a note where the peer was not built. Returns 0, or 1 when the two
// sides do not find the same ambient occlusion. Throws UsageError, InputError (what the peer did wrong),
// OutputError.
int bench_ray_peers(const RayPeersOptions& options, std::ostream& out);

}  // namespace crevice
