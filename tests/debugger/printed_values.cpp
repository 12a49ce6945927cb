// A program for a debugger to stop in: a value of each type that chapters/debugger/ prints.
#include <limits>

#include <glm/gtc/matrix_transform.hpp>

#include "rasterizer/draw/normal_depth.h"
#include "rasterizer/lanes/wide.h"
#include "ssao/light/lit_explanation.h"
#include "ssao/methods/luna_settings.h"
#include "ssao/methods/method.h"

using namespace crevice;

namespace {

struct Maps {
    Image<float> fine, coarse, depth_map;  // 4x2, 2x1, and the fine one with its border
};

Maps small_maps() {
    Maps maps{Image<float>({4, 2}, 0.5f), Image<float>({2, 1}, 0.25f), Image<float>({7, 5}, 100)};
    maps.fine.at(3, 1) = std::numeric_limits<float>::infinity();
    maps.coarse.at(1, 0) = 0.75f;
    maps.depth_map.at(4, 2) = 7;
    return maps;
}

Explanation two_samples() {
    Explanation told;
    told.surface = true;
    told.p_view = {1, 2, 3};
    told.samples = {ExplainedSample{.q_view = {1, 2, 2.5f}, .verdict = "nothing in front"},
                    ExplainedSample{.weight = 1, .contribution = 0.5f, .verdict = "occludes"}};
    return told;
}

ExplainedPass one_pass() {
    ExplainedPass pass;
    pass.name = "iteration 1, across";
    pass.taps = {ExplainedTap{.x = 3, .y = 1, .value = 0.25f, .weight = 1, .verdict = "counts"}};
    pass.value = 0.25f;
    return pass;
}

LitExplanation two_terms() {
    LitExplanation lit;
    lit.terms = {{LitTerm::ambient, -1, glm::vec3(0.5f)}, {LitTerm::diffuse, 0, {1, 0, 0}}};
    lit.colour = {1.5f, 0.5f, 0.5f};
    return lit;
}

template <class... Values>
void stop_here(const Values&...) {}

void hold_values(const Maps& maps) {
    const Image3 normals({4, 2}, {0, 0.5f, -1});
    const GBuffer gbuffer{normals, maps.fine, {DepthFormat::d24, Image<std::int32_t>({4, 2}, 16777215)}};
    const Image<std::uint8_t> kinds({2, 2}, 3);
    const Image<float> nothing;
    const Vec3<float> point = {1, -2, 0.1f};
    const Wide<4> lanes(Wide<4>::V{1, 2.5f, -3, 0.1f});
    const WideInt<4> whole_lanes(7);
    const WideDouble<8> halves = to_double(lane_index<Wide<8>>()) * WideDouble<8>(0.5);
    const WideMask<4> mask = lanes > Wide<4>(1);
    const Vec3<Wide<4>> points = {lanes, lanes, lanes};
    const Screen2<float> place = {12.5f, 3};
    const glm::vec2 pair(0.1f, 2);
    const glm::dvec3 eye(0.1, 0, -10);
    const glm::mat4 moved = glm::translate(glm::mat4(1), glm::vec3(5, 6, 7));
    const AnySettings settings = AnySettings::of(LunaSettings{}), few = AnySettings::of(Size{4, 2}), none;
    const Explanation told = two_samples();
    const ExplainedPass pass = one_pass();
    const LitExplanation lit = two_terms();
    stop_here(gbuffer, kinds, nothing, point, lanes, whole_lanes, halves, mask, points, place, pair, eye,
              moved, settings, few, none, told, pass, lit);
    const Image<float> not_yet({4, 2}, 1);
    stop_here(not_yet);
}

}  // namespace

int main() { hold_values(small_maps()); }
