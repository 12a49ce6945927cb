// The AO pass and its blur.
#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "tests/peers/gl_program.h"
#include "tests/peers/gl_texture.h"

namespace crevice {

// What an AO pass reads of the first pass.
struct GlGBuffer {
    GLuint normal_depth = 0, ndc_depth = 0;
};

// Between `estimate` and `blur` map() holds the raw AO, after that the blurred one.
class GlAo {
 public:
    virtual ~GlAo() = default;
    virtual void estimate() const = 0;
    virtual void blur() const = 0;
    const GlTarget& map() const { return map_; }

 protected:
    GlAo(const PeerFrame& frame, GLenum map_format);

    mutable GlTarget map_, between_;  // a blur may end in either: they change places
};

// X_Jun's and Luna's; and that of any method.
std::unique_ptr<GlAo> gl_tutorial_ao(const PeerScene& scene, const GlGBuffer& gbuffer);
std::unique_ptr<GlAo> gl_method_ao(const PeerScene& scene, const GlGBuffer& gbuffer);

// What stands before the text of every program of a scene, and before those of its AO; and the numbers that these know.
std::string gl_prefix(const PeerFrame& frame);
std::string gl_ao_prefix(const PeerScene& scene);
float number_of(const PeerScene& scene, std::string_view name);
void set_ao_numbers(const GlProgram& program, const PeerScene& scene);

}  // namespace crevice
