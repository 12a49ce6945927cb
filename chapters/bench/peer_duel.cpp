#include "chapters/bench/peer_duel.h"

#include <algorithm>

#include "chapters/bench/peer_scene.h"
#include "chapters/study/turns.h"
#include "chapters/terminal/progress.h"
#include "rasterizer/base/error.h"
#include "rasterizer/base/image_summary.h"

namespace crevice {

namespace {

std::vector<PassClock> times_of(const Frame& frame, const std::vector<std::string>& passes,
                                const std::string& subject) {
    std::vector<PassClock> times;
    for (const std::string& name : passes) {
        const auto pass = std::find_if(frame.passes.begin(), frame.passes.end(),
                                       [&](const PassTime& time) { return time.name == name; });
        if (pass == frame.passes.end()) {
            throw UsageError(subject + ": we have nothing to do in one pass (" + name +
                             "); compare with a scene that needs all of them");
        }
        times.push_back({pass->wall_ms, pass->cpu_ms});
    }
    return times;
}

FrameRequest request_of(const PeerSubject& subject, const SceneArgument& argument,
                        const PeersOptions& options) {
    FrameRequest request;
    request.size = options.size;
    request.method = &find_method(subject.method);
    request.settings = settings_for(argument, subject.scene, *request.method, subject.params);
    if (subject.draws == PeerSubject::Draws::ao) request.wanted.erase("lit");
    request.run = options.run;
    return request;
}

std::string hash_of_last(const Frame& frame) {
    return frame.lit.empty() ? content_hash(frame.ao_blurred) : content_hash(frame.lit);
}

}  // namespace

PeerDuel peer_duel(const PeerSubject& subject, const SceneArgument& argument, const PeersOptions& options) {
    const FrameRequest request = request_of(subject, argument, options);
    const Camera camera = chosen_camera(argument, options.camera);
    const PeerScene scene = peer_scene(argument.scene, camera, request);
    PeerSession peer(options.program, thread_count(options.run), options.patience_s);
    Progress progress(subject.name, options.pairs + 1);
    const std::string renderer = peer.load(scene);
    const std::vector<std::string> passes = peer.passes();
    PeerDuel duel{DuelSide(passes), DuelSide(passes), DuelSide(passes), renderer, {}, {}, {}, {}};
    Frame frame;
    const auto draw_ours = [&](DuelSide& side, bool counts) {
        frame = render_frame(argument.scene, camera, request);
        const std::vector<PassClock> times = times_of(frame, passes, subject.name);
        if (duel.first_hash.empty()) duel.first_hash = hash_of_last(frame);
        if (counts) side.add(times);
    };
    for (int round = -1; round < options.pairs; ++round) {
        const bool counts = round >= 0;
        constexpr std::uint32_t kSeed = 1;
        for (const std::size_t turn : turn_order(3, round, kSeed)) {
            if (turn == 0) draw_ours(duel.ours, counts);
            if (turn == 1) draw_ours(duel.again, counts);
            if (turn != 2) continue;
            const std::vector<PassClock> times = peer.frame();
            if (counts) duel.theirs.add(times);
        }
        progress.advance();
    }
    duel.last_hash = hash_of_last(frame);
    duel.their_buffers = peer.buffers();
    duel.agreement = agreement(argument.scene, request, frame, duel.their_buffers);
    return duel;
}

}  // namespace crevice
