#include "chapters/notebook/markdown_text.h"

#include "chapters/notebook/html.h"
#include "chapters/terminal/number_text.h"

namespace crevice {

namespace {

std::string paragraph(const BookText& text, BookLanguage language) {
    return text.empty() ? "" : text.in(language) + "\n\n";
}

std::string fenced(const std::string& code) {
    return "```cpp\n" + code + (code.ends_with('\n') ? "" : "\n") + "```\n\n";
}

// Plain text inside a table: no tags, and no end of a cell.
std::string escape_table_text(std::string_view text) {
    std::string escaped;
    for (const char c : escape_html(text)) {
        if (c == '|') escaped += '\\';
        escaped += c;
    }
    return escaped;
}

std::string markdown_of(const PictureOutput& output, BookLanguage language) {
    std::string result = paragraph(output.caption, language);
    for (const NotebookPicture& shown : output.pictures) {
        result += "![" + shown.name + "](" + shown.name + ".png)\n\n" + paragraph(shown.caption, language) +
                  "*" + shown.name + ", " + size_text(shown.picture.size) + ": " +
                  escape_html(shown.about.in(language)) + "*\n\n";
        // The lab's page lies beside the book's, this file in a directory of its own.
        if (!shown.command.empty())
            result += "[`" + shown.command + "`](../" + lab_address(shown.command) + ")\n\n";
    }
    return result;
}

std::string markdown_of(const FilmOutput& output, BookLanguage language) {
    return "![" + output.name + "](" + output.name + ".webp)\n\n" + paragraph(output.caption, language);
}

std::string markdown_of(const DrawingOutput& output, BookLanguage language) {
    return "![" + output.name + "](" + output.name + ".svg)\n\n" + paragraph(output.caption, language);
}

std::string markdown_of(const TableOutput& table, BookLanguage language) {
    const auto line = [language](const std::vector<BookText>& row) {
        std::string text = "|";
        for (const BookText& cell : row) text += " " + escape_table_text(cell.in(language)) + " |";
        return text + "\n";
    };
    std::string result = paragraph(table.caption, language) + line(table.header) + "|";
    for (std::size_t c = 0; c < table.header.size(); ++c)
        result += is_numeric_column(table, c) ? "---:|" : "---|";
    result += "\n";
    for (const auto& row : table.rows) result += line(row);
    return result + "\n";
}

std::string markdown_of(const CheckOutput& check, BookLanguage language) {
    const std::string detail = check.detail.empty() ? "" : " (" + escape_html(check.detail) + ")";
    return (check.ok ? "✓ " : "**✗** ") + check.claim.in(language) + detail + "\n\n";
}

std::string markdown_of(const ListingOutput& output, BookLanguage language) {
    const CodeListing& listing = output.listing;
    return paragraph(output.caption, language) + "`" + listing.file + ":" +
           std::to_string(listing.first_line) + "`\n\n" + fenced(listing.code);
}

std::string markdown_of(const TranscriptOutput& output, BookLanguage language) {
    return paragraph(output.caption, language) + "```console\n" + output.text + "```\n\n";
}

}  // namespace

std::string output_markdown(const Output& output, BookLanguage language) {
    return std::visit([language](const auto& known) { return markdown_of(known, language); }, output);
}

std::string code_markdown(const SourceCell& cell) {
    if (cell.kind != SourceCell::Kind::setup) return fenced(cell.text);
    return "<details><summary>" + cell.name + "</summary>\n\n" + fenced(cell.text) + "</details>\n\n";
}

std::string markdown_from_cells(const std::vector<NotebookCell>& cells, BookLanguage language) {
    std::string result;
    for (const NotebookCell& cell : cells) {
        if (cell.source.kind == SourceCell::Kind::prose) {
            result += paragraph(cell.prose, language);
            continue;
        }
        result += code_markdown(cell.source);
        for (const Output& output : cell.outputs) result += output_markdown(output, language);
    }
    return result;
}

}  // namespace crevice
