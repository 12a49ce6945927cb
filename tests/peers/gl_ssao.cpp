#include "tests/peers/gl_ssao.h"

#include <algorithm>
#include <cstddef>
#include <limits>

#include "rasterizer/base/error.h"
#include "tests/peers/gl_functions.h"
#include "tests/peers/gl_shaders.h"

namespace crevice {

namespace {

constexpr GLenum kNormalDepthFormat = GL_RGBA32F, kAoFormat = GL_R32F, kPictureFormat = GL_RGBA8;

std::string prefix_for(const PeerFrame& frame) {
    const auto define = [](const char* name, int value) {
        return std::string("#define ") + name + " " + std::to_string(value) + "\n";
    };
    return "#version 450\n" + define("PERSPECTIVE", frame.perspective) + define("PHONG", frame.phong) +
           define("SAMPLES", frame.samples) + define("LIGHTS", std::max(1, frame.light_count));
}

GLuint texture(GLenum format, Size size, GLint filter, GLint wrap) {
    GLuint name = 0;
    glCreateTextures(GL_TEXTURE_2D, 1, &name);
    glTextureStorage2D(name, 1, format, size.width, size.height);
    glTextureParameteri(name, GL_TEXTURE_MIN_FILTER, filter);
    glTextureParameteri(name, GL_TEXTURE_MAG_FILTER, filter);
    glTextureParameteri(name, GL_TEXTURE_WRAP_S, wrap);
    glTextureParameteri(name, GL_TEXTURE_WRAP_T, wrap);
    return name;
}

GlTarget target(GLenum format, Size size, GLint wrap, GLuint depth_texture = 0) {
    GlTarget result{texture(format, size, GL_LINEAR, wrap), 0, size};
    glCreateFramebuffers(1, &result.framebuffer);
    glNamedFramebufferTexture(result.framebuffer, GL_COLOR_ATTACHMENT0, result.texture, 0);
    if (depth_texture != 0)
        glNamedFramebufferTexture(result.framebuffer, GL_DEPTH_ATTACHMENT, depth_texture, 0);
    if (glCheckNamedFramebufferStatus(result.framebuffer, GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
        throw InputError("OpenGL: cannot draw into a picture of " + std::to_string(size.width) + "x" +
                         std::to_string(size.height) + "; choose a smaller --size");
    }
    return result;
}

void draw_into(const GlTarget& where) {
    glBindFramebuffer(GL_FRAMEBUFFER, where.framebuffer);
    glViewport(0, 0, where.size.width, where.size.height);
}

// Vertices and indices stay bound for all frames.
void upload(const PeerScene& scene) {
    GLuint arrays = 0, buffers[2];
    glGenVertexArrays(1, &arrays);
    glBindVertexArray(arrays);
    glGenBuffers(2, buffers);
    glBindBuffer(GL_ARRAY_BUFFER, buffers[0]);
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(scene.vertices.size() * sizeof(PeerVertex)),
                 scene.vertices.data(), GL_STATIC_DRAW);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffers[1]);
    glBufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(scene.indices.size() * sizeof(GLuint)),
                 scene.indices.data(), GL_STATIC_DRAW);
    const std::size_t offsets[2] = {offsetof(PeerVertex, p_world), offsetof(PeerVertex, n_world)};
    for (GLuint i = 0; i < 2; ++i) {
        glVertexAttribPointer(i, 3, GL_FLOAT, GL_FALSE, sizeof(PeerVertex),
                              reinterpret_cast<const void*>(offsets[i]));
        glEnableVertexAttribArray(i);
    }
}

void append_pixels(std::vector<float>& values, const GlTarget& from, GLenum format, int components) {
    const std::size_t first = values.size();
    values.resize(first + static_cast<std::size_t>(from.size.width) *
                              static_cast<std::size_t>(from.size.height * components));
    glBindFramebuffer(GL_FRAMEBUFFER, from.framebuffer);
    glReadPixels(0, 0, from.size.width, from.size.height, format, GL_FLOAT, values.data() + first);
}

}  // namespace

