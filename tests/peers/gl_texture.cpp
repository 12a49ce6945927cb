#include "tests/peers/gl_texture.h"

#include <algorithm>
#include <string>

#include "rasterizer/base/error.h"

namespace crevice {

namespace {

constexpr int kChannels = 4;

void require_complete(GLuint framebuffer, Size size) {
    if (glCheckNamedFramebufferStatus(framebuffer, GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE) return;
    throw InputError("OpenGL: cannot draw into a picture of " + std::to_string(size.width) + "x" +
                     std::to_string(size.height) + "; choose a smaller --size");
}

}  // namespace

GLuint gl_texture(GLenum format, Size size, GLint filter, GLint wrap) {
    GLuint name = 0;
    glCreateTextures(GL_TEXTURE_2D, 1, &name);
    glTextureStorage2D(name, 1, format, size.width, size.height);
    glTextureParameteri(name, GL_TEXTURE_MIN_FILTER, filter);
    glTextureParameteri(name, GL_TEXTURE_MAG_FILTER, filter);
    glTextureParameteri(name, GL_TEXTURE_WRAP_S, wrap);
    glTextureParameteri(name, GL_TEXTURE_WRAP_T, wrap);
    return name;
}

GLuint gl_texture(const PeerTexture& texture) {
    GLuint name = 0;
    glCreateTextures(GL_TEXTURE_2D, 1, &name);
    glTextureStorage2D(name, texture.levels, GL_RGBA32F, texture.width, texture.height);
    Size size{texture.width, texture.height};
    const float* texels = texture.texels.data();
    for (int level = 0; level < texture.levels; ++level) {
        const std::size_t count =
            static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height);
        glTextureSubImage2D(name, level, 0, 0, size.width, size.height, GL_RGBA, GL_FLOAT, texels);
        texels += kChannels * count;
        size = {std::max(1, size.width / 2), std::max(1, size.height / 2)};
    }
    glTextureParameteri(name, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    glTextureParameteri(name, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTextureParameteri(name, GL_TEXTURE_WRAP_S, texture.clamps_u != 0 ? GL_CLAMP_TO_EDGE : GL_REPEAT);
    glTextureParameteri(name, GL_TEXTURE_WRAP_T, texture.clamps_v != 0 ? GL_CLAMP_TO_EDGE : GL_REPEAT);
    return name;
}

GLuint gl_cube_map(int side, const std::vector<float>& rgb) {
    constexpr int kFaces = 6;
    GLuint name = 0;
    glCreateTextures(GL_TEXTURE_CUBE_MAP, 1, &name);
    glTextureStorage2D(name, 1, GL_RGBA32F, side, side);
    glTextureSubImage3D(name, 0, 0, 0, 0, side, side, kFaces, GL_RGB, GL_FLOAT, rgb.data());
    glTextureParameteri(name, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTextureParameteri(name, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glEnable(GL_TEXTURE_CUBE_MAP_SEAMLESS);
    return name;
}

void set_border(GLuint texture, const float* border) {
    glTextureParameteri(texture, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_BORDER);
    glTextureParameteri(texture, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_BORDER);
    glTextureParameterfv(texture, GL_TEXTURE_BORDER_COLOR, border);
}

GlTarget gl_target(GLenum format, Size size, GLint wrap, GLuint depth_texture) {
    GlTarget result{gl_texture(format, size, GL_LINEAR, wrap), 0, size};
    glCreateFramebuffers(1, &result.framebuffer);
    glNamedFramebufferTexture(result.framebuffer, GL_COLOR_ATTACHMENT0, result.texture, 0);
    if (depth_texture != 0)
        glNamedFramebufferTexture(result.framebuffer, GL_DEPTH_ATTACHMENT, depth_texture, 0);
    require_complete(result.framebuffer, size);
    return result;
}

GlTarget gl_depth_target(GLuint depth_texture, Size size) {
    GlTarget result{depth_texture, 0, size};
    glCreateFramebuffers(1, &result.framebuffer);
    glNamedFramebufferTexture(result.framebuffer, GL_DEPTH_ATTACHMENT, depth_texture, 0);
    glNamedFramebufferDrawBuffer(result.framebuffer, GL_NONE);
    require_complete(result.framebuffer, size);
    return result;
}

void draw_into(const GlTarget& where) {
    glBindFramebuffer(GL_FRAMEBUFFER, where.framebuffer);
    glViewport(0, 0, where.size.width, where.size.height);
}

void draw_picture() { glDrawArrays(GL_TRIANGLES, 0, 3); }

void append_pixels(std::vector<float>& values, const GlTarget& from, GLenum format, int components) {
    const std::size_t first = values.size();
    values.resize(first + static_cast<std::size_t>(from.size.width) *
                              static_cast<std::size_t>(from.size.height * components));
    glBindFramebuffer(GL_FRAMEBUFFER, from.framebuffer);
    glReadPixels(0, 0, from.size.width, from.size.height, format, GL_FLOAT, values.data() + first);
}

}  // namespace crevice
