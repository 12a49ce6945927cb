#include "chapters/props/stiff_frames.h"

#include <doctest/doctest.h>

using namespace crevice;

TEST_CASE("stiff frames: what is asked of images and warnings") {
    Image<float> a({2, 2}, 1.0f), b = a;
    b.at(1, 0) = 0.25f;
    CHECK(largest_difference(a, a) == 0);
    CHECK(largest_difference(a, b) == 0.75);
    CHECK(texels_below(b, 0.5f) == 1);
    CHECK(texels_below(b, 0.25f) == 0);
    Frame frame;
    CHECK(first_warning(frame) == kNoWarning);
    CHECK(lost(frame, "pixels_lost_to_clear_depth") == 0);
}

TEST_CASE("stiff frames: a ground that goes on behind the eye covers half of the picture") {
    const Frame frame = drawn(ground_view(), {32, 18}, "luna");
    CHECK(covered_share(frame) == doctest::Approx(0.5).epsilon(0.12));
}
