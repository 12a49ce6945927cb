#include "chapters/frame/frame_settings.h"

#include <algorithm>
#include <iomanip>
#include <ostream>
#include <utility>

#include "chapters/frame/parameter_words.h"
#include "rasterizer/base/no_such.h"

namespace crevice {

std::vector<Parameter<FrameSettings>> frame_parameters(const Method& method) {
    std::vector<Parameter<FrameSettings>> all = within<FrameSettings>(
        parameters_of(method), [](auto& settings) -> auto& { return settings.method; });
    for (std::vector<Parameter<FrameSettings>> around :
         {buffer_parameters(), history_parameters(), lit_parameters()}) {
        for (Parameter<FrameSettings>& parameter : around) all.push_back(std::move(parameter));
    }
    return all;
}

FrameSettings settings_of(const Method& method, const std::vector<std::string>& assignments,
                          float length_unit) {
    const std::vector<Parameter<FrameSettings>> parameters = frame_parameters(method);
    FrameSettings settings;
    settings.method = defaults_of(method, length_unit);
    for (const std::string& assignment : assignments) {
        const std::size_t equals = assignment.find('=');
        if (equals == std::string::npos)
            throw UsageError("--param: no value (" + assignment + "); write name=value");
        const std::string name = assignment.substr(0, equals);
        std::vector<std::string> known;
        const Parameter<FrameSettings>* found = nullptr;
        for (const Parameter<FrameSettings>& parameter : parameters) {
            known.push_back(parameter.name);
            if (name == parameter.name) found = &parameter;
        }
        if (found == nullptr)
            throw no_such("--param", std::string("parameter of ") + method.name, name, known);
        set_from_word(*found, settings, assignment.substr(equals + 1));
    }
    validate(method, settings.method);
    validate(settings.history);
    return settings;
}

MethodSettings reseeded(const Method& method, const MethodSettings& settings, int frame) {
    const std::optional<double> seed = value_of(method, settings, "seed");
    if (!seed) return settings;
    const auto next = static_cast<std::uint32_t>(*seed) + static_cast<std::uint32_t>(frame);
    return with_value(method, settings, "seed", next);
}

void print_methods(std::ostream& out) {
    constexpr int kNames = 12;
    for (const Method& method : ao_methods()) {
        out << std::left << std::setw(kNames) << method.name << method.title << "\n"
            << std::string(kNames, ' ') << method.source << "\n";
    }
}

void print_parameters(std::ostream& out, const Method& method) {
    constexpr int kGap = 2;
    using P = Parameter<FrameSettings>;
    const std::vector<P> parameters = frame_parameters(method);
    const FrameSettings own = settings_of(method);
    const auto width_of = [&](const std::string& heading, const auto& text) {
        std::size_t width = heading.size();
        for (const P& p : parameters) width = std::max(width, std::string(text(p)).size());
        return static_cast<int>(width) + kGap;
    };
    const int names = width_of("parameter", [](const P&p) { return p.name; }),
              defaults = width_of("default", [&](const P&p) { return word_of(p, own); }),
              ranges = width_of("range", [](const P&p) { return p.range; }),
              units = width_of("unit", [](const P&p) { return p.unit; });
    const auto print_row = [&](const std::string& name, const std::string& value, const std::string& range,
                               const std::string& unit, const std::string& effect) {
        out << std::left << std::setw(names) << name << std::setw(defaults) << value << std::setw(ranges)
            << range << std::setw(units) << unit << effect << "\n";
    };
    print_row("parameter", "default", "range", "unit", "effect");
    for (const P& p : parameters) print_row(p.name, word_of(p, own), p.range, p.unit, p.effect);
}

}  // namespace crevice
