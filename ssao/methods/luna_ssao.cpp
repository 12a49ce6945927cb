#include "ssao/methods/luna_ssao.h"

#include <utility>

namespace crevice {

AoFetch luna_fetch(const LunaSettings& settings) { return ao_fetch(settings, true); }

RawAo luna_ssao(const GBuffer& gbuffer, const Camera& camera, const LunaSettings& settings, const Run& run) {
    AoInputs inputs = ao_inputs(gbuffer, camera, luna_fetch(settings), run);
    AoMap map = luna_occlusion(inputs, settings, run);
    return {std::move(map.ao), std::move(map.tiles), std::move(inputs), settings.format};
}

}  // namespace crevice
