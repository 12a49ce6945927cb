// Where the rays of a texel of ray_cast_map.h start, and where they go.
#pragma once

#include <vector>

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include "ssao/inputs/linear_taps.h"
#include "ssao/rays/ray_cast_map.h"

namespace crevice {

// Relative space.
struct RayStart {
    bool surface = false;
    glm::vec3 origin{0}, normal{0};
    float lift = 0;  // of the origin, along the normal
};

// For all texels of one map; what it is made of must outlive it.
struct RayMapCaster {
    const RayScene& scene;
    const GBuffer& gbuffer;
    const AoInputs& inputs;
    const RayMapSettings& settings;
    const LinearTaps columns, rows;  // where the texels fall among the pixels
    const glm::mat3 relative_from_view;
    // Of RayPattern::interleaved: directions about +z, those of a texel side by side.
    std::vector<glm::vec3> pattern;
    std::vector<int> order;  // of a tile's texels: those whose rays point alike together

    RayMapCaster(const RayScene& ray_scene, const Camera& camera, const GBuffer& g, const AoInputs& ao_inputs,
                 const RayMapSettings& ray_map);

    RayStart start_at(int x, int y) const;
    void add_rays(const RayStart& from, int x, int y, std::vector<Ray>& rays) const;

 private:
    struct Pixel {
        int x, y;
    };
    float heading(int texel) const;
    std::vector<glm::vec3> directions(int count, std::uint32_t stream) const;
    Pixel pixel_of(int x, int y) const;
    float lift_at(const glm::vec3& p, float z) const;
};

// Accessibility of a texel of which so many rays meet something.
float accessibility_of(const RayMapSettings& settings, float met);

}  // namespace crevice