GlSsao::GlSsao(const PeerScene& scene)
    : frame_(scene.frame),
      draws_(scene.draws),
      index_count_(static_cast<int>(scene.indices.size())),
      normal_depth_program_(prefix_for(frame_), kGeometryVertices,
                            std::string(kUnitNormal) + kNormalDepthPixels),
      ao_program_(prefix_for(frame_), kPictureVertices, kOcclusionPixels),
      blur_program_(prefix_for(frame_), kPictureVertices, kBlurPixels),
      lit_program_(prefix_for(frame_), kGeometryVertices, std::string(kUnitNormal) + kLitPixels) {
    const Size picture{frame_.width, frame_.height}, ao_size{frame_.ao_width, frame_.ao_height};
    const GLuint depth = texture(GL_DEPTH_COMPONENT32F, picture, GL_NEAREST, GL_CLAMP_TO_EDGE);
    normal_depth_ = target(kNormalDepthFormat, picture, GL_CLAMP_TO_BORDER, depth);
    const float border[4] = {0, 0, -1, frame_.background_depth};
    glTextureParameterfv(normal_depth_.texture, GL_TEXTURE_BORDER_COLOR, border);
    ao_ = target(kAoFormat, ao_size, GL_CLAMP_TO_EDGE);
    blurring_ = target(kAoFormat, ao_size, GL_CLAMP_TO_EDGE);
    lit_ = target(kPictureFormat, picture, GL_CLAMP_TO_EDGE, depth);
    const Size map{kRandomMapSide, kRandomMapSide};
    random_map_ = texture(GL_RGBA8, map, GL_LINEAR, GL_REPEAT);
    glTextureSubImage2D(random_map_, 0, 0, 0, map.width, map.height, GL_RGBA, GL_UNSIGNED_BYTE,
                        scene.random_map.data());
    upload(scene);
    set_uniforms(scene);

    // Depth in [0,1]. Clockwise is in front; upside down that is counter-clockwise.
    glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
    glFrontFace(GL_CCW);
    glDisable(GL_DITHER);
}

void GlSsao::set_uniforms(const PeerScene& scene) const {
    for (const GlProgram* program : {&normal_depth_program_, &lit_program_}) {
        program->set("eye_world", frame_.eye_world);
        program->set("clip_from_relative", frame_.clip_from_relative);
        program->set("view_from_relative", frame_.view_from_relative);
    }
    const float range = frame_.fade_end - frame_.fade_start;
    const std::pair<const char*, float> of_ao[] = {{"near_plane", frame_.near_plane},
                                                   {"background_depth", frame_.background_depth},
                                                   {"radius", frame_.radius},
                                                   {"fade_end", frame_.fade_end},
                                                   {"inverse_fade", range > 0 ? 1 / range : 3e38f},
                                                   {"epsilon", frame_.epsilon},
                                                   {"exponent", frame_.exponent}};
    for (const auto& [name, value] : of_ao) ao_program_.set(name, value);
    ao_program_.set("ray_scale", frame_.ray_scale);
    ao_program_.set("offsets", std::span(frame_.offsets).first(static_cast<std::size_t>(frame_.samples)));
    blur_program_.set("weights", std::span<const float>(frame_.blur_weights));
    blur_program_.set("normal_threshold", frame_.blur_normal);
    blur_program_.set("depth_threshold", frame_.blur_depth);

    lit_program_.set("picture_size", glm::vec2(frame_.width, frame_.height));
    lit_program_.set("ambient_light", frame_.ambient_light);
    const auto set_lights = [&](const char* name, glm::vec3 PeerLight::*member) {
        std::vector<glm::vec3> values;
        for (const PeerLight& light : scene.frame.lights) values.push_back(light.*member);
        const auto count = static_cast<std::size_t>(std::max(1, frame_.light_count));
        lit_program_.set(name, std::span<const glm::vec3>(values).first(count));
    };
    set_lights("light_direction", &PeerLight::direction_view);
    set_lights("light_ambient", &PeerLight::ambient);
    set_lights("light_diffuse", &PeerLight::diffuse);
    set_lights("light_specular", &PeerLight::specular);
}

