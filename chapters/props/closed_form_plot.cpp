#include "chapters/props/closed_form_plot.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "rasterizer/lanes/approx_math.h"
#include "scenes/builtin_scenes.h"
#include "ssao/rays/ray_cast_ao.h"

namespace crevice {

namespace {

constexpr int kPositions = 20;
constexpr double kFarthest = 4;  // scene units
constexpr float kWallRadius = 4;

// Positions and the closed forms there.
struct ClosedForm {
    std::vector<double> x, cosine, uniform;
};

// A ray of the normal's hemisphere misses a sphere whose centre is seen in the direction c, and whose half
// angle has the sine s, with probability 1 - s^2 cos(c, n), cosine-weighted, if all of it is above the plane.
ClosedForm beside_a_sphere() {
    ClosedForm form;
    for (int i = 1; i <= kPositions; ++i) {
        const double x = kFarthest * i / kPositions, sine = 1 / std::sqrt(1 + x * x);
        form.x.push_back(x);
        form.cosine.push_back(1 - sine * sine * sine);
        form.uniform.push_back(x * sine);
    }
    return form;
}

// Parameter: the angle between the way to the wall and the rays that just reach it; its cosine is x / length.
ClosedForm beside_a_wall() {
    ClosedForm form;
    for (int i = kPositions - 1; i >= 0; --i) {
        const double angle_rad = kPi / 2 * i / kPositions;
        const SineCosine at = sine_cosine(angle_rad);
        form.x.push_back(static_cast<double>(kWallRadius) * at.cosine);
        form.cosine.push_back(1 - (angle_rad - at.cosine * at.sine) / kPi);
        form.uniform.push_back(0.5 + 0.5 * at.cosine);
    }
    return form;
}

// `away`: the way from x = 0 along the floor.
ClosedFormPlot plotted(const Scene& scene, glm::vec3 away, const ClosedForm& form, RayAoSettings settings,
                       const std::string& title, const std::string& distance) {
    const RayScene rays = ray_scene(scene, glm::dvec3(0));
    std::vector<SurfacePoint> points;
    for (const double x : form.x) points.push_back({static_cast<float>(x) * away, {0, 1, 0}, {0, 1, 0}});
    ClosedFormPlot result{{title, {distance, false, 0, kFarthest}, {"accessibility", false, 0, 1}, {}}, 0};
    for (const RayWeight weight : {RayWeight::cosine, RayWeight::uniform}) {
        const bool cosine = weight == RayWeight::cosine;
        const std::vector<double>& exact = cosine ? form.cosine : form.uniform;
        const std::string name = cosine ? "cosine" : "uniform";
        settings.weight = weight;
        const std::vector<float> open = ray_cast_ao(rays, points, settings);
        for (std::size_t i = 0; i < open.size(); ++i)
            result.worst = std::max(result.worst, std::fabs(static_cast<double>(open[i]) - exact[i]));
        result.plot.curves.push_back({name + ", closed form", form.x, exact, {}, {}, PlotStyle::smooth});
        result.plot.curves.push_back(
            {name + ", rays", form.x, {open.begin(), open.end()}, {}, {}, PlotStyle::dots});
    }
    return result;
}

}  // namespace

ClosedFormPlot sphere_on_plane_plot(int rays, std::uint32_t seed) {
    return plotted(sphere_on_plane_scene(), {1, 0, 0}, beside_a_sphere(),
                   {.rays = rays, .radius = std::numeric_limits<float>::infinity(), .seed = seed},
                   "Beside a resting sphere", "distance from the contact, radii of the sphere");
}

ClosedFormPlot long_wall_plot(int rays, std::uint32_t seed) {
    return plotted(wall_corner_scene(), {0, 0, -1}, beside_a_wall(),
                   {.rays = rays, .radius = kWallRadius, .seed = seed}, "Before a long wall",
                   "distance from the wall, scene units");
}

}  // namespace crevice
