// The eleven weights of the tutorials' blur: as a curve, against a Gaussian, and how wide they are.
#pragma once

#include <string>

#include "chapters/notebook/plot.h"
#include "ssao/blur/bilateral_blur.h"

namespace crevice {

// Over the distance from the texel, -kBlurRadius to kBlurRadius texels.
PlotCurve weights_curve(const std::string& name, const BlurWeights& weights);

// That of a Gaussian of standard deviation sigma (texels) at distance i, cut off at kBlurRadius and made to add up to 1.
double gaussian_weight(int i, double sigma);

// The square of the weights' standard deviation, texels².
double variance_of(const BlurWeights& weights);

}  // namespace crevice
