// The parameters of the second drawing, the depth mismatch among them; the first word of each choice is the
// cure.
#include <climits>

#include "chapters/frame/parameter_kinds.h"

namespace crevice {

namespace {

Parameter depth_test() {
    return choice<DepthFunction>(
        "lit_depth_test", "equal|less_equal",
        "how the lit pass meets the first one's depths; reversed z turns it round",
        [](MethodSettings& s) -> DepthFunction& { return s.lit.depth_function; },
        {{"equal", DepthFunction::equal}, {"less_equal", DepthFunction::less_equal}});
}

Parameter depth_bias() {
    return whole(
        "lit_depth_bias", -INT_MAX, INT_MAX, "steps of the depth format; negative: the lit pass is nearer",
        [](MethodSettings& s, long long v) { s.lit.depth_bias.constant = static_cast<int>(v); },
        [](const MethodSettings& s) { return static_cast<long long>(s.lit.depth_bias.constant); });
}

}  // namespace

Parameter position_order(const char* name, const char* effect, MemberOf<PositionOrder> member) {
    return choice<PositionOrder>(name, "relative|premultiplied|view_first", effect, member,
                                 {{"relative", PositionOrder::relative},
                                  {"premultiplied", PositionOrder::premultiplied},
                                  {"view_first", PositionOrder::view_first}});
}

std::vector<Parameter> lit_parameters() {
    using S = MethodSettings;
    return {
        position_order("lit_position", "how the lit pass multiplies positions: unlike depth_position, holes",
                       [](S& s) -> PositionOrder& { return s.lit.position_order; }),
        depth_test(), depth_bias(),
        yes_no("lit_cutouts", "false: the lit pass draws holes too; EQUAL hides that, less_equal does not",
               [](S& s) -> bool& { return s.lit.cutouts; }),
        choice<AoLookup>("ao_lookup", "exact|slip_wrap|slip_clamp",
                         "slip: v too small by 1; hidden by WRAP, with CLAMP the top row everywhere",
                         [](S& s) -> AoLookup& { return s.ao_lookup; },
                         {{"exact", AoLookup::exact},
                          {"slip_wrap", AoLookup::slip_wrap},
                          {"slip_clamp", AoLookup::slip_clamp}})};
}

}  // namespace crevice
