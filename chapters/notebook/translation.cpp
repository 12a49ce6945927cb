#include "chapters/notebook/translation.h"

#include <cstdint>
#include <cstdio>

#include "chapters/notebook/percent_format.h"
#include "rasterizer/base/error.h"

namespace crevice {

namespace {

constexpr std::string_view kOpen = "<!-- ", kClose = " -->";

}  // namespace

Translation translation_from(std::string_view markdown, const std::string& file) {
    Translation result;
    std::string* current = nullptr;
    for (int number = 1; !markdown.empty(); ++number) {
        const std::size_t end = markdown.find('\n');
        const std::string_view line = markdown.substr(0, end);
        markdown = end == markdown.npos ? std::string_view() : markdown.substr(end + 1);
        const auto fail = [&](const std::string& what) {
            throw UsageError(file + ":" + std::to_string(number) + ": " + what);
        };
        if (line.starts_with(kOpen) && line.ends_with(kClose)) {
            const std::string_view heading =
                line.substr(kOpen.size(), line.size() - kOpen.size() - kClose.size());
            const std::size_t word = heading.find(' '), hash = heading.rfind(' ');
            if (heading.starts_with("cell ") && hash > word) {
                auto& prose = result.cells[std::string(heading.substr(word + 1, hash - word - 1))];
                prose.hash = heading.substr(hash + 1);
                current = &prose.chinese;
            } else if (heading.starts_with("text ")) {
                current = &result.texts[std::string(heading.substr(word + 1))];
            } else {
                fail("not a heading (" + std::string(heading) + "); write cell NAME HASH or text ENGLISH");
            }
        } else if (current != nullptr) {
            *current += std::string(line) + "\n";
        } else if (!line.empty()) {
            fail("text before the first heading; begin with <!-- cell NAME HASH -->");
        }
    }
    const auto finish = [](std::string& text) {
        drop_empty_lines_around(text);
        text = chinese_lines_joined(text);
    };
    for (auto& [name, prose] : result.cells) finish(prose.chinese);
    for (auto& [english, chinese] : result.texts) finish(chinese);
    return result;
}

std::string chinese_lines_joined(const std::string& text) {
    std::string joined;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const auto byte = [&text](std::size_t at) { return static_cast<unsigned char>(text[at]); };
        const bool inside = text[i] == '\n' && i > 0 && i + 1 < text.size();
        if (inside && byte(i - 1) >= 0x80 && byte(i + 1) >= 0xe3) continue;
        joined += text[i];
    }
    return joined;
}

// FNV-1a of 32 bits: http://www.isthe.com/chongo/tech/comp/fnv/
std::string text_hash(std::string_view text) {
    std::uint32_t hash = 2166136261u;
    for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 16777619u;
    char digits[9];
    std::snprintf(digits, sizeof digits, "%08x", static_cast<unsigned>(hash));
    return digits;
}

}  // namespace crevice
