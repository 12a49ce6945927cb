// The AO passes of the methods that are public as shaders, and their blurs.
#include <algorithm>

#include "ssao/blur/edge_blur.h"
#include "ssao/blur/sao_blur_kernel.h"
#include "tests/peers/gl_ao.h"
#include "tests/peers/gl_ao_shaders.h"
#include "tests/peers/gl_method_shaders.h"

namespace crevice {

namespace {

constexpr GLuint kMapUnit = 1, kExtraUnit = 3;  // kGBuffer's are 0 and 2

// A program over the AO map.
struct MapProgram : GlProgram {
    MapProgram(const PeerScene& scene, const std::string& pixels)
        : GlProgram(gl_ao_prefix(scene), kPictureVertices, kGBuffer + pixels) {
        set_ao_numbers(*this, scene);
    }
};

class GlMethodAo : public GlAo {
 public:
    void estimate() const override {
        prepare();
        bind_gbuffer();
        glBindTextureUnit(kMapUnit, noise_);
        draw(estimator_, map_);
    }

 protected:
    GlMethodAo(const PeerScene& scene, const GlGBuffer& gbuffer, const char* pixels, GLenum map_format)
        : GlAo(scene.frame, map_format),
          gbuffer_(gbuffer),
          iterations_(scene.frame.blur_iterations),
          estimator_(scene, std::string(kPixels) + pixels) {
        const Size side{scene.frame.noise_side, scene.frame.noise_side};
        noise_ = gl_texture(GL_RGBA32F, side, GL_NEAREST, GL_REPEAT);
        glTextureSubImage2D(noise_, 0, 0, 0, side.width, side.height, GL_RGBA, GL_FLOAT, scene.noise.data());
    }

    // What estimate() begins with.
    virtual void prepare() const {}
    void bind_gbuffer() const {
        glBindTextureUnit(0, gbuffer_.normal_depth);
        glBindTextureUnit(2, gbuffer_.ndc_depth);
    }
    static void draw(const GlProgram& program, const GlTarget& to) {
        draw_into(to);
        program.use();
        draw_picture();
    }
    void blur_into(const GlProgram& program, const GlTarget& from, const GlTarget& to) const {
        glBindTextureUnit(kMapUnit, from.texture);
        draw(program, to);
    }

    GlGBuffer gbuffer_;
    int iterations_;

 private:
    MapProgram estimator_;
    GLuint noise_ = 0;
};

// LearnOpenGL's.
class GlHemisphere final : public GlMethodAo {
 public:
    GlHemisphere(const PeerScene& scene, const GlGBuffer& gbuffer)
        : GlMethodAo(scene, gbuffer, kHemispherePixels, GL_R32F), box_(scene, kBoxPixels) {}

    void blur() const override {
        bind_gbuffer();
        for (int i = 0; i < iterations_; ++i) {
            box_.set("step_uv", glm::vec2(1.0f / static_cast<float>(map_.size.width), 0));
            blur_into(box_, map_, between_);
            box_.set("step_uv", glm::vec2(0, 1.0f / static_cast<float>(map_.size.height)));
            blur_into(box_, between_, map_);
        }
    }

 private:
    MapProgram box_;
};

// McGuire's scalable ambient obscurance, with its pyramid of depths.
class GlSao final : public GlMethodAo {
 public:
    GlSao(const PeerScene& scene, const GlGBuffer& gbuffer)
        : GlMethodAo(scene, gbuffer, kSaoPixels, GL_RG32F),
          minify_(scene, kPyramidPixels),
          quads_(scene, kQuadPixels),
          blur_(scene, kSaoBlurPixels),
          evens_out_(number_of(scene, "quads") != 0),
          smooths_(number_of(scene, "fine") != 0) {
        const int top = static_cast<int>(number_of(scene, "levels"));
        glCreateTextures(GL_TEXTURE_2D, 1, &pyramid_);
        glTextureStorage2D(pyramid_, top + 1, GL_R32F, scene.frame.width, scene.frame.height);
        glTextureParameteri(pyramid_, GL_TEXTURE_MIN_FILTER, GL_NEAREST_MIPMAP_NEAREST);
        glTextureParameteri(pyramid_, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
        for (int level = 0; level <= top; ++level) {
            GlTarget& target = levels_.emplace_back();
            target.texture = pyramid_;
            target.size = {scene.frame.width >> level, scene.frame.height >> level};
            glCreateFramebuffers(1, &target.framebuffer);
            glNamedFramebufferTexture(target.framebuffer, GL_COLOR_ATTACHMENT0, pyramid_, level);
        }
    }

    void blur() const override {
        if (iterations_ == 0) return;
        const GlTarget *from = &map_, *to = &between_;
        const auto pass = [&](const GlProgram& program) {
            blur_into(program, *from, *to);
            std::swap(from, to);
        };
        const auto both_ways = [&](const SaoBlurPass& by) {
            blur_.set("weights", std::span<const float>(by.weights));
            blur_.set("taps", static_cast<float>(by.taps));
            blur_.set("step_texels", static_cast<float>(by.step));
            for (const float down : {0.0f, 1.0f}) blur_.set("down", down), pass(blur_);
        };
        if (evens_out_) pass(quads_);
        for (int i = 0; i < iterations_; ++i) both_ways(kPublished);
        if (smooths_) both_ways(kFine);
        if (from != &map_) std::swap(map_, between_);
    }

 private:
    void prepare() const override {
        bind_gbuffer();
        glBindTextureUnit(kExtraUnit, pyramid_);
        for (std::size_t level = 0; level < levels_.size(); ++level) {
            minify_.set("level", static_cast<float>(level));
            draw(minify_, levels_[level]);
        }
    }

    MapProgram minify_, quads_, blur_;
    bool evens_out_, smooths_;
    GLuint pyramid_ = 0;
    std::vector<GlTarget> levels_;
};

// GTAO with XeGTAO's samples, noise and denoiser.
class GlGtao final : public GlMethodAo {
 public:
    GlGtao(const PeerScene& scene, const GlGBuffer& gbuffer)
        : GlMethodAo(scene, gbuffer, kGtaoPixels, GL_R32F),
          find_edges_(scene, kEdgePixels),
          blur_(scene, kEdgeBlurPixels),
          edges_(gl_target(GL_R8UI, map_.size, GL_CLAMP_TO_EDGE)) {
        find_edges_.set("map_size", glm::vec2(map_.size.width, map_.size.height));
        glTextureParameteri(edges_.texture, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
        glTextureParameteri(edges_.texture, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    }

    void blur() const override {
        if (iterations_ == 0) return;
        bind_gbuffer();
        draw(find_edges_, edges_);
        glBindTextureUnit(kExtraUnit, edges_.texture);
        for (int i = 1; i <= iterations_; ++i) {
            blur_.set("own_weight", i == iterations_ ? kEdgeBlurOwn : kEdgeBlurOwnBefore);
            blur_into(blur_, map_, between_);
            std::swap(map_, between_);
        }
    }

 private:
    MapProgram find_edges_, blur_;
    GlTarget edges_;
};

}  // namespace

std::unique_ptr<GlAo> gl_method_ao(const PeerScene& scene, const GlGBuffer& gbuffer) {
    switch (scene.frame.method) {
        case PeerMethod::hemisphere: return std::make_unique<GlHemisphere>(scene, gbuffer);
        case PeerMethod::sao: return std::make_unique<GlSao>(scene, gbuffer);
        case PeerMethod::gtao: return std::make_unique<GlGtao>(scene, gbuffer);
        case PeerMethod::luna: break;
    }
    return gl_tutorial_ao(scene, gbuffer);
}

}  // namespace crevice
