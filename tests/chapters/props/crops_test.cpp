#include "chapters/props/crops.h"

#include <doctest/doctest.h>

using namespace crevice;

TEST_CASE("crops: a part around the largest value lies inside of the image and holds it") {
    Image<float> image({20, 10}, 0.0f);
    image.at(19, 0) = -3;
    image.at(4, 4) = 2;
    const PixelRect part = part_around_largest(image, {6, 4});
    CHECK(part == PixelRect{14, 0, 20, 4});
    const Image<float> cut = cropped(image, part);
    CHECK(cut.size == Size{6, 4});
    CHECK(cut.at(5, 0) == -3);
    CHECK(part_around(image.size, 0, 0, {100, 100}) == PixelRect{0, 0, 20, 10});
}

TEST_CASE("crops: an enlarged image shows each pixel as a square") {
    Image<float> image({2, 1}, 0.0f);
    image.at(1, 0) = 5;
    const Image<float> large = enlarged(image, 3);
    CHECK(large.size == Size{6, 3});
    CHECK(large.at(2, 2) == 0);
    CHECK(large.at(3, 0) == 5);
    CHECK(large.at(5, 2) == 5);
}
