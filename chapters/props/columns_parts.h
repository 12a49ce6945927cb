// Parts of X_Jun's scene as its own camera and the view of the column's foot show it; `size` is that of the image.
#pragma once

#include "rasterizer/base/image.h"

namespace crevice {

// The house, and the left of it with columns beside.
inline PixelRect house_of(Size size) {
    return {size.width * 3 / 10, size.height * 2 / 5, size.width * 7 / 10, size.height * 5 / 6};
}
inline PixelRect left_of_house(Size size) {
    return {size.width / 7, size.height * 2 / 5, size.width * 4 / 7, size.height * 4 / 5};
}

// The foot of the column in its own view.
inline PixelRect foot_of_column(Size size) {
    return {size.width * 2 / 5, size.height / 4, size.width * 3 / 4, size.height * 3 / 4};
}

}  // namespace crevice
