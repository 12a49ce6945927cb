// The fit of bounced light, as chapter 20 shows it.
#pragma once

#include <string>

#include "chapters/notebook/plot.h"
#include "ssao/light/multi_bounce.h"

namespace crevice {

// What ambient light is multiplied by, over the accessibility from 0 to 1, on a surface of this albedo.
PlotCurve bounce_curve(const std::string& name, float albedo, const MultiBounceFit& fit);

// A coefficient of the fit, linear in the albedo, as mathematics: "2.0404\,\rho - 0.3324".
std::string linear_text(float slope, float offset);

}  // namespace crevice
