// Talking with the peer program, tests/peers/gl_ssao_peer.cpp.
#pragma once

#include <array>

#include "chapters/bench/peer_stream.h"
#include "chapters/terminal/child.h"
#include "rasterizer/base/image.h"

namespace crevice {

// The passes both sides have, and last the whole frame.
inline constexpr std::array<const char*, 5> kPeerPasses = {"normal_depth", "ao", "blur", "lit", "frame"};

struct PassClock {
    double wall_ms = 0, cpu_ms = 0;
};

struct PeerBuffers {
    Image3 normal;  // view space, unit; background (0, 0, -1)
    Image<float> view_depth, ndc_depth, ao_raw, ao_blurred;
    Image3 lit;
};

// The peer program, beside our own.
std::filesystem::path peer_program();

class PeerSession {
 public:
    // Starts the peer on so many threads. Throws InputError, as does every function: it tells which packages
    // to install when the program is not there, and what the peer did when it dies, hangs or answers
    // nonsense.
    PeerSession(const std::filesystem::path& program, int threads, double patience_s);

    // Gives it a scene; the answer is who draws it.
    std::string load(const PeerScene& scene);
    // Draws one frame; the times of kPeerPasses.
    std::array<PassClock, kPeerPasses.size()> frame();
    // The buffers of one more frame.
    PeerBuffers buffers();

 private:
    std::string program_;
    Child child_;
    Size picture_, ao_size_;
};

}  // namespace crevice
