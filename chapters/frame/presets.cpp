#include "chapters/frame/presets.h"

#include "rasterizer/base/error.h"

namespace crevice {

namespace {

const Preset kPresets[] = {
    {"xjun2020", "X_Jun as its text has it", "columns", "xjun"},
    {"xjun2022", "X_Jun as its repository had it two years later", "columns_2022", "xjun"},
    {"learnopengl", "LearnOpenGL, its errata cured", "room", "hemisphere"},
    {"luna", "Luna", "columns_luna", "luna"},
};

}  // namespace

std::span<const Preset> presets() { return kPresets; }

const Preset& find_preset(const std::string& name) {
    std::string known;
    for (const Preset& preset : kPresets) {
        if (name == preset.name) return preset;
        known += std::string(known.empty() ? "" : ", ") + preset.name;
    }
    throw UsageError("--preset: there is no such preset (" + name + "); give one of " + known);
}

}  // namespace crevice
