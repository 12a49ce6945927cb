// `crevice bench --scale`: how time and memory grow.
// How:  frames of method xjun by all threads. Over pixels: the scene `columns`, 64x36 to 7680x4320. Over
//       triangles: hills, 12 to 10 million at 1280x720. Over samples: `columns`, 1 to 14. Each point in a
//       program of its own, for its peak memory; times are medians of 15 frames. Two threads against one:
//       frames that take turns in one program.
// Says: exponents (least squares of the logarithms, with standard error) over all points, and between the two
//       largest, where fixed costs have faded; bytes per pixel and per triangle (a straight line through the
//       peak memory). 7680x4320 must need less than kMemoryLimit.
#pragma once

#include <filesystem>
#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include "chapters/bench/point.h"
#include "chapters/notebook/table.h"
#include "rasterizer/base/run.h"

namespace crevice {

inline constexpr Size kLargestPicture{7680, 4320};
inline constexpr double kMemoryLimit_bytes = 4e9;

struct ScaleOptions {
    bool quick = false;  // to 1920x1080 and 500,000 triangles; the memory of 7680x4320 from the line
    int threads = 0;     // as Run::threads
    std::optional<std::filesystem::path> out;  // the directory for tables and the page, if any
};

// What was varied, and what it gave.
struct ScaleStudy {
    std::string name;  // "pixels", "triangles", "samples"
    std::vector<double> x;
    std::vector<BenchPoint> points;
    std::vector<PointFigures> figures;

    // Of one pass; 0 where it did not run.
    std::vector<double> wall_ms(const std::string& pass) const;
    std::vector<double> peak_bytes() const;
};

// One row a study and pass: the exponent over all points with its error, and between the two largest.
Table exponent_table(const std::vector<ScaleStudy>& studies);

struct MemoryNeed {
    double bytes_per_pixel = 0, bytes_per_pixel_error = 0;
    double bytes_per_triangle = 0, bytes_per_triangle_error = 0;
    double largest_picture_bytes = 0;  // of kLargestPicture, measured or from the line
    bool measured = false;
};
MemoryNeed memory_need(const ScaleStudy& pixels, const ScaleStudy& triangles);

// Prints and writes the tables and DIR/bench_scale.html. Returns 0, or 1 when kLargestPicture needs too much.
// Throws InputError, OutputError.
int bench_scale(const ScaleOptions& options, std::ostream& out);

}  // namespace crevice
