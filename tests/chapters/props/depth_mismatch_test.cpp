#include "chapters/props/depth_mismatch.h"

#include <numeric>

#include <doctest/doctest.h>

#include "rasterizer/draw/cutouts.h"
#include "scenes/builtin_scenes.h"
#include "tests/tools/special_floats.h"

using namespace crevice;

TEST_CASE("lit shares: holes and wrong pixels of those that show a surface") {
    const Size size{4, 2};
    Image<float> view_depth(size, 5.0f);
    view_depth.at(3, 0) = view_depth.at(3, 1) = kInfinity;
    const Image3 right(size, glm::vec3(0.5f));
    Image3 lit = right;
    lit.set(0, 0, kMagenta);
    lit.set(1, 0, {0.51f, 0.505f, 0.5f});  // within the tolerance
    lit.set(2, 0, {0.52f, 0.5f, 0.49f});   // beyond it
    lit.set(3, 0, kMagenta);               // background
    const LitShares shares = lit_shares(lit, right, view_depth);
    CHECK(shares.holes == doctest::Approx(1.0 / 6));
    CHECK(shares.wrong == doctest::Approx(1.0 / 6));
    const LitShares nothing = lit_shares(lit, right, Image<float>(size, kInfinity));
    CHECK(nothing.holes == 0);
    CHECK(nothing.wrong == 0);
}

TEST_CASE("depth differences: shares that add up to 1, all of them 0 steps for one order") {
    const Scene scene = find_builtin_scene("columns")->make();
    Camera camera = scene.camera;
    camera.eye = {-7.3, 1.7, -11.1};
    for (const DepthFormat format : {DepthFormat::d16, DepthFormat::d24, DepthFormat::d32f}) {
        CAPTURE(static_cast<int>(format));
        const auto shares = [&](PositionOrder second) {
            return depth_differences(scene, camera, {160, 90}, format, PositionOrder::view_first, second);
        };
        const std::vector<double> same = shares(PositionOrder::view_first),
                                  other = shares(PositionOrder::premultiplied);
        REQUIRE(same.size() == 2 * kMostSteps + 1);
        CHECK(same[kMostSteps] == 1);
        CHECK(std::accumulate(other.begin(), other.end(), 0.0) == doctest::Approx(1));
        CHECK((format == DepthFormat::d16 ? other[kMostSteps] > 0.9 : other[kMostSteps] < 0.9));
    }
}

TEST_CASE("the lattice has holes, and without cut-outs has none") {
    const Scene cut = lattice_scene(), whole = without_cutouts(cut);
    CHECK(has_cutouts(cut));
    CHECK(!has_cutouts(whole));
    const GBuffer through = normal_depth(cut, cut.camera, {160, 90}),
                  solid = normal_depth(whole, whole.camera, {160, 90});
    int holes = 0, bars = 0;
    for (int y = 0; y < 90; ++y) {
        for (int x = 0; x < 160; ++x) {
            if (solid.view_depth.at(x, y) > 5.1f) continue;
            (through.view_depth.at(x, y) > 5.1f ? holes : bars) += 1;
        }
    }
    CHECK(holes > bars / 2);
    CHECK(bars > 500);
}
