// The words that a probe's text and its JSON document have in common.
#pragma once

#include "rasterizer/draw/pixel_fragments.h"
#include "ssao/light/lighting.h"

namespace crevice {

inline const char* word_of(DepthFormat format) {
    return format == DepthFormat::d16 ? "d16" : format == DepthFormat::d24 ? "d24" : "d32f";
}

inline const char* word_of(FragmentVerdict verdict) {
    switch (verdict) {
        case FragmentVerdict::kept: return "kept";
        case FragmentVerdict::drawn_over: return "drawn over";
        case FragmentVerdict::behind: return "behind";
        case FragmentVerdict::equal: return "equal";
        case FragmentVerdict::outside: return "outside";
        case FragmentVerdict::facing_away: return "facing away";
        case FragmentVerdict::cut_out: return "cut out";
        case FragmentVerdict::hidden: return "hidden";
    }
    return "";
}

inline const char* word_of(LitTerm term) {
    switch (term) {
        case LitTerm::ambient: return "ambient";
        case LitTerm::diffuse: return "diffuse";
        case LitTerm::specular: return "specular";
        case LitTerm::diffuse_and_specular: return "diffuse and specular";
        case LitTerm::reflection: return "reflection";
        case LitTerm::sky: return "sky";
    }
    return "";
}

}  // namespace crevice
