#include "rasterizer/obj/obj_lines.h"

#include <algorithm>

namespace crevice {
namespace {

// Whether a backslash joins the next line to this one. In a comment it is part of a path (`# C:\models\`).
bool is_continued(std::string_view physical) {
    return !physical.empty() && physical.back() == '\\' &&
           without_comment(physical).size() == trimmed(physical).size();
}

}  // namespace

bool LogicalLines::advance() {
    if (rest.empty()) return false;
    line = next_line;
    text = take_physical();
    if (!is_continued(text)) return true;
    joined.clear();
    while (is_continued(text)) {
        joined.append(text.substr(0, text.size() - 1)).push_back(' ');
        text = take_physical();
    }
    joined.append(text);
    text = joined;
    return true;
}

std::string_view LogicalLines::take_physical() {
    if (rest.empty()) return {};
    if (to_feed == 0) to_feed = std::min(rest.find('\n'), rest.size()) + 1;
    const std::string_view before_feed = rest.substr(0, to_feed - 1);
    const std::string_view physical = before_feed.substr(0, before_feed.find('\r'));
    const bool crlf = physical.size() + 1 == before_feed.size();
    const std::size_t taken = physical.size() + (crlf ? 2 : 1);
    rest.remove_prefix(std::min(taken, rest.size()));
    to_feed -= taken;
    ++next_line;
    return physical;
}

std::string_view take_word(std::string_view& rest) {
    std::size_t begin = 0;
    while (begin < rest.size() && is_blank(rest[begin])) ++begin;
    if (begin == rest.size() || rest[begin] == '#') return {};
    std::size_t end = begin;
    while (end < rest.size() && !is_blank(rest[end])) ++end;
    const std::string_view word = rest.substr(begin, end - begin);
    rest.remove_prefix(end);
    return word;
}

std::string_view trimmed(std::string_view text) {
    while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
    while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
    return text;
}

std::string_view without_comment(std::string_view text) {
    for (std::size_t at = 0; at < text.size(); ++at) {
        if (text[at] == '#' && (at == 0 || is_blank(text[at - 1]))) return trimmed(text.substr(0, at));
    }
    return trimmed(text);
}

std::string_view without_quotes(std::string_view name) {
    const bool quoted = name.size() >= 2 && name.front() == '"' && name.back() == '"';
    return quoted ? name.substr(1, name.size() - 2) : name;
}

std::string lower_case(std::string_view text) {
    std::string lower(text);
    for (char& c : lower) {
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    }
    return lower;
}

}  // namespace crevice
