// What the settings of a method share when many of them are tried on one view: buffers drawn once.
#pragma once

#include <array>
#include <memory>

#include "chapters/study/error_settings.h"
#include "rasterizer/draw/normal_depth.h"

namespace crevice {

struct MethodView {
    const Method* method = nullptr;
    const Scene* scene = nullptr;  // must outlive this
    float length_unit = 1;
    Camera camera;
    Size size;
    std::shared_ptr<const std::array<GBuffer, 3>> gbuffers;  // one for each BufferFormat, in its order
    std::shared_ptr<const RayScene> rays;             // where the method casts them
    std::shared_ptr<const VertexAo> baked = nullptr;  // with_bake(): for one setting
};

MethodView method_view(const Scene& scene, const Camera& camera, Size size, const Method& method,
                       const Run& run);

// The same view, buffers and trees shared, for another method.
MethodView for_method(MethodView view, const Method& method, const Run& run);

// The view with what the method bakes with these settings, as it is where it bakes nothing.
MethodView with_bake(MethodView view, const FrameSettings& settings, const Run& run);

// What the method is given to look at: the buffers that the settings ask for.
AoView ao_view_of(const MethodView& view, const FrameSettings& settings);

// What the method estimates, before its denoiser.
RawAo raw_ao_of(const MethodView& view, const FrameSettings& settings, const Run& run);

// Whether the method has a denoiser, and the settings let it work.
bool has_blur(const Method& method, const FrameSettings& settings);

// The raw map denoised and, where the settings ask for it, brought to the picture's size.
Image<float> map_of_raw(const MethodView& view, RawAo raw, const FrameSettings& settings, const Run& run);

// Both: the AO map as it is before the picture is lit: estimated, denoised and, where the settings ask for it, brought to the
// picture's size. This is what is timed, inputs included.
Image<float> ao_map_of(const MethodView& view, const FrameSettings& settings, const Run& run);

// The same at picture size, as the lit pass reads it.
Image<float> ao_picture_of(const MethodView& view, const FrameSettings& settings, const Run& run);

}  // namespace crevice
