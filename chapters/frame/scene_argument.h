// SCENE on the command line: the name of a built-in scene, or the path of an OBJ file.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "chapters/frame/frame_settings.h"
#include "rasterizer/obj/obj_load.h"

namespace crevice {

struct SceneArgument {
    Scene scene;
    bool from_obj = false;             // its coordinates are right-handed
    std::vector<LoadStep> load_steps;  // what making or reading it took
};

// What of a scene is wanted beside its triangles and materials.
struct WantedOfScene {
    // SceneDetail::surfaces, and the texture files of an OBJ; else those stay unread.
    bool surfaces = true;
    bool unused_texcoords = false;  // of an OBJ: texture coordinates that no texture asks for
    bool outside_files = false;     // of an OBJ: materials and textures outside its directory
    // Of an OBJ: ObjOptions::crease_angle_rad; none: as that says.
    std::optional<double> crease_angle_rad = {};
    Run run = {};  // with which a built-in scene is made, and an OBJ is read
};

// WantedOfScene::crease_angle_rad of the word of --crease, degrees in [0, 180]. Throws UsageError.
std::optional<double> crease_angle_of(const std::optional<std::string>& word);

// Takes what is to be said while a scene is loaded, a line at a time, without its end.
using WarningSink = std::function<void(const std::string& line)>;
void warn_on_stderr(const std::string& line);

// `warn` takes the warnings of the OBJ loader, and that a crease angle has nothing to decide. Throws UsageError for a word that names nothing, InputError for a file that
// cannot be read and for coordinates beyond 1e29, which no camera can frame. A scene too small for floats is a warning.
SceneArgument load_scene(const std::string& name_or_path, const WantedOfScene& wanted = {},
                         const WarningSink& warn = warn_on_stderr);

// A point of world space in the scene's own coordinates, those that its author and --eye use.
glm::dvec3 own_coordinates(const SceneArgument& argument, const glm::dvec3& p_world);

// What to say of a scene that was loaded as `name_or_path`, a line each: that it is empty, or that one vertex
// stretches it.
std::vector<std::string> scene_warnings(const SceneArgument& argument, const std::string& name_or_path);

// The camera flags, each as it was typed; nothing means: as the scene says.
struct CameraFlags {
    std::optional<std::string> eye, target, fov_y, near_plane, far_plane, ortho;
};

// The scene's camera with the flags applied. --eye and --target are in the scene's own coordinates. A given
// eye looks at the middle of the scene unless a target is given too. Of an OBJ near and far follow eye and target, where they are
// not given themselves. Throws UsageError.
Camera chosen_camera(const SceneArgument& scene, const CameraFlags& flags);

// `camera`, which has come from chosen_camera() and moved since, with near and far as that would set them for its new place.
Camera moved_planes(const SceneArgument& scene, const CameraFlags& flags, const Camera& camera);

// settings_of() in the scene's units; `name` is the word that named the scene. Throws as that does, and InputError where it is
// the method's own defaults, lengths in those units, that are out of range.
FrameSettings settings_for(const SceneArgument& scene, const std::string& name, const Method& method,
                           const std::vector<std::string>& assignments);

}  // namespace crevice
