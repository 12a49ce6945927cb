#include "chapters/frame/presets.h"

#include "rasterizer/base/no_such.h"

namespace crevice {

namespace {

// What both D3D tutorials store their buffers in, beside the traps that as_published names.
const std::vector<std::string> kPublishedD3D = {"as_published=true", "buffer_format=float16",
                                                "depth_format=d24"};

const Preset kPresets[] = {
    {"xjun2020", "X_Jun, the scene of its text, its traps cured", "columns", "xjun"},
    {"xjun2020_published", "X_Jun as its text has it, traps included", "columns", "xjun", kPublishedD3D},
    {"xjun2022", "X_Jun, the scene of its repository two years later, its traps cured", "columns_2022",
     "xjun"},
    {"xjun2022_published", "X_Jun as its repository had it two years later", "columns_2022", "xjun",
     kPublishedD3D},
    {"learnopengl", "LearnOpenGL, its errata cured", "room", "hemisphere"},
    {"learnopengl_published",
     "LearnOpenGL as its text has it",
     "room",
     "hemisphere",
     {"as_published=true", "blur_shift=true", "buffer_format=float16"}},
    {"luna", "Luna, its traps cured", "columns_luna", "luna"},
    {"luna_published", "Luna as its text has it, traps included", "columns_luna", "luna", kPublishedD3D},
};

}  // namespace

std::span<const Preset> presets() { return kPresets; }

const Preset& find_preset(const std::string& name) {
    std::vector<std::string> known;
    for (const Preset& preset : kPresets) {
        if (name == preset.name) return preset;
        known.push_back(preset.name);
    }
    throw no_such("--preset", "preset", name, known);
}

}  // namespace crevice
