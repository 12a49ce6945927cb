// A rectangle of pixels.
#pragma once

#include <algorithm>

namespace crevice {

struct PixelRect {
    int x0 = 0, y0 = 0, x1 = 0, y1 = 0;  // x1 and y1 are one past the last

    bool empty() const { return x0 >= x1 || y0 >= y1; }
    friend bool operator==(const PixelRect&, const PixelRect&) = default;
};

// What both cover; x0 >= x1 or y0 >= y1 when that is nothing.
inline PixelRect common_part(const PixelRect& a, const PixelRect& b) {
    return {std::max(a.x0, b.x0), std::max(a.y0, b.y0), std::min(a.x1, b.x1), std::min(a.y1, b.y1)};
}

// The smallest rectangle around both.
inline PixelRect around(const PixelRect& a, const PixelRect& b) {
    if (a.empty()) return b;
    if (b.empty()) return a;
    return {std::min(a.x0, b.x0), std::min(a.y0, b.y0), std::max(a.x1, b.x1), std::max(a.y1, b.y1)};
}

}  // namespace crevice
