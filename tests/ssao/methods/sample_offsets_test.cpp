// The offsets that rows tell of are those of the samples: a porter who uploads them gets the same kernel.
#include <cmath>

#include <doctest/doctest.h>

#include "tests/tools/method_maps.h"
#include "tests/tools/still_life.h"

using namespace crevice;

TEST_CASE("offsets: as many as samples, and each as long as its sample lies away, in radii") {
    constexpr double kRadius = 2, kTolerance = 1e-5;
    const Scene scene = still_life();
    int with_offsets = 0;
    for (const Method* method : computing_methods()) {
        if (!method->offsets) continue;
        CAPTURE(std::string(method->name));
        ++with_offsets;
        for (const double samples : {3.0, 14.0}) {
            MethodSettings settings = with_value(*method, full_size(*method), "radius", kRadius);
            settings = with_value(*method, settings, "samples", samples);
            const SampleOffsets offsets = method->offsets(settings.ao);
            REQUIRE(static_cast<double>(offsets.vectors.size()) == samples);
            const Maps maps = maps_of(*method, scene, kMethodMaps, settings);
            const AoView view = {scene, scene.camera, maps.gbuffer, &maps.rays};
            const Explanation told = method->explain(view, maps.raw, settings.ao, 22, 20);
            REQUIRE(told.samples.size() == offsets.vectors.size());
            for (std::size_t i = 0; i < told.samples.size(); ++i) {
                CAPTURE(i);
                CHECK(glm::length(told.samples[i].offset) ==
                      doctest::Approx(kRadius * glm::length(offsets.vectors[i])).epsilon(kTolerance));
                if (std::string(offsets.space) == "tangent") {
                    CHECK(glm::dot(told.samples[i].offset, told.n_view) ==
                          doctest::Approx(kRadius * offsets.vectors[i].z).epsilon(kTolerance).scale(kRadius));
                }
            }
        }
    }
    CHECK(with_offsets == 4);  // xjun, luna, hemisphere, unity
}

TEST_CASE("offsets: another seed gives others, the same seed the same") {
    for (const Method* method : computing_methods()) {
        if (!method->offsets) continue;
        CAPTURE(std::string(method->name));
        const MethodSettings one = defaults_of(*method), other = with_value(*method, one, "seed", 77);
        CHECK(method->offsets(one.ao).vectors == method->offsets(one.ao).vectors);
        CHECK(method->offsets(one.ao).vectors != method->offsets(other.ao).vectors);
    }
}
