#include "chapters/props/cost_curves.h"

#include <algorithm>
#include <utility>

namespace crevice {

namespace {

constexpr int kSampleCounts[] = {1, 2, 4, 7, 10, 14}, kRayCounts[] = {1, 2, 4, 8, 16, 32};

// RMSE against T over what a picture's pixel asks on average: samples, or rays.
PlotCurve curve_of_method(const ErrorStudy& study, const std::string& name, float scale, int blurs) {
    PlotCurve curve{name, {}, {}};
    for (const StudyPoint& p : study.points) {
        if (!p.of || p.of->ao_scale != scale || p.of->blur_iterations != blurs) continue;
        curve.x.push_back(p.of->samples * static_cast<double>(scale) * static_cast<double>(scale));
        curve.y.push_back(p.truth.rmse);
        curve.y_low.push_back(p.truth.lowest);
        curve.y_high.push_back(p.truth.highest);
    }
    return curve;
}
PlotCurve curve_of_rays(const ErrorStudy& study) {
    PlotCurve curve{"ray cast", {}, {}};
    for (const StudyPoint& p : study.points) {
        if (p.of) continue;
        curve.x.push_back(kRayCounts[curve.x.size()]);
        curve.y.push_back(p.truth.rmse);
    }
    return curve;
}

}  // namespace

ErrorPlan cost_plan(Size size, int seeds) {
    constexpr Size kSmallest = {160, 90};
    ErrorPlan plan;
    plan.size = {std::max(size.width / 2, kSmallest.width), std::max(size.height / 2, kSmallest.height)};
    for (const auto& [scale, blurs] : {std::pair{1.0f, 0}, std::pair{1.0f, 4}, std::pair{0.5f, 4}}) {
        for (const int samples : kSampleCounts) plan.settings.push_back({samples, scale, blurs, false});
    }
    plan.cast_rays.assign(std::begin(kRayCounts), std::end(kRayCounts));
    plan.seeds = seeds;
    plan.reference_rays = 128;
    plan.limit_seeds = 64;
    return plan;
}

CostCurves cost_curves(const ErrorStudy& study) {
    return {curve_of_method(study, "raw", 1, 0), curve_of_method(study, "blurred", 1, 4),
            curve_of_method(study, "half size, blurred", 0.5f, 4), curve_of_rays(study)};
}

PlotCurve front_of(const std::vector<PlotCurve>& curves) {
    std::vector<std::pair<double, double>> points;
    for (const PlotCurve& curve : curves) {
        for (std::size_t i = 0; i < curve.x.size(); ++i) points.push_back({curve.x[i], curve.y[i]});
    }
    std::sort(points.begin(), points.end());
    PlotCurve front{"Pareto front", {}, {}, {}, {}, PlotStyle::front};
    for (const auto& [x, y] : points) {
        if (!front.y.empty() && y >= front.y.back()) continue;
        front.x.push_back(x);
        front.y.push_back(y);
    }
    return front;
}

}  // namespace crevice
