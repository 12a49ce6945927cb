#include "chapters/props/blur_weights_curve.h"

#include <algorithm>
#include <cmath>

namespace crevice {
namespace {

double weight_at(const BlurWeights& weights, int i) {
    return static_cast<double>(weights[static_cast<std::size_t>(i + kBlurRadius)]);
}

// That of a Gaussian at distance i, which is made to add up to 1.
double gaussian_weight(int i, double sigma) {
    double total = 0;
    for (int j = -kBlurRadius; j <= kBlurRadius; ++j) total += std::exp(-j * j / (2 * sigma * sigma));
    return std::exp(-i * i / (2 * sigma * sigma)) / total;
}

// The square of the standard deviation, texels².
double variance_of(const BlurWeights& weights) {
    double total = 0, squares = 0;
    for (int i = -kBlurRadius; i <= kBlurRadius; ++i) {
        total += weight_at(weights, i);
        squares += weight_at(weights, i) * i * i;
    }
    return squares / total;
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

double off_gaussian(const BlurWeights& weights, double sigma) {
    double most = 0;
    for (int i = -kBlurRadius; i <= kBlurRadius; ++i)
        most = std::max(most, std::fabs(weight_at(weights, i) - gaussian_weight(i, sigma)));
    return most;
}

double sigma_after(int iterations, const BlurWeights& weights) {
    return std::sqrt(iterations * variance_of(weights));
}

}  // namespace crevice
