#include "chapters/commands/notebook_flags.h"

#include "chapters/terminal/parse.h"
#include "rasterizer/base/error.h"

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

}  // namespace

NotebookOptions notebook_options_of(const NotebookWords& words) {
    NotebookOptions options;
    options.out = words.out;
    if (words.size) options.size = parse_size("--size", *words.size);
    options.seed = static_cast<std::uint32_t>(parse_whole("--seed", words.seed, 0, 0xffffffffLL));
    options.scene = words.scene;
    options.words = words.parameters;
    options.cell = words.cell;
    options.language = language_of(words.language);
    options.step = words.step;
    options.quiet = words.quiet;
    return options;
}

}  // namespace crevice
