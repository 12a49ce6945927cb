// Talking with the peer program, tests/peers/gl_ssao_peer.cpp.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "chapters/bench/peer_stream.h"
#include "chapters/terminal/child.h"
#include "rasterizer/base/image.h"

namespace crevice {

struct PassClock {
    double wall_ms = 0, cpu_ms = 0;
};

struct PeerBuffers {
    Image3 normal;  // view space, unit; background (0, 0, -1)
    Image<float> view_depth, ndc_depth, ao_raw, ao_blurred;
    Image<float> shadow;   // ndc depth of the light; empty: the scene has none
    Image3 lit;            // linear light, as it is timed: 8 bits a channel; empty: not drawn
    Image3 lit_trilinear;  // the same in floats, with trilinear filters in the place of anisotropic ones
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
    // Draws one frame; the times of passes().
    std::vector<PassClock> frame();
    // peer_passes() of the scene.
    std::vector<std::string> passes() const { return peer_passes(frame_); }
    // The buffers of one more frame.
    PeerBuffers buffers();

 private:
    std::string program_;
    Child child_;
    PeerFrame frame_;
};

}  // namespace crevice
