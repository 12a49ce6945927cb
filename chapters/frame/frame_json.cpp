#include "chapters/frame/frame_json.h"

#include "chapters/frame/parameter_words.h"
#include "chapters/terminal/json_number.h"

namespace crevice {

using Json = nlohmann::ordered_json;

Json passes_json(const std::vector<PassTime>& passes) {
    Json list = Json::array();
    for (const PassTime& pass : passes) {
        list.push_back({{"name", pass.name},
                        {"wall_ms", pass.wall_ms},
                        {"cpu_ms", pass.cpu_ms},
                        {"wall_ms_mad", pass.wall_ms_mad},
                        {"runs", pass.runs}});
    }
    return list;
}

Json precision_json(const std::vector<PrecisionLoss>& losses) {
    Json counts = Json::object();
    for (const PrecisionLoss& loss : losses) counts[loss.name] = loss.count;
    return counts;
}

namespace {

Json value_json(const Parameter<FrameSettings>& parameter, const FrameSettings& settings) {
    const double value = parameter.get(settings);
    switch (parameter.kind) {
        case ParameterKind::number: return json_number(static_cast<float>(value));
        case ParameterKind::whole: return static_cast<long long>(value);
        case ParameterKind::yes_no: return value != 0;
        case ParameterKind::choice: break;
    }
    return word_of(parameter, settings);
}

}  // namespace

Json parameters_json(const Method& method, const FrameSettings& settings) {
    Json values = Json::object();
    for (const Parameter<FrameSettings>& p : frame_parameters(method))
        values[p.name] = value_json(p, settings);
    return values;
}

Json parameter_words_json(const FrameRequest& request) {
    Json words = Json::object();
    for (const Parameter<FrameSettings>& p : frame_parameters(*request.method))
        words[p.name] = word_of(p, request.settings);
    return words;
}

Json statistics_json(Size size, int components, const BufferStatistics& statistics) {
    Json shape = {size.height, size.width};
    if (components > 1) shape.push_back(components);
    return {{"shape", shape},          {"min", statistics.min}, {"max", statistics.max},
            {"mean", statistics.mean}, {"nan", statistics.nan}, {"inf", statistics.inf}};
}

}  // namespace crevice
