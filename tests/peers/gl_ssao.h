// The tutorial's passes drawn by OpenGL: what `crevice bench --peers` measures ours against.
// Buffers are 32-bit floats like ours (bench_peers.h says why not the tutorial's 16-bit ones), the picture
// has 8 bits a channel.
#pragma once

#include <cstdint>
#include <vector>

#include "chapters/bench/peer_stream.h"
#include "chapters/terminal/stopwatch.h"
#include "tests/peers/gl_program.h"

namespace crevice {

// One render target with its texture.
struct GlTarget {
    std::uint32_t texture = 0, framebuffer = 0;
    Size size;
};

class GlSsao {
 public:
    // Uploads the scene and compiles the programs of its passes; a context must be current.
    explicit GlSsao(const PeerScene& scene);

    // One frame; after each of the four passes it waits until the pixels are there. The clock readings before
    // the first pass and after each: normal_depth, ao, blur, lit.
    std::array<Clocks, 5> draw_frame() const;

    // One more frame's buffers as floats, one after the other, row 0 at the top: normal and view depth (4 a
    // pixel), ndc depth (1), raw AO (1 an AO texel), blurred AO (1), lit (4).
    std::vector<float> buffers() const;

 private:
    void draw_normal_depth() const;
    void draw_ao() const;
    void blur() const;
    void draw_lit() const;
    void set_uniforms(const PeerScene& scene) const;

    PeerFrame frame_;
    std::vector<PeerDraw> draws_;
    int index_count_ = 0;
    GlProgram normal_depth_program_, ao_program_, blur_program_, lit_program_;
    GlTarget normal_depth_, ao_, blurring_, lit_;
    std::uint32_t random_map_ = 0;
};

}  // namespace crevice
