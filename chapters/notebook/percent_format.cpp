#include "chapters/notebook/percent_format.h"

#include <algorithm>

#include "rasterizer/base/error.h"

namespace crevice {

namespace {

constexpr std::string_view kMarker = "// %%";
constexpr std::string_view kProse = "[markdown]";
constexpr std::string_view kSetupTag = "tags=[\"setup\"]";

[[noreturn]] void fail(const std::string& file, int line, const std::string& what) {
    throw UsageError(file + ":" + std::to_string(line) + ": " + what);
}

bool is_cell_name(std::string_view name) {
    return !name.empty() && std::all_of(name.begin(), name.end(), [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_';
    });
}

std::string_view trimmed(std::string_view text) {
    const std::size_t first = text.find_first_not_of(' ');
    if (first == text.npos) return {};
    return text.substr(first, text.find_last_not_of(' ') + 1 - first);
}

// What follows the marker on its line.
SourceCell begun_cell(std::string_view rest, const std::string& file, int line) {
    SourceCell cell;
    rest = trimmed(rest);
    const auto ends_with = [&rest](std::string_view word) {
        if (!rest.ends_with(word)) return false;
        rest = trimmed(rest.substr(0, rest.size() - word.size()));
        return true;
    };
    if (ends_with(kProse)) {
        cell.kind = SourceCell::Kind::prose;
    } else if (ends_with(kSetupTag)) {
        cell.kind = SourceCell::Kind::setup;
    }
    if (!is_cell_name(rest))
        fail(file, line,
             "not a cell's name (" + std::string(rest) +
                 "); give a-z, 0-9 and _, then [markdown] or tags=[\"setup\"] if it is one");
    cell.name = rest;
    cell.first_line = line + 1;
    return cell;
}

std::string uncommented(std::string_view line, const std::string& file, int number) {
    if (line.starts_with("// ")) return std::string(line.substr(3));
    if (line == "//" || line.empty()) return {};
    fail(file, number,
         "a line of a prose cell that is no comment (" + std::string(line.substr(0, 40)) +
             "); begin it with // or begin a code cell before it");
}

}  // namespace

void drop_empty_lines_around(std::string& text) {
    text.erase(0, std::min(text.find_first_not_of('\n'), text.size()));
    text.erase(text.find_last_not_of('\n') + 1);
}

std::vector<SourceCell> percent_cells(std::string_view source, const std::string& file) {
    std::vector<SourceCell> cells;
    int number = 0;
    while (!source.empty()) {
        const std::size_t end = source.find('\n');
        const std::string_view line = source.substr(0, end);
        source = end == source.npos ? std::string_view() : source.substr(end + 1);
        ++number;
        if (!line.starts_with(kMarker) && trimmed(line).starts_with(kMarker))
            fail(file, number,
                 "a cell that does not begin at the margin; move it there, and switch clang-format off");
        if (line.starts_with(kMarker)) {
            cells.push_back(begun_cell(line.substr(kMarker.size()), file, number));
        } else if (cells.empty()) {
            SourceCell first;
            first.name = "all";
            first.first_line = 1;
            cells.push_back(first);
        }
        SourceCell& cell = cells.back();
        cell.last_line = number;
        if (line.starts_with(kMarker)) continue;
        cell.text +=
            cell.kind == SourceCell::Kind::prose ? uncommented(line, file, number) : std::string(line);
        cell.text += '\n';
    }
    for (SourceCell& cell : cells) drop_empty_lines_around(cell.text);
    for (std::size_t i = 0; i < cells.size(); ++i) {
        if (cells[i].name == "all" && cells[i].first_line == 1 && cells.size() > 1)
            fail(file, 1, "text before the first cell; begin the file with // %% and a name");
        for (std::size_t j = 0; j < i; ++j) {
            if (cells[j].name == cells[i].name)
                fail(file, cells[i].first_line - 1,
                     "two cells have one name (" + cells[i].name + "); rename one");
        }
    }
    return cells;
}

}  // namespace crevice
