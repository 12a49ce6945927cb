// How much Alchemy's and SAO's formulas take of a surface, over its distance; and the depths they read: for chapter 15.
#pragma once

#include <cmath>
#include <limits>
#include <string>

#include "chapters/notebook/plot.h"
#include "ssao/inputs/ao_inputs.h"
#include "ssao/methods/alchemy.h"
#include "ssao/methods/sao.h"

namespace crevice {

// What a surface straight above p takes at a distance, in radii, of the sum that is divided by the number of taps.
inline double alchemy_takes(double distance) {
    const AlchemySettings s;
    const double epsilon = static_cast<double>(s.epsilon);
    return 2 * distance / (distance * distance + epsilon);
}
inline double sao_takes(double distance) {
    const SaoSettings s;
    const double square = distance * distance, epsilon = static_cast<double>(s.epsilon);
    const double near = std::fmax(1 - square, 0.0);
    return 5 * near * near * near * std::fmax(distance - static_cast<double>(s.bias), 0.0) /
           (epsilon + square);
}

inline PlotCurve taking_curve(const std::string& name, double (*takes)(double)) {
    PlotCurve curve{name, {}, {}, {}, {}, PlotStyle::smooth};
    for (int i = 1; i <= 240; ++i) {
        curve.x.push_back(i / 200.0);
        curve.y.push_back(takes(i / 200.0));
    }
    return curve;
}

// A level of a pyramid as a picture, the background infinitely far away.
inline Image<float> level_of(const AoInputs& inputs, const DepthPyramid& pyramid, int level) {
    const float background = inputs.depth_map.pixels.front();
    Image<float> depth(pyramid.size(level));
    for (int y = 0; y < depth.size.height; ++y) {
        for (int x = 0; x < depth.size.width; ++x) {
            const float z = pyramid.at(level, x, y);
            depth.at(x, y) = z < background ? z : std::numeric_limits<float>::infinity();
        }
    }
    return depth;
}

}  // namespace crevice
