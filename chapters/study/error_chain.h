// Where a method's error comes from: the images of error_parts.h for one setting, each differing in one thing from
// the one before.
#pragma once

#include "chapters/study/method_view.h"
#include "chapters/study/references.h"
#include "ssao/judge/error_parts.h"

namespace crevice {

// truth -> depth buffer (S) -> definition (C) -> half size -> sampling -> rounding -> float16 -> blur, bias ->
// blur, noise removed. Steps that the setting does not take are left out. The method's images are those of
// the settings' seed; "blur, bias" is what the blur does to the method's limit, the rest of what it does is noise removed.
std::vector<ChainImage> error_chain(const MethodView& view, const References& references,
                                    const FrameSettings& settings, int limit_seeds, const Run& run);

// The exponent that brings the method's limit nearest to its truth on some built-in scenes other than `name`.
struct FittedElsewhere {
    double exponent = 1;
    std::vector<std::string> scenes;
};
FittedElsewhere fitted_elsewhere(const Method& method, const std::string& name, const Run& run);

}  // namespace crevice
