// `crevice view SCENE`: a window to look at a scene while the passes run: every buffer, method and parameter, live.
#pragma once

#include <filesystem>

#include "chapters/view/frame_thread.h"

namespace crevice {

struct ViewOptions {
    LabWords words;                     // of the first frame
    std::vector<std::string> shown;     // one buffer or two
    std::filesystem::path out = "out";  // where screenshots go
    Run run;
};

// Returns when the window is closed. Throws UsageError where the program was built without SDL2 or Dear ImGui, and for a
// system without a display; InputError and UsageError for a first frame that cannot be drawn.
void view(const ViewOptions& options);

}  // namespace crevice
