#include "ssao/methods/luna_ssao.h"

namespace crevice {

AoFetch luna_fetch(const LunaSettings& settings) { return ao_fetch(settings, true); }

Image<float> luna_ssao(const GBuffer& gbuffer, const Camera& camera, const LunaSettings& settings,
                       const Run& run) {
    return luna_occlusion(ao_inputs(gbuffer, camera, luna_fetch(settings), run), settings, run);
}

}  // namespace crevice
