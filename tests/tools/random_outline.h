// Random simple polygons, the same on every machine.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <glm/vec2.hpp>

namespace crevice {

// An integer hash (the "lowbias32" constants).
inline std::uint32_t hash_of(std::uint32_t x) {
    x = (x ^ (x >> 16)) * 0x7feb352du;
    x = (x ^ (x >> 15)) * 0x846ca68bu;
    return x ^ (x >> 16);
}

// Whether two edges cross or touch.
inline bool edges_meet(glm::dvec2 a, glm::dvec2 b, glm::dvec2 c, glm::dvec2 d) {
    const auto side = [](glm::dvec2 p, glm::dvec2 q, glm::dvec2 r) {
        return (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
    };
    return side(a, b, c) * side(a, b, d) <= 0 && side(c, d, a) * side(c, d, b) <= 0;
}
// Corners on a grid of 1024, uncrossed by turning stretches of the outline round until no two edges meet.
// Empty when that does not come to an end.
inline std::vector<glm::ivec2> random_outline(std::uint32_t seed, std::size_t count) {
    std::vector<glm::ivec2> p;
    for (std::uint32_t i = 0; i < count; ++i) {
        const std::uint32_t h = hash_of(seed * 4099 + i);
        p.emplace_back(static_cast<int>(h & 1023), static_cast<int>((h >> 10) & 1023));
    }
    for (int round = 0; round < 1000; ++round) {
        bool met = false;
        for (std::size_t i = 0; i < count; ++i) {
            for (std::size_t j = i + 2; j < count - (i == 0); ++j) {
                if (!edges_meet(p[i], p[i + 1], p[j], p[(j + 1) % count])) continue;
                std::reverse(p.begin() + static_cast<std::ptrdiff_t>(i + 1),
                             p.begin() + static_cast<std::ptrdiff_t>(j + 1));
                met = true;
            }
        }
        if (!met) return p;
    }
    return {};
}

}  // namespace crevice
