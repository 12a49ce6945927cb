#include "chapters/notebook/notebook.h"

#include <algorithm>
#include <cstdio>
#include <iostream>
#include <sstream>
#include <utility>

#include <unistd.h>

#include "chapters/notebook/notebook_page.h"
#include "chapters/notebook/notebook_text.h"
#include "rasterizer/base/error.h"
#include "rasterizer/base/image_io.h"

namespace crevice {

namespace {

bool is_file_name(const std::string& name) {
    const auto allowed = [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
    };
    return !name.empty() && std::all_of(name.begin(), name.end(), allowed);
}

// Without the empty lines around it and the indentation that all its lines share.
std::string unindented(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) {
        line.erase(line.find_last_not_of(" \t") + 1);
        lines.push_back(line);
    }
    std::size_t shared = std::string::npos;
    for (const std::string& line : lines) {
        if (!line.empty()) shared = std::min(shared, line.find_first_not_of(' '));
    }
    std::string result;
    for (const std::string& line : lines) {
        if (!line.empty()) result += line.substr(shared);
        if (!result.empty()) result += '\n';
    }
    while (result.ends_with("\n\n")) result.pop_back();
    return result;
}

std::string numbered(const std::string& heading, const std::vector<std::string>& items) {
    std::string markdown = "**" + heading + "**\n\n";
    for (std::size_t i = 0; i < items.size(); ++i) markdown += std::to_string(i + 1) + ". " + items[i] + "\n";
    return markdown;
}

// Terminal colours only where a person looks: not in a pipe, not in a file.
bool wants_colour(const std::ostream& terminal) {
    return &terminal == &std::cout && isatty(STDOUT_FILENO) == 1;
}

}  // namespace

Notebook::Notebook(NotebookOptions options, std::string name)
    : Notebook(std::move(options), std::move(name), std::cout) {}

Notebook::Notebook(NotebookOptions options, std::string name, std::ostream& terminal)
    : options_(std::move(options)), name_(std::move(name)), terminal_(terminal) {
    std::error_code error;
    std::filesystem::create_directories(directory(), error);
    if (error) {
        throw OutputError(directory().string() + ": cannot be made (" + error.message() +
                          "); give --out a directory that may be written to");
    }
}

void Notebook::add(Cell cell, const std::string& terminal_note) {
    const CheckCell* check = std::get_if<CheckCell>(&cell);
    if (!options_.quiet || (check != nullptr && !check->ok)) {
        terminal_ << terminal_text(cell, directory(), wants_colour(terminal_)) << terminal_note << std::flush;
    }
    cells_.push_back(std::move(cell));
    if (options_.step && isatty(STDIN_FILENO) == 1) {
        terminal_ << "[Enter] " << std::flush;
        std::string line;
        if (!std::getline(std::cin, line)) options_.step = false;
    }
}

NotebookPicture Notebook::store(const std::string& name, const Picture& picture) {
    if (!is_file_name(name)) {
        throw UsageError(name_ + ": not a picture name (" + name + "); use a-z, 0-9, _ and -");
    }
    if (!picture_names_.insert(name).second) {
        throw UsageError(name_ + ": two pictures have one name (" + name + "); rename one");
    }
    NotebookPicture stored;
    stored.name = name;
    stored.size = picture.size;
    stored.about = picture.mapping + ". " + statistics_text(picture.statistics);
    stored.png = png_bytes(picture.size, picture.channels, picture.pixels);
    write_file_atomically(directory() / (name + ".png"), stored.png);
    return stored;
}

void Notebook::text(const std::string& markdown) {
    add(TextCell{TextCell::Kind::plain, unindented(markdown)});
}

void Notebook::show(const std::string& name, const Picture& picture, const std::string& caption,
                    std::optional<double> wall_ms) {
    std::string note;
    if (wall_ms) {
        char text[48];
        std::snprintf(text, sizeof text, "    %.2f ms\n", *wall_ms);
        note = text;
    }
    add(PictureCell{caption, {store(name, picture)}}, note);
}

void Notebook::show_row(const std::string& caption, const std::vector<Named>& pictures) {
    PictureCell cell{caption, {}};
    for (const Named& named : pictures) cell.pictures.push_back(store(named.name, named.picture));
    add(std::move(cell));
}

void Notebook::table(const std::vector<std::string>& header,
                     const std::vector<std::vector<std::string>>& rows) {
    for (const auto& row : rows) {
        if (row.size() != header.size()) {
            throw UsageError(name_ + ": a table row of another length (" + std::to_string(row.size()) +
                             " cells for " + std::to_string(header.size()) + " columns); fill it up");
        }
    }
    add(TableCell{header, rows});
}

bool Notebook::check(const std::string& claim, bool ok, const std::string& detail) {
    ++checks_;
    if (!ok) ++failed_checks_;
    add(CheckCell{claim, ok, detail});
    return ok;
}

void Notebook::try_it(const std::vector<std::string>& edits) {
    add(TextCell{TextCell::Kind::aside, numbered("Try:", edits)});
}

void Notebook::errata(const std::vector<std::string>& items) {
    add(TextCell{TextCell::Kind::aside, numbered("Errata of the tutorial:", items)});
}

std::string Notebook::html() const { return html_from_cells(cells_); }

void Notebook::write_files() const {
    write_file_atomically(directory() / (name_ + ".md"), markdown_from_cells(cells_));
    write_file_atomically(directory() / (name_ + ".ipynb"), jupyter_from_cells(cells_, name_));
}

}  // namespace crevice
