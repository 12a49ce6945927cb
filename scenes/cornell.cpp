// The Cornell box, from the measurements that the Cornell University Program of Computer Graphics has
// published for the use of all ("Cornell Box Data", graphics.cornell.edu/online/box/data.html): coordinates
// in mm, camera, reflectances.
//
// The published axes are right-handed (x to the left of the viewer, y up, z into the picture). Ours are
// left-handed with x to the right: x is negated, which keeps the picture as published, red wall left and
// green wall right. One scene unit is 100 mm. The published ceiling has the lamp in its plane; here it has a
// hole of the lamp's shape, so that nothing is there twice. The blocks have no underside, as published. The
// lamp does not shine: an ambient light and one through the open front stand in for it.
#include <array>
#include <span>
#include <vector>

#include "rasterizer/lanes/approx_math.h"
#include "scenes/builtin_scenes.h"
#include "scenes/composing.h"
#include "scenes/flat_mesh.h"

namespace crevice {
namespace {

enum CornellMaterial { kWhite, kRed, kGreen, kLamp };

// Published coordinates, mm.
struct Quad {
    std::array<glm::dvec3, 4> corners;
    int material;
};

// Counterclockwise seen from inside the room.
constexpr Quad kFloor = {{{{552.8, 0, 0}, {0, 0, 0}, {0, 0, 559.2}, {549.6, 0, 559.2}}}, kWhite};
constexpr Quad kCeiling = {{{{556.0, 548.8, 0}, {556.0, 548.8, 559.2}, {0, 548.8, 559.2}, {0, 548.8, 0}}},
                           kWhite};
constexpr Quad kLampPanel = {
    {{{343.0, 548.8, 227.0}, {343.0, 548.8, 332.0}, {213.0, 548.8, 332.0}, {213.0, 548.8, 227.0}}}, kLamp};
constexpr Quad kBackWall = {{{{549.6, 0, 559.2}, {0, 0, 559.2}, {0, 548.8, 559.2}, {556.0, 548.8, 559.2}}},
                            kWhite};
constexpr Quad kRightWall = {{{{0, 0, 559.2}, {0, 0, 0}, {0, 548.8, 0}, {0, 548.8, 559.2}}}, kGreen};
constexpr Quad kLeftWall = {{{{552.8, 0, 0}, {549.6, 0, 559.2}, {556.0, 548.8, 559.2}, {556.0, 548.8, 0}}},
                            kRed};

// The tops of the two blocks, counterclockwise seen from above.
constexpr Quad kShortBlock = {{{{130, 165, 65}, {82, 165, 225}, {240, 165, 272}, {290, 165, 114}}}, kWhite};
constexpr Quad kTallBlock = {{{{423, 330, 247}, {265, 330, 296}, {314, 330, 456}, {472, 330, 406}}}, kWhite};

// Into our axes and unit. Negating x mirrors, so the corners are taken in reverse to keep the front in front.
FlatPolygon in_world(const Quad& quad) {
    FlatPolygon polygon{{}, quad.material};
    for (std::size_t i = quad.corners.size(); i-- > 0;) {
        polygon.corners.push_back(quad.corners[i] * glm::dvec3(-0.01, 0.01, 0.01));
    }
    return polygon;
}

// The frame between a quad and a hole whose corners follow it.
std::vector<Quad> frame(const Quad& outer, const Quad& hole) {
    std::vector<Quad> sides;
    for (std::size_t i = 0; i < 4; ++i) {
        const std::size_t next = (i + 1) % 4;
        sides.push_back(
            {{{outer.corners[i], outer.corners[next], hole.corners[next], hole.corners[i]}}, outer.material});
    }
    return sides;
}

// A block by its top: the top, and four sides down to the floor.
std::vector<Quad> block(const Quad& top) {
    std::vector<Quad> faces = {top};
    for (std::size_t i = 0; i < 4; ++i) {
        const glm::dvec3 a = top.corners[i], b = top.corners[(i + 1) % 4];
        faces.push_back({{{a, {a.x, 0, a.z}, {b.x, 0, b.z}, b}}, top.material});
    }
    return faces;
}

Mesh cornell_mesh() {
    std::vector<FlatPolygon> polygons;
    const auto add = [&](std::span<const Quad> quads) {
        for (const Quad& quad : quads) polygons.push_back(in_world(quad));
    };
    add(std::array{kFloor, kBackWall, kRightWall, kLeftWall, kLampPanel});
    add(frame(kCeiling, kLampPanel));
    add(block(kShortBlock));
    add(block(kTallBlock));
    return flat_mesh(polygons);
}

}  // namespace

Scene cornell_scene() {
    Scene scene;
    scene.name = "cornell";
    // Close to the measured spectra, as linear RGB; matt.
    scene.materials = {
        book_material("white", {0.725f, 0.71f, 0.68f}, glm::vec3(0), 1),
        book_material("red", {0.63f, 0.065f, 0.05f}, glm::vec3(0), 1),
        book_material("green", {0.14f, 0.45f, 0.091f}, glm::vec3(0), 1),
        book_material("lamp", glm::vec3(0.78f), glm::vec3(0), 1),
    };
    scene.ambient_light = glm::vec3(0.7f);
    scene.lights[0].direction = unit({0.3, -0.45, 0.85});
    scene.lights[0].diffuse = {0.48f, 0.45f, 0.40f};
    scene.lighting = LightingModel::blinn_schlick;
    scene.sky = glm::vec3(0.02f);
    scene.camera.eye = {-2.78, 2.73, -8};
    scene.camera.target = {-2.78, 2.73, 0};
    scene.camera.fov_y_rad = 0.6860478807;  // 2 arctan(12.5 / 35): a 25 mm picture behind a 35 mm lens
    scene.instances = {placed(add_mesh(scene, cornell_mesh()), {0, 0, 0})};
    return scene;
}

}  // namespace crevice
