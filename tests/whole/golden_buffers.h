// Every buffer that has a golden image: those of the frames of all built-in scenes (the presets'
// among them), those of each artifact on purpose, of a frame with a history, and
// the scenes' references.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "rasterizer/base/image_io.h"

namespace crevice {

struct GoldenBuffer {
    std::string scene, buffer, command;  // the command draws it
    Planes values;

    std::string name() const { return scene + " " + buffer; }
    std::filesystem::path file(const std::filesystem::path& directory) const {
        return directory / scene / (buffer + ".npy");
    }
    std::string replay() const { return "crevice " + command + " --out DIR"; }
};

std::vector<GoldenBuffer> golden_buffers();

}  // namespace crevice
