#include "chapters/study/error_settings.h"

namespace crevice {

namespace {

std::vector<ErrorSetting> every(const std::vector<int>& samples, const std::vector<float>& scales,
                                const std::vector<int>& blurs, const std::vector<bool>& formats) {
    std::vector<ErrorSetting> settings;
    for (const bool half_floats : formats) {
        for (const float scale : scales) {
            for (const int blur : blurs) {
                for (const int count : samples) settings.push_back({count, scale, blur, half_floats});
            }
        }
    }
    return settings;
}

}  // namespace

std::string setting_name(const ErrorSetting& s) {
    const auto counted = [](int count, const std::string& what) {
        return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
    };
    return counted(s.samples, "sample") + (s.ao_scale < 1 ? ", half size, " : ", full size, ") +
           counted(s.blur_iterations, "blur") + (s.half_floats ? ", float16" : ", float32");
}

MethodSettings settings_of(const Method& method, const ErrorSetting& setting, float length_unit,
                           std::uint32_t seed) {
    MethodSettings settings = settings_of(method, {}, length_unit);
    settings.ao.samples = setting.samples;
    settings.ao.ao_scale = setting.ao_scale;
    settings.ao.seed = seed;
    settings.blur.iterations = setting.blur_iterations;
    if (setting.half_floats) {
        settings.buffers.buffer_format = BufferFormat::float16_toward_zero;
        settings.ao.format = settings.blur.format = BufferFormat::float16_toward_zero;
    }
    return settings;
}

ErrorSetting default_setting(const Method& method) {
    return {method.defaults.ao.samples, method.defaults.ao.ao_scale, method.defaults.blur.iterations, false};
}

ErrorPlan full_error_plan() {
    ErrorPlan plan;
    plan.settings = every({1, 2, 4, 7, 10, 14}, {0.5f, 1}, {0, 1, 2, 3, 4}, {false, true});
    plan.cast_rays = {1, 2, 4, 8, 16, 32, 64, 128, 256};
    plan.vertex_rays = {32, 256};
    return plan;
}

ErrorPlan quick_error_plan() {
    ErrorPlan plan;
    plan.size = {320, 180};
    plan.settings = every({1, 4, 14}, {0.5f, 1}, {0, 2, 4}, {false});
    plan.settings.push_back({kCubeVectors, 0.5f, 4, true});
    plan.cast_rays = {1, 4, 16, 64};
    plan.vertex_rays = {32};
    plan.rounds = 9;
    plan.slow_rounds = 3;
    plan.reference_rays = 256;
    plan.limit_seeds = 128;
    return plan;
}

}  // namespace crevice
