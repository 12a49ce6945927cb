// The flags of the commands that cast rays: --rays --radius --weight --seed.
#pragma once

#include <optional>
#include <string>

#include "chapters/terminal/command_line.h"
#include "ssao/rays/ray_cast_ao.h"

namespace crevice {

// As they were typed.
struct RayWords {
    std::string rays, weight = "cosine", seed = "1";
    std::optional<std::string> radius;
};
void add_ray_flags(CommandLine& command, RayWords& words, const char* default_radius);
// The radius is that of RayAoSettings where --radius was not given. Throws UsageError.
RayAoSettings ray_settings_of(const RayWords& words);

}  // namespace crevice
