#include "rasterizer/base/leave_out.h"

namespace crevice {

const char* skip_name(Skip skip) {
    switch (skip) {
        case Skip::passes: return "passes";
        case Skip::off_screen_clusters: return "off-screen clusters";
        case Skip::off_screen_triangles: return "off-screen triangles";
        case Skip::hidden_triangles: return "hidden triangles";
        case Skip::empty_tiles: return "empty tiles";
        case Skip::background_pixels: return "background pixels";
        case Skip::open_tiles: return "open tiles";
        case Skip::faint_highlights: return "faint highlights";
        case Skip::second_drawing: return "second drawing";
    }
    return "unknown";
}

const char* skip_reason(Skip skip) {
    switch (skip) {
        case Skip::passes: return "nothing that was asked for reads them";
        case Skip::off_screen_clusters: return "the box around them lies beyond one side of the view";
        case Skip::off_screen_triangles: return "all three corners lie beyond one side of the view";
        case Skip::hidden_triangles:
            return "their nearest depth is behind the farthest that the tile shows there";
        case Skip::empty_tiles: return "no triangle's bounding box and edges reach them";
        case Skip::background_pixels: return "they show no surface";
        case Skip::open_tiles: return "accessibility is exactly 1 in them and wherever they read";
        case Skip::faint_highlights: return "added to the albedo they round away";
        case Skip::second_drawing: return "the first pass kept the normal and material that EQUAL would find";
    }
    return "unknown";
}

}  // namespace crevice
