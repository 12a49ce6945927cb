#include "chapters/terminal/shell_word.h"

#include <algorithm>
#include <cctype>
#include <string_view>

namespace crevice {

std::string shell_word(const std::string& word) {
    constexpr std::string_view kHarmless = "_.,=:/+-";
    const bool harmless = !word.empty() && std::all_of(word.begin(), word.end(), [&](char c) {
        return std::isalnum(static_cast<unsigned char>(c)) != 0 || kHarmless.find(c) != kHarmless.npos;
    });
    if (harmless) return word;
    std::string quoted = "'";
    for (const char c : word) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return quoted + "'";
}

}  // namespace crevice
