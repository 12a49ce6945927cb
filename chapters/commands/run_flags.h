// Flags that several commands share.
#pragma once

#include <optional>
#include <string>

#include "chapters/frame/scene_argument.h"
#include "chapters/terminal/command_line.h"
#include "rasterizer/base/run.h"

namespace crevice {

// What SCENE is.
inline constexpr const char* kSceneMeaning = "a built-in scene (crevice scenes) or the path of an OBJ file";

inline constexpr const char* kOutsideFilesMeaning =
    "also read materials and textures of the OBJ that lie outside its directory";

// `--crease DEG`: which edges of an OBJ stay sharp where it has no normals.
void add_crease_flag(CommandLine& command, std::optional<std::string>& word);

// How to run, as it was typed.
struct RunWords {
    std::string threads = "0", tile = "64", lanes, isa;
    bool keep_all = false;
};
// --threads --lanes --isa --tile
void add_run_flags(CommandLine& command, RunWords& words);
// Throws UsageError.
Run run_of(const RunWords& words);

inline constexpr const char* kCameraFlags[] = {"--eye", "--target", "--fov-y", "--near", "--far", "--ortho"};
void add_camera_flags(CommandLine& command, CameraFlags& camera);

}  // namespace crevice
