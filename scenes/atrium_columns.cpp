// The atrium's columns with their capitals, and the balustrade between the upper ones.
#include <algorithm>
#include <utility>
#include <vector>

#include "scenes/atrium.h"
#include "scenes/composing.h"
#include "scenes/curved_meshes.h"
#include "scenes/shapes.h"
#include "scenes/texture_painting.h"

namespace crevice {
namespace {

using Profile = std::vector<glm::dvec2>;

// From its floor up: pedestal, base, shaft, capital, abacus.
struct ColumnHeights {
    double pedestal, base, shaft, capital, abacus;
};
// Together they are as high as from each storey's floor to its spring.
constexpr ColumnHeights kGroundColumn{0.30, 0.17, 1.68, 0.46, 0.14},
    kUpperColumn{0.94, 0.13, 0.70, 0.36, 0.12};

Mesh square_pillar(const Profile& profile) {
    return with_material(frame_mesh(glm::dvec2(0), profile, kTextureAUnit), kLimestone);
}

Mesh pedestal_mesh(double half, double height) {
    return square_pillar({{0, height},
                          {half, height},
                          {half + 0.02, height - 0.02},
                          {half + 0.02, height - 0.07},
                          {half - 0.02, height - 0.10},
                          {half - 0.02, 0.10},
                          {half + 0.02, 0.06},
                          {half + 0.02, 0}});
}

Mesh abacus_mesh(double half, double height) {
    return square_pillar({{0, height},
                          {half, height},
                          {half, 0.55 * height},
                          {half - 0.03, 0.15 * height},
                          {half - 0.03, 0},
                          {0, 0}});
}

// An Attic base: two rolls with a hollow between them.
Mesh base_mesh(double radius, double height) {
    Profile profile = {{0.8 * radius, 0.95 * height}};  // the shaft stands in it
    const auto add_roll = [&](double middle, double half, double outer) {
        for (int i = 0; i <= 6; ++i) {
            const SineCosine at = sine_cosine(kPi * i / 6);
            profile.emplace_back(outer - half + half * at.sine, middle + half * at.cosine);
        }
    };
    add_roll(0.80 * height, 0.15 * height, 1.18 * radius);
    profile.emplace_back(1.06 * radius, 0.62 * height);
    profile.emplace_back(1.10 * radius, 0.50 * height);
    add_roll(0.24 * height, 0.22 * height, 1.38 * radius);
    profile.emplace_back(1.2 * radius, 0);
    return with_material(lathe_mesh(profile, 28, {3, 0.4}), kLimestone);
}

// `flutes` hollows run up the shaft, which narrows by a tenth; 0 leaves it smooth.
Mesh shaft_mesh(double radius, double height, int flutes) {
    const auto surface = [=](double u, double v) {
        const SineCosine around = sine_cosine(2 * kPi * u);
        // The hollows run out just below the top and just above the bottom.
        const double ends = smooth_step(0.0, 0.06, v) * smooth_step(0.0, 0.06, 1 - v);
        const double wave = flutes == 0 ? 0 : 0.5 - 0.5 * sine_cosine(2 * kPi * flutes * u).cosine;
        const double narrowing = 1 - 0.1 * (1 - v) * (1 - v);
        const double r = radius * narrowing * (1 - 0.075 * ends * wave);
        return glm::dvec3(r * around.cosine, (1 - v) * height, r * around.sine);
    };
    return with_material(curved_mesh(surface, flutes == 0 ? 32 : 6 * flutes, flutes == 0 ? 4 : 8, {2, 1}),
                         flutes == 0 ? kPorphyry : kLimestone);
}

// How far a row of eight leaves stands out of the bell: from its foot, where it grows, to the tip, which curls
// outward and ends.
double leaf_row(double turn, double up, double foot, double tip) {
    const double along = (up - foot) / (tip - foot);
    if (along <= 0 || along >= 1) return 0;
    const double from_midrib =
        2 * std::abs(8 * turn - floor_to_int(8 * turn) - 0.5);  // 0 at it, 1 between leaves
    const double blade = 1 - smooth_step(0.55, 0.95, from_midrib + 0.35 * along * along);
    const double curl = 0.35 * smooth_step(0.0, 0.3, along) + 0.65 * along * along;
    const double midrib = 0.25 * (1 - smooth_step(0.0, 0.16, from_midrib));
    return blade * curl * (1 - smooth_step(0.7, 1.0, along)) * (1 - midrib);
}

// A bell with two rows of leaves, the upper one between those of the lower. Radius at its foot 1, height 1.
Mesh capital_mesh(int columns, int rows) {
    const auto surface = [](double u, double v) {
        const double up = 1 - v;
        const SineCosine around = sine_cosine(2 * kPi * u);
        const double bell = 1 + 0.12 * up + 0.30 * up * up * up;
        const double leaves =
            std::max(0.36 * leaf_row(u, up, 0.02, 0.52), 0.40 * leaf_row(u + 1.0 / 16, up, 0.25, 0.92));
        const double r = bell + leaves;
        return glm::dvec3(r * around.cosine, up, r * around.sine);
    };
    return with_material(curved_mesh(surface, columns, rows, {2, 0.5}), kLimestone);
}

void add_columns(Scene& scene, double floor, const ColumnHeights& heights, double radius, int flutes,
                 Mesh bell) {
    const int pedestal = add_mesh(scene, pedestal_mesh(1.35 * radius, heights.pedestal));
    const int base = add_mesh(scene, base_mesh(radius, heights.base));
    const int shaft = add_mesh(scene, shaft_mesh(radius, heights.shaft, flutes));
    const int capital = add_mesh(scene, std::move(bell));
    const int abacus = add_mesh(scene, abacus_mesh(0.36, heights.abacus));
    for (const ArcadePlace& column : arcade_columns()) {
        glm::dvec3 at = column.at + glm::dvec3(0, floor, 0);
        const auto stack = [&](int mesh, double height, glm::dvec3 scale) {
            glm::dmat3 axes = column.axes;
            for (int i = 0; i < 3; ++i) axes[i] *= scale[i];
            scene.instances.push_back(placed(mesh, at, axes));
            at.y += height;
        };
        stack(pedestal, heights.pedestal, glm::dvec3(1));
        stack(base, heights.base, glm::dvec3(1));
        stack(shaft, heights.shaft, glm::dvec3(1));
        stack(capital, heights.capital, {0.9 * radius, heights.capital, 0.9 * radius});
        stack(abacus, heights.abacus, glm::dvec3(1));
    }
}

// A baluster: two bellies between rings.
Mesh baluster_mesh(double height) {
    const Profile parts = {{0.075, 1.0},  {0.075, 0.95}, {0.045, 0.92}, {0.05, 0.86},  {0.036, 0.80},
                           {0.040, 0.66}, {0.062, 0.48}, {0.076, 0.34}, {0.066, 0.22}, {0.042, 0.14},
                           {0.05, 0.10},  {0.075, 0.06}, {0.075, 0.0}};
    Profile profile;
    for (const glm::dvec2& part : parts) profile.emplace_back(part.x, part.y * height);
    return with_material(lathe_mesh(profile, 10, {1, 1}), kLimestone);
}

void add_balustrade(Scene& scene, double floor) {
    constexpr double kFoot = 0.10, kRail = 0.76, kHand = 0.90;
    constexpr int kBalusters = 6;
    const Profile foot = {{-0.13, floor},        {-0.13, floor + kFoot - 0.02}, {-0.11, floor + kFoot},
                          {0.11, floor + kFoot}, {0.13, floor + kFoot - 0.02},  {0.13, floor}};
    const Profile hand = {
        {0.10, floor + kRail},         {-0.10, floor + kRail},       {-0.14, floor + kRail + 0.04},
        {-0.14, floor + kHand - 0.04}, {-0.10, floor + kHand},       {0.10, floor + kHand},
        {0.14, floor + kHand - 0.04},  {0.14, floor + kRail + 0.04}, {0.10, floor + kRail}};
    for (const Profile& profile : {foot, hand}) {
        const int frame =
            add_mesh(scene, with_material(frame_mesh(kCourt, profile, kTextureAUnit), kLimestone));
        scene.instances.push_back(placed(frame, glm::dvec3(0), glm::dmat3(1)));
    }
    const int baluster = add_mesh(scene, baluster_mesh(kRail - kFoot));
    for (const ArcadePlace& arch : arcade_arches()) {
        for (int i = 0; i < kBalusters; ++i) {
            const double along = 0.3 * (i - 0.5 * (kBalusters - 1));
            scene.instances.push_back(placed(
                baluster, arch.at + along * arch.axes[0] + glm::dvec3(0, floor + kFoot, 0), glm::dmat3(1)));
        }
    }
}

}  // namespace

void add_atrium_columns(Scene& scene) {
    add_columns(scene, kStoreys[0].floor, kGroundColumn, 0.25, 16, capital_mesh(64, 20));
    add_columns(scene, kStoreys[1].floor, kUpperColumn, 0.19, 0, capital_mesh(48, 14));
    add_balustrade(scene, kStoreys[1].floor);
}

}  // namespace crevice
