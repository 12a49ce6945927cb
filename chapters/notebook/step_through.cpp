#include "chapters/notebook/step_through.h"

#include <istream>
#include <optional>
#include <ostream>
#include <sstream>

#include "chapters/notebook/terminal_picture.h"
#include "chapters/terminal/number_text.h"
#include "rasterizer/base/error.h"

namespace crevice {

namespace {

constexpr int kStepPreviewColumns = 96;
constexpr const char* kHelp =
    "Enter goes on; p X Y: the values at a pixel; v NAME: a preview; s NAME FILE: save as .png or .npy; "
    "set NAME=VALUE: run again from here; q: quit\n";

std::vector<const NotebookPicture*> pictures_of(const std::vector<NotebookCell>& cells) {
    std::vector<const NotebookPicture*> pictures;
    for (const NotebookCell& cell : cells) {
        for (const Output& output : cell.outputs) {
            if (const auto* shown = std::get_if<PictureOutput>(&output)) {
                for (const NotebookPicture& picture : shown->pictures) pictures.push_back(&picture);
            }
        }
    }
    return pictures;
}

const NotebookPicture& picture_named(const std::vector<NotebookCell>& cells, const std::string& name) {
    std::string known;
    for (const NotebookPicture* picture : pictures_of(cells)) {
        if (picture->name == name) return *picture;
        known += " " + picture->name;
    }
    throw UsageError("no picture of this name has been shown (" + name + "); there are:" + known);
}

std::string values_at(const Picture& picture, int x, int y) {
    std::string text;
    for (const Image<float>& plane : picture.values) text += " " + exact_text(plane.at(x, y));
    if (!picture.values.empty()) return text;
    const std::size_t first = (static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.size.width) +
                               static_cast<std::size_t>(x)) *
                              static_cast<std::size_t>(picture.channels);
    for (int c = 0; c < picture.channels; ++c)
        text += " " + std::to_string(picture.pixels[first + static_cast<std::size_t>(c)]);
    return text + " of 255";
}

void probe(const std::vector<NotebookCell>& cells, std::istream& words, std::ostream& terminal) {
    int x = 0, y = 0;
    if (!(words >> x >> y)) throw UsageError("p needs two whole numbers; write p X Y");
    bool any = false;
    for (const NotebookPicture* shown : pictures_of(cells)) {
        const Size size = shown->picture.size;
        if (x < 0 || y < 0 || x >= size.width || y >= size.height) continue;
        terminal << "  " << shown->name << " (" << size_text(size) << "):" << values_at(shown->picture, x, y)
                 << "\n";
        any = true;
    }
    if (!any) terminal << "  no picture that was shown has this pixel\n";
}

void save(const NotebookPicture& shown, const std::filesystem::path& file) {
    if (file.extension() == ".png") {
        write_file_atomically(file, shown.png);
    } else if (file.extension() == ".npy" && !shown.picture.values.empty()) {
        write_file_atomically(file, npy_bytes(shown.picture.values));
    } else {
        throw UsageError("cannot be saved so (" + file.string() + "); give a name that ends in .png" +
                         (shown.picture.values.empty() ? "" : " or .npy"));
    }
}

// Nothing where the line was about the pictures, so that the next one is asked for.
std::optional<StepAnswer> answer_in(const std::string& line, const std::vector<NotebookCell>& cells,
                                    std::ostream& terminal) {
    std::istringstream words(line);
    std::string command, name, file;
    words >> command;
    if (command.empty()) return StepAnswer{};
    if (command == "q") return StepAnswer{StepAnswer::Kind::quit, ""};
    if (command == "set") {
        if (!(words >> name) || name.find('=') == name.npos) throw UsageError("set needs NAME=VALUE");
        return StepAnswer{StepAnswer::Kind::run_again, name};
    }
    if (command == "p") {
        probe(cells, words, terminal);
    } else if (command == "v" && words >> name) {
        terminal << terminal_picture(picture_named(cells, name).picture, kStepPreviewColumns);
    } else if (command == "s" && words >> name >> file) {
        save(picture_named(cells, name), file);
        terminal << "  " << file << "\n";
    } else {
        terminal << kHelp;
    }
    return std::nullopt;
}

}  // namespace

StepAnswer asked(const std::vector<NotebookCell>& cells, std::istream& answers, std::ostream& terminal) {
    for (;;) {
        terminal << "[Enter, p, v, s, set, q, ?] " << std::flush;
        std::string line;
        if (!std::getline(answers, line)) return {StepAnswer::Kind::never_ask, ""};
        try {
            if (const auto answer = answer_in(line, cells, terminal)) return *answer;
        } catch (const Error& error) {
            terminal << "  " << error.what() << "\n";
        }
    }
}

}  // namespace crevice
