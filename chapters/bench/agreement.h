// Whether ours and the peer's pictures are the same picture: only then do their times compare.
//
// The peer takes the plain mean of an AO texel's four pixels, as the tutorials do. What is compared with it
// tightly is therefore our AO with that fetch, blurred and lit; ours as it was timed resolves texels that
// show several surfaces, and is compared loosely.
#pragma once

#include <optional>
#include <vector>

#include "chapters/bench/peer_session.h"
#include "chapters/frame/frame.h"

namespace crevice {

struct Agreement {
    const char* buffer;
    const char* measure;  // and its unit
    double value;
    std::optional<double> limit;  // none: told, not judged

    bool holds() const { return !limit || value <= *limit; }  // NaN does not
};

// All measures, in the order of the passes. `ours` is the frame drawn of `scene` as `request` says. Throws UsageError for
// methods that peer_scene() refuses.
std::vector<Agreement> agreement(const Scene& scene, const FrameRequest& request, const Frame& ours,
                                 const PeerBuffers& theirs);

}  // namespace crevice
