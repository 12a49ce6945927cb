// Every artifact switch of the AO pass turned on, one by one, and some together.
#pragma once

#include <string>

#include "ssao/methods/luna_settings.h"

namespace crevice {

struct NamedSwitch {
    std::string name;
    void (*turn_on)(LunaSettings&);
};

inline const NamedSwitch kAoSwitches[] = {
    {"random_vectors=raw", [](LunaSettings& s) { s.random_vectors = RandomVectors::raw; }},
    {"random_vectors=none", [](LunaSettings& s) { s.random_vectors = RandomVectors::none; }},
    {"sign_of_zero=zero", [](LunaSettings& s) { s.sign_of_zero = SignOfZero::zero; }},
    {"self_occlusion_test=false", [](LunaSettings& s) { s.self_occlusion_test = false; }},
    {"depth_source=view_depth", [](LunaSettings& s) { s.depth_source = DepthSource::view_depth; }},
    {"depth_source=ndc_depth", [](LunaSettings& s) { s.depth_source = DepthSource::ndc_depth; }},
    {"border=edge", [](LunaSettings& s) { s.border = MapBorder::edge; }},
    {"border=wrap", [](LunaSettings& s) { s.border = MapBorder::wrap; }},
    {"texel_centre=off", [](LunaSettings& s) { s.texel_centre = TexelCentre::off; }},
    {"edge_texels=mixed", [](LunaSettings& s) { s.edge_texels = EdgeTexels::mixed; }},
    {"sky_depth=as_stored", [](LunaSettings& s) { s.sky_depth = SkyDepth::as_stored; }},
    {"raw, no dp and wrap",
     [](LunaSettings& s) {
         s.random_vectors = RandomVectors::raw;
         s.self_occlusion_test = false;
         s.border = MapBorder::wrap;
     }},
    {"off and mixed",
     [](LunaSettings& s) {
         s.texel_centre = TexelCentre::off;
         s.edge_texels = EdgeTexels::mixed;
     }},
};

}  // namespace crevice
