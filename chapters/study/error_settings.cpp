#include "chapters/study/error_settings.h"
#include "rasterizer/base/float_text.h"

#include <algorithm>

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

FrameSettings settings_of(const Method& method, const ErrorSetting& setting, float length_unit,
                          std::uint32_t seed) {
    std::vector<std::pair<std::string, std::string>> words = {
        {"samples", std::to_string(setting.samples)},
        {"ao_scale", shortest_text(setting.ao_scale)},
        {"blur_iterations", std::to_string(setting.blur_iterations)},
        {"seed", std::to_string(seed)}};
    if (setting.half_floats)
        words.insert(words.end(), {{"buffer_format", "float16"}, {"ao_format", "float16"}});
    const std::vector<Parameter<FrameSettings>> known = frame_parameters(method);
    std::vector<std::string> assignments;
    for (const auto& [name, word] : words) {
        const bool has = std::any_of(known.begin(), known.end(), [&, &name = name](const auto& parameter) {
            return parameter.name == name;
        });
        if (has) assignments.push_back(name + "=" + word);
    }
    return settings_of(method, assignments, length_unit);
}

ErrorSetting default_setting(const Method& method) {
    const auto own = [&](const char* name, double otherwise) {
        return value_of(method, defaults_of(method), name).value_or(otherwise);
    };
    return {static_cast<int>(own("samples", 1)), static_cast<float>(own("ao_scale", 1)),
            static_cast<int>(own("blur_iterations", 0)), false};
}

ErrorPlan full_error_plan(const Method& method) {
    ErrorPlan plan;
    plan.settings = every(method.samples_to_try, {0.5f, 1}, {0, 1, 2, 3, 4}, {false, true});
    plan.cast_rays = {1, 2, 4, 8, 16, 32, 64, 128, 256};
    plan.vertex_rays = {32, 256};
    return plan;
}

ErrorPlan quick_error_plan(const Method& method) {
    const std::vector<int>& samples = method.samples_to_try;
    ErrorPlan plan;
    plan.size = {320, 180};
    plan.settings = every({samples.front(), samples[(samples.size() - 1) / 2], samples.back()}, {0.5f, 1},
                          {0, 2, 4}, {false});
    plan.settings.push_back({samples.back(), 0.5f, 4, true});
    plan.cast_rays = {1, 4, 16, 64};
    plan.vertex_rays = {32};
    plan.rounds = 9;
    plan.slow_rounds = 3;
    plan.reference_rays = 256;
    plan.limit_seeds = 128;
    return plan;
}

}  // namespace crevice
