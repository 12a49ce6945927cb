// AO inputs of a few planes made by hand: orthographic, one scene unit a pixel.
#pragma once

#include <cmath>

#include "tests/tools/ao_cases.h"

namespace crevice {

// A plane whose view depth grows by `slope_x` a pixel to the right and `slope_y` a pixel down.
inline AoInputs tilted_inputs(Size size, float slope_x, float slope_y = 0) {
    AoInputs inputs = plain_inputs(size, 0);
    const float length = std::sqrt(1 + slope_x * slope_x + slope_y * slope_y);
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
            const float z = 1000 + slope_x * static_cast<float>(x) + slope_y * static_cast<float>(y);
            inputs.view_depth.at(x, y) = z;
            inputs.normal.set(x, y, glm::vec3(slope_x, -slope_y, -1) / length);
            inputs.depth_map.at(x + 1, y + 1) = z;
        }
    }
    return inputs;
}

// Where a step up begins.
enum class StepSide { right, left, below, above };

// A plane that faces the eye, and another one nearer by `height`, from `distance` pixels beside the centre on.
inline AoInputs step_inputs(Size size, StepSide side, float distance, float height) {
    AoInputs inputs = plain_inputs(size, 1000);
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
            const float right = static_cast<float>(x) + 0.5f - 0.5f * static_cast<float>(size.width),
                        down = static_cast<float>(y) + 0.5f - 0.5f * static_cast<float>(size.height);
            const float towards[] = {right, -right, down, -down};
            if (towards[static_cast<int>(side)] < distance) continue;
            inputs.view_depth.at(x, y) = 1000 - height;
            inputs.depth_map.at(x + 1, y + 1) = 1000 - height;
        }
    }
    return inputs;
}

}  // namespace crevice
