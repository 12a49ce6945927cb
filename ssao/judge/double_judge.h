// What a picture's pixels show, worked out in double from the scene itself: the judge of every rounding between the vertices
// and the AO map. It takes from the rasterizer only which triangle a pixel shows.
// In:     a scene, its camera, the geometry and the G-buffer drawn of both
// Out:    view depth: where the eye's ray through the pixel's centre meets the triangle's plane; the vertex normal there
// Cost:   about 300 double operations a pixel.
#pragma once

#include <glm/mat3x3.hpp>

#include "rasterizer/draw/normal_depth.h"
#include "rasterizer/draw/screen_geometry.h"
#include "ssao/inputs/double_buffers.h"

namespace crevice {

struct JudgedPixel {
    bool surface = false;
    double view_depth = 0;              // scene units
    double slant = 0;                   // cosine between the eye's ray and the plane's normal
    double reach = 0;                   // how far the triangle's farthest corner is from the eye
    glm::dvec3 normal = glm::dvec3(0);  // view space, unit; 0 where the mesh has none
};

// Where a vertex is. Perspective: w is its view depth; orthographic: 1.
struct JudgedVertex {
    double x_px, y_px, w;
};

class DoubleJudge {
 public:
    // All three must outlive it.
    DoubleJudge(const Scene& scene, const Camera& camera, const ScreenGeometry& geometry);

    // `g` with GBuffer::triangle.
    JudgedPixel at(const GBuffer& g, int x, int y) const;
    // The depth buffer's number for a view depth: CameraMatrices, not rounded.
    double depth_a() const;
    double depth_b() const;
    double ndc_depth(double view_depth) const;
    double cleared_depth() const { return camera_.reversed_z ? 0 : 1; }
    // A vertex of an instance, by its number in the mesh.
    JudgedVertex vertex(const Instance& instance, std::size_t number) const;

 private:
    struct Corner {
        glm::dvec3 position, normal;  // view space
    };
    glm::dvec3 position(const Instance& instance, std::size_t number) const;
    Corner corner_of(const ScreenTriangle& t, std::size_t i) const;
    // The eye's ray through a pixel's centre, view space.
    struct Sight {
        glm::dvec3 from, along;  // `along` has z = 1
    };
    Sight sight(int x, int y) const;

    const Scene& scene_;
    const Camera& camera_;
    const ScreenGeometry& geometry_;
    glm::dmat3 view_from_relative_;
    glm::dvec2 half_;  // of the picture: scene units at view depth 1; orthographic: at any depth
};

// All pixels of a G-buffer.
DoubleGBuffer double_gbuffer(const DoubleJudge& judge, const GBuffer& g);

}  // namespace crevice
