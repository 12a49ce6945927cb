// What SceneDetail::surfaces adds to the shapes of a built-in scene: textures, normal maps, tangents, a sky.
#pragma once

#include <functional>
#include <initializer_list>
#include <memory>

#include <glm/vec2.hpp>

#include "rasterizer/base/run.h"
#include "rasterizer/scene/scene.h"
#include "scenes/procedural_sky.h"
#include "scenes/procedural_textures.h"

namespace crevice {

// A texture and the normal map of the same surface, for as many materials as like to share them. Both null:
// plain.
struct Surface {
    std::shared_ptr<const Texture> colour, normal;
};
Surface shared_surface(SurfaceMaps textures);

// The material of a surface. A texture brings its colour along, so that the reflectances alone are left to
// the material; where there is none, `mean_colour` (linear light) multiplies diffuse and ambient instead.
Material covered(Material material, const Surface& surface, glm::vec3 mean_colour, const Sampler& sampler);

// The sky of a look, kSkySide texels a face.
inline constexpr int kSkySide = 512;
std::shared_ptr<const CubeMap> shared_sky(const SkyLook& look, const Run& run);

// The mesh with its texture repeated `repeats` times as often along u and v.
Mesh with_repeats(Mesh mesh, glm::vec2 repeats);

// The mesh with the tangents that normal maps need (tangents.h); it must have texture coordinates.
Mesh with_tangents(Mesh mesh);

// The first tutorial samples its textures with all filters linear, the second with 8 anisotropic probes; both
// wrap. On a floor seen at a slant the first blurs sooner.
inline constexpr Sampler kXjunSampler{.filter = TextureFilter::trilinear};
inline constexpr Sampler kLunaSampler{.filter = TextureFilter::anisotropic, .max_anisotropy = 8};

// Both tutorials drop fragments whose alpha is below this. The mip levels of what is cut out must allow for
// it (cutout_mips.h).
inline constexpr float kTutorialCutoff = 0.1f;

// Does each of some independent pieces of work once, on all threads.
void at_once(const Run& run, std::initializer_list<std::function<void()>> pieces);

}  // namespace crevice
