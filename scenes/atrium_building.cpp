// Walls, arcades, vaults, floors and roof of the atrium.
#include <utility>
#include <vector>

#include "scenes/atrium.h"
#include "scenes/composing.h"
#include "scenes/curved_meshes.h"
#include "scenes/lattice_mesh.h"
#include "scenes/shapes.h"

namespace crevice {
namespace {

using Profile = std::vector<glm::dvec2>;

// The arcade's wall over one bay: from y = 0, where the arch springs, up to `height`. The arch is cut where
// lines from its middle meet the wall's sides and top at even steps.
Mesh spandrel_mesh(double height) {
    constexpr int kSideSteps = 8, kTopSteps = 16;
    std::vector<glm::dvec2> rim;  // from the left foot up and over to the right one
    for (int i = 0; i < kSideSteps; ++i) rim.emplace_back(-0.5 * kBay, height * i / kSideSteps);
    for (int i = 0; i <= kTopSteps; ++i)
        rim.emplace_back(kBay * (static_cast<double>(i) / kTopSteps - 0.5), height);
    for (int i = kSideSteps - 1; i >= 0; --i) rim.emplace_back(0.5 * kBay, height * i / kSideSteps);
    Mesh mesh;
    const auto add_row = [&](double z, bool on_arch, bool underside) {
        for (const glm::dvec2& outer : rim) {
            const glm::dvec2 inner = kOpening * glm::normalize(outer);
            const glm::dvec3 p(on_arch ? inner : outer, z);
            const glm::dvec3 normal = underside ? glm::dvec3(-inner, 0) : glm::dvec3(0, 0, z);
            add_vertex(mesh, p, normal, kTextureAUnit * glm::dvec2(underside ? p.z : p.x, -p.y));
        }
    };
    const auto add_strip = [&](auto upper, auto lower, bool underside) {
        const int first = static_cast<int>(mesh.positions.size());
        add_row(upper.first, upper.second, underside);
        add_row(lower.first, lower.second, underside);
        add_lattice_triangles(mesh, first, 2, static_cast<int>(rim.size()));
    };
    const std::pair<double, bool> front_rim{-kWallHalf, false}, front_arch{-kWallHalf, true},
        back_rim{kWallHalf, false}, back_arch{kWallHalf, true};
    add_strip(front_rim, front_arch, false);
    add_strip(front_arch, back_arch, true);
    add_strip(back_arch, back_rim, false);
    return as_one_part(std::move(mesh), kAshlar);
}

// A moulded half ring that stands on y = 0 around the origin, |z| <= half_depth.
Mesh ring_mesh(double inner, double outer, double half_depth) {
    constexpr double kChamfer = 0.03;
    const double in = inner + kChamfer, out = outer - kChamfer, back = half_depth - kChamfer;
    const Profile profile = {{in, half_depth}, {out, half_depth},  {outer, back},
                             {outer, -back},   {out, -half_depth}, {in, -half_depth},
                             {inner, -back},   {inner, back},      {in, half_depth}};
    return with_material(lathe_mesh(profile, 48, {6, 0.5}, 24), kLimestone);
}

// A quarter of a bay's groined vault, from its middle towards +x, seen from below. Its radius leaves a strip
// along the bay's edge that ribs and piers hide.
Mesh vault_mesh() {
    constexpr double kRadius = 1.22;
    const auto surface = [](double u, double v) {
        const SineCosine at = sine_cosine((0.5 - u) * kPi);
        const double groin = kRadius * (at.sine < 0 ? -at.sine : at.sine);
        return glm::dvec3(groin + v * (0.5 * kBay - groin), kRadius * at.cosine, kRadius * at.sine);
    };
    return with_material(curved_mesh(surface, 12, 4, {2, 1}), kPlaster);
}

// The square pier under the ribs at the outer wall: half of it stands out.
Mesh pier_mesh(double height) {
    const Profile profile = {
        {0, height},           {0.30, height}, {0.30, height - 0.08}, {0.26, height - 0.14},
        {0.22, height - 0.18}, {0.22, 0.12},   {0.26, 0.08},          {0.26, 0}};
    return with_material(frame_mesh(glm::dvec2(0), profile, kTextureAUnit), kLimestone);
}

void add_vaults(Scene& scene, int vault, double spring) {
    const glm::dmat3 quarter{{0, 0, 1}, {0, 1, 0}, {-1, 0, 0}};
    const int last_x = kBaysAcross + 1, last_z = kBaysAlong + 1;
    for (int i = 0; i <= last_x; ++i) {
        for (int k = 0; k <= last_z; ++k) {
            if (i > 0 && i < last_x && k > 0 && k < last_z) continue;  // the court
            const glm::dvec3 middle((i - 0.5 * last_x) * kBay, spring, (k - 0.5 * last_z) * kBay);
            glm::dmat3 axes(1);
            for (int turn = 0; turn < 4; ++turn, axes = quarter * axes)
                scene.instances.push_back(placed(vault, middle, axes));
        }
    }
}

// The ribs from the columns to the outer wall, and the piers that they end on.
void add_ribs(Scene& scene, int rib, int pier, const Storey& storey) {
    for (const ArcadePlace& column : arcade_columns()) {
        const auto add = [&](glm::dvec3 into_aisle, glm::dvec3 across) {
            const glm::dmat3 axes = glm::dmat3(into_aisle, {0, 1, 0}, across) * kStanding;
            scene.instances.push_back(
                placed(rib, column.at + 0.5 * kBay * into_aisle + glm::dvec3(0, storey.spring, 0), axes));
            scene.instances.push_back(
                placed(pier, column.at + kBay * into_aisle + glm::dvec3(0, storey.floor, 0), glm::dmat3(1)));
        };
        add(column.axes[2], -column.axes[0]);
        if (column.number == 0) add(-column.axes[0], -column.axes[2]);
    }
}

void add_storey(Scene& scene, const Storey& storey, int ring, int keystone) {
    const double height = storey.top - storey.spring;
    const int spandrel = add_mesh(scene, spandrel_mesh(height));
    const int corner = add_mesh(scene, with_material(box_mesh({0.54, height, 0.54}), kLimestone));
    const int pier = add_mesh(scene, pier_mesh(storey.spring - storey.floor));
    const glm::dvec3 spring(0, storey.spring, 0);
    for (const ArcadePlace& arch : arcade_arches()) {
        scene.instances.push_back(placed(spandrel, arch.at + spring, arch.axes));
        scene.instances.push_back(placed(ring, arch.at + spring, arch.axes * kStanding));
        scene.instances.push_back(placed(keystone, arch.at + spring + glm::dvec3(0, 1.1, 0), arch.axes));
    }
    for (const ArcadePlace& column : arcade_columns()) {
        if (column.number == 0)
            scene.instances.push_back(
                placed(corner, column.at + spring + glm::dvec3(0, 0.5 * height, 0), glm::dmat3(1)));
    }
    add_ribs(scene, add_mesh(scene, ring_mesh(1.08, 1.3, 0.17)), pier, storey);
}

// What runs round the court, or round the aisles: walls, floors, mouldings.
void add_frames(Scene& scene) {
    constexpr double kBricksAUnit = 0.9;
    const auto add = [&scene](glm::dvec2 half, const Profile& profile, int material) {
        const double texture = material == kBrick ? kBricksAUnit : kTextureAUnit;
        const int frame = add_mesh(scene, with_material(frame_mesh(half, profile, texture), material));
        scene.instances.push_back(placed(frame, glm::dvec3(0), glm::dmat3(1)));
    };
    const double ground = kStoreys[0].floor, gallery = kStoreys[1].floor, top = kStoreys[1].top;
    constexpr double kOuterWall = 0.4, kStepOut = -0.6, kCorniceOut = -0.44;
    const glm::dvec2 aisles = kCourt + kBay;  // to the outer walls' inner faces
    add(aisles, {{0, 0}, {0, gallery}}, kAshlar);
    add(aisles, {{0, gallery}, {0, top}}, kBrick);
    add(aisles, {{kOuterWall, top}, {kOuterWall, 0}}, kAshlar);
    // A bench along the outer walls.
    add(aisles,
        {{-0.24, ground},
         {-0.24, ground + 0.36},
         {-0.31, ground + 0.41},
         {-0.31, ground + 0.46},
         {-0.29, ground + 0.48},
         {0, ground + 0.48}},
        kLimestone);
    add(kCourt, {{kStepOut, 0}, {kStepOut, ground - 0.02}, {kStepOut + 0.02, ground}}, kLimestone);
    add(kCourt, {{kStepOut + 0.02, ground}, {kBay, ground}}, kPaving);
    add(kCourt,
        {{-kWallHalf, gallery - 0.36},
         {-0.30, gallery - 0.33},
         {-0.30, gallery - 0.25},
         {-0.36, gallery - 0.18},
         {-0.42, gallery - 0.14},
         {kCorniceOut, gallery - 0.11},
         {kCorniceOut, gallery}},
        kLimestone);
    add(kCourt, {{kCorniceOut, gallery}, {kBay, gallery}}, kTiles);
    add(kCourt,
        {{-kWallHalf, top - 0.12},
         {-0.32, top - 0.08},
         {-0.32, top},
         {-0.46, top + 0.12},
         {-0.52, top + 0.15},
         {-0.52, top + 0.25},
         {kBay + 0.55, top + 0.25},
         {kBay + 0.55, top + 0.15},
         {kBay + kOuterWall, top}},
        kLimestone);
    const glm::dvec2 court = 2.0 * (kCourt + kStepOut);
    const int floor = add_mesh(scene, with_material(grid_mesh(court.x, court.y, 2, 2, court / 1.6), kTiles));
    scene.instances.push_back(placed(floor, glm::dvec3(0), glm::dmat3(1)));
}

// Places on the four sides, one a bay, the first `offset` bays from the side's left end.
std::vector<ArcadePlace> places(double offset) {
    std::vector<ArcadePlace> all;
    const glm::dmat3 to_the_right{{0, 0, -1}, {0, 1, 0}, {1, 0, 0}};
    glm::dmat3 axes(1);  // of the far side, at +z
    for (int side = 0; side < 4; ++side, axes = to_the_right * axes) {
        const bool long_side = side % 2 == 1;
        const int bays = long_side ? kBaysAlong : kBaysAcross;
        const double out = long_side ? kCourt.x : kCourt.y;
        for (int i = 0; i < bays; ++i)
            all.push_back({out * axes[2] + kBay * (i + offset - 0.5 * bays) * axes[0], axes, long_side, i});
    }
    return all;
}

}  // namespace

std::vector<ArcadePlace> arcade_columns() { return places(0); }
std::vector<ArcadePlace> arcade_arches() { return places(0.5); }

void add_atrium_building(Scene& scene) {
    add_frames(scene);
    const int vault = add_mesh(scene, vault_mesh());
    const int ring = add_mesh(scene, ring_mesh(0.96, 1.13, kWallHalf + 0.06));
    const int keystone =
        add_mesh(scene, with_material(box_mesh({0.2, 0.4, 2 * kWallHalf + 0.2}), kLimestone));
    for (const Storey& storey : kStoreys) {
        add_vaults(scene, vault, storey.spring);
        add_storey(scene, storey, ring, keystone);
    }
}

}  // namespace crevice
