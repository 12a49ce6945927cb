#include "tests/peers/gl_frame.h"

#include <algorithm>

#include <glm/matrix.hpp>

#include "tests/peers/gl_geometry_shaders.h"
#include "tests/peers/gl_lit_shaders.h"

namespace crevice {

namespace {

constexpr GLenum kNormalDepthFormat = GL_RGBA32F, kPictureFormat = GL_RGBA8, kFloatPictureFormat = GL_RGBA32F;
constexpr float kFarthest = 1;

void cull_back_faces(bool culled) {
    if (culled) {
        glEnable(GL_CULL_FACE);
    } else {
        glDisable(GL_CULL_FACE);
    }
}

void start_depth_pass(bool culled) {
    glEnable(GL_DEPTH_TEST);
    glDepthMask(GL_TRUE);
    glDepthFunc(GL_LESS);
    cull_back_faces(culled);
    glClearBufferfv(GL_DEPTH, 0, &kFarthest);
}

}  // namespace

GlFrame::GlFrame(const PeerScene& scene)
    : frame_(scene.frame),
      geometry_(scene),
      depth_(gl_texture(GL_DEPTH_COMPONENT32F, {frame_.width, frame_.height}, GL_LINEAR, GL_CLAMP_TO_EDGE)),
      normal_depth_(gl_target(kNormalDepthFormat, {frame_.width, frame_.height}, GL_CLAMP_TO_EDGE, depth_)),
      normal_depth_pass_(gl_prefix(frame_), geometry_, kNormalDepthPixels, GlReads::holes),
      ao_(gl_method_ao(scene, {normal_depth_.texture, depth_})) {
    const float far_depth[4] = {kFarthest, 0, 0, 0}, nothing[4] = {0, 0, -1, frame_.background_depth};
    set_border(depth_, far_depth);
    set_border(normal_depth_.texture, nothing);
    set_view(normal_depth_pass_, frame_.eye_world, frame_.clip_from_relative, frame_.view_from_relative);
    if (frame_.sky_side > 0) sky_cube_ = gl_cube_map(frame_.sky_side, scene.sky);
    if (frame_.shadow.side > 0) make_shadow();
    if (frame_.lit != 0) make_lit();

    // Depth in [0,1]. Clockwise is in front; upside down that is counter-clockwise.
    glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
    glFrontFace(GL_CCW);
    glDisable(GL_DITHER);
}

void GlFrame::make_shadow() {
    const PeerShadow& shadow = frame_.shadow;
    const Size size{shadow.side, shadow.side};
    shadow_depth_ = gl_texture(GL_DEPTH_COMPONENT24, size, GL_LINEAR, GL_CLAMP_TO_BORDER);
    const float border[4] = {shadow.border_is_lit != 0 ? 1.0f : 0.0f, 0, 0, 0};
    set_border(shadow_depth_, border);
    glTextureParameteri(shadow_depth_, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
    glTextureParameteri(shadow_depth_, GL_TEXTURE_COMPARE_FUNC, shadow.less != 0 ? GL_LESS : GL_LEQUAL);
    shadow_ = gl_depth_target(shadow_depth_, size);
    shadow_pass_.emplace(gl_prefix(frame_), geometry_, kShadowPixels, GlReads::holes);
    set_view(*shadow_pass_, shadow.eye_world, shadow.clip_from_relative, glm::mat4(1));
}

void GlFrame::make_lit() {
    lit_ = gl_target(kPictureFormat, normal_depth_.size, GL_CLAMP_TO_EDGE, depth_);
    lit_floats_ = gl_target(kFloatPictureFormat, normal_depth_.size, GL_CLAMP_TO_EDGE, depth_);
    lit_pass_.emplace(gl_prefix(frame_), geometry_,
                      std::string(kShadowFactor) + kSurfaceTextures + kLitPixels, GlReads::colours);
    const GlGeometryPass& lit = *lit_pass_;
    set_view(lit, frame_.eye_world, frame_.clip_from_relative, frame_.view_from_relative);
    lit.set("picture_size", glm::vec2(frame_.width, frame_.height));
    lit.set("ambient_light", frame_.ambient_light);
    const auto set_lights = [&](const char* name, glm::vec3 PeerLight::*member) {
        std::vector<glm::vec3> values;
        for (const PeerLight& light : frame_.lights) values.push_back(light.*member);
        const auto count = static_cast<std::size_t>(std::max(1, frame_.light_count));
        lit.set(name, std::span<const glm::vec3>(values).first(count));
    };
    set_lights("light_direction", &PeerLight::direction_view);
    set_lights("light_ambient", &PeerLight::ambient);
    set_lights("light_diffuse", &PeerLight::diffuse);
    set_lights("light_specular", &PeerLight::specular);
    const PeerShadow& shadow = frame_.shadow;
    lit.set("shadow_u", shadow.u);
    lit.set("shadow_v", shadow.v);
    lit.set("shadow_depth", shadow.depth);
    lit.set("shadow_bias", shadow.shader_bias);
    lit.set("shadow_texel", 1 / static_cast<float>(std::max(1, shadow.side)));
    const glm::mat4 world_from_view = glm::transpose(frame_.view_from_relative);
    lit.set("world_from_view", world_from_view);
    if (frame_.sky_side == 0) return;
    sky_program_.emplace(gl_prefix(frame_), kSkyVertices, kSkyPixels);
    sky_program_->set("world_from_view", world_from_view);
    sky_program_->set("ray_scale", frame_.ray_scale);
}

void GlFrame::draw_normal_depth() const {
    draw_into(normal_depth_);
    const float nothing[4] = {0, 0, -1, frame_.background_depth};
    glClearBufferfv(GL_COLOR, 0, nothing);
    start_depth_pass(frame_.two_sided == 0);
    normal_depth_pass_.draw();
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_CULL_FACE);
}

void GlFrame::draw_shadow() const {
    const PeerShadow& shadow = frame_.shadow;
    draw_into(shadow_);
    start_depth_pass(shadow.keeps_back_faces == 0);
    glEnable(GL_POLYGON_OFFSET_FILL);
    // llvmpipe counts a unit as two steps of the buffer, Direct3D as one.
    constexpr float kUnitsPerStep = 0.5f;
    glPolygonOffset(shadow.bias_slope, kUnitsPerStep * shadow.bias_constant);
    shadow_pass_->draw();
    glDisable(GL_POLYGON_OFFSET_FILL);
}

void GlFrame::draw_lit(const GlTarget& picture) const {
    draw_into(picture);
    glEnable(GL_DEPTH_TEST);
    glDepthMask(GL_FALSE);
    glDepthFunc(GL_EQUAL);
    cull_back_faces(frame_.two_sided == 0);
    const float sky[4] = {frame_.sky.x, frame_.sky.y, frame_.sky.z, 1};
    glClearBufferfv(GL_COLOR, 0, sky);
    glBindTextureUnit(0, ao_->map().texture);
    glBindTextureUnit(3, shadow_depth_);
    glBindTextureUnit(4, sky_cube_);
    lit_pass_->draw();
}

void GlFrame::draw_sky(const GlTarget& picture) const {
    draw_into(picture);
    glDisable(GL_CULL_FACE);
    glDepthFunc(GL_LEQUAL);
    sky_program_->use();
    glBindTextureUnit(4, sky_cube_);
    draw_picture();
}

std::vector<Clocks> GlFrame::draw() const {
    std::vector<Clocks> at;
    const auto finish = [&] {
        glFinish();
        at.push_back(clocks());
    };
    finish();
    draw_normal_depth();
    finish();
    ao_->estimate();
    finish();
    ao_->blur();
    finish();
    if (shadow_pass_) draw_shadow(), finish();
    if (lit_pass_) draw_lit(lit_), finish();
    if (sky_program_) draw_sky(lit_), finish();
    return at;
}

std::vector<float> GlFrame::buffers() const {
    std::vector<float> values;
    draw_normal_depth();
    append_pixels(values, normal_depth_, GL_RGBA, 4);
    append_pixels(values, normal_depth_, GL_DEPTH_COMPONENT, 1);
    ao_->estimate();
    append_pixels(values, ao_->map(), GL_RED, 1);
    ao_->blur();
    append_pixels(values, ao_->map(), GL_RED, 1);
    if (shadow_pass_) draw_shadow(), append_pixels(values, shadow_, GL_DEPTH_COMPONENT, 1);
    if (!lit_pass_) return values;
    const auto append_lit = [&](const GlTarget& picture) {
        draw_lit(picture);
        if (sky_program_) draw_sky(picture);
        append_pixels(values, picture, GL_RGBA, 4);
    };
    append_lit(lit_);
    geometry_.set_anisotropic(false);
    append_lit(lit_floats_);
    geometry_.set_anisotropic(true);
    return values;
}

}  // namespace crevice
