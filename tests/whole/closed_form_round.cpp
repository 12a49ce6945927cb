#include <algorithm>
#include <cmath>

#include "scenes/shapes.h"
#include "tests/tools/closed_form_scenes.h"
#include "tests/tools/closed_form_shapes.h"
#include "tests/tools/small_scenes.h"
#include "tests/tools/special_floats.h"

namespace crevice {

namespace {

using glm::dvec3;

constexpr dvec3 kUp = {0, 1, 0};
// How much smaller than the circle a polygon may be, in radii. No answer below changes faster than in
// proportion to a relative change of the radius.
// A function, for kInnerCircle may come about later than a constant here.
double polygon_error() { return 1 - kInnerCircle; }

double square(double a) { return a * a; }
double cube(double a) { return a * a * a; }

SurfacePoint point_at(dvec3 p, dvec3 normal) { return {placed(p), glm::vec3(normal), glm::vec3(normal)}; }

std::string named(const char* name, double value) {
    return std::string(name) + " = " + std::to_string(value);
}

ClosedForm coaxial_disc() {
    const double a = 1;
    ClosedForm form{
        "coaxial disc of radius 1", scene_of_shapes({disc(a, 2)}), kInfinity, polygon_error(), {}};
    for (const double h : {0.25, 1.0, 2.0})
        form.points.push_back(
            {named("h", h), point_at({0, 2 - h, 0}, kUp), h * h / (a * a + h * h), h / std::hypot(a, h)});
    return form;
}

// What the floor of a pit sees of its opening, r from the axis.
double pit_floor(double a, double d, double r) {
    const double sum = d * d + r * r;
    return 0.5 * (1 - (sum - a * a) / std::sqrt(square(sum + a * a) - 4 * r * r * a * a));
}
// What its wall sees of the opening from z below it.
double pit_wall(double a, double z) {
    const double share = z / (2 * a);
    return (share * share + 0.5) / std::sqrt(share * share + 1) - share;
}

ClosedForm pit() {
    const double a = 1, d = 1.5;
    ClosedForm form{"pit of radius 1 and depth 1.5",
                    scene_of_shapes({tube(a, -d), disc(a, -d)}),
                    kInfinity,
                    2 * polygon_error(),
                    {}};
    form.points.push_back({"centre of the floor", point_at({0, -d, 0}, kUp), a * a / (a * a + d * d),
                           1 - d / std::hypot(a, d)});
    for (const double r : {0.5, 0.875})
        form.points.push_back({named("floor, r", r), point_at({r, -d, 0}, kUp), pit_floor(a, d, r), {}});
    // r = a, as near to the wall as the polygon lets it be.
    form.points.push_back({"edge of the floor",
                           point_at({kInnerCircle - 1e-6, -d, 0}, kUp),
                           0.5 * (1 - d / std::sqrt(d * d + 4 * a * a)),
                           {}});
    for (const double z : {0.25, 0.75, 1.25})
        form.points.push_back(
            {named("wall, depth", z), point_at({kInnerCircle, -z, 0}, {-1, 0, 0}), pit_wall(a, z), {}});
    return form;
}

// A sphere of radius 1 whose centre is h above the floor, seen from the floor. By cosine the answer changes
// by at most twice the relative change of the radius; evenly weighted, at distance D from the centre, by
// 1 / (D sqrt(D^2 - 1)) of it, which is below 2 where the point is half a radius off the contact.
ClosedForm sphere_above_floor(std::shared_ptr<const RayScene> sphere) {
    ClosedForm form{"sphere over floor", std::move(sphere), kInfinity, 2 * kSphereSagitta, {}};
    const auto point = [](double rho, double h) { return point_at({0.6 * rho, -h, 0.8 * rho}, kUp); };
    form.points.push_back({"contact", point(0, 1), 0, 0});
    for (const double rho : {0.5, 1.0, 3.0})
        form.points.push_back({named("resting, rho", rho), point(rho, 1), 1 - 1 / cube(std::hypot(1.0, rho)),
                               rho / std::hypot(1.0, rho)});
    for (const double rho : {0.0, 1.0, 2.0}) {
        const double h = 1.5, distance = std::hypot(rho, h);
        form.points.push_back({named("raised to 1.5, rho", rho), point(rho, h), 1 - h / cube(distance),
                               std::sqrt(1 - 1 / square(distance))});
    }
    return form;
}

// At points of the surface. Where a ray of length R ends changes by at most the sagitta over R / 2 in its
// cosine, on either end.
ClosedForm inside_sphere(std::shared_ptr<const RayScene> sphere, float length) {
    const double share = std::min(length / 2.0, 1.0);
    ClosedForm form{named("inside sphere, rays of length", length),
                    std::move(sphere),
                    length,
                    share < 1 ? 4 * kSphereSagitta : 0,
                    {}};
    for (const std::size_t i : {std::size_t{0}, form.scene->triangles.size() / 3}) {
        const Corners& c = form.scene->triangles[i];
        const dvec3 inward = kPlace - dvec3(c[0]);
        form.points.push_back({named("triangle", static_cast<double>(i)),
                               point_of_triangle(c, dvec3(1.0 / 3), inward), 1 - share * share, 1 - share});
    }
    return form;
}

// A sphere of plane quadrilaterals, which bulges everywhere. (Of kSphereCells' sphere the cells are bent
// along their diagonals, some of them inwards.)
ClosedForm convex_sphere() {
    const Mesh mesh = sphere_mesh(1, 24, 16);
    Triangles triangles;
    for (const auto& t : mesh.triangles)
        triangles.push_back(
            {placed(mesh.positions[t[0]]), placed(mesh.positions[t[1]]), placed(mesh.positions[t[2]])});
    ClosedForm form{"convex sphere", scene_of_shapes({triangles}), kInfinity, 0, {}};
    for (const std::size_t i : {std::size_t{1}, triangles.size() / 3, triangles.size() / 2}) {
        const dvec3 outward = dvec3(triangles[i][0]) - kPlace;
        form.points.push_back({named("triangle", static_cast<double>(i)),
                               point_of_triangle(triangles[i], dvec3(0.5, 0.25, 0.25), outward), 1, 1});
    }
    return form;
}

}  // namespace

std::vector<ClosedForm> round_closed_forms() {
    const std::shared_ptr<const RayScene> sphere = scene_of_shapes({unit_sphere()});
    return {coaxial_disc(),
            pit(),
            sphere_above_floor(sphere),
            convex_sphere(),
            inside_sphere(sphere, 0.5f),
            inside_sphere(sphere, 1.5f),
            inside_sphere(sphere, 2),
            inside_sphere(sphere, kInfinity)};
}

std::vector<ClosedForm> closed_forms() {
    std::vector<ClosedForm> forms = flat_closed_forms();
    for (ClosedForm& form : round_closed_forms()) forms.push_back(std::move(form));
    return forms;
}

}  // namespace crevice
