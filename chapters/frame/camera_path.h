// Where the camera of `crevice render --frames A-B` stands in each frame.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "rasterizer/scene/camera.h"
#include "scenes/camera_walk.h"

namespace crevice {

enum class CameraPath {
    turn,   // round what it looks at, kFramesOfTurn frames a turn
    walk,   // through the scene's stops and back, kFramesOfStop frames from one to the next
    still,  // at rest: only what is random changes
};
inline constexpr int kFramesOfTurn = 36, kFramesOfStop = 16;
// Lights that turn with time go on by this from one frame to the next, but before a camera at rest.
inline constexpr double kFrame_s = 1.0 / 12;

struct FrameRange {
    int first = 0, last = 0;  // 0 <= first <= last < 100,000
};
// "A-B", or "A" for one. Throws UsageError.
FrameRange frames_of(const std::string& flag, const std::string& word);

// "turn", "walk" or "still"; where nothing was said, the walk of a scene that has one. Throws UsageError for another
// word, and for the walk of a scene without stops.
CameraPath path_of(const std::string& flag, const std::optional<std::string>& word,
                   std::span<const WalkStop> stops);
const char* path_name(CameraPath path);

// The camera of a frame: turned about its target and its own up vector, by frame / kFramesOfTurn of a full turn.
Camera turned_camera(const Camera& camera, int frame);

// The camera of a frame on any path.
Camera camera_on(CameraPath path, const Camera& camera, std::span<const WalkStop> stops, int frame);

}  // namespace crevice
