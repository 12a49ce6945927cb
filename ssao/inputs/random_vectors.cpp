#include "ssao/inputs/random_vectors.h"

#include <cmath>

#include "rasterizer/base/parallel.h"

namespace crevice {

namespace {

// Streams of the hash that must not meet.
constexpr std::uint32_t kOffsetStream = 0x0ff5e7u, kMapStream = 0x3a9u;

constexpr glm::vec3 kCubeDirections[kCubeVectors] = {
    {+1, +1, +1}, {-1, -1, -1}, {-1, +1, +1}, {+1, -1, -1}, {+1, +1, -1}, {-1, -1, +1}, {-1, +1, -1},
    {+1, -1, +1}, {-1, 0, 0},   {+1, 0, 0},   {0, -1, 0},   {0, +1, 0},   {0, 0, -1},   {0, 0, +1}};

}  // namespace

std::array<glm::vec3, kCubeVectors> cube_offsets(std::uint32_t seed) {
    std::array<glm::vec3, kCubeVectors> offsets;
    for (std::uint32_t i = 0; i < kCubeVectors; ++i) {
        const glm::vec3 d = kCubeDirections[i];
        const float unit = static_cast<float>(hash_of(seed, kOffsetStream, i) >> 8) * (1.0f / 16777216.0f);
        const float length = kShortestOffset + (1 - kShortestOffset) * unit;
        offsets[i] = length / std::sqrt(d.x * d.x + d.y * d.y + d.z * d.z) * d;
    }
    return offsets;
}

RandomMap random_map(std::uint32_t seed, const Run& run) {
    constexpr std::uint32_t kTexels = kRandomMapSide * kRandomMapSide;
    constexpr std::size_t kTexelsAtOnce = 16 * kRandomMapSide;
    RandomMap map;
    for (std::vector<float>* plane : {&map.x, &map.y, &map.z}) plane->resize(kTexels);
    std::array<float, 256> signed_unit;
    for (std::size_t byte = 0; byte < 256; ++byte)
        signed_unit[byte] = 2 * (static_cast<float>(byte) / 255) - 1;
    parallel_blocks(kTexels, kTexelsAtOnce, run, [&](std::size_t first, std::size_t end) {
        for (std::size_t texel = first; texel < end; ++texel) {
            const std::uint32_t bits = hash_of(seed, kMapStream, static_cast<std::uint32_t>(texel));
            map.x[texel] = signed_unit[bits >> 24];
            map.y[texel] = signed_unit[bits >> 16 & 0xff];
            map.z[texel] = signed_unit[bits >> 8 & 0xff];
        }
    });
    return map;
}

}  // namespace crevice
