// The flags that say what one frame shows and how it is made: of every command that draws one.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "chapters/commands/render.h"
#include "chapters/commands/run_flags.h"

namespace crevice {

// As they were typed.
struct FrameWords {
    std::string scene, size = "1280x720", ao, ao_scale, time = "0";
    std::optional<std::string> preset;
    std::vector<std::string> params;
    CameraFlags camera;
    RunWords run;
    bool outside_files = false;
    std::optional<std::string> crease;
};

// All but SCENE, whose place among the words each command knows.
void add_frame_flags(CommandLine& command, FrameWords& words);

// What they come to, with all buffers wanted. Throws UsageError; `command` is its name.
RenderOptions frame_options(const std::string& command, const FrameWords& words);

}  // namespace crevice
