// A group of threads over the pixels of the depth map, its apron, and the samples of some of its texels: for chapter 12.
#pragma once

#include <string>
#include <vector>

#include <glm/vec2.hpp>

#include "rasterizer/base/pixel_rect.h"
#include "ssao/methods/explanation.h"

namespace crevice {

struct TexelSamples {
    glm::vec2 p_screen{0};  // pixels of the picture
    Explanation texel;
};

// Samples that stay within the apron in ink, those that leave it in orange.
std::string group_diagram(const PixelRect& group, int apron_px, const std::vector<TexelSamples>& texels,
                          const std::string& title);

}  // namespace crevice
