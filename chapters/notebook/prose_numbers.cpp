#include "chapters/notebook/prose_numbers.h"

#include <algorithm>
#include <cctype>
#include <functional>

#include "rasterizer/base/error.h"

namespace crevice {

namespace {

bool is_name(std::string_view text) {
    return !text.empty() && std::all_of(text.begin(), text.end(), [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_';
    });
}

// The end of what stands between equal marks (one or two $, any number of `), marks included; `at` + 1 where nothing
// closes it.
std::size_t end_of_span(std::string_view text, std::size_t at) {
    const char mark = text[at];
    std::size_t length = 0;
    while (at + length < text.size() && text[at + length] == mark) ++length;
    const std::size_t close = text.find(text.substr(at, length), at + length);
    return close == text.npos ? at + length : close + length;
}

// The text with what `number_of` says in place of every name.
std::string replaced(std::string_view text, const std::function<std::string(const std::string&)>& number_of) {
    std::string result;
    for (std::size_t at = 0; at < text.size();) {
        std::size_t end = at + 1;
        if (text[at] == '`') {
            end = end_of_span(text, at);
        } else if (text[at] == '$') {
            end = end_of_span(text, at);
            const std::string_view mathematics = text.substr(at, end - at);
            for (std::size_t i = 0; i < mathematics.size();) {
                const std::size_t close = mathematics.find("}}", i);
                const bool opens = mathematics.substr(i).starts_with("{{") && close != text.npos;
                const std::string name(opens ? mathematics.substr(i + 2, close - i - 2) : "");
                result += is_name(name) ? number_of(name) : std::string(1, mathematics[i]);
                i = is_name(name) ? close + 2 : i + 1;
            }
            at = end;
            continue;
        } else if (text[at] == '{') {
            const std::size_t close = text.find('}', at);
            const std::string name(close == text.npos ? "" : text.substr(at + 1, close - at - 1));
            if (is_name(name)) {
                result += number_of(name);
                at = close + 1;
                continue;
            }
        }
        result += text.substr(at, end - at);
        at = end;
    }
    return result;
}

}  // namespace

std::string with_numbers(std::string_view markdown, const ProseNumbers& numbers) {
    std::string missing;
    std::string text = replaced(markdown, [&](const std::string& name) {
        const auto found = numbers.find(name);
        if (found == numbers.end()) missing += (missing.empty() ? "" : ", ") + name;
        return found == numbers.end() ? "" : found->second;
    });
    if (!missing.empty())
        throw UsageError("the prose names numbers that no cell before it makes (" + missing +
                         "); make them with number()");
    return text;
}

std::string numbers_taken_out(std::string_view text, ProseNumbers& numbers) {
    std::string result;
    const auto is_digit = [text](std::size_t at) {
        return at < text.size() && std::isdigit(static_cast<unsigned char>(text[at])) != 0;
    };
    for (std::size_t at = 0; at < text.size();) {
        const bool minus = text[at] == '-' && is_digit(at + 1) && (at == 0 || text[at - 1] == ' ');
        std::size_t end = at + (minus ? 1 : 0);
        if (!is_digit(end)) {
            result += text[at++];
            continue;
        }
        // A point ends a sentence, and an e begins a word, where no digit follows.
        while (is_digit(end) || (text.substr(end).starts_with('.') && is_digit(end + 1))) ++end;
        const bool exponent = text.substr(end).starts_with("e+") || text.substr(end).starts_with("e-");
        if (exponent && is_digit(end + 2)) end += 2;
        while (is_digit(end)) ++end;
        const std::string name = std::to_string(numbers.size() + 1);
        numbers[name] = text.substr(at, end - at);
        result += "{" + name + "}";
        at = end;
    }
    return result;
}

std::vector<std::string> numbers_named(std::string_view markdown) {
    std::vector<std::string> names;
    replaced(markdown, [&names](const std::string& name) {
        names.push_back(name);
        return name;
    });
    return names;
}

}  // namespace crevice
