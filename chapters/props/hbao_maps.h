// The maps of chapter 17: over steps and over radii, and of a ball of few facets.
#pragma once

#include <string>
#include <vector>

#include "chapters/notebook/notebook.h"
#include "chapters/props/judged_view.h"
#include "ssao/methods/hbao.h"

namespace crevice {

// The first sample of the direction that takes most; `steps` samples belong to each.
std::size_t darkest_direction(const Explanation& texel, int steps);

// HBAO with each of several settings: the raw maps of `view` around the foot of the column, and numbers of each.
struct HbaoStrip {
    std::vector<Notebook::Named> pictures;
    std::vector<std::vector<std::string>> rows;  // under kErrorHeader
    std::vector<double> errors, noise;           // RMS of what the method tends to against truth; of one map
    std::vector<double> means;                   // over the surfaces of the whole view
};
// 1, 2, 4 and 12 steps with bias 0; errors are measured on `judged`. No means.
HbaoStrip hbao_over_steps(const JudgedView& view, const JudgedView& judged, const Truth& truth);
// Radii of 1/4, 1/2, 1 and 2 scene units. Nothing but pictures and means.
HbaoStrip hbao_over_radii(const JudgedView& view);

// A ball of few facets with the smooth normals of a round one, on a floor.
Scene faceted_ball();
// At picture size with 96 samples of 8 steps.
Image<float> without_noise(const Scene& scene, Size size, HbaoSettings settings);

}  // namespace crevice
