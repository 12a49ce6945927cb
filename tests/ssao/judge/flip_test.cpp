#include "ssao/judge/flip.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <doctest/doctest.h>

#include "rasterizer/base/error.h"
#include "tests/tools/about.h"
#include "tests/tools/colour_flip.h"
#include "tests/tools/image_checks.h"
#include "tests/tools/noise.h"
#include "tests/tools/special_floats.h"

using namespace crevice;

namespace {

// A grey picture with edges, points and slopes.
Image<float> pattern(Size size) {
    Image<float> picture = noise_image(size, 3);
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
            float& value = picture.at(x, y);
            value = 0.1f * value + 0.5f * static_cast<float>(x) / static_cast<float>(size.width);
            if (x > y + 4) value += 0.4f;
            if (x % 7 == 3 && y % 5 == 2) value = 1 - value;
        }
    }
    return picture;
}

Image<float> split(Size size, int first_right, float left, float right) {
    Image<float> picture(size, left);
    for (int y = 0; y < size.height; ++y)
        for (int x = first_right; x < size.width; ++x) picture.at(x, y) = right;
    return picture;
}

}  // namespace

TEST_CASE("FLIP without chroma filters equals the whole computation in colour") {
    struct Observer {
        Size size;
        double ppd;
    };
    for (const Observer& observer : {Observer{{29, 17}, 20}, Observer{{26, 14}, kPixelsPerDegree}}) {
        CAPTURE(observer.ppd);
        const Size size = observer.size;
        const Image<float> a = pattern(size), b = noise_image(size, 9);
        const ColourFlip whole{size, observer.ppd};
        const Colours colours_a = whole.opponents(a), colours_b = whole.opponents(b);
        const Flip ours = flip(a, b, observer.ppd);
        double mean = 0, worst = 0;
        for (int y = 0; y < size.height; ++y) {
            for (int x = 0; x < size.width; ++x) {
                const double expected = whole.at(colours_a, colours_b, x, y);
                mean += expected / (size.width * size.height);
                worst = std::max(worst, std::fabs(ours.map.at(x, y) - expected));
            }
        }
        CHECK(worst < 1e-7);
        CHECK(ours.mean == about(mean, 1e-9));
        CHECK(ours.mean > 0.1);  // the pictures are not alike, so the agreement says something
    }
}

TEST_CASE("FLIP in colour equals the whole computation, and of grey pictures the grey form") {
    const Size size{23, 15};
    constexpr double ppd = 20;
    const auto colours = [&](unsigned seed) {
        Image3 colour(size);
        colour.x = pattern(size);
        colour.y = noise_image(size, seed);
        colour.z = noise_image(size, seed + 1);
        return colour;
    };
    const Image3 a = colours(5), b = colours(8);
    const ColourFlip whole{size, ppd};
    const Colours colours_a = whole.opponents(a), colours_b = whole.opponents(b);
    const Flip ours = flip(a, b, ppd);
    double worst = 0;
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x)
            worst = std::max(worst, std::fabs(ours.map.at(x, y) - whole.at(colours_a, colours_b, x, y)));
    }
    CHECK(worst < 1e-7);
    CHECK(ours.mean > 0.1);

    Image3 grey_a(size), grey_b(size);
    grey_a.x = grey_a.y = grey_a.z = a.x;
    grey_b.x = grey_b.y = grey_b.z = b.y;
    CHECK(flip(grey_a, grey_b, ppd).mean == about(flip(a.x, b.y, ppd).mean, 1e-9));

    // Green against blue of the same patches: the largest difference of colours there is.
    const Image3 green(size, {0, 1, 0}), blue(size, {0, 0, 1});
    CHECK(flip(green, blue, ppd).mean == about(1, 1e-9));
    CHECK(flip(green, green, ppd).mean == 0);
}

TEST_CASE("FLIP of a picture with itself is 0, whatever the size") {
    for (const Size size : {Size{1, 1}, Size{1, 9}, Size{33, 2}, Size{40, 30}}) {
        CAPTURE(size.width);
        CAPTURE(size.height);
        const Image<float> picture = pattern(size);
        const Flip same = flip(picture, picture);
        CHECK(same.mean == 0);
        CHECK(same.p99 == 0);
        CHECK(other_than(same.map, 0) == "");
    }
}

// Without edges L* differs by 100, so with c = 100^0.7 and m the 0.7th power of the largest distance it is
// .95 + .05 (c - .4 m) / (.6 m), for m = 41.2761 (Andersson et al. 2020: green to blue).
TEST_CASE("FLIP of black against white is the value of its formulas, at the borders too") {
    const Image<float> black({30, 20}, 0.0f), white_picture({30, 20}, 1.0f);
    const Flip found = flip(black, white_picture);
    CHECK(found.mean == about(0.96737976, 1e-7));
    CHECK(found.p99 == about(0.96737976, 1e-7));
    CHECK(further_apart_than(1e-6, found.map, Image<float>({30, 20}, 0.96737976f)) == "");
    CHECK(flip(black, white_picture, 11).mean == about(found.mean, 1e-9));
}

