// `crevice render SCENE --pixel X,Y --pass PASS --break`: a frame up to one pass, and then that pass's kernel for one
// pixel, for a debugger to step through. chapters/debugger/ has what GDB, LLDB and Visual Studio show of it.
#pragma once

#include "chapters/commands/render.h"

namespace crevice {

struct PixelStop {
    std::string pixel;        // X,Y in the picture, as typed
    std::string pass = "ao";  // one of kProbedPasses
};

// Draws the frame up to the pass on one thread, stops in the debugger right before the pixel's kernel, runs that and
// prints what it comes to. No file is written. Throws UsageError, without a debugger too, and InputError.
void step_pixel(const RenderOptions& options, const PixelStop& stop);

}  // namespace crevice
