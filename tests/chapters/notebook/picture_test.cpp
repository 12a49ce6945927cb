#include "chapters/notebook/picture.h"

#include <doctest/doctest.h>

#include "rasterizer/base/image_io.h"
#include "rasterizer/textures/texture.h"
#include "ssao/judge/flip.h"
#include "tests/tools/image_checks.h"
#include "tests/tools/noise.h"
#include "tests/tools/scratch_directory.h"
#include "tests/tools/special_floats.h"

using namespace crevice;

namespace {

using Bytes = std::vector<std::uint8_t>;
const Bytes kMagenta = {255, 0, 255};

Image<float> row_of(const std::vector<float>& values) {
    Image<float> image({static_cast<int>(values.size()), 1}, kNan);  // NaN in the padding must not show
    for (std::size_t x = 0; x < values.size(); ++x) image.at(static_cast<int>(x), 0) = values[x];
    return image;
}

Bytes pixel(const Picture& picture, int x) {
    const auto first = picture.pixels.begin() + x * picture.channels;
    return {first, first + picture.channels};
}

}  // namespace

TEST_CASE("ao: floor(255 v + 1/2), clamped") {
    const Picture picture =
        ao_picture(row_of({0, 1, 0.5f, 0.001f, 0.0021f, -3, 7, kInfinity, -kInfinity, 127.4f / 255}));
    CHECK(picture.channels == 1);
    CHECK(picture.size == Size{10, 1});
    CHECK(picture.pixels == Bytes{0, 255, 128, 0, 1, 0, 255, 255, 0, 127});
    CHECK(!picture.mapping.empty());
}

TEST_CASE("every k / 255 maps to k") {
    std::vector<float> values;
    for (int k = 0; k < 256; ++k) values.push_back(static_cast<float>(k) / 255);
    const Picture picture = ao_picture(row_of(values));
    for (std::size_t k = 0; k < 256; ++k) CHECK(picture.pixels[k] == k);
}

TEST_CASE("a NaN turns a grey picture to RGB and is magenta; the statistics count it") {
    const Picture picture = ao_picture(row_of({0.5f, kNan, 1}));
    REQUIRE(picture.channels == 3);
    CHECK(pixel(picture, 0) == Bytes{128, 128, 128});
    CHECK(pixel(picture, 1) == kMagenta);
    CHECK(picture.statistics.nan == 1);
    CHECK(picture.mapping.find("magenta") != std::string::npos);
    CHECK(pixel(view_depth_picture(row_of({1, kNan})), 1) == kMagenta);
    CHECK(pixel(ndc_depth_picture(row_of({1, kNan})), 1) == kMagenta);
    CHECK(pixel(mask_picture(row_of({1, kNan})), 1) == kMagenta);
    CHECK(pixel(difference_picture(row_of({1, kNan})), 1) == kMagenta);
    CHECK(pixel(normal_picture(Image3({1, 1}, {0, kNan, 1})), 0) == kMagenta);
    CHECK(pixel(lit_picture(Image3({1, 1}, {0, 0, kNan})), 0) == kMagenta);
}

TEST_CASE("normals: n / 2 + 1/2, background black") {
    Image3 normals({4, 1}, {0, 0, 0});
    normals.set(1, 0, {1, 0, 0});
    normals.set(2, 0, {0, -1, 0});
    normals.set(3, 0, {0, 0, -1});
    const Picture picture = normal_picture(normals);
    CHECK(pixel(picture, 0) == Bytes{0, 0, 0});
    CHECK(pixel(picture, 1) == Bytes{255, 128, 128});
    CHECK(pixel(picture, 2) == Bytes{128, 0, 128});
    CHECK(pixel(picture, 3) == Bytes{128, 128, 0});
}

TEST_CASE("view depth: nearest white, farthest dark but lighter than the background, affine, range printed") {
    const Picture picture = view_depth_picture(row_of({2, 6, 4, kInfinity}));
    CHECK(picture.pixels == Bytes{255, 26, 140, 0});
    CHECK(picture.mapping.find("from 2 (") != std::string::npos);
    CHECK(picture.mapping.find("to 6 (") != std::string::npos);
    CHECK(view_depth_picture(row_of({3, 3})).pixels == Bytes{255, 255});
    CHECK(view_depth_picture(row_of({kInfinity})).pixels == Bytes{0});
}

