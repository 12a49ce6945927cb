#include "ssao/methods/method.h"

#include <utility>

namespace crevice {

std::vector<Parameter<MethodSettings>> parameters_of(const Method& method) {
    std::vector<Parameter<MethodSettings>> all = within<MethodSettings>(
        method.parameters, [](auto& settings) -> auto& { return settings.ao; });
    for (auto& parameter : within<MethodSettings>(
             method.denoiser.parameters, [](auto& settings) -> auto& { return settings.denoiser; }))
        all.push_back(std::move(parameter));
    return all;
}

MethodSettings defaults_of(const Method& method, float length_unit) {
    MethodSettings settings{method.defaults, method.denoiser.defaults};
    for (const Parameter<MethodSettings>& parameter : parameters_of(method)) {
        if (parameter.unit == kSceneUnit)
            parameter.set(settings, parameter.get(settings) * static_cast<double>(length_unit));
    }
    return settings;
}

void validate(const Method& method, const MethodSettings& settings) {
    if (method.validate) method.validate(settings.ao);
    if (method.denoiser.validate) method.denoiser.validate(settings.denoiser);
}

std::optional<double> value_of(const Method& method, const MethodSettings& settings,
                               const std::string& name) {
    // Asked for several times a frame: without parameters_of(), which copies all that is told of each.
    for (const auto& parameter : method.parameters) {
        if (parameter.name == name) return parameter.get(settings.ao);
    }
    for (const auto& parameter : method.denoiser.parameters) {
        if (parameter.name == name) return parameter.get(settings.denoiser);
    }
    return std::nullopt;
}

MethodSettings with_value(const Method& method, MethodSettings settings, const std::string& name,
                          double value) {
    for (const Parameter<MethodSettings>& parameter : parameters_of(method)) {
        if (parameter.name == name) parameter.set(settings, value);
    }
    return settings;
}

Image3 bent_normals(const Method& method, const AoInputs& inputs, const MethodSettings& settings,
                    const Run& run) {
    Image3 directions = method.bent_normals(inputs, settings.ao, run);
    if (!method.denoiser.directions) return directions;
    return method.denoiser.directions(directions, inputs, settings.denoiser, run);
}

AoMap denoised(const Method& method, const RawAo& raw, const MethodSettings& settings, const Run& run) {
    if (method.denoiser.denoised) return method.denoiser.denoised(raw, settings.denoiser, run);
    return {raw.ao, raw.tiles};
}

}  // namespace crevice
