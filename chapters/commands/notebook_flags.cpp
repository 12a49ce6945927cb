#include "chapters/commands/notebook_flags.h"

#include "chapters/frame/frame_settings.h"
#include "chapters/terminal/parse.h"
#include "rasterizer/base/error.h"
#include "rasterizer/base/no_such.h"
#include "scenes/builtin_scenes.h"
#include "ssao/ao_methods.h"

namespace crevice {

void add_notebook_flags(CommandLine& command, NotebookWords& words) {
    command.option("--out", words.out, "the directory for pictures and pages");
    command.option("--size", words.size, "size of the pictures in pixels, WxH; default: 640x360");
    command.option("--seed", words.seed, "seed of whatever is random");
    command.option("--scene", words.scene, "show this scene instead of the chapter's own");
    command.option("--param", words.parameters, "NAME=VALUE of every method that the chapter runs");
    command.option("--cell", words.cell,
                   "show what one cell puts out; its pictures are saved as .npy as well");
    command.option("--lang", words.language, "language of the pages: en, zh or both");
    command.flag("--step", words.step,
                 "ask after each cell: go on, look at pixels and pictures, change a parameter");
    command.flag("--quiet", words.quiet, "say only which checks fail");
}

namespace {

BookLanguage language_of(const std::string& word) {
    if (word == "en") return BookLanguage::en;
    if (word == "zh") return BookLanguage::zh;
    if (word == "both") return BookLanguage::both;
    throw UsageError("--lang: not a language of the book (" + word + "); give en, zh or both");
}

// A scene that the chapters can make; nothing: each its own.
std::string scene_of(const std::string& word) {
    if (word.empty() || find_builtin_scene(word) != nullptr) return word;
    std::vector<std::string> known;
    for (const BuiltinScene& scene : builtin_scenes()) known.push_back(scene.name);
    throw no_such("--scene", "built-in scene", word, known);
}

// Refused where no method has such a parameter; a chapter whose methods do not have it says so itself.
void require_known_parameter(const std::string& word) {
    const std::string name = word.substr(0, word.find('='));
    for (const Method& method : ao_methods()) {
        for (const Parameter<FrameSettings>& parameter : frame_parameters(method))
            if (parameter.name == name) return;
    }
    throw UsageError("--param: no method has such a parameter (" + word +
                     "); write NAME=VALUE, with a name that crevice params METHOD lists");
}

}  // namespace

NotebookOptions notebook_options_of(const NotebookWords& words) {
    NotebookOptions options;
    options.out = words.out;
    if (words.size) options.size = parse_size("--size", *words.size);
    options.seed = static_cast<std::uint32_t>(parse_whole("--seed", words.seed, 0, 0xffffffffLL));
    options.scene = scene_of(words.scene);
    for (const std::string& word : words.parameters) require_known_parameter(word);
    options.words = words.parameters;
    options.cell = words.cell;
    options.language = language_of(words.language);
    options.step = words.step;
    options.quiet = words.quiet;
    return options;
}

}  // namespace crevice
