#include "chapters/props/bounced_light.h"

#include <cmath>

#include "chapters/terminal/number_text.h"

namespace crevice {

PlotCurve bounce_curve(const std::string& name, float albedo, const MultiBounceFit& fit) {
    PlotCurve curve{name, {}, {}, {}, {}, PlotStyle::smooth};
    for (int i = 0; i <= 50; ++i) {
        const float access = static_cast<float>(i) / 50;
        curve.x.push_back(static_cast<double>(access));
        curve.y.push_back(static_cast<double>(multi_bounce(access, albedo, fit)));
    }
    return curve;
}

std::string linear_text(float slope, float offset) {
    return decimal_text(static_cast<double>(slope), 4) + "\\,\\rho " + (offset < 0 ? "- " : "+ ") +
           decimal_text(std::fabs(static_cast<double>(offset)), 4);
}

}  // namespace crevice
