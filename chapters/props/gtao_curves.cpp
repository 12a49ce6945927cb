#include "chapters/props/gtao_curves.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "ssao/rays/surface_points.h"

namespace crevice {

PlotCurve over_distance(const std::string& name, const JudgedView& view, const Image<float>& ao,
                        PlotStyle style) {
    constexpr int kRings = 14, kFirst = 2;
    constexpr double kRing = 0.2;
    std::vector<double> sums(kRings, 0), counts(kRings, 0);
    const SurfacePoints points = surface_points(view.scene(), view.camera(), view.gbuffer());
    for (std::size_t i = 0; i < points.points.size(); ++i) {
        const glm::dvec3 p = glm::dvec3(points.points[i].position) + view.camera().eye;
        if (p.y > 1e-3) continue;
        const std::size_t ring = static_cast<std::size_t>(std::sqrt(p.x * p.x + p.z * p.z) / kRing);
        if (ring >= kRings) continue;
        sums[ring] +=
            static_cast<double>(ao.at(points.pixel[i] % ao.size.width, points.pixel[i] / ao.size.width));
        counts[ring] += 1;
    }
    PlotCurve curve{name, {}, {}, {}, {}, style};
    for (std::size_t ring = kFirst; ring < kRings; ++ring) {
        if (counts[ring] == 0) continue;
        curve.x.push_back((static_cast<double>(ring) + 0.5) * kRing);
        curve.y.push_back(sums[ring] / counts[ring]);
    }
    return curve;
}

Gap gap_between(const PlotCurve& a, const PlotCurve& b) {
    Gap gap;
    const std::size_t count = std::min(a.y.size(), b.y.size());
    for (std::size_t i = 0; i < count; ++i) {
        const double apart = std::fabs(a.y[i] - b.y[i]);
        gap.most = std::max(gap.most, apart);
        gap.mean += apart / static_cast<double>(count);
    }
    return gap;
}

PlotCurve kept_curve(const std::string& name, double gamma) {
    PlotCurve curve{name, {}, {}, {}, {}, PlotStyle::smooth};
    const double open = gamma + std::numbers::pi / 2;
    for (int i = 0; i <= 100; ++i) {
        const double h = open * i / 100;
        curve.x.push_back(h * 180 / std::numbers::pi);
        curve.y.push_back((-std::cos(2 * h - gamma) + std::cos(gamma) + 2 * h * std::sin(gamma)) / 4);
    }
    return curve;
}

}  // namespace crevice
