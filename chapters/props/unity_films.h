// The films of chapter 14: the Unity notes' SSAO while a slider moves.
#pragma once

#include <vector>

#include "chapters/notebook/picture.h"
#include "chapters/props/judged_view.h"

namespace crevice {

// Frames of raw AO. Along the lower edge of each stands the slider: dark as far as it has gone.
struct UnityFilms {
    std::vector<Picture> radii;   // 0.1, 0.2 ... 1.2 scene units
    std::vector<Picture> counts;  // 4, 8 ... 64 points
    std::vector<Picture> seeds;   // 1 ... 8, of 16 points
};
// `shown` is the view's map with the settings that the seeds are drawn with.
UnityFilms unity_films(const JudgedView& view, const MethodMap& shown);

}  // namespace crevice
