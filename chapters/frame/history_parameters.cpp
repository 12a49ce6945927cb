// The parameters of what frames take over from the ones before them.
#include "chapters/frame/frame_settings.h"

namespace crevice {

std::vector<Parameter<FrameSettings>> history_parameters() {
    using S = TemporalSettings;
    const std::vector<Parameter<S>> own = {
        whole("history", 1, kMostFramesOfHistory,
              "with --frames: AO is the mean over up to so many frames, each of another seed; 1: no history",
              &S::longest),
        number("history_depth", "[0, 1]", "view depth",
               "what the last frame saw further from the surface than this is another one", &S::depth),
        number("history_normal", "[-1, 1]", "cosine",
               "what the last frame saw face another way than this is another surface", &S::normal),
        yes_no("history_clamp",
               "true: held within what this frame's texels around show; no ghosts where that is smooth",
               &S::clamp)};
    return within<FrameSettings>(
        own, [](auto& settings) -> auto& { return settings.history; });
}

}  // namespace crevice
