// An AO map with a ring around the pixel that the text speaks of.
#pragma once

#include <optional>

#include <glm/vec2.hpp>

#include "chapters/notebook/picture.h"

namespace crevice {

// Accessibility as ao_picture() shows it, the ring in green; without a pixel no ring.
inline Picture marked_picture(const Image<float>& ao, std::optional<glm::ivec2> pixel) {
    constexpr int kRadius_px = 6;
    const glm::vec3 ring(0.1f, 0.65f, 0.2f);
    Image3 canvas(ao.size, glm::vec3(0));
    for (int y = 0; y < ao.size.height; ++y) {
        for (int x = 0; x < ao.size.width; ++x) {
            bool on_ring = false;
            if (pixel) {
                const int across = x - pixel->x, down = y - pixel->y, squared = across * across + down * down;
                on_ring = squared >= (kRadius_px - 1) * (kRadius_px - 1) &&
                          squared < (kRadius_px + 1) * (kRadius_px + 1);
            }
            canvas.set(x, y, on_ring ? ring : glm::vec3(ao.at(x, y)));
        }
    }
    return colour_picture(canvas);
}

}  // namespace crevice
