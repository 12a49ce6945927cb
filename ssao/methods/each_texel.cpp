#include "ssao/methods/each_texel.h"

#include <algorithm>
#include <utility>

#include "rasterizer/base/float_text.h"

namespace crevice {

TileMap surface_tiles(const AoInputs& inputs, const Run& run) {
    TileMap map(inputs.size(), kTexelTile);
    if (!run.leaves_out(Skip::background_pixels)) return map;
    const auto shows_surface = [&](int column, int row) {
        const int left = column * kTexelTile, top = row * kTexelTile;
        const int right = std::min(left + kTexelTile, map.picture.width),
                  bottom = std::min(top + kTexelTile, map.picture.height);
        for (int y = top; y < bottom; ++y) {
            const float* const z = inputs.view_depth.row(y);
            if (std::any_of(z + left, z + right,
                            [](float at) { return at < std::numeric_limits<float>::infinity(); }))
                return true;
        }
        return false;
    };
    parallel_for(map.tiles.size.height, run, [&](int row) {
        for (int column = 0; column < map.tiles.size.width; ++column) {
            if (!shows_surface(column, row)) map.tiles.at(column, row) = TileWork::background;
        }
    });
    return map;
}

void Explainer::operator()(const SampleFacts<float>& facts) const {
    const auto as_glm = [](const Vec3<float>& v) { return glm::vec3(v.x, v.y, v.z); };
    ExplainedSample sample;
    sample.offset = as_glm(facts.q - at.p);
    sample.q_view = as_glm(facts.q);
    sample.q_screen = {facts.at.x, facts.at.y};
    sample.r_view = as_glm(facts.r);
    sample.dz = at.p.z - facts.r.z;
    sample.dp = facts.facing;
    sample.weight = facts.weight;
    sample.contribution = facts.contribution;
    sample.verdict = verdict_of(sample);
    sample.numbers = std::exchange(told, {});
    result.samples.push_back(std::move(sample));
}

const char* verdict_of(const ExplainedSample& sample) {
    if (sample.contribution > 0) return "occludes";
    // What stands for a whole side or scale lies nowhere else than the texel.
    if (sample.offset == glm::vec3(0)) return "nothing in front";
    if (sample.weight == 0) return "too far away";
    if (!(sample.dp > 0)) return "below the surface";
    return "nothing in front";
}

std::string contrast_formula(const std::string& access, float exponent) {
    if (exponent == 1) return "clamp(" + access + ", 0, 1)";
    return "clamp(" + access + ", 0, 1) ^ " + shortest_text(exponent);
}

std::string mean_formula(int count, float exponent) {
    return contrast_formula("1 - sum / " + std::to_string(count), exponent);
}

}  // namespace crevice
