// The eleven weights of the tutorials' blur: as a curve, against a Gaussian, and how wide they are.
#pragma once

#include <string>

#include "chapters/notebook/plot.h"
#include "ssao/blur/bilateral_blur.h"

namespace crevice {

// Over the distance from the texel, -kBlurRadius to kBlurRadius texels.
PlotCurve weights_curve(const std::string& name, const BlurWeights& weights);

// The largest difference of a weight from a Gaussian's of standard deviation sigma (texels), cut off at kBlurRadius and
// made to add up to 1.
double off_gaussian(const BlurWeights& weights, double sigma);

// The standard deviation of so many iterations, texels: the squares of those of one add up.
double sigma_after(int iterations, const BlurWeights& weights);

}  // namespace crevice
