// Each cell of the pyramid is a pixel of the picture, by the paper's rule, and a fetch knows which.
#include "ssao/inputs/depth_pyramid.h"

#include <set>

#include <doctest/doctest.h>

#include "tests/tools/ao_cases.h"
#include "tests/tools/every_run.h"
#include "tests/tools/image_checks.h"

using namespace crevice;

namespace {

constexpr Size kSize = {83, 67};

// Every pixel has a depth of its own, which tells where it is.
AoInputs numbered(Size size) {
    AoInputs inputs = plain_inputs(size, 1);
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x)
            inputs.depth_map.at(x + 1, y + 1) = static_cast<float>(y * size.width + x + 2);
    }
    return inputs;
}

}  // namespace

TEST_CASE("depth pyramid: level 0 is the picture, each next one picks by the rotated grid") {
    const AoInputs inputs = numbered(kSize);
    const DepthPyramid pyramid(inputs, 5, {});
    CHECK(pyramid.top() == 5);
    CHECK(pixels_against(kSize, [&](int x, int y) {
              return pyramid.at(0, x, y) == inputs.depth_map.at(x + 1, y + 1);
          }) == "");
    for (int level = 1; level <= 5; ++level) {
        CAPTURE(level);
        CHECK(pyramid.size(level) == Size{kSize.width >> level, kSize.height >> level});
        CHECK(pixels_against(pyramid.size(level), [&](int x, int y) {
                  const int right = y % 2 == 0 ? 1 : 0, lower = x % 2 == 0 ? 1 : 0;
                  return pyramid.at(level, x, y) == pyramid.at(level - 1, 2 * x + right, 2 * y + lower);
              }) == "");
    }
    // Over two by two cells the picks are of all four kinds.
    std::set<int> kinds;
    for (int y = 0; y < 2; ++y) {
        for (int x = 0; x < 2; ++x) {
            const int pixel = static_cast<int>(pyramid.at(1, x, y)) - 2;
            kinds.insert(pixel % kSize.width % 2 + 2 * (pixel / kSize.width % 2));
        }
    }
    CHECK(kinds.size() == 4);
}

TEST_CASE("depth pyramid: a fetch tells the depth of the pixel that it names, close to the position") {
    const AoInputs inputs = numbered(kSize);
    const DepthPyramid pyramid(inputs, 5, {});
    for (int level = 0; level <= 5; ++level) {
        CAPTURE(level);
        // A last column without a cell of its own belongs to the one before.
        const float cell = static_cast<float>(1 << level), furthest = level == 0 ? 1 : 2 * cell;
        CHECK(pixels_against(kSize, [&](int x, int y) {
                  const Screen2<float> position = {static_cast<float>(x) + 0.25f,
                                                   static_cast<float>(y) + 0.875f};
                  const auto fetched = pyramid.fetch<float>(position, level);
                  const int column = static_cast<int>(fetched.at.x), row = static_cast<int>(fetched.at.y);
                  const bool centre = fetched.at.x == static_cast<float>(column) + 0.5f &&
                                      fetched.at.y == static_cast<float>(row) + 0.5f;
                  const bool near = std::fabs(fetched.at.x - position.x) < furthest &&
                                    std::fabs(fetched.at.y - position.y) < furthest;
                  return fetched.inside && centre && near &&
                         fetched.z == inputs.depth_map.at(column + 1, row + 1);
              }) == "");
        for (const Screen2<float> outside :
             {Screen2<float>{-0.01f, 5}, {5, -0.01f}, {83, 5}, {5, 67}, {kNan, 5}, {1e30f, 1e30f}})
            CHECK(!pyramid.fetch<float>(outside, level).inside);
    }
}

TEST_CASE("depth pyramid: a small picture has fewer levels; threads change nothing") {
    CHECK(DepthPyramid(numbered({1, 1}), 5, {}).top() == 0);
    CHECK(DepthPyramid(numbered({64, 3}), 5, {}).top() == 1);
    CHECK(DepthPyramid(numbered({16, 17}), 5, {}).top() == 4);
    CHECK(DepthPyramid(numbered({16, 17}), 2, {}).top() == 2);
    const AoInputs inputs = numbered(kSize);
    const DepthPyramid one(inputs, 5, kOneLane);
    Run run;
    run.threads = 3;
    const DepthPyramid three(inputs, 5, run);
    for (int level = 0; level <= 5; ++level)
        CHECK(pixels_against(one.size(level), [&](int x, int y) {
                  return one.at(level, x, y) == three.at(level, x, y);
              }) == "");
}
