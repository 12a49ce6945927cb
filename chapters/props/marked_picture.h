// Pictures with a ring around the pixel that the text speaks of.
#pragma once

#include <algorithm>
#include <iterator>
#include <optional>

#include <glm/vec2.hpp>

#include "chapters/notebook/picture.h"

namespace crevice {

// Whether (x, y) lies on a ring around the pixel.
inline bool is_on_ring(glm::ivec2 pixel, int x, int y) {
    constexpr int kRadius_px = 6;
    const int across = x - pixel.x, down = y - pixel.y, squared = across * across + down * down;
    return squared >= (kRadius_px - 1) * (kRadius_px - 1) && squared < (kRadius_px + 1) * (kRadius_px + 1);
}

// Accessibility as ao_picture() shows it, the ring in green; without a pixel no ring.
inline Picture marked_picture(const Image<float>& ao, std::optional<glm::ivec2> pixel) {
    const glm::vec3 ring(0.1f, 0.65f, 0.2f);
    Image3 canvas(ao.size, glm::vec3(0));
    for (int y = 0; y < ao.size.height; ++y) {
        for (int x = 0; x < ao.size.width; ++x) {
            const bool on_ring = pixel && is_on_ring(*pixel, x, y);
            canvas.set(x, y, on_ring ? ring : glm::vec3(ao.at(x, y)));
        }
    }
    return colour_picture(canvas);
}

// A picture in colours with the same ring.
inline Picture with_ring(Picture picture, glm::ivec2 pixel) {
    constexpr std::uint8_t kGreen[] = {0x1a, 0x7f, 0x37};
    for (int y = 0; y < picture.size.height; ++y) {
        for (int x = 0; x < picture.size.width; ++x) {
            if (!is_on_ring(pixel, x, y)) continue;
            const std::ptrdiff_t at = std::ptrdiff_t{3} * (y * picture.size.width + x);
            std::copy(std::begin(kGreen), std::end(kGreen), picture.pixels.begin() + at);
        }
    }
    return picture;
}

}  // namespace crevice