void GlSsao::draw_normal_depth() const {
    draw_into(normal_depth_);
    glEnable(GL_DEPTH_TEST);
    glDepthMask(GL_TRUE);
    glDepthFunc(GL_LESS);
    if (frame_.two_sided == 0) glEnable(GL_CULL_FACE);
    const float nothing[4] = {0, 0, -1, frame_.background_depth}, farthest = 1;
    glClearBufferfv(GL_COLOR, 0, nothing);
    glClearBufferfv(GL_DEPTH, 0, &farthest);
    normal_depth_program_.use();
    glDrawElements(GL_TRIANGLES, index_count_, GL_UNSIGNED_INT, nullptr);
}

void GlSsao::draw_ao() const {
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_CULL_FACE);
    draw_into(ao_);
    ao_program_.use();
    glBindTextureUnit(0, normal_depth_.texture);
    glBindTextureUnit(1, random_map_);
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

void GlSsao::blur() const {
    blur_program_.use();
    const auto pass = [&](const GlTarget& from, const GlTarget& to, glm::vec2 step_uv) {
        draw_into(to);
        glBindTextureUnit(1, from.texture);
        blur_program_.set("step_uv", step_uv);
        glDrawArrays(GL_TRIANGLES, 0, 3);
    };
    for (int i = 0; i < frame_.blur_iterations; ++i) {
        pass(ao_, blurring_, {1.0f / static_cast<float>(ao_.size.width), 0});
        pass(blurring_, ao_, {0, 1.0f / static_cast<float>(ao_.size.height)});
    }
}

void GlSsao::draw_lit() const {
    draw_into(lit_);
    glEnable(GL_DEPTH_TEST);
    glDepthMask(GL_FALSE);
    glDepthFunc(GL_EQUAL);
    if (frame_.two_sided == 0) glEnable(GL_CULL_FACE);
    const float sky[4] = {frame_.sky.x, frame_.sky.y, frame_.sky.z, 1};
    glClearBufferfv(GL_COLOR, 0, sky);
    lit_program_.use();
    glBindTextureUnit(0, ao_.texture);
    for (const PeerDraw& draw : draws_) {
        lit_program_.set("diffuse", draw.diffuse);
        lit_program_.set("ambient", draw.ambient);
        lit_program_.set("specular", draw.specular);
        lit_program_.set("shininess", draw.shininess);
        const std::size_t offset = draw.first_index * sizeof(GLuint);
        glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(draw.index_count), GL_UNSIGNED_INT,
                       reinterpret_cast<const void*>(offset));
    }
}

std::array<Clocks, 5> GlSsao::draw_frame() const {
    std::array<Clocks, 5> at;
    const auto finished = [] {
        glFinish();
        return clocks();
    };
    at[0] = finished();
    draw_normal_depth();
    at[1] = finished();
    draw_ao();
    at[2] = finished();
    blur();
    at[3] = finished();
    draw_lit();
    at[4] = finished();
    return at;
}

std::vector<float> GlSsao::buffers() const {
    std::vector<float> values;
    draw_normal_depth();
    append_pixels(values, normal_depth_, GL_RGBA, 4);
    append_pixels(values, normal_depth_, GL_DEPTH_COMPONENT, 1);
    draw_ao();
    append_pixels(values, ao_, GL_RED, 1);
    blur();
    append_pixels(values, ao_, GL_RED, 1);
    draw_lit();
    append_pixels(values, lit_, GL_RGBA, 4);
    return values;
}

}  // namespace crevice
