#include "rasterizer/obj/cutout_images.h"

#include <algorithm>
#include <cstdint>

#include "rasterizer/base/error.h"
#include "rasterizer/obj/texel_images.h"

namespace crevice {

bool keeps_nothing(const Image<float>& alpha, float cutoff) {
    for (int y = 0; y < alpha.size.height; ++y) {
        for (int x = 0; x < alpha.size.width; ++x) {
            if (alpha.at(x, y) >= cutoff) return false;
        }
    }
    return true;
}

void bring_to_one_size(Image3& colour, Image<float>& alpha, const std::string& name) {
    const Size a = colour.size(), b = alpha.size,
               size{std::max(a.width, b.width), std::max(a.height, b.height)};
    if (std::int64_t{size.width} * size.height > kMaxTexturePixels) {
        throw InputError(name + ": the sizes of the texture and its cut-out do not go together (" +
                         std::to_string(size.width) + " x " + std::to_string(size.height) +
                         " would hold both); give both one size");
    }
    if (a != size) {
        for (Image<float>* plane : {&colour.x, &colour.y, &colour.z}) *plane = resized(*plane, size);
    }
    if (b != size) alpha = resized(alpha, size);
}

}  // namespace crevice
