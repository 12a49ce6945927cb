// The frames of one subject, ours and the peer's in turns: what peers.h tells of.
#pragma once

#include <string>
#include <vector>

#include "chapters/bench/agreement.h"
#include "chapters/bench/peers.h"
#include "chapters/terminal/stopwatch.h"

namespace crevice {

// The times of all frames of one side, pass by pass.
struct DuelSide {
    std::vector<PassSamples> passes;

    explicit DuelSide(const std::vector<std::string>& names) {
        for (const std::string& name : names) passes.push_back({name, {}, {}});
    }
    void add(const std::vector<PassClock>& frame) {
        for (std::size_t i = 0; i < passes.size(); ++i) {
            passes[i].wall_ms.push_back(frame[i].wall_ms);
            passes[i].cpu_ms.push_back(frame[i].cpu_ms);
        }
    }
};

struct PeerDuel {
    DuelSide ours, again, theirs;                 // `again`: ours as if it were another
    std::string renderer, first_hash, last_hash;  // hashes of our last image
    std::vector<Agreement> agreement;
    PeerBuffers their_buffers;
};

// Throws InputError as PeerSession does, UsageError where one side has a pass that the other has not.
PeerDuel peer_duel(const PeerSubject& subject, const SceneArgument& argument, const PeersOptions& options);

}  // namespace crevice
