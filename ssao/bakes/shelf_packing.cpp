#include "ssao/bakes/shelf_packing.h"

#include <algorithm>
#include <numeric>
#include <tuple>

namespace crevice {

std::optional<std::vector<glm::ivec2>> pack_shelves(std::span<const Size> rectangles, int side, int gap) {
    std::vector<std::size_t> order(rectangles.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        const Size &first = rectangles[a], &second = rectangles[b];
        return std::tie(second.height, second.width, a) < std::tie(first.height, first.width, b);
    });
    std::vector<glm::ivec2> corners(rectangles.size());
    glm::ivec2 next(0);
    int shelf_height = 0;
    for (const std::size_t i : order) {
        const Size& size = rectangles[i];
        if (next.x > 0 && next.x + size.width > side) {
            next = {0, next.y + shelf_height + gap};
            shelf_height = 0;
        }
        if (size.width > side || next.y + size.height > side) return std::nullopt;
        corners[i] = next;
        next.x += size.width + gap;
        shelf_height = std::max(shelf_height, size.height);
    }
    return corners;
}

}  // namespace crevice
