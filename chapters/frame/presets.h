// `--preset NAME`: a tutorial's own scene, method and parameters in one word.
#pragma once

#include <span>
#include <string>

namespace crevice {

struct Preset {
    const char* name;
    const char* title;
    const char* scene;   // a built-in scene
    const char* method;  // of ao_methods.h; its defaults are the tutorial's parameters
};

std::span<const Preset> presets();
// Throws UsageError listing the presets there are.
const Preset& find_preset(const std::string& name);

}  // namespace crevice
