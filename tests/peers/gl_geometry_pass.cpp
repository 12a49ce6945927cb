#include "tests/peers/gl_geometry_pass.h"

#include "tests/peers/gl_geometry_shaders.h"

namespace crevice {

namespace {

constexpr int kTextured = 1, kMapped = 2, kCutOut = 4;
constexpr GLuint kDiffuseUnit = 1, kNormalUnit = 2;

std::string prefix_of(int kind) {
    const auto define = [&](const char* name, int bit) {
        return std::string("#define ") + name + ((kind & bit) != 0 ? " 1\n" : " 0\n");
    };
    return define("TEXTURED", kTextured) + define("MAPPED", kMapped) + define("CUTOUT", kCutOut);
}

}  // namespace

GlGeometryPass::GlGeometryPass(const std::string& prefix, const GlGeometry& geometry,
                               const std::string& pixels, GlReads reads)
    : geometry_(geometry), reads_(reads) {
    for (const PeerDraw& draw : geometry.draws()) {
        std::unique_ptr<GlProgram>& program = programs_[kind_of(draw)];
        if (program == nullptr)
            program = std::make_unique<GlProgram>(prefix + prefix_of(kind_of(draw)), kGeometryVertices,
                                                  kSurface + pixels);
    }
}

// Depth EQUAL finds no holes: what they show was drawn behind them.
int GlGeometryPass::kind_of(const PeerDraw& draw) const {
    if (reads_ == GlReads::holes) return draw.alpha_cutoff > 0 ? kCutOut : 0;
    return (draw.texture != kNoPeerTexture ? kTextured : 0) |
           (draw.normal_map != kNoPeerTexture ? kMapped : 0);
}

void GlGeometryPass::draw() const {
    if (reads_ == GlReads::holes && programs_.size() == 1 && programs_.count(0) == 1) {
        programs_.at(0)->use();
        geometry_.draw_all();
        return;
    }
    for (const PeerDraw& draw : geometry_.draws()) {
        const GlProgram& program = *programs_.at(kind_of(draw));
        program.use();
        program.set("diffuse", draw.diffuse);
        program.set("ambient", draw.ambient);
        program.set("specular", draw.specular);
        program.set("shininess", draw.shininess);
        program.set("alpha_cutoff", draw.alpha_cutoff);
        glBindTextureUnit(kDiffuseUnit, geometry_.texture(draw.texture));
        glBindTextureUnit(kNormalUnit, geometry_.texture(draw.normal_map));
        geometry_.draw(draw);
    }
}

void set_view(const GlGeometryPass& pass, const glm::vec3& eye_world, const glm::mat4& clip_from_relative,
              const glm::mat4& view_from_relative) {
    pass.set("eye_world", eye_world);
    pass.set("clip_from_relative", clip_from_relative);
    pass.set("view_from_relative", view_from_relative);
}

}  // namespace crevice
