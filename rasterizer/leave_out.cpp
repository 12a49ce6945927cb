#include "rasterizer/leave_out.h"

namespace crevice {

const char* skip_name(Skip skip) {
    switch (skip) {
        case Skip::passes: return "passes";
        case Skip::off_screen_triangles: return "off-screen triangles";
        case Skip::hidden_triangles: return "hidden triangles";
        case Skip::empty_tiles: return "empty tiles";
        case Skip::background_pixels: return "background pixels";
        case Skip::open_tiles: return "open tiles";
        case Skip::second_drawing: return "second drawing";
    }
    return "unknown";
}

}  // namespace crevice
