#include "chapters/lab/catalogue.h"

#include "chapters/frame/parameter_words.h"
#include "chapters/frame/presets.h"
#include "scenes/builtin_scenes.h"
#include "ssao/needs.h"

namespace crevice {

namespace {

using Json = nlohmann::ordered_json;

const char* kind_name(ParameterKind kind) {
    switch (kind) {
        case ParameterKind::number: return "number";
        case ParameterKind::whole: return "whole";
        case ParameterKind::yes_no: return "yes_no";
        case ParameterKind::choice: break;
    }
    return "choice";
}

// A history takes frames before this one, and the lab draws single frames: its parameters are not offered.
Json parameters_json(const Method& method) {
    const FrameSettings defaults = settings_of(method);
    Json list = Json::array();
    const auto add = [&](const char* part, const std::vector<Parameter<FrameSettings>>& parameters) {
        for (const Parameter<FrameSettings>& p : parameters) {
            list.push_back({{"name", p.name},
                            {"kind", kind_name(p.kind)},
                            {"range", p.range},
                            {"unit", p.unit},
                            {"effect", p.effect},
                            {"default", word_of(p, defaults)},
                            {"part", part}});
        }
    };
    const auto of_frame = [](const std::vector<Parameter<AnySettings>>& parameters, auto member) {
        return within<FrameSettings>(
            parameters, [member](auto& settings) -> auto& { return settings.method.*member; });
    };
    add("method", of_frame(method.parameters, &MethodSettings::ao));
    add("denoiser", of_frame(method.denoiser.parameters, &MethodSettings::denoiser));
    add("buffers", buffer_parameters());
    add("light", lit_parameters());
    return list;
}

}  // namespace

Json lab_catalogue() {
    Json scenes = Json::array(), presets_json = Json::array(), methods = Json::array();
    for (const BuiltinScene& scene : builtin_scenes())
        scenes.push_back({{"name", scene.name}, {"purpose", scene.purpose}, {"unit", scene.unit}});
    for (const Preset& preset : presets()) {
        presets_json.push_back({{"name", preset.name},
                                {"title", preset.title},
                                {"scene", preset.scene},
                                {"method", preset.method},
                                {"params", preset.words}});
    }
    for (const Method& method : ao_methods()) {
        methods.push_back({{"name", method.name},
                           {"title", method.title},
                           {"source", method.source},
                           {"computes_ao", method.computes_ao()},
                           {"bent_normals", method.bent_normals != nullptr},
                           {"parameters", parameters_json(method)}});
    }
    return {
        {"scenes", scenes}, {"presets", presets_json}, {"buffer_names", kBufferNames}, {"methods", methods}};
}

}  // namespace crevice
