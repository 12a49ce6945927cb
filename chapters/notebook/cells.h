// What a notebook is made of: the cells of a chapter's source in their order, each with what it put out when it ran.
// The writers (terminal, HTML, Markdown, Jupyter) all read these.
#pragma once

#include <cstddef>
#include <string>
#include <variant>
#include <vector>

#include "chapters/notebook/code_listing.h"
#include "chapters/notebook/percent_format.h"
#include "chapters/notebook/picture.h"

namespace crevice {

enum class BookLanguage { en, zh, both };

// A text in the languages of the book; `zh` is empty where it has not been translated.
struct BookText {
    std::string en, zh;

    // The one to be read in this language, English where there is no other.
    const std::string& in(BookLanguage language) const {
        return language == BookLanguage::zh && !zh.empty() ? zh : en;
    }
    bool empty() const { return en.empty(); }
};

struct NotebookPicture {
    std::string name;  // the file is NAME.png
    Picture picture;
    std::string png;   // the file's bytes
    BookText caption;  // Markdown, one sentence or two; may be empty
    BookText about;    // plain text: its mapping and statistics
    // `crevice render` or `crevice probe` that shows it, too; pages lead from it into the lab; or empty.
    std::string command;
};
struct PictureOutput {
    enum class Layout {
        row,   // side by side, or one alone
        pair,  // two of one size, one on the other behind a slider
    };
    Layout layout = Layout::row;
    std::vector<NotebookPicture> pictures;
    BookText caption;  // of all together; Markdown, may be empty
};

// Frames one after the other, for who asks to see them move.
struct FilmOutput {
    std::string name;  // the file is NAME.webp
    Size size;
    int frames = 0;
    std::string webp;  // the file's bytes
    BookText caption;  // Markdown
};

// A diagram or a plot.
struct DrawingOutput {
    std::string name;  // the file is NAME.svg
    BookText svg;      // an <svg> that takes the page's colours
    BookText caption;  // Markdown
};

struct TableOutput {
    std::vector<BookText> header;             // plain text
    std::vector<std::vector<BookText>> rows;  // each as long as the header
    BookText caption;                         // Markdown, may be empty
};

struct CheckOutput {
    BookText claim;  // Markdown, a whole sentence
    bool ok = false;
    std::string detail;  // the numbers behind it, may be empty
};

struct ListingOutput {
    CodeListing listing;
    BookText caption;  // Markdown, may be empty
};

// What was typed at a prompt, `$` or `(gdb)`, and what was answered.
struct TranscriptOutput {
    std::string text;  // in lines, the prompts among them
    BookText caption;  // Markdown, may be empty
};

// Its lines without their newlines, and whether each was typed: after a prompt, or after a typed line that ends in a backslash.
struct TranscriptLine {
    std::string text;
    bool typed = false;
};
std::vector<TranscriptLine> lines_of(const TranscriptOutput& transcript);

// Whether every cell of a table's column reads as a number, so that it is set flush right.
bool is_numeric_column(const TableOutput& table, std::size_t column);

using Output = std::variant<PictureOutput, FilmOutput, DrawingOutput, TableOutput, CheckOutput, ListingOutput,
                            TranscriptOutput>;

struct NotebookCell {
    SourceCell source;
    BookText prose;  // of a prose cell: Markdown with its numbers filled in
    std::vector<Output> outputs;
};

}  // namespace crevice
