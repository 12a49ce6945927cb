// Textures and render targets.
#pragma once

#include <cstdint>
#include <vector>

#include "chapters/bench/peer_stream.h"
#include "rasterizer/base/image.h"
#include "tests/peers/gl_functions.h"

namespace crevice {

// With one level.
GLuint gl_texture(GLenum format, Size size, GLint filter, GLint wrap);

// A material's, in floats, linear between texels and levels. README.md says why not the tutorials' 8 bits.
GLuint gl_texture(const PeerTexture& texture);

// Six faces, RGB in floats, seamless.
GLuint gl_cube_map(int side, const std::vector<float>& rgb);

// What is outside: `border`, 4 numbers.
void set_border(GLuint texture, const float* border);

// One render target with its texture.
struct GlTarget {
    GLuint texture = 0, framebuffer = 0;
    Size size;
};
// Throws InputError where it is too large.
GlTarget gl_target(GLenum format, Size size, GLint wrap, GLuint depth_texture = 0);
// One with depth alone.
GlTarget gl_depth_target(GLuint depth_texture, Size size);

void draw_into(const GlTarget& where);
// One triangle over all of it, with the program in use.
void draw_picture();

// Its pixels after what `values` already holds, row 0 first.
void append_pixels(std::vector<float>& values, const GlTarget& from, GLenum format, int components);

}  // namespace crevice
