#include "tests/peers/gl_geometry.h"

#include <algorithm>
#include <cstddef>

namespace crevice {

namespace {

template <class T>
void upload(GLenum target, const std::vector<T>& elements) {
    GLuint buffer = 0;
    glGenBuffers(1, &buffer);
    glBindBuffer(target, buffer);
    glBufferData(target, static_cast<GLsizeiptr>(elements.size() * sizeof(T)), elements.data(),
                 GL_STATIC_DRAW);
}

// Of the buffer that is bound.
void set_attribute(GLuint place, int components, std::size_t stride, std::size_t offset) {
    glVertexAttribPointer(place, components, GL_FLOAT, GL_FALSE, static_cast<GLsizei>(stride),
                          reinterpret_cast<const void*>(offset));
    glEnableVertexAttribArray(place);
}

}  // namespace

GlGeometry::GlGeometry(const PeerScene& scene)
    : draws_(scene.draws), index_count_(static_cast<int>(scene.indices.size())) {
    GLuint arrays = 0;
    glGenVertexArrays(1, &arrays);
    glBindVertexArray(arrays);
    upload(GL_ELEMENT_ARRAY_BUFFER, scene.indices);
    upload(GL_ARRAY_BUFFER, scene.vertices);
    set_attribute(0, 3, sizeof(PeerVertex), offsetof(PeerVertex, p_world));
    set_attribute(1, 3, sizeof(PeerVertex), offsetof(PeerVertex, n_world));
    for (const PeerTexture& texture : scene.textures) {
        textures_.push_back(gl_texture(texture));
        probes_.push_back(static_cast<float>(texture.probes));
    }
    set_anisotropic(true);
    if (scene.surface_vertices.empty()) return;
    upload(GL_ARRAY_BUFFER, scene.surface_vertices);
    set_attribute(2, 2, sizeof(PeerSurfaceVertex), offsetof(PeerSurfaceVertex, uv));
    set_attribute(3, 4, sizeof(PeerSurfaceVertex), offsetof(PeerSurfaceVertex, tangent_world));
}

bool GlGeometry::has_cutouts() const {
    return std::any_of(draws_.begin(), draws_.end(), [](const PeerDraw& d) { return d.alpha_cutoff > 0; });
}

GLuint GlGeometry::texture(std::int32_t number) const {
    return number == kNoPeerTexture ? 0 : textures_[static_cast<std::size_t>(number)];
}

void GlGeometry::set_anisotropic(bool anisotropic) const {
    for (std::size_t i = 0; i < textures_.size(); ++i)
        glTextureParameterf(textures_[i], GL_TEXTURE_MAX_ANISOTROPY, anisotropic ? probes_[i] : 1.0f);
}

void GlGeometry::draw(const PeerDraw& part) const {
    glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(part.index_count), GL_UNSIGNED_INT,
                   reinterpret_cast<const void*>(part.first_index * sizeof(GLuint)));
}

void GlGeometry::draw_all() const { glDrawElements(GL_TRIANGLES, index_count_, GL_UNSIGNED_INT, nullptr); }

}  // namespace crevice
