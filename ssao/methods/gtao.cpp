#include "ssao/methods/gtao.h"

#include "ssao/methods/gtao_kernel.h"

namespace crevice {

void validate(const GtaoSettings& s) {
    validate_slice_samples(s.samples);
    require_within("radius_multiplier", s.radius_multiplier, 0.3, 3);
    require_within("falloff", s.falloff, 0, 1);
    require_within("step_power", s.step_power, 1, 3);
    require_within("thickness", s.thickness, 0, 0.7);
    require_within("level_offset", s.level_offset, 2, 30);
    require_common(s);
}

AoMap gtao(const AoInputs& inputs, const GtaoSettings& settings, const Run& run) {
    validate(settings);
    return each_texel(GtaoKernel(inputs, settings, run), settings, run);
}

double gtao_reach_px(const AoInputs& inputs, const GtaoSettings& settings, double view_depth) {
    const double reach =
        static_cast<double>(settings.radius_multiplier) * static_cast<double>(settings.radius);
    // A cell is at most 2^(1/2 - offset) of its sample's distance wide, two cells where a picture of odd size ends.
    const double with_cell = 1 + 2 * static_cast<double>(exp2_of(0.5f - settings.level_offset));
    constexpr double kNextPixel = 3;
    return with_cell * length_px(inputs, 1.0f, view_depth) * reach + kNextPixel;
}

Explanation explain_gtao(const AoInputs& inputs, const GtaoSettings& settings, int x, int y) {
    validate(settings);
    return explain_texel(GtaoKernel(inputs, settings, {.threads = 1}), settings, x, y);
}

}  // namespace crevice
