// Every denoiser tells its passes: of any texel the taps give what the pass writes, and the last pass writes the map.
#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <variant>

#include <doctest/doctest.h>

#include "tests/tools/image_checks.h"
#include "tests/tools/method_maps.h"
#include "tests/tools/still_life.h"

using namespace crevice;

namespace {

// What the sums of a pass come to by its own words.
float by_last_step(const ExplainedPass& pass) {
    const std::string step = pass.last_step;
    if (step == "no surface: 1") return 1;
    if (step == "the texel keeps its value, for no other counts") return pass.taps.front().value;
    const float mean = pass.sum() / pass.total();
    if (step == "sum / total, at most 1") return std::min(mean, 1.0f);
    CHECK(step == "sum / total");
    return mean;
}

bool tells(const std::vector<ExplainedPass>& passes, float denoised) {
    for (const ExplainedPass& pass : passes) {
        if (by_last_step(pass) != pass.value) return false;
        for (const ExplainedTap& tap : pass.taps) {
            const bool counts =
                tap.verdict == std::string("counts") || tap.verdict == std::string("the texel itself");
            if (counts != (tap.weight > 0)) return false;
        }
    }
    return !passes.empty() && passes.back().value == denoised;
}

}  // namespace

TEST_CASE("explained passes: the taps of every denoiser add up to its map, to the last bit") {
    for (const Method* method : computing_methods()) {
        if (!method->denoiser.denoised) continue;
        REQUIRE(method->denoiser.explain);
        CAPTURE(std::string(method->name));
        const Scene scene = still_life();
        const MethodSettings settings = with_value(*method, defaults_of(*method), "radius", 1);
        const Maps maps = maps_of(*method, scene, {27, 16}, settings);
        CHECK(pixels_against(maps.raw.ao.size, [&](int x, int y) {
                  return tells(method->denoiser.explain(maps.raw, settings.denoiser, x, y),
                               maps.smooth.ao.at(x, y));
              }) == "");
    }
}

TEST_CASE(
    "explained passes: none where the denoiser keeps the map, and a word for every tap that does not count") {
    const Scene scene = still_life();
    std::set<std::string> verdicts;
    for (const Method* method : computing_methods()) {
        if (!method->denoiser.denoised) continue;
        CAPTURE(std::string(method->name));
        const Maps maps = maps_of(*method, scene, {27, 16});
        const MethodSettings kept = with_value(*method, defaults_of(*method), "blur_iterations", 0);
        CHECK(method->denoiser.explain(maps.raw, kept.denoiser, 9, 9).empty());
        for (int x = 0; x < maps.raw.ao.size.width; ++x) {
            for (const ExplainedPass& pass :
                 method->denoiser.explain(maps.raw, defaults_of(*method).denoiser, x, 5)) {
                for (const ExplainedTap& tap : pass.taps) {
                    verdicts.insert(tap.verdict);
                    for (const NamedNumber& number : tap.numbers) {
                        const float* const length = std::get_if<float>(&number.value);
                        CHECK_FALSE((length != nullptr && std::isnan(*length)));
                    }
                }
            }
        }
    }
    for (const char* verdict :
         {"the texel itself", "counts", "outside the map", "no surface", "the normals differ",
          "the depths differ", "one lies off the other's plane", "an edge lies between"}) {
        CAPTURE(std::string(verdict));
        CHECK(verdicts.contains(verdict));
    }
}
