#include "chapters/props/blur_weights_curve.h"

#include <cmath>

namespace crevice {
namespace {

double weight_at(const BlurWeights& weights, int i) {
    return static_cast<double>(weights[static_cast<std::size_t>(i + kBlurRadius)]);
}

}  // namespace

PlotCurve weights_curve(const std::string& name, const BlurWeights& weights) {
    PlotCurve curve{name, {}, {}};
    for (int i = -kBlurRadius; i <= kBlurRadius; ++i) {
        curve.x.push_back(i);
        curve.y.push_back(weight_at(weights, i));
    }
    return curve;
}

double gaussian_weight(int i, double sigma) {
    double total = 0;
    for (int j = -kBlurRadius; j <= kBlurRadius; ++j) total += std::exp(-j * j / (2 * sigma * sigma));
    return std::exp(-i * i / (2 * sigma * sigma)) / total;
}

double variance_of(const BlurWeights& weights) {
    double total = 0, squares = 0;
    for (int i = -kBlurRadius; i <= kBlurRadius; ++i) {
        total += weight_at(weights, i);
        squares += weight_at(weights, i) * i * i;
    }
    return squares / total;
}

}  // namespace crevice
