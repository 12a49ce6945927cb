#include "chapters/notebook/jupyter.h"

#include <filesystem>

#include <nlohmann/json.hpp>

#include "chapters/notebook/html.h"
#include "chapters/notebook/markdown_text.h"
#include "chapters/notebook/svg.h"
#include "chapters/notebook/terminal_text.h"
#include "chapters/terminal/json_text.h"
#include "chapters/terminal/number_text.h"

namespace crevice {

namespace {

using nlohmann::ordered_json;

// What the first cell of every notebook runs.
constexpr const char* kSetup =
    "import os\n"
    "import numpy as np\n"
    "from IPython.display import HTML, Image, SVG, display\n"
    "crevice = os.environ.get(\"CREVICE\", \"crevice\")  # the program, where it is not on the PATH";

ordered_json markdown_cell(const std::string& id, const std::string& text) {
    return {{"cell_type", "markdown"}, {"id", id}, {"metadata", ordered_json::object()}, {"source", text}};
}

ordered_json code_cell(const std::string& id, int count, const std::string& source,
                       const ordered_json& outputs) {
    return {
        {"cell_type", "code"}, {"execution_count", count}, {"id", id}, {"metadata", ordered_json::object()},
        {"outputs", outputs},  {"source", source}};
}

ordered_json display_of(const std::string& type, const std::string& content, const std::string& plain,
                        const ordered_json& metadata = ordered_json::object()) {
    return {{"output_type", "display_data"},
            {"metadata", metadata},
            {"data", {{type, content}, {"text/plain", plain}}}};
}

// The Python that runs the cell and shows what it made; the notebook lies beside the pictures.
std::string python_of(const NotebookCell& cell, const std::string& name, const std::string& flags) {
    std::string source = "!{crevice} chapter " + name.substr(0, name.find('_')) + " --cell " +
                         cell.source.name + flags + " --out ..\nassert _exit_code == 0";
    for (const Output& output : cell.outputs) {
        if (const auto* pictures = std::get_if<PictureOutput>(&output)) {
            for (const NotebookPicture& shown : pictures->pictures) {
                source += "\ndisplay(Image(\"" + shown.name + ".png\"))";
                if (!shown.picture.values.empty()) {
                    std::string variable = shown.name;
                    for (char& c : variable) c = c == '-' ? '_' : c;
                    source += "\n" + variable + " = np.load(\"" + shown.name + ".npy\")";
                }
            }
        } else if (const auto* film = std::get_if<FilmOutput>(&output)) {
            source += "\ndisplay(HTML('<img src=\"" + film->name + ".webp\">'))";
        } else if (const auto* drawing = std::get_if<DrawingOutput>(&output)) {
            source += "\ndisplay(SVG(\"" + drawing->name + ".svg\"))";
        }
    }
    return source;
}

ordered_json outputs_of(const NotebookCell& cell, BookLanguage language) {
    std::string said;
    ordered_json displays = ordered_json::array();
    for (const Output& output : cell.outputs) {
        said += terminal_text(output, {"", language, false});
        if (const auto* pictures = std::get_if<PictureOutput>(&output)) {
            for (const NotebookPicture& shown : pictures->pictures) {
                const Size size = shown.picture.size;
                displays.push_back(
                    display_of("image/png", base64(shown.png), shown.name + " " + size_text(size),
                               {{"image/png", {{"width", size.width}, {"height", size.height}}}}));
            }
        } else if (const auto* film = std::get_if<FilmOutput>(&output)) {
            displays.push_back(display_of("text/html", "<img src=\"" + film->name + ".webp\">", film->name));
        } else if (const auto* drawing = std::get_if<DrawingOutput>(&output)) {
            displays.push_back(
                display_of("image/svg+xml", standalone_svg(drawing->svg.in(language)), drawing->name));
        }
    }
    ordered_json outputs = ordered_json::array();
    outputs.push_back({{"name", "stdout"}, {"output_type", "stream"}, {"text", said}});
    for (ordered_json& shown : displays) outputs.push_back(std::move(shown));
    return outputs;
}

}  // namespace

std::string jupyter_from_cells(const std::vector<NotebookCell>& cells, const std::string& name,
                               BookLanguage language, const std::string& flags) {
    int count = 1;
    ordered_json written = ordered_json::array();
    for (const NotebookCell& cell : cells) {
        if (cell.source.kind == SourceCell::Kind::prose) {
            written.push_back(markdown_cell(cell.source.name, cell.prose.in(language)));
            continue;
        }
        written.push_back(markdown_cell(cell.source.name + "-source", code_markdown(cell.source)));
        if (!cell.outputs.empty())
            written.push_back(code_cell(cell.source.name, ++count, python_of(cell, name, flags),
                                        outputs_of(cell, language)));
    }
    written.insert(written.begin(), code_cell("python-setup", 1, kSetup, ordered_json::array()));
    const ordered_json notebook = {
        {"cells", written},
        {"metadata",
         {{"kernelspec", {{"display_name", "Python 3"}, {"language", "python"}, {"name", "python3"}}},
          {"language_info", {{"name", "python"}}}}},
        {"nbformat", 4},
        {"nbformat_minor", 5}};
    return json_text(notebook);
}

}  // namespace crevice
