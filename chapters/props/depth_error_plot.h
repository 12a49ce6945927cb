// The errors of rebuilt view depths as a table and a plot: for chapter 04.
#pragma once

#include <string>
#include <vector>

#include "chapters/notebook/plot.h"
#include "rasterizer/draw/depth_precision.h"

namespace crevice {

// A depth buffer that a picture may have.
struct DepthKind {
    const char* name;
    DepthFormat format;
    bool reversed_z;
};
inline constexpr DepthKind kDepthKinds[] = {{"D16", DepthFormat::d16, false},
                                            {"D24", DepthFormat::d24, false},
                                            {"D32F", DepthFormat::d32f, false},
                                            {"reversed D32F", DepthFormat::d32f, true}};

struct DepthErrorTable {
    std::vector<std::string> header;
    std::vector<std::vector<std::string>> rows;  // one a pair of planes
    double most_of_bound = 0;                    // the largest error over its bound
    double worst_reversed = 0;                   // the largest relative error of reversed D32F
};

// The largest relative errors for eight pairs of near and far planes, 32 depths an octave.
DepthErrorTable depth_error_table();

// Relative error over z from 1 to 1000, the planes: measured as dots, bounds as lines; D32F, which does as
// D24, left out.
Plot depth_error_plot();

}  // namespace crevice
