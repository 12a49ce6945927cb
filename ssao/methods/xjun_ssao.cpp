#include "ssao/methods/xjun_ssao.h"

namespace crevice {

AoFetch xjun_fetch(const LunaSettings& settings) { return ao_fetch(settings, false); }

Image<float> xjun_ssao(const GBuffer& gbuffer, const Camera& camera, const LunaSettings& settings,
                       const Run& run) {
    return luna_occlusion(ao_inputs(gbuffer, camera, xjun_fetch(settings), run), settings, run);
}

}  // namespace crevice
