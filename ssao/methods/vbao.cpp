#include "ssao/methods/vbao.h"

#include "ssao/inputs/pixel_fetch.h"
#include "ssao/methods/settings_range.h"
#include "ssao/methods/vbao_kernel.h"

namespace crevice {

void validate(const VbaoSettings& s) {
    validate_slice_samples(s.samples);
    require_length("thickness", s.thickness);
    require_common(s);
}

AoMap vbao(const AoInputs& inputs, const VbaoSettings& settings, const Run& run) {
    validate(settings);
    return each_texel(VbaoKernel(inputs, settings), settings, run);
}

double vbao_reach_px(const AoInputs& inputs, const VbaoSettings& settings, double view_depth) {
    return reach_of_length_px(inputs, static_cast<double>(settings.radius), view_depth);
}

Explanation explain_vbao(const AoInputs& inputs, const VbaoSettings& settings, int x, int y) {
    validate(settings);
    return explain_texel(VbaoKernel(inputs, settings), settings, x, y);
}

}  // namespace crevice
