// `crevice render`: a scene's buffers as files, and passes.json beside them.
#pragma once

#include <filesystem>
#include <iosfwd>
#include <optional>
#include <string>

#include "chapters/frame/buffer_writer.h"
#include "chapters/frame/frame.h"
#include "chapters/frame/scene_argument.h"

namespace crevice {

struct RenderOptions {
    std::string scene;
    bool outside_files = false;              // WantedOfScene::outside_files
    std::optional<double> crease_angle_rad;  // the same
    CameraFlags camera;
    std::vector<std::string> params;  // "name=value"
    FrameRequest request;             // its settings follow from params and the scene
    double time_s = 0;                // how long the lights have been turning
    bool inset = false;               // the AO map over the lower right of lit.png (not of lit.npy)
    BufferFiles files = BufferFiles::npy;
    std::filesystem::path out = "out";
};

// What the options come to: the scene loaded, its lights turned, its camera, and settings in its units.
// Warnings go to stderr. Throws InputError, UsageError.
struct PreparedRender {
    SceneArgument argument;
    Camera camera;
    FrameRequest request;
};
PreparedRender prepared_render(const RenderOptions& options);

// Writes a frame's wanted buffers and its passes.json into a directory, as render() does, and tells of the files where
// there is somebody to be told. `unchanged`
// as in WorkedFrame.
void write_frame(const RenderOptions& options, const PreparedRender& prepared,
                 const std::filesystem::path& out, const Frame& frame,
                 const std::vector<std::string>& unchanged = {}, std::ostream* told = nullptr);

// Writes OUT/NAME.npy and OUT/NAME.png for each wanted buffer, or OUT/frame.exr, and OUT/passes.json, and prints one
// line for each. Throws InputError, UsageError (for a history, which takes frames before this one, too), OutputError;
// the output directory is tried before anything is drawn.
void render(const RenderOptions& options);

}  // namespace crevice
