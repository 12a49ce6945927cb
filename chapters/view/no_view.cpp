// Instead of view.cpp where SDL2 or Dear ImGui was not found.
#include "chapters/view/view.h"
#include "rasterizer/base/error.h"

namespace crevice {

void view(const ViewOptions&) {
    throw UsageError(
        "crevice view: this program was built without SDL2 and Dear ImGui; install libsdl2-dev and "
        "libimgui-dev and build "
        "anew, or open the lab in a browser (./crevice.sh web)");
}

}  // namespace crevice
