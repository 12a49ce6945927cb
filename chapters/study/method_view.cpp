#include "chapters/study/method_view.h"

#include <utility>

#include "ssao/light/ao_lookup.h"
#include "ssao/light/widened_ao.h"
#include "ssao/rays/ray_cast.h"

namespace crevice {

MethodView method_view(const Scene& scene, const Camera& camera, Size size, const Method& method,
                       const Run& run) {
    std::array<GBuffer, 3> gbuffers;
    for (const BufferFormat format :
         {BufferFormat::float32, BufferFormat::float16_toward_zero, BufferFormat::float16_nearest_even}) {
        NormalDepthSettings settings;
        settings.buffer_format = format;
        gbuffers[static_cast<std::size_t>(format)] = normal_depth(scene, camera, size, settings, run);
    }
    MethodView view{nullptr, &scene, scene.length_unit, camera, size, {}, {}, {}};
    view.gbuffers = std::make_shared<const std::array<GBuffer, 3>>(std::move(gbuffers));
    return for_method(std::move(view), method, run);
}

MethodView for_method(MethodView view, const Method& method, const Run& run) {
    view.method = &method;
    view.baked = nullptr;
    if (method.casts_rays && view.rays == nullptr)
        view.rays = std::make_shared<const RayScene>(ray_scene(*view.scene, view.camera.eye, run));
    return view;
}

MethodView with_bake(MethodView view, const FrameSettings& settings, const Run& run) {
    if (view.method->bake) view.baked = view.method->bake(*view.scene, *view.rays, settings.method.ao, run);
    return view;
}

AoView ao_view_of(const MethodView& view, const FrameSettings& settings) {
    const auto format = static_cast<std::size_t>(settings.buffers.buffer_format);
    return {*view.scene, view.camera, (*view.gbuffers)[format], view.rays.get(), view.baked.get()};
}

RawAo raw_ao_of(const MethodView& view, const FrameSettings& settings, const Run& run) {
    return view.method->ao(ao_view_of(view, settings), settings.method.ao, run);
}

bool has_blur(const Method& method, const FrameSettings& settings) {
    return method.denoiser.denoised && value_of(method, settings.method, "blur_iterations") != 0;
}

Image<float> map_of_raw(const MethodView& view, RawAo raw, const FrameSettings& settings, const Run& run) {
    Image<float> map = has_blur(*view.method, settings) ? denoised(*view.method, raw, settings.method, run).ao
                                                        : std::move(raw.ao);
    if (settings.ao_lookup == AoLookup::exact) return map;
    return looked_up(map, raw.inputs, ao_view_of(view, settings).gbuffer, settings.ao_lookup, run);
}

Image<float> ao_map_of(const MethodView& view, const FrameSettings& settings, const Run& run) {
    return map_of_raw(view, raw_ao_of(view, settings, run), settings, run);
}

Image<float> ao_picture_of(const MethodView& view, const FrameSettings& settings, const Run& run) {
    return ao_at_picture_size(ao_map_of(view, settings, run), view.size, run);
}

}  // namespace crevice
