// One measurement of `crevice bench --scale`: a frame's times and the memory it takes. Peak memory is a
// program's own for good, so each point is measured by a program of its own, which is told the point as a
// word and answers with a line of JSON.
#pragma once

#include <string>

#include "chapters/terminal/stopwatch.h"
#include "rasterizer/base/image.h"

namespace crevice {

struct BenchPoint {
    Size size{1280, 720};  // pixels
    Size cells;            // of the height field, two triangles each; 0: the scene `columns`
    int samples = 14;      // of xjun
    int threads = 0;       // as Run::threads
    int frames = 15;       // times are medians over them
};

// "1280x720,columns,14,0,15", "1280x720,707x707,14,0,15"
std::string point_word(const BenchPoint& point);
// Throws UsageError.
BenchPoint point_from_word(const std::string& word);

struct PointFigures {
    double triangles = 0;
    double peak_bytes = 0;         // of the whole program, after its first frame
    std::vector<PassTime> passes;  // and last the frame
};

// Draws one frame for the memory, then as many as asked for the times.
PointFigures measure(const BenchPoint& point);

std::string figures_json(const PointFigures& figures);
// Throws InputError for anything else.
PointFigures figures_from_json(const std::string& text);

// Measures in a program of its own.
PointFigures measure_apart(const BenchPoint& point);

}  // namespace crevice
