#include "rasterizer/draw/cutouts.h"

#include <algorithm>

namespace crevice {

bool has_cutouts(const Material& material) {
    return material.alpha_cutoff > 0 && material.texture != nullptr && material.texture->has_alpha();
}

bool has_cutouts(const Scene& scene) {
    return std::any_of(scene.materials.begin(), scene.materials.end(),
                       [](const Material& m) { return has_cutouts(m); });
}

}  // namespace crevice
