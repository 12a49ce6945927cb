// What adorns the atrium: a statue in a basin, reliefs, curtains and awnings.
#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>

#include "scenes/atrium.h"
#include "scenes/carved_head.h"
#include "scenes/composing.h"
#include "scenes/curved_meshes.h"
#include "scenes/shapes.h"
#include "scenes/texture_painting.h"

namespace crevice {
namespace {

using Profile = std::vector<glm::dvec2>;

// In the middle of the court: a basin of water's depth, steps, a drum, and on it a head that looks to -z.
void add_statue(Scene& scene, const Run& run) {
    const Profile basin = {{1.50, 0.36}, {1.56, 0.42}, {1.70, 0.42}, {1.76, 0.38}, {1.76, 0.33},
                           {1.66, 0.27}, {1.66, 0.08}, {1.76, 0.04}, {1.76, 0.0}};
    Profile inside = {{0.0, 0.10}, {1.44, 0.10}, {1.50, 0.16}, {1.50, 0.36}};
    inside.insert(inside.end(), basin.begin() + 1, basin.end());
    const Profile plinth = {{0.0, 1.50},  {0.52, 1.50}, {0.56, 1.47}, {0.56, 1.42}, {0.48, 1.34},
                            {0.44, 1.22}, {0.42, 0.72}, {0.47, 0.64}, {0.56, 0.60}, {0.56, 0.50},
                            {0.72, 0.50}, {0.72, 0.32}, {0.92, 0.32}, {0.92, 0.09}};
    const Profile neck = {{0.18, 0.58}, {0.20, 0.22}, {0.24, 0.12}, {0.33, 0.05}, {0.36, 0.0}};
    const auto add = [&scene](Mesh mesh, int material, glm::dvec3 at, double scale) {
        const int index = add_mesh(scene, with_material(std::move(mesh), material));
        scene.instances.push_back(placed(index, at, scale * glm::dmat3(1)));
    };
    add(lathe_mesh(inside, 64, {10, 2}), kLimestone, glm::dvec3(0), 1);
    add(lathe_mesh(plinth, 48, {4, 2}), kLimestone, glm::dvec3(0), 1);
    add(lathe_mesh(neck, 32, {1, 1}), kMarble, {0, 1.50, 0.05}, 1);
    constexpr double kScale = 0.2;
    constexpr int kCells = 40;
    add(carved_head_mesh(run, kCells), kMarble, {0, 1.70, 0}, kScale);
}

// cos(8 a) of the direction (x, y) at the angle a, by squaring a complex number three times; 1 in the middle.
double cosine_of_eight(glm::dvec2 at) {
    double r2 = glm::dot(at, at);
    if (r2 < 1e-12) return 1;
    for (int i = 0; i < 3; ++i) {
        at = {at.x * at.x - at.y * at.y, 2 * at.x * at.y};
        r2 *= r2;
    }
    return at.x / std::sqrt(r2);
}

// Half of a hill: 1 at 0, upright at 1, 0 beyond.
double dome(double t) { return std::sqrt(std::max(1 - t * t, 0.0)); }

// The height of a rosette in a ring, |x| and |y| <= 1/2.
double rosette_height(glm::dvec2 at) {
    const double r = glm::length(at), eight = cosine_of_eight(at);
    const double petal = 0.5 + 0.5 * eight, between = 1 - petal;
    const double outer = (0.03 + 0.05 * smooth_step(0.0, 0.8, petal)) * dome(r / (0.30 + 0.06 * petal));
    const double inner =
        0.04 + (0.03 + 0.03 * smooth_step(0.0, 0.8, between)) * dome(r / (0.15 + 0.04 * between));
    const double boss = 0.07 + 0.06 * dome(r / 0.065);
    double height = outer;
    if (r < 0.15 + 0.04 * between) height = std::max(height, inner);
    if (r < 0.065) height = std::max(height, boss);
    return std::max(height, 0.05 * dome((r - 0.39) / 0.025));
}

Mesh rosette_mesh(int cells) {
    constexpr double kGround = 0.02;  // in front of the wall
    const auto surface = [](double u, double v) {
        const glm::dvec2 at(u - 0.5, 0.5 - v);
        return glm::dvec3(at, -kGround - rosette_height(at));
    };
    return with_material(curved_mesh(surface, cells, cells, glm::dvec2(0.5)), kLimestone);
}

// The frame of a rosette, lying: its inner edge covers that of the rosette's square.
Mesh relief_frame_mesh() {
    const Profile profile = {{-0.04, 0.0},  {-0.04, 0.05}, {-0.025, 0.07}, {0.015, 0.07},
                             {0.025, 0.06}, {0.025, 0.04}, {0.05, 0.03},   {0.05, 0.0}};
    return with_material(frame_mesh(glm::dvec2(0.5), profile, kTextureAUnit), kLimestone);
}

void add_reliefs(Scene& scene) {
    const int large = add_mesh(scene, rosette_mesh(40)), small = add_mesh(scene, rosette_mesh(20));
    const int frame = add_mesh(scene, relief_frame_mesh());
    const auto add = [&](int rosette, glm::dvec3 on_wall, const glm::dmat3& axes, double side) {
        scene.instances.push_back(placed(rosette, on_wall, side * axes));
        scene.instances.push_back(placed(frame, on_wall, side * (axes * kStanding)));
    };
    for (const ArcadePlace& arch : arcade_arches()) {
        if (arch.number % 2 == 1)
            add(large, arch.at + kBay * arch.axes[2] + glm::dvec3(0, 1.75, 0), arch.axes, 1.2);
    }
    // Small ones above the columns, on the court's side; a corner has no room.
    for (const Storey& storey : kStoreys) {
        for (const ArcadePlace& column : arcade_columns()) {
            const glm::dvec3 on_wall =
                column.at - kWallHalf * column.axes[2] + glm::dvec3(0, storey.spring + 0.85, 0);
            if (column.number > 0) add(small, on_wall, column.axes, 0.4);
        }
    }
}

constexpr double kCurtainHeight = 2.62, kTie = 0.6;  // the tie: its part of the height, from the top

// How wide a curtain is: all of it at the rod, drawn together at the tie, wider again below.
double drawn_width(double v) {
    return 1 - 0.78 * smooth_step(0.0, kTie, v) + 0.16 * smooth_step(kTie, 1.05, v);
}

// One half of a pair, from the column (x = 0) towards the middle of the arch (x > 0), hanging from y = 0.
Mesh curtain_mesh(int material) {
    constexpr double kWidth = 0.96;
    constexpr int kFolds = 6;
    const auto surface = [](double u, double v) {
        const double wide = drawn_width(v);
        const double fold = sine_cosine(2 * kPi * kFolds * (u + 0.02 * v)).sine;
        const double swing = sine_cosine(2 * kPi * (u + 0.5 * v)).sine;
        return glm::dvec3(kWidth * wide * u, -kCurtainHeight * v,
                          (0.03 + 0.055 * (1 - wide)) * fold + 0.02 * v * swing);
    };
    return with_material(curved_mesh(surface, 60, 20, {1, 2.5}), material);
}

// In every second arch of the long sides.
void add_curtains(Scene& scene) {
    const int curtains[] = {add_mesh(scene, curtain_mesh(kCrimson)), add_mesh(scene, curtain_mesh(kBlue))};
    const int rod = add_mesh(scene, with_material(cylinder_mesh(0.022, 0.022, 2.0, 12, 1), kBronze));
    const Profile tie_profile = {{0.11, 0.03}, {0.125, 0.02}, {0.125, -0.02}, {0.11, -0.03}, {0.11, 0.03}};
    const int tie = add_mesh(scene, with_material(lathe_mesh(tie_profile, 24, {1, 1}), kBronze));
    const double rod_y = kStoreys[0].spring - 0.07;
    for (const ArcadePlace& arch : arcade_arches()) {
        if (!arch.long_side || arch.number % 2 == 0) continue;
        const glm::dmat3& axes = arch.axes;
        const glm::dvec3 middle = arch.at + glm::dvec3(0, rod_y, 0);
        scene.instances.push_back(placed(rod, middle, glm::dmat3(axes[1], -axes[0], axes[2])));
        const int curtain = curtains[arch.number / 2 % 2];
        for (const double side : {-1.0, 1.0}) {
            // The right half is the left one turned about the arch's middle line, not mirrored.
            const glm::dmat3 turn(-side * axes[0], axes[1], -side * axes[2]);
            scene.instances.push_back(placed(curtain, middle + 0.97 * side * axes[0], turn));
            scene.instances.push_back(
                placed(tie, middle + 0.87 * side * axes[0] - glm::dvec3(0, kTie * kCurtainHeight, 0),
                       glm::dmat3(1)));
        }
    }
}

// A cloth from wall to wall across the court, along x, gathered at its ends and sagging.
Mesh awning_mesh(int material) {
    constexpr double kSpan = 7.1, kSag = 1.0;
    constexpr int kFolds = 5;
    const auto surface = [](double u, double v) {
        const double spread = 4 * u * (1 - u);
        const double across = v - 0.5;
        const double fold = sine_cosine(2 * kPi * kFolds * v).cosine;
        return glm::dvec3(
            kSpan * (u - 0.5),
            -kSag * spread - 0.25 * spread * (1 - 4 * across * across) + (0.07 - 0.045 * spread) * fold,
            -(0.45 + 1.35 * spread) * across);
    };
    return with_material(curved_mesh(surface, 40, 40, {5, 1.2}), material);
}

void add_awnings(Scene& scene) {
    const int awnings[] = {add_mesh(scene, awning_mesh(kBlue)), add_mesh(scene, awning_mesh(kCrimson))};
    int number = 0;
    for (const double z : {-3.75, 1.25, 6.25}) {
        scene.instances.push_back(
            placed(awnings[number % 2], {0, kStoreys[1].spring + 0.25, z}, glm::dmat3(1)));
        ++number;
    }
}

}  // namespace

void add_atrium_art(Scene& scene, const Run& run) {
    add_statue(scene, run);
    add_reliefs(scene);
    add_curtains(scene);
    add_awnings(scene);
}

}  // namespace crevice
