// What the materials' textures say of visible pixels, looked up once for each of them.
// Source: X_Jun and Luna (diffuse map, normal map with the shininess in its alpha).
// In:     a row of triangle numbers; the row's materials and vertex normals (surfaces.h)
// Out:    colour and gloss, and where there is a normal map the normal
// Cost:   one lookup a pixel and material, for as many pixels at a time as there are lanes
#pragma once

#include <vector>

#include "rasterizer/draw/surfaces.h"
#include "rasterizer/draw/texture_coordinates.h"

namespace crevice {

// What is looked up, with pointers as in SurfaceRow. Null: not wanted.
struct TextureRow {
    const std::int32_t* material;  // of the pixels, as find_surfaces() writes them
    float* normal[3] = {};         // changed where there is a normal map: view space, unit
    float* colour[3] = {};         // of the texture, linear light; 1 where there is none
    float* gloss = nullptr;        // [0,1], the normal map's alpha; 1 where there is none
};

class SurfaceTextures {
 public:
    // Scene and geometry must outlive it.
    SurfaceTextures(const Scene& scene, const ScreenGeometry& geometry);

    // Whether a material of the scene has anything to be looked up.
    bool any() const;
    // The pixels [x0, x1) of row y; `triangle` and x0 as in find_surfaces().
    void look_up(const std::int32_t* triangle, int x0, int x1, int y, const TextureRow& row,
                 const Run& run) const;

 private:
    const Scene& scene_;
    const ScreenGeometry& geometry_;
    std::vector<InstanceAttributes> attributes_;
    std::vector<bool> textured_;  // one a material: it has a texture or a normal map
};

}  // namespace crevice
