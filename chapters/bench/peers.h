// `crevice bench --peers`: our passes against the same passes on Mesa's llvmpipe, in one run.
// What: the tutorials' scenes in plain colours, X_Jun's method with its 4 blur iterations at half resolution; the
//       tutorials' whole demos (--preset), with textures, shadow, reflections and sky; and other methods' AO (--ao).
// How:  the same triangles, textures, matrices, parameters and random numbers on both sides. Frames take turns in random
//       order, ours twice, so that what else the machine does meets all; the first round is thrown away.
// Says: medians, and the median of the paired ratios with its order-statistic interval. Ours against ours again is the
//       noise: a ratio inside its interval means nothing. cpu_ratio is that of the medians of processor time, which other
//       programs disturb less.
// What differs between the sides, and for whom it is less work: tests/peers/README.md.
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

// What both sides draw.
struct PeerSubject {
    enum class Draws { plain, whole, ao };

    std::string scene;            // as on the command line
    std::string method = "xjun";  // AO by its defaults
    Draws draws = Draws::plain;   // plain: in plain colours; whole: with all surfaces; ao: up to the blur
    std::vector<std::string> params = {};  // name=value, of the method
    std::string name = {};                 // in tables
};
PeerSubject plain_subject(const std::string& scene);
// Throws UsageError as find_preset() does.
PeerSubject preset_subject(const std::string& preset);
PeerSubject ao_subject(const std::string& scene, const std::string& method);
// Both scenes plain, both whole demos, and every other method that the peer knows.
std::vector<PeerSubject> all_peer_subjects();

struct PeersOptions {
    std::vector<PeerSubject> subjects = all_peer_subjects();
    CameraFlags camera;
    Size size{1280, 720};
    int pairs = 21;  // rounds
    Run run;
    std::optional<std::filesystem::path> out;  // the directory for tables and buffers, if any
    std::filesystem::path program = peer_program();
    double patience_s = 120;  // for one answer of the peer
};

// Prints and writes the tables, and the peer's buffers as OUT/NAME_peer/BUFFER.npy, its lit picture as .png, too.
// Returns 0, or 1 when the two sides did not draw the same picture. Throws UsageError, InputError (no peer, or what it
// did wrong), OutputError.
int bench_peers(const PeersOptions& options, std::ostream& out);

// Throws UsageError for options out of range, as bench_peers() does.
void validate(const PeersOptions& options);

}  // namespace crevice
