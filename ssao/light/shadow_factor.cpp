#include "ssao/light/shadow_factor.h"

#include <glm/gtc/matrix_access.hpp>
#include <glm/gtc/matrix_transform.hpp>

namespace crevice {

ShadowLookup shadow_lookup(const ShadowMap& map, const Camera& view) {
    const Camera& light = map.light;
    const double side = map.depth.size().width, depth_range = light.far_plane - light.near_plane;
    const glm::dmat4 relative_from_view =
        glm::transpose(glm::dmat4(glm::dmat3(glm::lookAtLH(view.eye, view.target, view.up))));
    const glm::dmat4 light_from_relative =
        glm::dmat4(glm::dmat3(glm::lookAtLH(light.eye, light.target, light.up)));
    const glm::dmat4 light_from_view =
        light_from_relative * glm::translate(glm::dmat4(1), view.eye - light.eye) * relative_from_view;
    const double texels_a_unit = side / light.ortho_height;
    const glm::dvec4 one(0, 0, 0, 1);
    return {map, glm::vec4(texels_a_unit * glm::row(light_from_view, 0) + 0.5 * side * one),
            glm::vec4(-texels_a_unit * glm::row(light_from_view, 1) + 0.5 * side * one),
            glm::vec4((glm::row(light_from_view, 2) - light.near_plane * one) / depth_range)};
}

void copy_shadow_texels(const ShadowMap& map, int column, int row, std::int32_t* texels) {
    const Image<std::int32_t>& codes = map.depth.codes;
    const std::int32_t border = map.settings.border_is_lit ? depth_code(map.settings.format, 1.0f, 0.0) : 0;
    for (int y = row; y < row + kShadowTexels; ++y) {
        for (int x = column; x < column + kShadowTexels; ++x) {
            const bool inside = x >= 0 && y >= 0 && x < codes.size.width && y < codes.size.height;
            *texels++ = inside ? codes.at(x, y) : border;
        }
    }
}

}  // namespace crevice
