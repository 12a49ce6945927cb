#include "chapters/props/sky_in_half.h"

#include "chapters/props/stored_depth.h"
#include "chapters/terminal/number_text.h"
#include "ssao/methods/xjun_ssao.h"

namespace crevice {

SkyInHalf sky_in_half(const SwitchedView& view, Size size, BufferFormat format) {
    const GBuffer gbuffer = normal_depth(view.scene(), view.camera(), size, {.buffer_format = format});
    const AoInputs inputs = ao_inputs(gbuffer, view.camera(), xjun_fetch({.as_published = true}));
    SkyInHalf result{stored_as(1e5f, format), ao_with_std_max(inputs)};
    const double texels = static_cast<double>(result.ao.size.width) * result.ao.size.height / 100;
    result.nan = static_cast<double>(buffer_statistics(result.ao).nan) / texels;
    const Image<float> blurred = bilateral_blur(result.ao, inputs).ao;
    result.nan_blurred = static_cast<double>(buffer_statistics(blurred).nan) / texels;
    return result;
}

std::vector<std::string> sky_row(const char* rounding, const SkyInHalf& half) {
    return {rounding,
            exact_text(half.sky),
            exact_text(half.sky - half.sky),
            exact_text(10 + 0 * (half.sky - 10)),
            significant_text(half.nan, 3),
            significant_text(half.nan_blurred, 3)};
}

}  // namespace crevice
