// What leaving out saves, kind by kind, and that it costs nothing where there is nothing to leave out.
#pragma once

#include <iosfwd>

#include "chapters/bench/frames.h"

namespace crevice {

// With nothing to leave out (noise_wall), a frame may take this much longer than with all work kept.
inline constexpr double kMostOverhead = 1.02;

// One table: for each scene and kind of work what was left out of how many, the ms that saves (median of pairs
// of frames in turns, with interval), and the ratio of the frame times with all left out and with all kept.
// Returns 1 when that ratio is above kMostOverhead for a scene of which no tile and no visible triangle was
// left out, else 0. Throws UsageError, InputError, OutputError.
int bench_left_out(const FramesOptions& options, std::ostream& out);

}  // namespace crevice
