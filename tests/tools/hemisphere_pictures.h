// Pictures of the methods that count points in a hemisphere.
#pragma once

#include "rasterizer/draw/normal_depth.h"
#include "ssao/inputs/pixel_fetch.h"
#include "ssao/methods/hemisphere.h"
#include "ssao/methods/unity.h"
#include "tests/tools/special_floats.h"

namespace crevice {

struct HemispherePicture {
    GBuffer g;
    AoInputs inputs;
    Image<float> ao;
};
inline constexpr Size kHemispherePicture = {64, 48};

inline HemispherePicture picture_of(const Scene& scene, const HemisphereSettings& settings = {},
                                    Size size = kHemispherePicture) {
    HemispherePicture picture{normal_depth(scene, scene.camera, size), {}, {}};
    picture.inputs = ao_inputs(picture.g, scene.camera, hemisphere_fetch(settings));
    picture.ao = hemisphere_ao(picture.inputs, settings).ao;
    return picture;
}
inline HemispherePicture picture_of(const Scene& scene, const UnitySettings& settings,
                                    Size size = kHemispherePicture) {
    HemispherePicture picture{normal_depth(scene, scene.camera, size), {}, {}};
    picture.inputs = ao_inputs(picture.g, scene.camera, pixel_fetch(settings));
    picture.ao = unity_ao(picture.inputs, settings).ao;
    return picture;
}

// Over all texels that show a surface.
template <class Settings>
double mean_of(const Scene& scene, const Settings& settings, Size size = kHemispherePicture) {
    const HemispherePicture picture = picture_of(scene, settings, size);
    double sum = 0;
    int count = 0;
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
            if (!(picture.inputs.view_depth.at(x, y) < kInfinity)) continue;
            sum += static_cast<double>(picture.ao.at(x, y));
            ++count;
        }
    }
    return sum / count;
}

inline double mean_of_row(const Image<float>& ao, int y, int first, int end) {
    double sum = 0;
    for (int x = first; x < end; ++x) sum += static_cast<double>(ao.at(x, y));
    return sum / (end - first);
}

}  // namespace crevice
