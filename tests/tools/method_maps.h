// What the suites over all rows of the table of methods share.
#pragma once

#include <string>
#include <vector>

#include "rasterizer/base/image_summary.h"
#include "ssao/ao_methods.h"
#include "ssao/rays/ray_cast.h"

namespace crevice {

inline constexpr Size kMethodMaps{53, 31};

inline std::vector<const Method*> computing_methods() {
    std::vector<const Method*> methods;
    for (const Method& method : ao_methods()) {
        if (method.computes_ao()) methods.push_back(&method);
    }
    return methods;
}

// A method's two maps of one picture.
struct Maps {
    GBuffer gbuffer;
    RayScene rays;  // of those that cast them
    RawAo raw;
    AoMap smooth;
};

inline Maps maps_of(const Method& method, const Scene& scene, Size size, const MethodSettings& settings,
                    const Run& run = {}) {
    Maps maps;
    maps.gbuffer = normal_depth(scene, scene.camera, size, run);
    if (method.casts_rays) maps.rays = ray_scene(scene, scene.camera.eye, run);
    maps.raw = method.ao({scene, scene.camera, maps.gbuffer, &maps.rays}, settings.ao, run);
    maps.smooth = denoised(method, maps.raw, settings, run);
    return maps;
}

inline Maps maps_of(const Method& method, const Scene& scene, Size size = kMethodMaps) {
    return maps_of(method, scene, size, defaults_of(method, scene.length_unit));
}

inline std::string hashes(const Maps& maps) {
    return content_hash(maps.raw.ao) + content_hash(maps.smooth.ao);
}

// Full size, where a G-buffer pixel is a texel.
inline MethodSettings full_size(const Method& method) {
    return with_value(method, defaults_of(method), "ao_scale", 1);
}

}  // namespace crevice
