// Words of the command line as values. Each throws UsageError "FLAG: what is wrong (word); what to do" for
// anything that is not exactly what it should be: trailing junk, NaN, infinities and numbers out of range are
// never accepted.
#pragma once

#include <initializer_list>
#include <string>
#include <utility>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "rasterizer/base/error.h"
#include "rasterizer/base/image.h"

namespace crevice {

// A member of a library's settings, and the flag that sets it.
struct MemberFlag {
    const char* member;
    const char* flag;
};

// Calls body(). What it refuses with UsageError "MEMBER: ...", as libraries do, is refused as "FLAG: ..."; of
// a member that is not listed it is refused as the library said it.
template <class Body>
auto named_as(std::initializer_list<MemberFlag> flags, const Body& body) {
    try {
        return body();
    } catch (const UsageError& error) {
        const std::string message = error.what();
        const std::size_t colon = message.find(": ");
        for (const auto& [member, flag] : flags) {
            if (message.substr(0, colon) == member) throw UsageError(flag + message.substr(colon));
        }
        throw;
    }
}

double parse_number(const std::string& flag, const std::string& word);
long long parse_whole(const std::string& flag, const std::string& word, long long lowest, long long highest);
// "true", "false", "1" or "0".
bool parse_yes_no(const std::string& flag, const std::string& word);
// The value that one of a few words stands for.
template <class T>
T parse_choice(const std::string& flag, const std::string& word,
               const std::vector<std::pair<const char*, T>>& choices) {
    std::string known;
    for (const auto& [name, value] : choices) {
        if (word == name) return value;
        known += std::string(known.empty() ? "" : " or ") + name;
    }
    throw UsageError(flag + ": no such choice (" + word + "); give " + known);
}
// "x,y,z"
glm::dvec3 parse_point(const std::string& flag, const std::string& word);
// "X,Y"
glm::ivec2 parse_pixel(const std::string& flag, const std::string& word);
// "WxH", each in 1..kLargestSide, together small enough to be addressed and for the buffers of a frame to find
// room in this machine's memory.
inline constexpr int kLargestSide = 32767;  // what a PNG can hold
Size parse_size(const std::string& flag, const std::string& word);

}  // namespace crevice
