#include "tests/peers/gl_ao.h"

#include <algorithm>

#include "rasterizer/base/error.h"
#include "ssao/inputs/random_vectors.h"
#include "tests/peers/gl_ao_shaders.h"

namespace crevice {

namespace {

std::string define(const char* name, int value) {
    return std::string("#define ") + name + " " + std::to_string(value) + "\n";
}

// X_Jun's and Luna's: one estimator, and a blur along rows and columns.
class GlTutorialAo final : public GlAo {
 public:
    GlTutorialAo(const PeerScene& scene, const GlGBuffer& gbuffer)
        : GlAo(scene.frame, GL_R32F),
          gbuffer_(gbuffer),
          iterations_(scene.frame.blur_iterations),
          estimator_(gl_ao_prefix(scene), kPictureVertices, std::string(kGBuffer) + kLunaPixels),
          blur_(gl_ao_prefix(scene), kPictureVertices, std::string(kGBuffer) + kBilateralPixels),
          random_map_(gl_texture(GL_RGBA8, {kRandomMapSide, kRandomMapSide}, GL_LINEAR, GL_REPEAT)) {
        glTextureSubImage2D(random_map_, 0, 0, 0, kRandomMapSide, kRandomMapSide, GL_RGBA, GL_UNSIGNED_BYTE,
                            scene.random_map.data());
        for (const GlProgram* program : {&estimator_, &blur_}) set_ao_numbers(*program, scene);
    }

    void estimate() const override {
        draw_into(map_);
        estimator_.use();
        bind_gbuffer();
        glBindTextureUnit(1, random_map_);
        draw_picture();
    }

    void blur() const override {
        blur_.use();
        bind_gbuffer();
        const Size size = map_.size;
        for (int i = 0; i < iterations_; ++i) {
            blur_along({1.0f / static_cast<float>(size.width), 0}, map_, between_);
            blur_along({0, 1.0f / static_cast<float>(size.height)}, between_, map_);
        }
    }

 private:
    void bind_gbuffer() const {
        glBindTextureUnit(0, gbuffer_.normal_depth);
        glBindTextureUnit(2, gbuffer_.ndc_depth);
    }
    void blur_along(glm::vec2 step_uv, const GlTarget& from, const GlTarget& to) const {
        draw_into(to);
        glBindTextureUnit(1, from.texture);
        blur_.set("step_uv", step_uv);
        draw_picture();
    }

    GlGBuffer gbuffer_;
    int iterations_;
    GlProgram estimator_, blur_;
    GLuint random_map_;
};

}  // namespace

GlAo::GlAo(const PeerFrame& frame, GLenum map_format)
    : map_(gl_target(map_format, {frame.ao_width, frame.ao_height}, GL_CLAMP_TO_EDGE)),
      between_(gl_target(map_format, map_.size, GL_CLAMP_TO_EDGE)) {}

std::unique_ptr<GlAo> gl_tutorial_ao(const PeerScene& scene, const GlGBuffer& gbuffer) {
    return std::make_unique<GlTutorialAo>(scene, gbuffer);
}

std::string gl_prefix(const PeerFrame& frame) {
    return "#version 450\n" + define("PERSPECTIVE", frame.perspective) + define("PHONG", frame.phong) +
           define("LIGHTS", std::max(1, frame.light_count)) +
           define("SHADOW", frame.shadow.side > 0 ? 1 : 0) + define("SKY", frame.sky_side > 0 ? 1 : 0);
}

std::string gl_ao_prefix(const PeerScene& scene) {
    const PeerFrame& frame = scene.frame;
    const bool point_normals = frame.method != PeerMethod::luna || frame.reads_as_luna != 0;
    return gl_prefix(frame) + define("NDC_DEPTH", frame.reads_as_luna) +
           define("HALF_SIZE", frame.ao_width != frame.width ? 1 : 0) +
           define("POINT_NORMALS", point_normals ? 1 : 0) +
           define("SAMPLES", std::max(1, static_cast<int>(scene.samples.size())));
}

float number_of(const PeerScene& scene, std::string_view name) {
    for (const PeerNumber& number : scene.numbers) {
        if (name == number.name.data()) return number.value;
    }
    throw InputError("scene stream: no number " + std::string(name) + "; both programs must be of one build");
}

void set_ao_numbers(const GlProgram& program, const PeerScene& scene) {
    const PeerFrame& frame = scene.frame;
    for (const PeerNumber& number : scene.numbers) program.set(number.name.data(), number.value);
    program.set("ray_scale", frame.ray_scale);
    program.set("near_plane", frame.near_plane);
    program.set("background_depth", frame.background_depth);
    program.set("depth_a", frame.depth_a);
    program.set("depth_b", frame.depth_b);
    if (!scene.samples.empty()) program.set("samples", std::span<const glm::vec3>(scene.samples));
    if (!scene.blur_weights.empty()) program.set("weights", std::span<const float>(scene.blur_weights));
}

}  // namespace crevice
