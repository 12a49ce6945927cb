// Why a frame has no map of a pass.
#pragma once

#include <string>

#include "chapters/frame/frame.h"

namespace crevice {

// Empty when the pass was not left out.
inline std::string left_out_reason(const Frame& frame, const std::string& pass) {
    for (const LeftOut& left_out : frame.left_out) {
        if (left_out.what == pass) return left_out.why;
    }
    return "";
}

}  // namespace crevice
