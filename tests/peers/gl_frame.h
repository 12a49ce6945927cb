// The tutorials' passes drawn by OpenGL: what `crevice bench --peers` measures ours against.
// Buffers are 32-bit floats like ours (README.md says why not the tutorials' 16-bit ones), the picture that is timed has
// 8 bits a channel.
#pragma once

#include <optional>
#include <vector>

#include "chapters/terminal/stopwatch.h"
#include "tests/peers/gl_ao.h"
#include "tests/peers/gl_geometry_pass.h"

namespace crevice {

class GlFrame {
 public:
    // Uploads the scene and compiles the programs of its passes; a context must be current.
    explicit GlFrame(const PeerScene& scene);

    // One frame; after each pass it waits until the pixels are there. The clock readings before the first pass and
    // after each of peer_passes() but "frame".
    std::vector<Clocks> draw() const;

    // One more frame's buffers as floats, one after the other, row 0 at the top: normal and view depth (4 a
    // pixel), ndc depth (1), raw AO (1 an AO texel), blurred AO (1); if there is one, the shadow map (1 a texel); if there
    // is one, the lit picture as it is timed (4), and in 32-bit floats with trilinear filters (4).
    std::vector<float> buffers() const;

 private:
    void draw_normal_depth() const;
    void draw_shadow() const;
    void draw_lit(const GlTarget& picture) const;
    void draw_sky(const GlTarget& picture) const;
    void make_shadow();
    void make_lit();

    PeerFrame frame_;
    GlGeometry geometry_;
    GLuint depth_ = 0, shadow_depth_ = 0, sky_cube_ = 0;
    GlTarget normal_depth_, shadow_, lit_, lit_floats_;
    GlGeometryPass normal_depth_pass_;
    std::unique_ptr<GlAo> ao_;
    std::optional<GlGeometryPass> shadow_pass_, lit_pass_;
    std::optional<GlProgram> sky_program_;
};

}  // namespace crevice
