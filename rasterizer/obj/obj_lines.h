// The lines and words of an OBJ's or MTL's text.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace crevice {

// One logical line after another: lines end in LF, CRLF or CR, and a backslash at the end joins a line to the
// next one (not in a comment). After advance() returned true, `text` is the line and `line` the number of its
// first physical line, counted from that of the text.
struct LogicalLines {
    explicit LogicalLines(std::string_view whole_text, std::size_t first_line = 1)
        : rest(whole_text), next_line(first_line) {}

    bool advance();  // false: there are no more

    std::string_view text;
    std::size_t line = 0;

 private:
    std::string_view take_physical();

    std::string_view rest;
    std::size_t next_line;
    // Length of the rest with its first LF, or 1 more than its own; 0: not looked for.
    std::size_t to_feed = 0;
    std::string joined;  // backs `text` where lines were joined
};

// Space, tab, NUL, VT and FF. Most characters are none, and found to be so at the first look.
inline bool is_blank(char c) {
    return c <= ' ' && (c == ' ' || c == '\t' || c == '\0' || c == '\v' || c == '\f');
}

// Takes the next word off the front of `rest`; empty at the end and at a comment.
std::string_view take_word(std::string_view& rest);

// `text` without blanks at both ends.
std::string_view trimmed(std::string_view text);

// `text` up to a comment: a # at its start or behind a blank; without blanks at both ends.
std::string_view without_comment(std::string_view text);

// `name` without the quotes around it, if there are any.
std::string_view without_quotes(std::string_view name);

// ASCII letters made small, as keywords are compared.
std::string lower_case(std::string_view text);

}  // namespace crevice
