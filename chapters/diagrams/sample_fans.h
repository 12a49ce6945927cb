// The samples of texels as the eye sees them: what chapter 07 shows of neighbours that look the same way, or not.
#pragma once

#include <string>
#include <vector>

#include "ssao/methods/explanation.h"

namespace crevice {

struct SampleFan {
    std::string name;  // under the fan
    Explanation texel;
};

// A drawing a texel, in rows of `columns`: view x to the right and y upwards, the offset of each sample as a line from
// the texel's point, red where it takes something from it, else blue; the dotted circle is the radius.
std::string sample_fans(const std::string& title, const std::vector<SampleFan>& fans, int columns,
                        double radius);

}  // namespace crevice
