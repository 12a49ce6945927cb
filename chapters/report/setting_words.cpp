#include "chapters/report/setting_words.h"

#include <algorithm>
#include <cmath>

#include "chapters/terminal/number_text.h"

namespace crevice {

namespace {

// A whole count in words, or nothing.
std::optional<std::string> count_words(const std::string& value, const std::string& word) {
    const std::optional<double> number = number_in(value);
    if (!number || *number != static_cast<double>(static_cast<long long>(*number))) return std::nullopt;
    return *number == 0 ? "no " + word : counted(static_cast<long long>(*number), word);
}

std::string parameter_phrase(const std::string& name, const std::string& value) {
    if (name == "samples") {
        if (const auto words = count_words(value, "sample")) return *words;
    }
    if (name == "blur_iterations") {
        if (const auto words = count_words(value, "blur")) return *words;
    }
    if (name == "ao_scale" && number_in(value) == 1.0) return "full size";
    if (name == "ao_scale" && number_in(value) == 0.5) return "half size";
    return name + " " + value;
}

}  // namespace

std::string setting_words(const SweepSetting& setting) {
    std::string words;
    for (const auto& [name, value] : setting.parameters)
        words += (words.empty() ? "" : ", ") + parameter_phrase(name, value);
    return words.empty() ? "defaults" : words;
}

std::string setting_phrase(const SweepSetting& setting) {
    if (setting.parameters.empty()) return setting.method + " with its defaults";
    std::vector<std::string> with;
    std::string at;
    for (const auto& [name, value] : setting.parameters) {
        const std::string words = parameter_phrase(name, value);
        if (words.ends_with(" size")) {
            at = " at " + words;
        } else {
            with.push_back(words);
        }
    }
    return setting.method + (with.empty() ? "" : " with " + listed(with)) + at;
}

SweepSetting without(SweepSetting setting, const std::string& parameter) {
    std::erase_if(setting.parameters, [&](const auto& known) { return known.first == parameter; });
    return setting;
}

std::string view_words(const SweepView& view) {
    return view.scene + (view.camera.empty() ? "" : " " + view.camera) + ", " + size_text(view.size);
}

std::string margin_words(double margin) {
    return std::isfinite(margin) ? decimal_text(margin, 4) : "unknown";
}

std::string listed(const std::vector<std::string>& words) {
    std::string list;
    for (std::size_t i = 0; i < words.size(); ++i) {
        if (i > 0) list += i + 1 == words.size() ? " and " : ", ";
        list += words[i];
    }
    return list;
}

std::string as_code(const std::string& text) {
    std::string code = text;
    std::replace(code.begin(), code.end(), '`', '\'');
    return "`" + code + "`";
}

std::string escaped_markdown(const std::string& text) {
    constexpr std::string_view kMarks = "\\`*_[]<>&$~|#";
    std::string escaped;
    for (const char c : text) {
        if (kMarks.find(c) != kMarks.npos) escaped += '\\';
        escaped += c;
    }
    return escaped;
}

}  // namespace crevice