TEST_CASE("FLIP of two constant greys has no edges or points: it is the lightness term alone") {
    const auto lightness = [](float display) {
        return 116 * std::cbrt(std::pow((static_cast<double>(display) + 0.055) / 1.055, 2.4)) - 16;
    };
    const Flip found = flip(Image<float>({25, 25}, 0.5f), Image<float>({25, 25}, 0.6f));
    const double difference = std::pow(lightness(0.6f) - lightness(0.5f), 0.7);
    CHECK(found.mean == about(0.95 * difference / (0.4 * 41.2760984), 1e-7));
    CHECK(outside_unit_interval(found.map) == "");
    // The same difference of greys is seen more beside an edge that only one picture has.
    const Image<float> flat({25, 25}, 0.55f), step = split({25, 25}, 12, 0.5f, 0.6f);
    CHECK(flip(flat, step).map.at(14, 12) > 1.2 * flip(flat, Image<float>({25, 25}, 0.6f)).mean);
}

TEST_CASE("FLIP is symmetric and grows with contrast") {
    const Image<float> a = pattern({31, 22}), b = noise_image({31, 22}, 5);
    const Flip forth = flip(a, b), back = flip(b, a);
    CHECK(forth.mean == back.mean);
    CHECK(further_apart_than(0, forth.map, back.map) == "");

    const Image<float> base({40, 20}, 0.5f);
    double last = 0;
    for (const float contrast : {0.01f, 0.05f, 0.1f, 0.3f, 0.5f}) {
        CAPTURE(contrast);
        const double mean = flip(base, split({40, 20}, 20, 0.5f - contrast, 0.5f + contrast)).mean;
        CHECK(mean > last);
        last = mean;
    }
}

TEST_CASE("FLIP sees a pixel only as far as its filters reach, and less from farther away") {
    Image<float> a({61, 41}, 0.5f), b = a;
    b.at(30, 20) = 1;
    const Flip found = flip(a, b);
    CHECK(found.map.at(30, 20) > 0.3);
    CHECK(found.map.at(30 + 7, 20) > 0);
    CHECK(found.map.at(30 + 11, 20) == 0);
    CHECK(found.map.at(30, 20 - 7) > 0);
    CHECK(found.map.at(30, 20 - 11) == 0);
    CHECK(flip(a, b, 20).mean < found.mean * 2);
    CHECK(flip(a, b, 134).map.at(30, 20) < found.map.at(30, 20));
}

TEST_CASE("FLIP continues a picture beyond its border as its outermost pixels") {
    // Cut anywhere, a picture of rows that do not change gives the same rows.
    const auto rows_of = [](int width) {
        Image<float> picture({width, 30}, 0.2f);
        for (int y = 15; y < 30; ++y)
            for (int x = 0; x < width; ++x) picture.at(x, y) = 0.9f;
        return picture;
    };
    const auto flat = [](int width) { return Image<float>({width, 30}, 0.2f); };
    const Flip narrow = flip(flat(3), rows_of(3)), wide = flip(flat(50), rows_of(50));
    for (int y = 0; y < 30; ++y) {
        CAPTURE(y);
        CHECK(narrow.map.at(0, y) == wide.map.at(25, y));
        CHECK(narrow.map.at(2, y) == wide.map.at(49, y));
    }
}

TEST_CASE("FLIP: the 99th percentile is a value of the map that 99 in 100 pixels do not exceed") {
    Image<float> a({20, 20}, 0.5f), b = a;
    b.at(3, 3) = 0.9f;
    const Flip found = flip(a, b);
    std::vector<float> values;
    for (int y = 0; y < 20; ++y)
        for (int x = 0; x < 20; ++x) values.push_back(found.map.at(x, y));
    std::sort(values.begin(), values.end());
    CHECK(static_cast<float>(found.p99) == values[395]);
}

TEST_CASE("FLIP's observer: 0.7 m before a 0.7 m wide monitor of 3840 pixels is 67 pixels a degree") {
    CHECK(pixels_per_degree(0.7, 0.7, 3840) == about(kPixelsPerDegree, 1e-14));
    CHECK(pixels_per_degree(1.4, 0.7, 3840) == about(2 * kPixelsPerDegree, 1e-14));
}

TEST_CASE("FLIP refuses what has no answer") {
    const Image<float> grey({8, 8}, 0.5f);
    Image<float> broken = grey;
    broken.at(3, 5) = kNan;
    CHECK_THROWS_WITH_AS(flip(grey, broken), "FLIP of a picture with a NaN (pixel 3, 5); replace it first",
                         InputError);
    CHECK_THROWS_AS(flip(grey, Image<float>({8, 7}, 0.5f)), InputError);
    CHECK_THROWS_AS(flip(Image<float>(), Image<float>()), InputError);
    for (const double ppd : {0.0, -67.0, 1001.0, std::numeric_limits<double>::quiet_NaN()}) {
        CAPTURE(ppd);
        CHECK_THROWS_AS(flip(grey, grey, ppd), UsageError);
    }
    const Image<float> white_picture({8, 8}, 1.0f);
    for (const double ppd : {1.0, 1000.0}) {
        CAPTURE(ppd);
        CHECK(outside_unit_interval(flip(grey, noise_image({8, 8}, 1), ppd).map) == "");
    }
    // Values beyond [0,1] are shown as 0 and 1; infinities too.
    CHECK(flip(Image<float>({8, 8}, kInfinity), white_picture).mean == 0);
    CHECK(flip(Image<float>({8, 8}, 1.5f), white_picture).mean == 0);
}
