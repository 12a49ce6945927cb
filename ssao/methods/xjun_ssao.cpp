#include "ssao/methods/xjun_ssao.h"

#include <utility>

namespace crevice {

AoFetch xjun_fetch(const LunaSettings& settings) { return ao_fetch(settings, false); }

RawAo xjun_ssao(const GBuffer& gbuffer, const Camera& camera, const LunaSettings& settings, const Run& run) {
    AoInputs inputs = ao_inputs(gbuffer, camera, xjun_fetch(settings), run);
    AoMap map = luna_occlusion(inputs, settings, run);
    return {std::move(map.ao), std::move(map.tiles), std::move(inputs), settings.format};
}

}  // namespace crevice
