#include "chapters/study/method_view.h"

#include "ssao/light/widened_ao.h"

namespace crevice {

MethodView method_view(const Scene& scene, const Camera& camera, Size size, const Method& method,
                       const Run& run) {
    MethodView view{&method, scene.length_unit, camera, size, {}};
    const BufferFormat formats[] = {BufferFormat::float32, BufferFormat::float16_toward_zero};
    for (std::size_t i = 0; i < view.gbuffer.size(); ++i) {
        NormalDepthSettings settings;
        settings.buffer_format = formats[i];
        view.gbuffer[i] = normal_depth(scene, camera, size, settings, run);
    }
    return view;
}

AoInputs inputs_of(const MethodView& view, const MethodSettings& settings, const Run& run) {
    const bool half_floats = settings.buffers.buffer_format != BufferFormat::float32;
    return ao_inputs(view.gbuffer[half_floats ? 1 : 0], view.camera, view.method->fetch(settings.ao), run);
}

Image<float> ao_map_of(const MethodView& view, const MethodSettings& settings, const Run& run) {
    const AoInputs inputs = inputs_of(view, settings, run);
    Image<float> ao = luna_occlusion(inputs, settings.ao, run);
    return settings.blur.iterations == 0 ? ao : bilateral_blur(ao, inputs, settings.blur, run);
}

Image<float> ao_picture_of(const MethodView& view, const MethodSettings& settings, const Run& run) {
    return ao_at_picture_size(ao_map_of(view, settings, run), view.size, run);
}

}  // namespace crevice
