// `crevice bench --peers`: our passes against the same passes on Mesa's llvmpipe, in one run.
// How:  the same triangles, matrices, parameters and random numbers on both sides, X_Jun's method (xjun)
//       with its 4 blur iterations at half resolution. Frames take turns (ours, peer, ours, peer ...), so
//       that what else the machine does meets both; the first pair is thrown away.
// Says: medians, and the median of the paired ratios with its order-statistic interval. Ours against ours
//       (consecutive frames of the same run) is the noise floor: a ratio inside its interval means nothing.
// Formats: 32-bit floats on both sides. The tutorial's 16-bit ones were measured too: they slow llvmpipe down
//       (frame 101 ms against 96) and hide a wrong radius behind their rounding.
// Differs on the peer's side, both less work than ours: the picture has 8 bits a channel, and a texel of the
//       AO map takes the plain mean of its four pixels where ours tells surfaces apart.
#pragma once

#include <filesystem>
#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include "chapters/bench/peer_session.h"
#include "chapters/frame/scene_argument.h"
#include "rasterizer/base/run.h"

namespace crevice {

inline constexpr int kFewestPairs = 15, kMostPairs = 999;
// In smaller pictures a corner's snapping to 1/256 pixel turns normals and depths by more than two programs
// may differ.
inline constexpr Size kSmallestCompared{320, 180};

struct PeersOptions {
    std::vector<std::string> scenes = {"columns", "columns_luna"};
    CameraFlags camera;
    Size size{1280, 720};
    int pairs = 21;
    Run run;
    std::optional<std::filesystem::path> out;  // the directory for tables and buffers, if any
    std::filesystem::path program = peer_program();
    double patience_s = 120;  // for one answer of the peer
};

// Prints and writes the tables, and the peer's buffers as OUT/SCENE_peer/NAME.npy. Returns 0, or 1 when the two
// sides did not draw the same picture. Throws UsageError, InputError (no peer, or what it did wrong), OutputError.
int bench_peers(const PeersOptions& options, std::ostream& out);

// Throws UsageError for options out of range, as bench_peers() does.
void validate(const PeersOptions& options);

}  // namespace crevice