TEST_CASE("ndc depth: stretched from the nearest to the background") {
    CHECK(ndc_depth_picture(row_of({0.75f, 0.875f, 1})).pixels == Bytes{255, 128, 0});
    CHECK(ndc_depth_picture(row_of({1, 1})).pixels == Bytes{0, 0});
    CHECK(ndc_depth_picture(row_of({0, 0.25f, 0.5f}), true).pixels == Bytes{0, 128, 255});
    CHECK(ndc_depth_picture(row_of({0, 0}), true).pixels == Bytes{0, 0});
    CHECK(ndc_depth_picture(row_of({0.75f, 1})).mapping.find("0.75") != std::string::npos);
}

TEST_CASE("lit: the sRGB curve at known points") {
    Image3 lit({1, 1}, {0.5f, 0.0021404f, 2});
    // 0.5 -> 0.7354 -> 187.5..188; 0.0021404 -> 12.92 v -> 7.05; above 1 clamps.
    CHECK(pixel(lit_picture(lit), 0) == Bytes{188, 7, 255});
    CHECK(pixel(lit_picture(Image3({1, 1}, {-1, 0, 1})), 0) == Bytes{0, 0, 255});
    CHECK(pixel(colour_picture(Image3({1, 1}, {-1, 0.5f, 1})), 0) == Bytes{0, 128, 255});
}

TEST_CASE("signed difference: white at 0, blue below, red above, clamped at one fixed scale") {
    const Picture picture = difference_picture(row_of({0, 0.25f, -0.25f, 9, -kInfinity, 0.125f, -0.0f}));
    CHECK(pixel(picture, 0) == Bytes{255, 255, 255});
    CHECK(pixel(picture, 6) == Bytes{255, 255, 255});
    const Bytes red = pixel(picture, 1), blue = pixel(picture, 2), half = pixel(picture, 5);
    CHECK(red[0] > 200);
    CHECK(red[2] < 50);
    CHECK(blue[2] > 190);
    CHECK(blue[0] < 50);
    CHECK(pixel(picture, 3) == red);
    CHECK(pixel(picture, 4) == blue);
    CHECK(half[1] == (255 + red[1] + 1) / 2);
    CHECK(picture.mapping.find("0.25") != std::string::npos);
    CHECK(pixel(difference_picture(row_of({1}), 2), 0) == half);
    // Of three components the one farthest from 0, with its sign.
    CHECK(pixel(difference_picture(Image3({1, 1}, {0.1f, -0.25f, 0})), 0) == blue);
}

TEST_CASE("masks and greys") {
    CHECK(mask_picture(row_of({0, 1, 0.01f, -2})).pixels == Bytes{0, 255, 255, 255});
    Image<std::uint8_t> mask({3, 1}, 0);
    mask.at(1, 0) = 1;
    mask.at(2, 0) = 255;
    CHECK(mask_picture(mask).pixels == Bytes{0, 255, 255});
    CHECK(grey_picture(row_of({2, 3, 4, 1, 5}), 2, 4).pixels == Bytes{0, 128, 255, 0, 255});
}

TEST_CASE("statistics as text") {
    CHECK(statistics_text(buffer_statistics(row_of({0, 0.5f, 1}))) == "min 0, mean 0.5, max 1");
    CHECK(statistics_text(buffer_statistics(row_of({1, kNan, kInfinity, kInfinity}))) ==
          "min 1, mean 1, max 1, 1 NaN, 2 infinite");
    CHECK(statistics_text(buffer_statistics(row_of({kInfinity}))) == "no finite value, 1 infinite");
}

TEST_CASE("a written picture reads back as its bytes") {
    const ScratchDirectory scratch;
    write_picture(scratch / "p.png", ao_picture(row_of({0, 0.25f, 1})));
    const Image3 read = read_png(scratch / "p.png").colour;
    REQUIRE(read.size() == Size{3, 1});
    CHECK(read.at(1, 0) == glm::vec3(64.0f / 255));
}

TEST_CASE("displayed: accessibility as the bytes of its picture") {
    const Image<float> ao = [] {
        Image<float> image = noise_image({37, 11}, 7);
        image.at(0, 0) = -1;
        image.at(1, 0) = 2;
        image.at(2, 0) = 0.5f / 255;  // the smallest that is not shown black
        return image;
    }();
    const Picture picture = ao_picture(ao);
    const Image<float> shown = displayed(ao);
    CHECK(pixels_against(ao.size, [&](int x, int y) {
              const std::uint8_t byte = picture.pixels[static_cast<std::size_t>(y * ao.size.width + x)];
              return shown.at(x, y) == static_cast<float>(byte) / 255;
          }) == "");
    CHECK(std::isnan(displayed(Image<float>({1, 1}, kNan)).at(0, 0)));
}
