#include "chapters/notebook/code_listing.h"

#include <algorithm>
#include <cctype>
#include <vector>

#include "rasterizer/base/error.h"

namespace crevice {

namespace {

bool is_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

// The source with comments, strings and characters blanked out, so that braces in them do not count. Of the same
// length.
std::string code_only(std::string_view source) {
    std::string code(source);
    const auto blank = [&code](std::size_t from, std::size_t to) {
        for (std::size_t i = from; i < std::min(to, code.size()); ++i) {
            if (code[i] != '\n') code[i] = ' ';
        }
    };
    for (std::size_t i = 0; i < source.size(); ++i) {
        std::size_t end = i;
        if (source.substr(i).starts_with("//")) {
            end = std::min(source.find('\n', i), source.size());
        } else if (source.substr(i).starts_with("/*")) {
            end = std::min(source.find("*/", i), source.size() - 2) + 2;
        } else if (source.substr(i).starts_with("R\"(")) {
            end = std::min(source.find(")\"", i), source.size() - 2) + 2;
        } else if (source[i] == '"' || (source[i] == '\'' && (i == 0 || !is_word(source[i - 1])))) {
            end = i + 1;
            while (end < source.size() && source[end] != source[i]) end += source[end] == '\\' ? 2 : 1;
            ++end;
        } else {
            continue;
        }
        blank(i, end);
        i = end - 1;
    }
    return code;
}

// One past the brace that closes the one at `open`.
std::size_t end_of_body(const std::string& code, std::size_t open) {
    int depth = 0;
    for (std::size_t i = open; i < code.size(); ++i) {
        if (code[i] == '{') ++depth;
        if (code[i] == '}' && --depth == 0) return i + 1;
    }
    return code.npos;
}

// Where the body begins of what is named at `name`; npos where that is a call or a declaration.
std::size_t body_of(const std::string& code, std::size_t name, std::size_t length) {
    int parentheses = 0;
    const std::size_t first = code.find_first_not_of(" \n", name + length);
    if (first == code.npos || std::string_view("({:=").find(code[first]) == std::string_view::npos)
        return code.npos;
    for (std::size_t i = first; i < code.size(); ++i) {
        if (code[i] == '(') ++parentheses;
        if (code[i] == ')' && --parentheses < 0) return code.npos;
        if (parentheses > 0) continue;
        if (code[i] == '{') return i;
        if (code[i] == ';' || code[i] == '}') return code.npos;
        // After the parameters of a call something else than a body follows.
        if (code[i] == ',' || code[i] == '+' || code[i] == '?' || code[i] == '.') return code.npos;
    }
    return code.npos;
}

std::vector<std::string> lines_of(std::string_view text) {
    std::vector<std::string> lines(1);
    for (const char c : text) {
        if (c == '\n') {
            lines.emplace_back();
        } else {
            lines.back() += c;
        }
    }
    if (lines.back().empty()) lines.pop_back();
    return lines;
}

bool belongs_above(const std::string& line) {
    const std::size_t first = line.find_first_not_of(' ');
    return first != line.npos &&
           (line.compare(first, 2, "//") == 0 || line.compare(first, 8, "template") == 0);
}

std::string unindented(const std::vector<std::string>& lines, std::size_t first, std::size_t last) {
    std::size_t shared = std::string::npos;
    for (std::size_t i = first; i <= last; ++i) shared = std::min(shared, lines[i].find_first_not_of(' '));
    std::string text;
    for (std::size_t i = first; i <= last; ++i)
        text += (lines[i].size() > shared ? lines[i].substr(shared) : "") + "\n";
    return text;
}

}  // namespace

CodeListing code_listing(std::string_view source, const std::string& file, const std::string& symbol) {
    const std::string code = code_only(source);
    for (std::size_t at = code.find(symbol); at != code.npos; at = code.find(symbol, at + 1)) {
        if ((at > 0 && is_word(code[at - 1])) || is_word(code[at + symbol.size()])) continue;
        const std::size_t open = body_of(code, at, symbol.size());
        if (open == code.npos) continue;
        const std::size_t end = end_of_body(code, open);
        if (end == code.npos) continue;
        const auto line_of = [&source](std::size_t place) {
            return static_cast<std::size_t>(
                std::count(source.begin(), source.begin() + static_cast<std::ptrdiff_t>(place), '\n'));
        };
        const std::vector<std::string> lines = lines_of(source);
        std::size_t first = line_of(at);
        while (first > 0 && belongs_above(lines[first - 1])) --first;
        return {file, symbol, static_cast<int>(first) + 1, unindented(lines, first, line_of(end - 1))};
    }
    throw UsageError(file + ": nothing of this name is defined there (" + symbol + "); name one that is");
}

CodeListing part_of(const CodeListing& listing, const std::string& from, const std::string& to) {
    const std::vector<std::string> lines = lines_of(listing.code);
    const auto line_with = [&](const std::string& words, std::size_t start) {
        for (std::size_t i = start; i < lines.size(); ++i) {
            if (lines[i].find(words) != std::string::npos) return i;
        }
        throw UsageError(listing.file + ": " + listing.symbol + " has no such line (" + words +
                         "); quote one that it has");
    };
    const std::size_t first = line_with(from, 0), last = line_with(to, first);
    return {listing.file, listing.symbol, listing.first_line + static_cast<int>(first),
            unindented(lines, first, last)};
}

}  // namespace crevice
