#include "ssao/judge/luna_limit.h"

namespace crevice {

ReferenceImage luna_limit(const AoInputs& inputs, const LunaSettings& settings, int seeds, const Run& run,
                          const std::function<void(long long)>& on_progress) {
    LunaSettings drawn = settings;
    drawn.exponent = 1;
    drawn.format = BufferFormat::float32;
    return seed_limit(inputs.view_depth, settings.exponent, seeds, run, on_progress, [&](std::uint32_t seed) {
        drawn.seed = seed;
        return luna_occlusion(inputs, drawn, run).ao;
    });
}

}  // namespace crevice
