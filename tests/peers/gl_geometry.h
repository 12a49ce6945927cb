// The triangles of a scene, and the textures of its materials.
#pragma once

#include <vector>

#include "tests/peers/gl_texture.h"

namespace crevice {

class GlGeometry {
 public:
    // Uploads them; vertices and indices stay bound for all frames.
    explicit GlGeometry(const PeerScene& scene);

    const std::vector<PeerDraw>& draws() const { return draws_; }
    bool has_cutouts() const;
    // The texture of a number, or 0.
    GLuint texture(std::int32_t number) const;

    // Filters as the textures say, or trilinear all.
    void set_anisotropic(bool anisotropic) const;
    void draw(const PeerDraw& part) const;
    void draw_all() const;

 private:
    std::vector<PeerDraw> draws_;
    std::vector<GLuint> textures_;
    std::vector<float> probes_;  // of each
    int index_count_ = 0;
};

}  // namespace crevice
