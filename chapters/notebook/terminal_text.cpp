#include "chapters/notebook/terminal_text.h"

#include <algorithm>
#include <sstream>
#include <string_view>

#include "chapters/notebook/plain_math.h"
#include "chapters/terminal/number_text.h"

namespace crevice {

namespace {

constexpr const char* kCodeBold = "\033[1m";
constexpr const char* kCodeDim = "\033[2m";
constexpr const char* kCodeGreen = "\033[32m";
constexpr const char* kCodeRed = "\033[31m";
constexpr const char* kCodePlain = "\033[0m";

std::string styled(const std::string& text, const char* code, bool colour) {
    return colour ? code + text + kCodePlain : text;
}

// Columns on the terminal: one a code point, two where it is Chinese or another wide one, none where it is a mark over
// the letter before it.
std::size_t shown_width(std::string_view text) {
    std::size_t width = 0;
    for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        if ((byte & 0xc0) != 0x80 && byte != 0xcc) width += byte >= 0xe3 && byte < 0xf0 ? 2 : 1;
    }
    return width;
}

std::string words_of(const BookText& text, const TerminalStyle& style) {
    return with_plain_math(text.in(style.language));
}

std::string lines_of(const BookText& caption, const TerminalStyle& style) {
    return caption.empty() ? "" : words_of(caption, style) + "\n";
}

std::string text_of(const PictureOutput& output, const TerminalStyle& style) {
    std::string result = lines_of(output.caption, style);
    for (const NotebookPicture& shown : output.pictures) {
        result += "  " + (style.directory / (shown.name + ".png")).string() + "  " +
                  size_text(shown.picture.size) + "\n";
        if (!shown.caption.empty()) result += "    " + lines_of(shown.caption, style);
        result += "    " + styled(words_of(shown.about, style), kCodeDim, style.colour) + "\n";
        if (!shown.command.empty()) result += "    " + styled(shown.command, kCodeDim, style.colour) + "\n";
    }
    return result + "\n";
}

std::string text_of(const FilmOutput& output, const TerminalStyle& style) {
    return "  " + (style.directory / (output.name + ".webp")).string() + "  " + size_text(output.size) +
           "\n    " + lines_of(output.caption, style) + "\n";
}

std::string text_of(const DrawingOutput& output, const TerminalStyle& style) {
    return "  " + (style.directory / (output.name + ".svg")).string() + "\n    " +
           lines_of(output.caption, style) + "\n";
}

std::string text_of(const TableOutput& table, const TerminalStyle& style) {
    std::vector<std::size_t> widths;
    for (std::size_t c = 0; c < table.header.size(); ++c) {
        std::size_t width = shown_width(words_of(table.header[c], style));
        for (const auto& row : table.rows) width = std::max(width, shown_width(words_of(row[c], style)));
        widths.push_back(width);
    }
    const auto line = [&](const std::vector<BookText>& row) {
        std::string text = "  ";
        for (std::size_t c = 0; c < row.size(); ++c) {
            const std::string word = words_of(row[c], style);
            const std::string padding(widths[c] - shown_width(word), ' ');
            text += is_numeric_column(table, c) ? padding + word : word + padding;
            text += "  ";
        }
        text.erase(text.find_last_not_of(' ') + 1);
        return text + "\n";
    };
    std::string result = lines_of(table.caption, style) + styled(line(table.header), kCodeBold, style.colour);
    for (const auto& row : table.rows) result += line(row);
    return result + "\n";
}

std::string text_of(const CheckOutput& check, const TerminalStyle& style) {
    const std::string mark =
        check.ok ? styled("✓", kCodeGreen, style.colour) : styled("✗", kCodeRed, style.colour);
    const std::string detail = check.detail.empty() ? "" : "  (" + check.detail + ")";
    return mark + " " + words_of(check.claim, style) + detail + "\n";
}

std::string text_of(const ListingOutput& output, const TerminalStyle& style) {
    const CodeListing& listing = output.listing;
    std::string result =
        lines_of(output.caption, style) +
        styled(listing.file + ":" + std::to_string(listing.first_line), kCodeBold, style.colour) + "\n";
    std::istringstream lines(listing.code);
    for (std::string line; std::getline(lines, line);) result += line.empty() ? "\n" : "    " + line + "\n";
    return result + "\n";
}

std::string text_of(const TranscriptOutput& output, const TerminalStyle& style) {
    std::string result = lines_of(output.caption, style);
    for (const TranscriptLine& line : lines_of(output))
        result += "    " + (line.typed ? styled(line.text, kCodeBold, style.colour) : line.text) + "\n";
    return result + "\n";
}

// A line of HTML that folds a part of the page: of these the terminal shows the summary alone.
std::string without_fold(const std::string& line) {
    const std::size_t open = line.find("<summary>"), close = line.find("</summary>");
    if (open != line.npos && close != line.npos) {
        const std::size_t begin = open + std::string_view("<summary>").size();
        return "[" + line.substr(begin, close - begin) + "]";
    }
    return line.starts_with("<details") || line.starts_with("</details") ? "" : line;
}

}  // namespace

std::string terminal_prose(const std::string& markdown, bool colour) {
    std::istringstream lines(with_plain_math(markdown));
    std::string result;
    for (std::string line; std::getline(lines, line);) {
        const std::string shown = without_fold(line);
        if (shown.empty() && !line.empty()) continue;
        result += shown.starts_with("#") ? styled(shown, kCodeBold, colour) : shown;
        result += '\n';
    }
    return result + '\n';
}

std::string terminal_text(const Output& output, const TerminalStyle& style) {
    return std::visit([&style](const auto& known) { return text_of(known, style); }, output);
}

}  // namespace crevice
