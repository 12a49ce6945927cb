// The samples of neighbouring texels, for a drawing of them side by side.
#pragma once

#include <vector>

#include "chapters/diagrams/sample_fans.h"
#include "chapters/props/number_words.h"
#include "chapters/props/switched_ao.h"

namespace crevice {

// So many texels of a map in a row, the followed one first; each is named by its AO.
inline std::vector<SampleFan> fans_of_neighbours(const SwitchedView& view, const SwitchedAo& shown,
                                                 int count) {
    const Texel at = followed_texel(shown.inputs.size());
    std::vector<SampleFan> fans;
    for (int x = at.x; x < at.x + count; ++x)
        fans.push_back({"AO " + text(shown.raw.at(x, at.y)), view.explanation(shown, x, at.y)});
    return fans;
}

}  // namespace crevice
