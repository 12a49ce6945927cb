#include "chapters/frame/camera_path.h"

#include <glm/geometric.hpp>

#include "chapters/terminal/parse.h"
#include "rasterizer/base/error.h"
#include "rasterizer/lanes/approx_math.h"

namespace crevice {

namespace {

constexpr int kMostFrame = 99999;

}  // namespace

FrameRange frames_of(const std::string& flag, const std::string& word) {
    const std::size_t dash = word.find('-', 1);
    const auto number = [&](const std::string& digits) {
        return static_cast<int>(parse_whole(flag, digits, 0, kMostFrame));
    };
    const int first = number(word.substr(0, dash));
    const int last = dash == std::string::npos ? first : number(word.substr(dash + 1));
    if (last < first)
        throw UsageError(flag + ": ends before it begins (" + word + "); write A-B with A <= B");
    return {first, last};
}

CameraPath path_of(const std::string& flag, const std::optional<std::string>& word,
                   std::span<const WalkStop> stops) {
    if (!word) return stops.empty() ? CameraPath::turn : CameraPath::walk;
    for (const CameraPath path : {CameraPath::turn, CameraPath::walk, CameraPath::still}) {
        if (*word != path_name(path)) continue;
        if (path == CameraPath::walk && stops.empty())
            throw UsageError(flag + ": this scene has no walk (walk); give turn or still");
        return path;
    }
    throw UsageError(flag + ": there is no such path (" + *word + "); give turn, walk or still");
}

const char* path_name(CameraPath path) {
    switch (path) {
        case CameraPath::turn: return "turn";
        case CameraPath::walk: return "walk";
        case CameraPath::still: break;
    }
    return "still";
}

Camera turned_camera(const Camera& camera, int frame) {
    const SineCosine turn = sine_cosine(2 * kPi * (frame % kFramesOfTurn) / kFramesOfTurn);
    const glm::dvec3 up = glm::normalize(camera.up), arm = camera.eye - camera.target;
    // Rodrigues' rotation of the arm about `up`.
    const glm::dvec3 turned =
        turn.cosine * arm + turn.sine * glm::cross(up, arm) + (1 - turn.cosine) * glm::dot(up, arm) * up;
    Camera moved = camera;
    moved.eye = camera.target + turned;
    return moved;
}

Camera camera_on(CameraPath path, const Camera& camera, std::span<const WalkStop> stops, int frame) {
    if (path == CameraPath::turn) return turned_camera(camera, frame);
    if (path == CameraPath::still) return camera;
    const int frames = kFramesOfStop * static_cast<int>(stops.size());
    return walking_camera(camera, stops, static_cast<double>(frame % frames) / frames);
}

}  // namespace crevice
