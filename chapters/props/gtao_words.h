// Words and rows of chapter 18 that are made from numbers: angles, slices, GTAO's parameters.
#pragma once

#include <string>
#include <vector>

#include "chapters/diagrams/slice_section.h"
#include "chapters/props/switched_ao.h"

namespace crevice {

// In whole degrees, with a minus as it is set in mathematics: "−38°".
std::string degrees_text(float radians);

// All slices of a texel.
std::vector<SliceHorizons> slices_of_texel(const AoInputs& inputs, const GtaoSettings& settings, Texel at);
// A row for each slice: number, |n_p|, gamma, both horizons, what it would keep if nothing occluded, what it loses.
std::vector<std::vector<std::string>> slice_rows(const std::vector<SliceHorizons>& slices);
// What the slices would keep if nothing occluded, one by one as "1.133, 0.904, ..."; and the mean of that.
std::string kept_when_open_text(const std::vector<SliceHorizons>& slices);
float mean_kept_when_open(const std::vector<SliceHorizons>& slices);

// {name, symbol, default, meaning} of each parameter that the chapter speaks of; the defaults are those of the method's row.
std::vector<std::vector<std::string>> gtao_parameter_rows();

// The numbers of samples that the method's row tries: "4, 8, ..."; and the slices and steps a side of each: "1 × 2, ...".
std::string sample_presets_text();
std::string slice_plans_text();

}  // namespace crevice
