// LearnOpenGL's scene for SSAO: the inside of a cube of side 15, with a model lying on its floor and one point light. The
// text's model is a backpack; ours is the carved head. Its right-handed world is mirrored: z is negated.
#include <algorithm>
#include <array>
#include <vector>

#include "rasterizer/lanes/approx_math.h"
#include "scenes/builtin_scenes.h"
#include "scenes/carved_head.h"
#include "scenes/composing.h"
#include "scenes/flat_mesh.h"
#include "scenes/shapes.h"

namespace crevice {
namespace {

constexpr double kHalfSide = 7.5, kFloor = -0.5;  // the cube's middle is at y = 7
constexpr double kHeadScale = 0.3;
enum RoomMaterial { kPlaster, kStone };

// The cube's six faces, their fronts inside.
Mesh room_mesh() {
    const glm::dvec3 low(-kHalfSide, kFloor, -kHalfSide), high(kHalfSide, kFloor + 2 * kHalfSide, kHalfSide);
    std::vector<FlatPolygon> faces = block_solid(std::array{Block{low, high, kPlaster}});
    for (FlatPolygon& face : faces) std::reverse(face.corners.begin(), face.corners.end());
    return flat_mesh(faces);
}

// On the floor, its face towards the light and half towards the eye.
Instance resting_head(int mesh) {
    const glm::dmat3 axes = glm::dmat3(kHeadScale) * turned({0, 1, 0}, 0.6);
    return placed(mesh, glm::dvec3(0, kFloor - kHeadScale * static_cast<double>(kHeadLow.y), 0), axes);
}

}  // namespace

Scene room_scene(SceneDetail, const Run& run) {
    Scene scene;
    scene.name = "room";
    scene.materials = {book_material("plaster", glm::vec3(0.95f), glm::vec3(0.04f), 0.9),
                       book_material("stone", glm::vec3(0.95f), glm::vec3(0.04f), 0.9)};
    const int room = add_mesh(scene, room_mesh());
    const int head = add_mesh(scene, with_material(carved_head_mesh(run), kStone));
    scene.instances = {placed(room, {0, 0, 0}), resting_head(head)};
    scene.ambient_light = glm::vec3(0.3f);
    scene.point_light = PointLight{.position = {2, 4, 2}, .colour = {0.2f, 0.2f, 0.7f}};
    scene.sky = glm::vec3(0);
    scene.camera.eye = {0, 1.2, -5};
    scene.camera.target = {0, 0.5, 0};
    scene.camera.fov_y_rad = kPi / 4;
    scene.camera.near_plane = 0.1;
    scene.camera.far_plane = 50;
    return scene;
}

}  // namespace crevice
