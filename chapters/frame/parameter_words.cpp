#include "chapters/frame/parameter_words.h"

#include <algorithm>
#include <iomanip>
#include <sstream>

#include "chapters/terminal/parse.h"
#include "rasterizer/base/error.h"

namespace crevice {

namespace {

std::string text_of(double value) {
    std::ostringstream text;
    text << std::setprecision(7) << value;
    return text.str();
}

double value_from_word(const Parameter<FrameSettings>& p, const std::string& word) {
    switch (p.kind) {
        case ParameterKind::number: return parse_number(p.name, word);
        case ParameterKind::whole: return static_cast<double>(parse_whole(p.name, word, p.lowest, p.highest));
        case ParameterKind::yes_no: return parse_yes_no(p.name, word) ? 1 : 0;
        case ParameterKind::choice: break;
    }
    const auto found = std::find(p.choices.begin(), p.choices.end(), word);
    if (found == p.choices.end())
        throw UsageError(p.name + ": no such choice (" + word + "); give one of " + p.range);
    return static_cast<double>(found - p.choices.begin());
}

}  // namespace

void set_from_word(const Parameter<FrameSettings>& parameter, FrameSettings& settings,
                   const std::string& word) {
    parameter.set(settings, value_from_word(parameter, word));
}

std::string word_of(const Parameter<FrameSettings>& parameter, const FrameSettings& settings) {
    const double value = parameter.get(settings);
    switch (parameter.kind) {
        case ParameterKind::number: return text_of(value);
        case ParameterKind::whole: return std::to_string(static_cast<long long>(value));
        case ParameterKind::yes_no: return value != 0 ? "true" : "false";
        case ParameterKind::choice: break;
    }
    return value < 0 ? "custom" : parameter.choices[static_cast<std::size_t>(value)];
}

}  // namespace crevice
