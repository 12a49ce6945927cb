// `--preset NAME`: a tutorial's own scene, method and parameters in one word, its traps cured; NAME_published has the
// numerics that its text and code have, traps included.
#pragma once

#include <span>
#include <string>
#include <vector>

namespace crevice {

struct Preset {
    const char* name;
    const char* title;
    const char* scene;                    // a built-in scene
    const char* method;                   // of ao_methods.h; its defaults are the tutorial's parameters
    std::vector<std::string> words = {};  // name=value, where the tutorial's numerics are not the defaults
};

std::span<const Preset> presets();
// Throws UsageError listing the presets there are.
const Preset& find_preset(const std::string& name);

}  // namespace crevice
