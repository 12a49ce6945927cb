// The maps of chapter 18: over samples and over radii, three causes of error, bare floors, bent normals.
#pragma once

#include <string>
#include <vector>

#include "chapters/notebook/notebook.h"
#include "chapters/props/judged_view.h"

namespace crevice {

// GTAO with each of several settings: the maps of `view` around the foot of the column, and numbers of each.
struct GtaoStrip {
    std::vector<Notebook::Named> pictures;
    std::vector<std::vector<std::string>> rows;  // under kErrorHeader
    std::vector<double> noise, errors;           // of one map; RMS of what the method tends to against truth
};
// 4, 8, 18 and 54 samples, before the filter; errors are measured on `judged`.
GtaoStrip over_samples(const JudgedView& view, const JudgedView& judged, const Truth& truth);
// Radii of 1/4, 1/2, 1 and 2 scene units, after the filter. Nothing but pictures.
GtaoStrip over_radii(const JudgedView& view);

// What makes the error of GTAO or of HBAO, each cause measured alone against `truth`.
struct ErrorCauses {
    MapError weight;  // even rays instead of cosine-weighted ones
    MapError depth;   // rays against the depth map instead of the scene
    MapError steps;   // the method instead of rays against the depth map
};
ErrorCauses error_causes(const JudgedView& view, const MethodLimit& method, const Truth& truth);
// A row for each: name, RMS error, mean error, and the methods that have it.
std::vector<std::vector<std::string>> error_cause_rows(const ErrorCauses& causes);

// Differences of a raw map from 1 over its lowest tenth, where the scene of the columns shows open floor.
struct Unevenness {
    double most = 0, rms = 0;
};
Unevenness unevenness(const MethodMap& map);

// The cosine between the normals of `inputs` and other unit vectors, texel by texel; 1 where there is no surface.
Image<float> cosine_to_normals(const AoInputs& inputs, const Image3& vectors);

}  // namespace crevice
