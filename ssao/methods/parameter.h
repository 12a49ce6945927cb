// A member of some settings by name, as a number: for a command line, a table or a slider, and for studies
// that set what methods have in common. Parameters that mean the same have the same name in every method:
// samples, radius, fade_start, fade_end, epsilon, exponent, bias, seed, blur_iterations, as_published, ao_scale.
#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "rasterizer/lanes/half.h"

namespace crevice {

enum class ParameterKind {
    number,
    whole,   // in [lowest, highest]
    yes_no,  // 1 or 0
    choice,  // an index into `choices`
};

// The unit of lengths. Defaults of that unit are multiplied by a scene's length_unit.
inline constexpr const char* kSceneUnit = "scene";

template <class S>
struct Parameter {
    std::string name, range, unit, effect;
    ParameterKind kind = ParameterKind::number;
    long long lowest = 0, highest = 0;    // of whole numbers
    std::vector<std::string> choices;     // of choices, the words for them
    std::function<double(const S&)> get;  // of a choice -1 where the member holds something else
    std::function<void(S&, double)> set;  // does not look at the range: validate() of the settings does
};

// A member that is a number; `range` is for reading.
template <class S>
Parameter<S> number(const char* name, const char* range, const char* unit, const char* effect,
                    float S::*member) {
    Parameter<S> p{name, range, unit, effect, ParameterKind::number, 0, 0, {}, {}, {}};
    p.get = [=](const S& s) { return static_cast<double>(s.*member); };
    p.set = [=](S& s, double value) { s.*member = static_cast<float>(value); };
    return p;
}

// A member that is a whole number in [lowest, highest].
template <class S, class T>
Parameter<S> whole(const char* name, long long lowest, long long highest, const char* effect, T S::*member) {
    const std::string range = std::to_string(lowest) + ".." + std::to_string(highest);
    Parameter<S> p{name, range, "-", effect, ParameterKind::whole, lowest, highest, {}, {}, {}};
    p.get = [=](const S& s) { return static_cast<double>(s.*member); };
    p.set = [=](S& s, double value) { s.*member = static_cast<T>(value); };
    return p;
}

template <class S>
Parameter<S> yes_no(const char* name, const char* effect, bool S::*member) {
    Parameter<S> p{name, "true|false", "-", effect, ParameterKind::yes_no, 0, 1, {}, {}, {}};
    p.get = [=](const S& s) { return s.*member ? 1.0 : 0.0; };
    p.set = [=](S& s, double value) { s.*member = value != 0; };
    return p;
}

// One of a few values, each with a word.
template <class T>
using Choices = std::vector<std::pair<std::string, T>>;

template <class S, class T>
Parameter<S> choice(const char* name, const char* effect, T S::*member, const Choices<T>& choices) {
    Parameter<S> p{name, "", "-", effect, ParameterKind::choice, 0, 0, {}, {}, {}};
    for (const auto& [word, value] : choices) {
        p.range += (p.range.empty() ? "" : "|") + word;
        p.choices.push_back(word);
    }
    p.get = [=](const S& s) {
        for (std::size_t i = 0; i < choices.size(); ++i) {
            if (s.*member == choices[i].second) return static_cast<double>(i);
        }
        return -1.0;
    };
    p.set = [=](S& s, double value) { s.*member = choices[static_cast<std::size_t>(value)].second; };
    return p;
}

template <class S>
Parameter<S> buffer_format(const char* name, const char* effect, BufferFormat S::*member) {
    return choice<S, BufferFormat>(name, effect, member,
                                   {{"float32", BufferFormat::float32},
                                    {"float16", BufferFormat::float16_toward_zero},
                                    {"float16_nearest", BufferFormat::float16_nearest_even}});
}

// The parameters of a part as parameters of the whole. `part_of` gives the part of a whole, const or not:
// [](auto& whole) -> auto& { return whole.part; }
template <class Whole, class Part, class PartOf>
std::vector<Parameter<Whole>> within(const std::vector<Parameter<Part>>& parameters, PartOf part_of) {
    std::vector<Parameter<Whole>> result;
    for (const Parameter<Part>& p : parameters) {
        result.push_back({p.name, p.range, p.unit, p.effect, p.kind, p.lowest, p.highest, p.choices,
                          [=, get = p.get](const Whole& whole) { return get(part_of(whole)); },
                          [=, set = p.set](Whole& whole, double value) { set(part_of(whole), value); }});
    }
    return result;
}

}  // namespace crevice
