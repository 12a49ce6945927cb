#include "chapters/frame/parameter_kinds.h"

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

}  // namespace

const Choices<BufferFormat>& format_choices() {
    static const Choices<BufferFormat> choices = {{"float32", BufferFormat::float32},
                                                  {"float16", BufferFormat::float16_toward_zero},
                                                  {"float16_nearest", BufferFormat::float16_nearest_even}};
    return choices;
}

Parameter number(const char* name, const char* range, const char* unit, const char* effect,
                 MemberOf<float> member) {
    const auto set = [=](MethodSettings& s, const std::string& word) {
        member(s) = static_cast<float>(parse_number(name, word));
    };
    const auto get = [=](const MethodSettings& s) {
        MethodSettings copy = s;
        return text_of(static_cast<double>(member(copy)));
    };
    return {name, range, unit, effect, set, get};
}

Parameter whole(const char* name, long long lowest, long long highest, const char* effect,
                void (*set)(MethodSettings&, long long), long long (*get)(const MethodSettings&)) {
    const auto read = [=](MethodSettings& s, const std::string& word) {
        set(s, parse_whole(name, word, lowest, highest));
    };
    const auto write = [=](const MethodSettings& s) { return std::to_string(get(s)); };
    return {name, std::to_string(lowest) + ".." + std::to_string(highest), "-", effect, read, write};
}

Parameter yes_no(const char* name, const char* effect, MemberOf<bool> member) {
    return choice<bool>(name, "true|false", effect, member,
                        {{"false", false}, {"true", true}, {"0", false}, {"1", true}});
}

void throw_no_such_choice(const std::string& name, const std::string& word, const std::string& range) {
    throw UsageError(name + ": no such choice (" + word + "); give one of " + range);
}

}  // namespace crevice
