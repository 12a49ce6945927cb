#include "chapters/diagrams/lookup_weights.h"

#include <doctest/doctest.h>

#include "tests/tools/well_formed.h"

using namespace crevice;

TEST_CASE("lookup weights: at half size the nearest of four texels has 9/16, at any size they add up to 1") {
    const std::array<TexelWeight, 4> half = lookup_weights({8, 4}, {16, 8}, 6, 4);
    CHECK(half[3].x == 3);
    CHECK(half[3].y == 2);
    CHECK(half[3].weight == 9.0f / 16);
    CHECK(half[0].weight == 1.0f / 16);
    for (int x = 0; x < 33; ++x) {
        float sum = 0;
        for (const TexelWeight& texel : lookup_weights({17, 5}, {33, 9}, x, 4)) {
            sum += texel.weight;
            CHECK(texel.x >= 0);
            CHECK(texel.x < 17);
        }
        CHECK_MESSAGE(sum == doctest::Approx(1), "pixel ", x);
    }
}

TEST_CASE("lookup diagram: a picture that readers accept") {
    const Image<float> ao({8, 4}, 0.5f);
    CHECK(xml_fault(lookup_diagram(ao, {16, 8}, 6, 4, "One pixel")) == "");
}
