#include "chapters/notebook/notebook_text.h"

#include <algorithm>
#include <sstream>
#include <string_view>

#include <nlohmann/json.hpp>

#include "chapters/notebook/html.h"
#include "chapters/terminal/number_text.h"

namespace crevice {

namespace {

constexpr const char* kBold = "\033[1m";
constexpr const char* kGreen = "\033[32m";
constexpr const char* kRed = "\033[31m";
constexpr const char* kPlain = "\033[0m";

// Columns on the terminal: code points, since UTF-8 continuation bytes take no room.
std::size_t shown_width(std::string_view text) {
    return static_cast<std::size_t>(std::count_if(
        text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xc0) != 0x80; }));
}

std::string text_lines(const TextCell& cell, bool colour) {
    if (!colour) return cell.markdown + "\n";
    std::istringstream lines(cell.markdown);
    std::string result;
    for (std::string line; std::getline(lines, line);) {
        result += line.starts_with("#") ? kBold + line + kPlain : line;
        result += '\n';
    }
    return result + '\n';
}

std::string picture_lines(const PictureCell& cell, const std::filesystem::path& directory) {
    std::string result = cell.caption.empty() ? "" : cell.caption + "\n";
    for (const NotebookPicture& picture : cell.pictures) {
        result += "  " + (directory / (picture.name + ".png")).string() + "  " + size_text(picture.size) +
                  "\n    " + picture.about + "\n";
    }
    return result;
}

std::string table_lines(const TableCell& table) {
    std::vector<std::size_t> widths;
    for (std::size_t c = 0; c < table.header.size(); ++c) {
        std::size_t width = shown_width(table.header[c]);
        for (const auto& row : table.rows) width = std::max(width, shown_width(row[c]));
        widths.push_back(width);
    }
    const auto line = [&](const std::vector<std::string>& row) {
        std::string text = "  ";
        for (std::size_t c = 0; c < row.size(); ++c) {
            const std::string padding(widths[c] - shown_width(row[c]), ' ');
            text += is_numeric_column(table, c) ? padding + row[c] : row[c] + padding;
            text += "  ";
        }
        text.erase(text.find_last_not_of(' ') + 1);
        return text + "\n";
    };
    std::string result = line(table.header);
    for (const auto& row : table.rows) result += line(row);
    return result + "\n";
}

std::string check_line(const CheckCell& check, bool colour) {
    std::string mark = check.ok ? "✓" : "✗";
    if (colour) mark = (check.ok ? kGreen : kRed) + mark + kPlain;
    return mark + " " + check.claim + (check.detail.empty() ? "" : "  (" + check.detail + ")") + "\n";
}

// Plain text inside Markdown: no tags, and no end of a table cell.
std::string escape_markdown(std::string_view text) {
    std::string escaped;
    for (const char c : escape_html(text)) {
        if (c == '|') escaped += '\\';
        escaped += c;
    }
    return escaped;
}

std::string table_markdown(const TableCell& table) {
    const auto line = [](const std::vector<std::string>& row) {
        std::string text = "|";
        for (const std::string& cell : row) text += " " + escape_markdown(cell) + " |";
        return text + "\n";
    };
    std::string result = line(table.header) + "|";
    for (std::size_t c = 0; c < table.header.size(); ++c)
        result += is_numeric_column(table, c) ? "---:|" : "---|";
    result += "\n";
    for (const auto& row : table.rows) result += line(row);
    return result;
}

// Everything but pictures, which Markdown links and Jupyter contains.
std::string cell_markdown(const Cell& cell) {
    if (const auto* text = std::get_if<TextCell>(&cell)) return text->markdown;
    if (const auto* table = std::get_if<TableCell>(&cell)) return table_markdown(*table);
    if (const auto* check = std::get_if<CheckCell>(&cell)) {
        return (check->ok ? "✓ " : "**✗** ") + escape_markdown(check->claim) +
               (check->detail.empty() ? "" : " (" + escape_markdown(check->detail) + ")") + "\n";
    }
    return escape_markdown(std::get<PictureCell>(cell).caption) + "\n";
}

nlohmann::ordered_json jupyter_picture(const NotebookPicture& picture) {
    const std::string about = picture.name + " " + size_text(picture.size) + ": " + picture.about;
    return {{"output_type", "display_data"},
            {"metadata", {{"image/png", {{"width", picture.size.width}, {"height", picture.size.height}}}}},
            {"data", {{"image/png", base64(picture.png)}, {"text/plain", {about}}}}};
}

}  // namespace

bool is_numeric_column(const TableCell& table, std::size_t column) {
    const auto is_number = [column](const std::vector<std::string>& row) {
        const std::string& text = row[column];
        const std::size_t first = text.find_first_not_of("+-.");
        return first != std::string::npos && text[first] >= '0' && text[first] <= '9';
    };
    return !table.rows.empty() && std::all_of(table.rows.begin(), table.rows.end(), is_number);
}

std::string terminal_text(const Cell& cell, const std::filesystem::path& directory, bool colour) {
    if (const auto* text = std::get_if<TextCell>(&cell)) return text_lines(*text, colour);
    if (const auto* pictures = std::get_if<PictureCell>(&cell)) return picture_lines(*pictures, directory);
    if (const auto* table = std::get_if<TableCell>(&cell)) return table_lines(*table);
    return check_line(std::get<CheckCell>(cell), colour);
}

std::string markdown_from_cells(const std::vector<Cell>& cells) {
    std::string result;
    for (const Cell& cell : cells) {
        result += cell_markdown(cell);
        if (const auto* pictures = std::get_if<PictureCell>(&cell)) {
            for (const NotebookPicture& picture : pictures->pictures) {
                result += "\n![" + picture.name + "](" + picture.name + ".png)\n\n*" + picture.name + ", " +
                          size_text(picture.size) + ": " + escape_markdown(picture.about) + "*\n";
            }
        }
        result += "\n";
    }
    return result;
}

std::string jupyter_from_cells(const std::vector<Cell>& cells, const std::string& name) {
    nlohmann::ordered_json written = nlohmann::ordered_json::array();
    int executed = 0;
    for (const Cell& cell : cells) {
        nlohmann::ordered_json entry;
        const auto* pictures = std::get_if<PictureCell>(&cell);
        entry["cell_type"] = pictures != nullptr ? "code" : "markdown";
        entry["id"] = name + "-" + std::to_string(written.size() + 1);
        entry["metadata"] = nlohmann::ordered_json::object();
        if (pictures != nullptr) {
            entry["execution_count"] = ++executed;
            entry["source"] = pictures->caption.empty() ? "" : "// " + pictures->caption;
            entry["outputs"] = nlohmann::ordered_json::array();
            for (const NotebookPicture& picture : pictures->pictures)
                entry["outputs"].push_back(jupyter_picture(picture));
        } else {
            entry["source"] = cell_markdown(cell);
        }
        written.push_back(std::move(entry));
    }
    const nlohmann::ordered_json notebook = {
        {"cells", written},
        {"metadata",
         {{"language_info", {{"name", "c++"}, {"file_extension", ".cpp"}, {"mimetype", "text/x-c++src"}}}}},
        {"nbformat", 4},
        {"nbformat_minor", 5}};
    return notebook.dump(1, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace crevice
