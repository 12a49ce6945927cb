#include "chapters/commands/notebook_flags.h"

#include "chapters/terminal/parse.h"

namespace crevice {

void add_notebook_flags(CommandLine& command, NotebookWords& words) {
    command.option("--out", words.out, "the directory for pictures and pages");
    command.option("--size", words.size, "size of the pictures in pixels, WxH; default: 640x360");
    command.option("--seed", words.seed, "seed of whatever is random");
    command.flag("--step", words.step, "wait for Enter after each cell");
    command.flag("--quiet", words.quiet, "say only which checks fail");
}

NotebookOptions notebook_options_of(const NotebookWords& words) {
    NotebookOptions options;
    options.out = words.out;
    if (words.size) options.size = parse_size("--size", *words.size);
    options.seed = static_cast<std::uint32_t>(parse_whole("--seed", words.seed, 0, 0xffffffffLL));
    options.step = words.step;
    options.quiet = words.quiet;
    return options;
}

}  // namespace crevice
