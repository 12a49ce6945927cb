#include <cmath>

#include "tests/tools/closed_form_scenes.h"
#include "tests/tools/closed_form_shapes.h"
#include "tests/tools/special_floats.h"

namespace crevice {

namespace {

using glm::dvec2;
using glm::dvec3;

constexpr dvec3 kUp = {0, 1, 0}, kRight = {1, 0, 0};
// In scenes that are what they should be but for the rounding of corners and the lift of origins.
constexpr double kRounding = 1e-5;

double square(double a) { return a * a; }

SurfacePoint point_at(dvec3 p, dvec3 normal) { return {placed(p), glm::vec3(normal), glm::vec3(normal)}; }

std::string named(const char* name, double value) {
    return std::string(name) + " = " + std::to_string(value);
}

Triangles floor_plane() { return level_rectangle({-8, -8}, {8, 8}, 0); }
// The plane x = 0, from below the floor up to `height`.
Triangles wall_plane(double height) {
    return rectangle({0, -1, -kFar}, {0, 1 + height, 0}, {0, 0, 2 * kFar});
}
// The half plane that leaves the z axis at an angle above the floor.
Triangles slope(double angle) {
    return rectangle({0, 0, -kFar}, kFar * dvec3(std::cos(angle), std::sin(angle), 0), {0, 0, 2 * kFar});
}
// The upright half plane that leaves the y axis at an angle from x to z.
Triangles upright(double angle) {
    return rectangle({0, -1, 0}, {0, 1 + kFar, 0}, kFar * dvec3(std::cos(angle), 0, std::sin(angle)));
}

ClosedForm open_plane() {
    ClosedForm form{"open plane", scene_of_shapes({floor_plane()}), kInfinity, 0, {}};
    for (const dvec3 p : {dvec3(0), dvec3(1, 0, -2), dvec3(-7.5, 0, 7.5)})
        form.points.push_back({named("x", p.x), point_at(p, kUp), 1, 1});
    return form;
}

ClosedForm open_tilted_plane() {
    const Triangles plane = rectangle({1, 2, 3}, {3, 1, 0.5}, {-0.5, 2, 3});
    ClosedForm form{"open plane, tilted", scene_of_shapes({plane}), kInfinity, 0, {}};
    const dvec3 side = {0, 1, 0};
    for (const dvec3 weights : {dvec3(0.25, 0.25, 0.5), dvec3(0.125, 0.75, 0.125)})
        form.points.push_back({named("weight", weights.y), point_of_triangle(plane[0], weights, side), 1, 1});
    form.points.push_back({"other side", point_of_triangle(plane[1], dvec3(0.5, 0.25, 0.25), -side), 1, 1});
    return form;
}

ClosedForm convex_box() {
    const Triangles sides[] = {
        level_rectangle({-1, -1}, {1, 1}, -1),         level_rectangle({-1, -1}, {1, 1}, 1),
        rectangle({-1, -1, -1}, {0, 2, 0}, {2, 0, 0}), rectangle({-1, -1, 1}, {0, 2, 0}, {2, 0, 0}),
        rectangle({-1, -1, -1}, {0, 2, 0}, {0, 0, 2}), rectangle({1, -1, -1}, {0, 2, 0}, {0, 0, 2})};
    ClosedForm form{"convex box", scene_of_shapes({std::begin(sides), std::end(sides)}), kInfinity, 0, {}};
    for (const dvec3 n : {dvec3(0, 1, 0), dvec3(-1, 0, 0), dvec3(0, 0, 1)})
        form.points.push_back({named("face n.x", n.x), point_at(n + 0.875 * dvec3(n.y, n.z, n.x), n), 1, 1});
    return form;
}

ClosedForm infinite_wall() {
    ClosedForm form{
        "infinite wall", scene_of_shapes({floor_plane(), wall_plane(kFar)}), kInfinity, kTruncation, {}};
    for (const double x : {0.25, 1.0, 3.0})
        form.points.push_back({named("x", x), point_at({x, 0, 0}, kUp), 0.5, 0.5});
    return form;
}

ClosedForm wall_of_height() {
    const double h = 1;
    ClosedForm form{"wall of height 1", scene_of_shapes({wall_plane(h)}), kInfinity, kTruncation, {}};
    for (const double x : {0.25, 1.0, 4.0})
        form.points.push_back({named("x", x), point_at({x, 0, 0}, kUp), 1 - (1 - x / std::hypot(x, h)) / 2,
                               1 - std::atan(h / x) / kPi});
    return form;
}

ClosedForm wall_and_ray_length() {
    const double length = 2;
    ClosedForm form{"infinite wall, rays of length 2", scene_of_shapes({wall_plane(kFar)}), 2, kRounding, {}};
    for (const double x : {0.25, 1.0, 1.75}) {
        const double c = x / length;
        form.points.push_back({named("x", x), point_at({x, 0, 0}, kUp),
                               1 - (std::acos(c) - c * std::sqrt(1 - c * c)) / kPi, 1 - (1 - c) / 2});
    }
    form.points.push_back({"out of reach", point_at({2.5, 0, 0}, kUp), 1, 1});
    return form;
}

ClosedForm dihedral(double degrees) {
    const double d = degrees * kPi / 180;
    const Triangles ground = rectangle({0, 0, -kFar}, {kFar, 0, 0}, {0, 0, 2 * kFar});
    ClosedForm form{named("dihedral of degrees", degrees),
                    scene_of_shapes({ground, slope(d)}),
                    kInfinity,
                    kTruncation,
                    {}};
    const double cosine = square(std::sin(d / 2)), uniform = d / kPi;
    for (const double x : {0.5, 2.0})
        form.points.push_back({named("x", x), point_at({x, 0, 0.25}, kUp), cosine, uniform});
    form.points.push_back({"on the slope",
                           point_at(dvec3(std::cos(d), std::sin(d), 0), {std::sin(d), -std::cos(d), 0}),
                           cosine, uniform});
    return form;
}

ClosedForm room_corner() {
    ClosedForm form{
        "room corner",
        scene_of_shapes({rectangle({0, 0, 0}, {kFar, 0, 0}, {0, 0, kFar}), upright(0), upright(kPi / 2)}),
        kInfinity,
        2 * kTruncation,
        {}};
    form.points.push_back({"floor", point_at({1, 0, 1}, kUp), 0.25, 0.25});
    form.points.push_back({"floor, near one wall", point_at({0.25, 0, 3}, kUp), 0.25, 0.25});
    form.points.push_back({"wall", point_at({0, 1, 2}, kRight), 0.25, 0.25});
    return form;
}

ClosedForm walls_of_opening(double degrees) {
    const double b = degrees * kPi / 180;
    ClosedForm form{named("walls opening degrees", degrees),
                    scene_of_shapes({upright(0), upright(b)}),
                    kInfinity,
                    2 * kTruncation,
                    {}};
    for (const double share : {0.5, 0.2})
        form.points.push_back({named("at share", share),
                               point_at(dvec3(std::cos(share * b), 0, std::sin(share * b)), kUp),
                               b / (2 * kPi), b / (2 * kPi)});
    return form;
}

ClosedForm ceiling(float length) {
    const double h = 1, r = length;
    ClosedForm form{named("ceiling at 1, rays of length", r),
                    scene_of_shapes({level_rectangle({-8, -8}, {8, 8}, h)}),
                    length,
                    kRounding,
                    {}};
    for (const double x : {0.0, 1.5})
        form.points.push_back({named("x", x), point_at({x, 0, x}, kUp), square(h / r), h / r});
    return form;
}

ClosedForm trench_floor() {
    const double w = 1, d = 0.75;
    const Triangles ground = rectangle({0, -d, -kFar}, {w, 0, 0}, {0, 0, 2 * kFar});
    const Triangles left = rectangle({0, -d, -kFar}, {0, d, 0}, {0, 0, 2 * kFar}),
                    right = rectangle({w, -d, -kFar}, {0, d, 0}, {0, 0, 2 * kFar});
    ClosedForm form{"trench", scene_of_shapes({ground, left, right}), kInfinity, kTruncation, {}};
    for (const double x : {0.125, 0.5, 0.9375}) {
        form.points.push_back({named("floor, x", x), point_at({x, -d, 0}, kUp),
                               (x / std::hypot(x, d) + (w - x) / std::hypot(w - x, d)) / 2,
                               (std::atan(x / d) + std::atan((w - x) / d)) / kPi});
    }
    for (const double z : {0.125, 0.5})
        form.points.push_back({named("wall, depth", z), point_at({0, -z, 0}, kRight),
                               (1 - z / std::hypot(z, w)) / 2, 0.5 - std::atan(z / w) / kPi});
    return form;
}

ClosedForm tilted_normals() {
    const Triangles ground = level_rectangle({-kFar, -kFar}, {kFar, kFar}, 0);
    ClosedForm form{"tilted normal over ground", scene_of_shapes({ground}), kInfinity, kTruncation, {}};
    for (const double degrees : {0.0, 30.0, 60.0, 90.0, 150.0}) {
        const double t = degrees * kPi / 180;
        const dvec3 tilted = {std::sin(t), std::cos(t), 0};
        const double cosine = (1 + std::cos(t)) / 2, uniform = 1 - t / kPi;
        form.points.push_back(
            {named("above, degrees", degrees), point_at({0, 0.5, 0}, tilted), cosine, uniform});
        if (degrees >= 90) continue;
        // On the ground itself: what a vertex normal does. Rays below the ground's own plane are blocked.
        SurfacePoint shaded = point_at({1, 0, 2}, tilted);
        shaded.geometric_normal = glm::vec3(kUp);
        form.points.push_back({named("on it, degrees", degrees), shaded, cosine, uniform});
    }
    return form;
}

// The share of a white hemisphere that an a x b rectangle takes, parallel, one corner above the point at c.
double parallel_share(double a, double b, double c) {
    const double x = a / c, y = b / c, wx = std::sqrt(1 + x * x), wy = std::sqrt(1 + y * y);
    return (x / wx * std::atan(y / wx) + y / wy * std::atan(x / wy)) / (2 * kPi);
}
// ... upright on the floor, of height a and width b, one foot at distance c in front of the point.
double upright_share(double a, double b, double c) {
    const double x = a / b, y = c / b, w = std::hypot(x, y);
    return (std::atan(1 / y) - y / w * std::atan(1 / w)) / (2 * kPi);
}

ClosedForm parallel_rectangle() {
    const double a = 1, b = 2;
    ClosedForm form{"parallel rectangle 1 x 2",
                    scene_of_shapes({level_rectangle({0, 0}, {a, b}, 1)}),
                    kInfinity,
                    kRounding,
                    {}};
    for (const double c : {0.25, 1.0})
        form.points.push_back(
            {named("corner at", c), point_at({0, 1 - c, 0}, kUp), 1 - parallel_share(a, b, c), {}});
    form.points.push_back({"under the middle",
                           point_at({a / 2, 0.5, b / 2}, kUp),
                           1 - 4 * parallel_share(a / 2, b / 2, 0.5),
                           {}});
    return form;
}

ClosedForm upright_rectangle() {
    const double a = 1.5, b = 2;
    ClosedForm form{"upright rectangle 1.5 x 2",
                    scene_of_shapes({rectangle({0, 0, 0}, {0, a, 0}, {0, 0, b})}),
                    kInfinity,
                    kRounding,
                    {}};
    for (const double c : {0.25, 1.0})
        form.points.push_back(
            {named("foot at", c), point_at({c, 0, 0}, kUp), 1 - upright_share(a, b, c), {}});
    form.points.push_back(
        {"before the middle", point_at({0.5, 0, b / 2}, kUp), 1 - 2 * upright_share(a, b / 2, 0.5), {}});
    return form;
}

}  // namespace

std::vector<ClosedForm> flat_closed_forms() {
    return {open_plane(),          open_tilted_plane(), convex_box(),   infinite_wall(), wall_of_height(),
            wall_and_ray_length(), dihedral(60),        dihedral(120),  room_corner(),   walls_of_opening(60),
            walls_of_opening(150), ceiling(2),          ceiling(1.25f), trench_floor(),  tilted_normals(),
            parallel_rectangle(),  upright_rectangle()};
}

}  // namespace crevice
