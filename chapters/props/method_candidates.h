// All methods in one table, for whoever has to choose one: what each asks, reads and gets wrong.
#pragma once

#include <string>
#include <vector>

#include "chapters/props/judged_view.h"

namespace crevice {

struct CandidatesTable {
    // Method, its question, reads, error by its own question, noise, error of light, error of light at the bars with a radius
    // of 2, what stays wrong.
    std::vector<std::vector<std::string>> rows;
    std::vector<std::string> ranking;  // by the error of light, the nearest first
};
// `light` is the truth of ambient light in `view`, `bars_light` that of the bars.
CandidatesTable candidates_table(const JudgedView& view, const Truth& light, const JudgedView& bars,
                                 const Truth& bars_light);

}  // namespace crevice
