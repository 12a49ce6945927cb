// For tests of what only a program with OpenEXR can do.
#pragma once

#include <doctest/doctest.h>

#include "chapters/images/exr.h"
#include "rasterizer/base/error.h"

namespace crevice {

// False, which is told, where it was built without.
inline bool has_openexr() {
    try {
        require_openexr();
        return true;
    } catch (const UsageError&) {
        MESSAGE("built without OpenEXR");
        return false;
    }
}

}  // namespace crevice
