// The kinds of parameters there are: each names a member of MethodSettings and says how a word becomes its
// value.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "chapters/frame/methods.h"

namespace crevice {

// The tables of which parameters_of() is made: of the AO map and its blur, of the buffers before them and of
// the drawing after them.
std::vector<Parameter> ao_parameters();
std::vector<Parameter> artifact_parameters();
std::vector<Parameter> blur_parameters();
std::vector<Parameter> buffer_parameters();
std::vector<Parameter> lit_parameters();

template <class T>
using MemberOf = T& (*)(MethodSettings&);
template <class T>
using Choices = std::vector<std::pair<std::string, T>>;

inline constexpr const char* kFormatRange = "float32|float16|float16_nearest";
// How buffers are stored, as the range above has it.
const Choices<BufferFormat>& format_choices();

// A member that is a number in that range.
Parameter number(const char* name, const char* range, const char* unit, const char* effect,
                 MemberOf<float> member);
// One that is a whole number in [lowest, highest].
Parameter whole(const char* name, long long lowest, long long highest, const char* effect,
                void (*set)(MethodSettings&, long long), long long (*get)(const MethodSettings&));
// True or false; 1 and 0 are understood.
Parameter yes_no(const char* name, const char* effect, MemberOf<bool> member);

// In which order positions are multiplied.
Parameter position_order(const char* name, const char* effect, MemberOf<PositionOrder> member);

// Throws UsageError.
[[noreturn]] void throw_no_such_choice(const std::string& name, const std::string& word,
                                       const std::string& range);

// One of a few words, which `range` lists.
template <class T>
Parameter choice(const char* name, const char* range, const char* effect, MemberOf<T> member,
                 Choices<T> choices) {
    const auto set = [=](MethodSettings& s, const std::string& word) {
        for (const auto& [text, value] : choices) {
            if (text == word) {
                member(s) = value;
                return;
            }
        }
        throw_no_such_choice(name, word, range);
    };
    const auto get = [=](const MethodSettings& s) {
        MethodSettings copy = s;
        for (const auto& [text, value] : choices) {
            if (member(copy) == value) return text;
        }
        return std::string("custom");
    };
    return {name, range, "-", effect, set, get};
}

}  // namespace crevice
