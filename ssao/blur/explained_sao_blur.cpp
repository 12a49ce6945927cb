// The blur of scalable ambient obscurance of one texel in numbers.
#include <cmath>
#include <string>

#include "ssao/blur/sao_blur_kernel.h"

namespace crevice {

namespace {

constexpr float kNoSurface = std::numeric_limits<float>::infinity();

// The mean of both along x or y in a texel's square of four.
ExplainedPass explained_quad(const Image<float>& map, const Image<float>& depth, float limit, int x, int y,
                             int along_x) {
    const int other_x = along_x == 1 ? x ^ 1 : x, other_y = along_x == 1 ? y : y ^ 1;
    ExplainedPass pass;
    pass.name = along_x == 1 ? "squares of four, across" : "squares of four, down";
    pass.last_step = "sum / total";
    pass.taps = {{x, y, map.at(x, y), 1, "the texel itself"}};
    pass.value = map.at(x, y);
    if (other_x >= map.size.width || other_y >= map.size.height) return pass;
    const float z = depth.at(x, y), other_z = depth.at(other_x, other_y);
    float other = map.at(other_x, other_y);
    ExplainedTap tap{
        other_x, other_y, other, 0, "the depths differ", {{"depth_difference", std::fabs(z - other_z)}}};
    if (even_out(pass.value, z, other, other_z, limit)) {
        tap.weight = 1;
        tap.verdict = "counts";
    }
    if (!(z < kNoSurface) || !(other_z < kNoSurface)) {
        tap.verdict = "no surface";
        tap.numbers.clear();  // of infinite depths, whose difference is none
    }
    pass.taps.push_back(tap);
    return pass;
}

// The pass along x or y of a map whose values `value_at(x, y)` gives.
template <class ValueAt>
ExplainedPass explained_pass(const SaoBlurPass& pass, const ValueAt& value_at, const Image<float>& depth,
                             float inverse_depth, int x, int y, int along_x) {
    ExplainedPass result;
    result.last_step = "sum / total, at most 1";
    const float own = value_at(x, y);
    WeighedSum<float> at(&own, depth.row(y) + x, pass.weights[0]);
    result.taps = {{x, y, own, pass.weights[0], "the texel itself"}};
    for (int i = 1; i <= pass.taps; ++i) {
        for (const int away : {-i * pass.step, i * pass.step}) {
            ExplainedTap tap{x + along_x * away, y + (1 - along_x) * away, 1, 0, "outside the map"};
            if (tap.x >= 0 && tap.y >= 0 && tap.x < depth.size.width && tap.y < depth.size.height) {
                const float* const z = depth.row(tap.y) + tap.x;
                tap.value = value_at(tap.x, tap.y);
                at.add(&tap.value, z, pass.weights[i], inverse_depth);
                tap.weight = at.weight_of(*z, pass.weights[i], inverse_depth);
                tap.verdict = tap.weight > 0 ? "counts" : "the depths differ";
                tap.numbers = {{"depth_difference", std::fabs(at.z - *z)}};
            }
            result.taps.push_back(tap);
        }
    }
    result.value = at.mean();
    if (!(at.z < kNoSurface)) {
        result.taps.clear();
        result.last_step = "no surface: 1";
    }
    return result;
}

// The rows of the square of four of a texel, evened out across.
Image<float> evened_across(Image<float> map, const Image<float>& depth, float limit, int x, int y) {
    const int left = x & ~1;
    if (left + 1 >= map.size.width) return map;
    for (int row = y & ~1; row <= (y | 1) && row < map.size.height; ++row)
        even_out(map.at(left, row), depth.at(left, row), map.at(left + 1, row), depth.at(left + 1, row),
                 limit);
    return map;
}

}  // namespace

std::vector<ExplainedPass> explain_sao_blur(const Image<float>& ao, const AoInputs& inputs,
                                            const SaoBlurSettings& settings, int x, int y) {
    validate(settings);
    if (settings.kind == SaoBlurKind::bilateral)
        return explain_bilateral_blur(ao, inputs, bilateral_settings(settings), x, y);
    if (settings.iterations == 0) return {};
    const Image<float>& depth = inputs.view_depth;
    const float inverse = inverse_limit(settings), quad_limit = kQuadShare * settings.depth;
    std::vector<ExplainedPass> passes;
    Image<float> map = ao;
    if (settings.quads) {
        passes.push_back(explained_quad(ao, depth, quad_limit, x, y, 1));
        passes.push_back(
            explained_quad(evened_across(ao, depth, quad_limit, x, y), depth, quad_limit, x, y, 0));
        even_out_quads(map, depth, quad_limit, {.threads = 1});
    }
    const auto both_ways = [&](const SaoBlurPass& pass, const std::string& name) {
        const auto before = [&](int at_x, int at_y) { return map.at(at_x, at_y); };
        const auto across = [&](int at_x, int at_y) {
            return explained_pass(pass, before, depth, inverse, at_x, at_y, 1).value;
        };
        passes.push_back(explained_pass(pass, before, depth, inverse, x, y, 1));
        passes.back().name = name + ", across";
        passes.push_back(explained_pass(pass, across, depth, inverse, x, y, 0));
        passes.back().name = name + ", down";
    };
    SaoBlurSettings once = settings;
    once.iterations = 1;
    once.quads = once.fine = false;
    for (int i = 1; i <= settings.iterations; ++i) {
        both_ways(kPublished, "iteration " + std::to_string(i));
        map = sao_blur(map, inputs, once, {.threads = 1}).ao;
    }
    if (settings.fine) both_ways(kFine, "fine");
    return passes;
}

}  // namespace crevice
