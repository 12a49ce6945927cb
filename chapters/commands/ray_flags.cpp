#include "chapters/commands/ray_flags.h"

#include <limits>

#include "chapters/terminal/parse.h"

namespace crevice {

namespace {

float radius_of(const std::string& word) {
    const float radius = word == "inf" ? std::numeric_limits<float>::infinity()
                                       : static_cast<float>(parse_number("--radius", word));
    if (!(radius > 0))
        throw UsageError("--radius: must lie in (0, inf] (" + word +
                         "); choose how far an occluder may be, scene units");
    return radius;
}

}  // namespace

void add_ray_flags(CommandLine& command, RayWords& words, const char* default_radius) {
    command.option("--rays", words.rays, "rays a point, 1..1048576 (truth: rounded up to a multiple of 8)");
    command.option("--radius", words.radius,
                   std::string("how far an occluder may be, scene units or inf; default: ") + default_radius);
    command.option("--weight", words.weight, "how directions are spread: cosine or uniform");
    command.option("--seed", words.seed, "of the rays' directions");
}

RayAoSettings ray_settings_of(const RayWords& words) {
    RayAoSettings rays;
    rays.rays = static_cast<int>(parse_whole("--rays", words.rays, 1, 1 << 20));
    if (words.radius) rays.radius = radius_of(*words.radius);
    rays.weight = parse_choice<RayWeight>("--weight", words.weight,
                                          {{"cosine", RayWeight::cosine}, {"uniform", RayWeight::uniform}});
    rays.seed = static_cast<std::uint32_t>(parse_whole("--seed", words.seed, 0, 0xffffffffLL));
    return rays;
}

}  // namespace crevice
