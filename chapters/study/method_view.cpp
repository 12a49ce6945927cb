#include "chapters/study/method_view.h"

#include <utility>

#include "ssao/light/ao_lookup.h"
#include "ssao/light/widened_ao.h"
#include "ssao/rays/ray_cast.h"

namespace crevice {

MethodView method_view(const Scene& scene, const Camera& camera, Size size, const Method& method,
                       const Run& run) {
    MethodView view{&method, &scene, scene.length_unit, camera, size, {}, {}, {}};
    const BufferFormat formats[] = {BufferFormat::float32, BufferFormat::float16_toward_zero};
    for (std::size_t i = 0; i < view.gbuffer.size(); ++i) {
        NormalDepthSettings settings;
        settings.buffer_format = formats[i];
        view.gbuffer[i] = normal_depth(scene, camera, size, settings, run);
    }
    if (method.casts_rays) view.rays = std::make_shared<const RayScene>(ray_scene(scene, camera.eye, run));
    return view;
}

MethodView with_bake(MethodView view, const FrameSettings& settings, const Run& run) {
    if (view.method->bake) view.baked = view.method->bake(*view.scene, *view.rays, settings.method.ao, run);
    return view;
}

AoView ao_view_of(const MethodView& view, const FrameSettings& settings) {
    const bool half_floats = settings.buffers.buffer_format != BufferFormat::float32;
    return {*view.scene, view.camera, view.gbuffer[half_floats ? 1 : 0], view.rays.get(), view.baked.get()};
}

Image<float> ao_map_of(const MethodView& view, const FrameSettings& settings, const Run& run) {
    const Method& method = *view.method;
    const AoView ao_view = ao_view_of(view, settings);
    RawAo raw = method.ao(ao_view, settings.method.ao, run);
    Image<float> map = value_of(method, settings.method, "blur_iterations") == 0
                           ? std::move(raw.ao)
                           : denoised(method, raw, settings.method, run).ao;
    if (settings.ao_lookup == AoLookup::exact) return map;
    return looked_up(map, raw.inputs, ao_view.gbuffer, settings.ao_lookup, run);
}

Image<float> ao_picture_of(const MethodView& view, const FrameSettings& settings, const Run& run) {
    return ao_at_picture_size(ao_map_of(view, settings, run), view.size, run);
}

}  // namespace crevice
