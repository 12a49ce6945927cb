// What screen-space AO says about chosen points of a scene, and what is true of them: for chapter 11.
#pragma once

#include <optional>
#include <span>

#include <glm/vec2.hpp>

#include "rasterizer/draw/normal_depth.h"

namespace crevice {

// A point of the scene's surface, world space.
struct WorldPoint {
    glm::dvec3 position;
    glm::vec3 normal;  // unit
};

// The pixel of a picture that shows the point; none where it is hidden or beside the picture.
std::optional<glm::ivec2> pixel_that_shows(const WorldPoint& point, const GBuffer& gbuffer,
                                           const Camera& camera);

struct SeenAo {
    double mean = 1;  // of the points that the picture shows
    int seen = 0;     // how many these are
};

// X_Jun's estimator without noise and without contrast, at the texels that show the points.
SeenAo seen_ao(const Scene& scene, const Camera& camera, Size size, std::span<const WorldPoint> points);

// The mean of the points by `rays` rays each, as long as X_Jun's radius, cosine-weighted.
double true_ao(const Scene& scene, std::span<const WorldPoint> points, int rays);

// The whole map of that estimator: full size, exponent 1.
Image<float> noiseless_ao(const GBuffer& gbuffer, const Camera& camera);

}  // namespace crevice
