#include "scenes/builtin_scenes.h"

#include <array>

#include "scenes/atrium.h"

namespace crevice {
namespace {

// A scene of which there is nothing more than its shapes.
template <Scene (*make)()>
Scene plain(SceneDetail, const Run&) {
    return make();
}

constexpr std::array<BuiltinScene, 14> kScenes = {{
    {"columns", "the scene of X_Jun: columns, spheres and a house with niches and eaves", "the tutorial's",
     columns_scene},
    {"columns_2022", "the same, lit as the code of 2022 does", "the tutorial's", columns_2022_scene},
    {"columns_luna", "the scene of Luna: tapered columns, a carved head of 60,492 triangles on a pedestal",
     "the tutorial's", columns_luna_scene},
    {"room", "the scene of LearnOpenGL: a bare room, a carved head on its floor, one point light",
     "the tutorial's", room_scene},
    {"sphere_on_plane", "closed form: the shade under a resting sphere", "the sphere's radius",
     plain<sphere_on_plane_scene>},
    {"wall_corner", "closed form: the shade along a wall", "none, 1", plain<wall_corner_scene>},
    {"trench", "closed form: the shade in a trench as wide as deep", "none, 1", plain<trench_scene>},
    {"cornell", "a closed room: the measured Cornell box", "10 cm", plain<cornell_scene>},
    {"fence", "cut-outs: a wire fence before a floor and solid things, seen and lit through its holes",
     "the tutorial's", fence_scene},
    {"leaves", "cut-outs, two-sided: a small tree of leaves", "the tutorial's", leaves_scene},
    {"field", "instances: 10,000 stones that are one mesh, each turned and stretched in its own way",
     "the tutorial's", field_scene},
    {"atrium",
     "the complex scene: two floors of arches round a court, cloth, chains and plants under the sky",
     "about 1 m", atrium_scene, kAtriumWalk},
    {"noise_wall", "a textured wall of noise: nothing that is seen of it can be left out", "none, 1",
     plain<noise_wall_scene>},
    {"empty", "no triangles: every buffer is its background", "none, 1", plain<empty_scene>},
}};

}  // namespace

std::span<const BuiltinScene> builtin_scenes() { return kScenes; }

const BuiltinScene* find_builtin_scene(std::string_view name) {
    for (const BuiltinScene& scene : kScenes) {
        if (name == scene.name) return &scene;
    }
    return nullptr;
}

}  // namespace crevice
