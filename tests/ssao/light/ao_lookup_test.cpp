#include "ssao/light/ao_lookup.h"

#include <algorithm>

#include <doctest/doctest.h>

#include "rasterizer/base/image_summary.h"
#include "ssao/light/widened_ao.h"
#include "tests/tools/ao_cases.h"
#include "tests/tools/image_checks.h"
#include "tests/tools/noise.h"

using namespace crevice;

namespace {

constexpr Size kSize{64, 32};

// As the lit pass of a picture of kSize would read it; the sampler's lookups ask the G-buffer for its size alone.
Image<float> read_by(const Image<float>& ao, AoLookup lookup) {
    const GBuffer g = made_up_gbuffer(kSize, 0.2f);
    return looked_up(ao, ao_inputs(g, made_up_camera(), {}), g, lookup);
}

}  // namespace

TEST_CASE("an AO map at the pixels: clamped it is what the lit pass reads; wrapped, first and last row mix") {
    const Image<float> ao = noise_image({33, 17}, 3);
    const Image<float> clamped = map_at_pixels(ao, kSize, AddressMode::clamp, 0),
                       wrapped = map_at_pixels(ao, kSize, AddressMode::wrap, 0);
    CHECK(further_apart_than(1e-5, clamped, ao_at_picture_size(ao, kSize)) == "");
    for (int y = 0; y < kSize.height; ++y) {
        CAPTURE(y);
        int unlike = 0;  // the outermost columns mix too
        for (int x = 1; x + 1 < kSize.width; ++x) unlike += clamped.at(x, y) != wrapped.at(x, y) ? 1 : 0;
        CHECK((unlike > 0) == (y == 0 || y == kSize.height - 1));
    }
}

TEST_CASE("an AO map at v - 1: the same bits with wrap where v - 1 is a float, the top row with clamp") {
    const Image<float> ao = noise_image({33, 17}, 4);
    CHECK(content_hash(read_by(ao, AoLookup::slip_wrap)) ==
          content_hash(map_at_pixels(ao, kSize, AddressMode::wrap, 0)));
    const Image<float> top = read_by(ao, AoLookup::slip_clamp),
                       right = map_at_pixels(ao, kSize, AddressMode::clamp, 0);
    for (int y = 0; y < kSize.height; ++y)
        CHECK(std::equal(top.row(y), top.row(y) + kSize.width, right.row(0)));
    CHECK(content_hash(read_by(ao, AoLookup::exact)) == content_hash(ao));
    CHECK(buffer_statistics(read_by({}, AoLookup::slip_clamp)).min == 1);
    const Image<float> half = noise_image({32, 16}, 5);
    CHECK(read_by(half, AoLookup::joint).size == kSize);
}
