#include "chapters/props/strained_passes.h"

#include <algorithm>

#include "chapters/props/stiff_faults.h"
#include "chapters/stability/rounding.h"
#include "chapters/stability/stiff_scenes.h"
#include "chapters/terminal/number_text.h"

namespace crevice {
namespace {

double cost_of_depth(const RoundingView& view) {
    const MethodRounding rounding = method_rounding(view, find_method("luna"), {});
    return rounding.of(RoundingCause::depth).value_or(AoRounding{}).off.mean;
}

}  // namespace

StrainedPasses strained_passes() {
    constexpr std::size_t kVertex = 1;  // of pass_rounding()
    StiffView far_planes = block_view();
    far_planes.camera = with_planes(far_planes.camera, 1e-4, 1e7);
    const RoundingView at_ease = rounding_view(block_view(), {}), strained = rounding_view(far_planes, {});
    const std::vector<PassRounding> passes = pass_rounding(at_ease), again = pass_rounding(strained);
    StrainedPasses result;
    for (std::size_t i = 0; i < passes.size(); ++i) {
        std::vector<std::string> row = {passes[i].pass, passes[i].unit};
        for (const RoundingFigures& off : {passes[i].off, again[i].off}) {
            row.push_back(significant_text(off.mean, 3));
            row.push_back(significant_text(off.p99, 3));
        }
        result.rows.push_back(row);
    }
    result.vertex_ulps = std::max(passes[kVertex].off.max, again[kVertex].off.max);
    result.luna_at_ease = cost_of_depth(at_ease);
    result.luna_strained = cost_of_depth(strained);
    return result;
}

}  // namespace crevice
