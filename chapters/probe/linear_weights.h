// The pixels of an image around the centre of a pixel of another, as a linear filter weighs them.
#pragma once

#include <utility>
#include <vector>

#include "ssao/inputs/linear_taps.h"

namespace crevice {

struct LinearWeight {
    int x = 0, y = 0;  // of the image that is read
    float weight = 0;  // (0,1], together 1
};

// Of pixel (x, y) of an image of size `from` among the pixels of one of size `among`: one, two or four.
inline std::vector<LinearWeight> linear_weights(Size from, Size among, int x, int y) {
    const LinearTaps columns(from.width, among.width), rows(from.height, among.height);
    const auto column = static_cast<std::size_t>(x), row = static_cast<std::size_t>(y);
    const float right = columns.weight_of_second[column], lower = rows.weight_of_second[row];
    std::vector<LinearWeight> weights;
    for (const auto& [at_y, weight_y] : {std::pair{rows.first[row], 1 - lower}, {rows.second[row], lower}}) {
        for (const auto& [at_x, weight_x] :
             {std::pair{columns.first[column], 1 - right}, {columns.second[column], right}}) {
            if (weight_x * weight_y > 0) weights.push_back({at_x, at_y, weight_x * weight_y});
        }
    }
    return weights;
}

}  // namespace crevice
