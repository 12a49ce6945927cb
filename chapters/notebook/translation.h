// The Chinese text of a chapter (chapters/zh/NN_topic.md), made cell by cell from the English one:
//
//     <!-- cell NAME HASH -->          prose of the cell NAME, translated from a text of this hash
//     中文……
//
//     <!-- text ENGLISH -->            a caption, a claim, a heading of a table, an axis
//     中文……
//
// A text whose English has changed since is not shown: its hash, or itself, is no longer found.
#pragma once

#include <map>
#include <string>
#include <string_view>

namespace crevice {

struct Translation {
    struct Prose {
        std::string hash;  // text_hash() of the English it was made from
        std::string chinese;
    };
    std::map<std::string, Prose> cells;        // by the cell's name
    std::map<std::string, std::string> texts;  // by the English text
};

// Throws UsageError, naming file and line, for a text before the first heading and for a heading of another form.
Translation translation_from(std::string_view markdown, const std::string& file);

// Chinese knows no spaces, which is what a page makes of the end of a line: lines that end and go on in Chinese are joined.
std::string chinese_lines_joined(const std::string& text);

// Eight hex digits that change with the text.
std::string text_hash(std::string_view text);

}  // namespace crevice
