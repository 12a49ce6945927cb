// XeGTAO's denoiser written anew in double, its edges, and what it must not mix.
#include "ssao/blur/edge_blur.h"

#include <cmath>

#include <doctest/doctest.h>

#include "rasterizer/base/error.h"
#include "rasterizer/base/image_summary.h"
#include "ssao/blur/bilateral_blur.h"
#include "ssao/blur/packed_edges.h"
#include "tests/tools/every_run.h"
#include "tests/tools/image_checks.h"
#include "tests/tools/plane_inputs.h"

using namespace crevice;

namespace {

using Edges = PackedEdges;
constexpr Size kSize = {45, 37};
constexpr int kSides[] = {Edges::kLeft, Edges::kRight, Edges::kTop, Edges::kBottom};

// Depths in steps of .01 from 3 to 3.15, a fifth of the texels sky; a texel is as wide as .01.
AoInputs uneven_inputs() {
    AoInputs inputs = plain_inputs(kSize, 3);
    inputs.rays.perspective = true;
    for (int y = 0; y < kSize.height; ++y) {
        for (int x = 0; x < kSize.width; ++x) {
            inputs.view_depth.at(x, y) =
                noise(5, x, y) < 0.2f ? kInfinity : 3 + 0.01f * std::floor(16 * noise(6, x, y));
        }
    }
    return inputs;
}

// The published loop over unpacked edges, but for neighbours that show nothing.
struct PublishedDenoiser {
    const PackedEdges& edges;

    bool shows(int x, int y) const { return (edges.bits.at(x + 1, y + 1) & Edges::kSurface) != 0; }
    double side(int x, int y, int which) const { return edges.at(x, y, which) / 3.0; }

    double value(const Image<float>& ao, double own_weight, int x, int y) const {
        double left = side(x, y, Edges::kLeft) * side(x - 1, y, Edges::kRight);
        double right = side(x, y, Edges::kRight) * side(x + 1, y, Edges::kLeft);
        double top = side(x, y, Edges::kTop) * side(x, y - 1, Edges::kBottom);
        double bottom = side(x, y, Edges::kBottom) * side(x, y + 1, Edges::kTop);
        const double sum_of_edges = left + right + top + bottom;
        const double edginess = std::fmin(std::fmax(4 - 2.5 - sum_of_edges, 0), 1) / (4 - 2.5) * 0.5;
        const auto leaking = [&](double edge, int i, int j) {
            return shows(i, j) ? std::fmin(edge + edginess, 1) : 0;
        };
        left = leaking(left, x - 1, y), right = leaking(right, x + 1, y);
        top = leaking(top, x, y - 1), bottom = leaking(bottom, x, y + 1);
        double sum = own_weight * double{ao.at(x, y)}, total = own_weight;
        const auto add = [&](double weight, int i, int j) {
            if (weight == 0) return;
            sum += weight * double{ao.at(i, j)};
            total += weight;
        };
        add(left, x - 1, y), add(right, x + 1, y), add(top, x, y - 1), add(bottom, x, y + 1);
        const double diagonal = 0.85 * 0.5;
        add(diagonal * (left * side(x - 1, y, Edges::kTop) + top * side(x, y - 1, Edges::kLeft)), x - 1,
            y - 1);
        add(diagonal * (top * side(x, y - 1, Edges::kRight) + right * side(x + 1, y, Edges::kTop)), x + 1,
            y - 1);
        add(diagonal * (bottom * side(x, y + 1, Edges::kLeft) + left * side(x - 1, y, Edges::kBottom)), x - 1,
            y + 1);
        add(diagonal * (right * side(x + 1, y, Edges::kBottom) + bottom * side(x, y + 1, Edges::kRight)),
            x + 1, y + 1);
        return sum / total;
    }
};

}  // namespace

TEST_CASE("edge blur: a slanted plane has no edges, a fold has some, a step cuts on both of its sides") {
    // 3 units a texel in a view 37 high: by the depths alone everything would be an edge.
    const PackedEdges plane = packed_edges(tilted_inputs(kSize, 3, -2));
    CHECK(pixels_against({kSize.width - 2, kSize.height - 2}, [&](int x, int y) {
              for (const int side : kSides) {
                  if (plane.at(x + 1, y + 1, side) != 3) return false;
              }
              return true;
          }) == "");

    AoInputs fold = plain_inputs(kSize, 3);
    for (int y = 0; y < kSize.height; ++y) {
        for (int x = 0; x < kSize.width; ++x)
            fold.view_depth.at(x, y) = 1000 + 0.6f * std::fabs(static_cast<float>(x - 20));
    }
    const PackedEdges folded = packed_edges(fold);
    CHECK(folded.at(20, 9, Edges::kLeft) == 0);
    CHECK(folded.at(20, 9, Edges::kRight) == 0);
    CHECK(folded.at(20, 9, Edges::kTop) == 3);
    CHECK(folded.at(19, 9, Edges::kRight) == 3);

    const PackedEdges step = packed_edges(step_inputs(kSize, StepSide::right, 0, 5));
    for (int x = 1; x + 1 < kSize.width; ++x) {
        CAPTURE(x);
        CHECK(step.at(x, 9, Edges::kLeft) == (x == 22 ? 0 : 3));
        CHECK(step.at(x, 9, Edges::kRight) == (x == 21 ? 0 : 3));
    }
}

TEST_CASE("edge blur: an edge has four steps, from a quarter of 1.1 % of the depth to five quarters of it") {
    for (const bool perspective : {true, false}) {
        AoInputs inputs = plain_inputs({3, 3}, 8);
        inputs.rays.perspective = perspective;
        // Orthographic, what counts is the height of the view, not where the eye stands.
        const float depth = perspective ? 8 : 1.5f * std::sqrt(3.0f);
        int before = 3;
        for (const float share : {0.2f, 0.3f, 0.5f, 0.8f, 1.2f, 1.3f}) {
            // To both sides, or the texel would lie on a slanted plane.
            inputs.view_depth.at(0, 1) = inputs.view_depth.at(2, 1) = 8 + share * 0.011f * depth;
            const int edge = packed_edges(inputs).at(1, 1, Edges::kRight);
            CAPTURE(perspective);
            CAPTURE(share);
            CHECK(edge == static_cast<int>(std::fmin(std::fmax(1.25f - share, 0.0f), 1.0f) * 2.9f + 0.5f));
            CHECK(edge <= before);
            before = edge;
        }
        CHECK(before == 0);
    }
}

TEST_CASE("edge blur: each texel is the published loop, whose last iteration keeps more of it") {
    const AoInputs inputs = uneven_inputs();
    const PackedEdges edges = packed_edges(inputs);
    const PublishedDenoiser published{edges};
    const Image<float> ao = noise_image(kSize, 9), once = edge_blur(ao, inputs, {.iterations = 1}).ao,
                       twice = edge_blur(ao, inputs, {.iterations = 2}).ao;
    Image<float> first(kSize, 1);
    for (int y = 0; y < kSize.height; ++y) {
        for (int x = 0; x < kSize.width; ++x) {
            if (published.shows(x, y)) first.at(x, y) = static_cast<float>(published.value(ao, 0.24, x, y));
        }
    }
    CHECK(pixels_against(kSize, [&](int x, int y) {
              if (inputs.view_depth.at(x, y) == kInfinity) return once.at(x, y) == 1 && twice.at(x, y) == 1;
              return std::fabs(double{once.at(x, y)} - published.value(ao, 1.2, x, y)) < 1e-6 &&
                     std::fabs(double{twice.at(x, y)} - published.value(first, 1.2, x, y)) < 1e-6;
          }) == "");
}

TEST_CASE("edge blur: an open map stays exactly open, an even one even; without iterations nothing changes") {
    const AoInputs inputs = uneven_inputs();
    CHECK(other_than(edge_blur(Image<float>(kSize, 1), inputs, {.iterations = 3}).ao, 1) == "");
    const Image<float> even = edge_blur(Image<float>(kSize, 0.3f), inputs, {.iterations = 3}).ao;
    CHECK(pixels_against(kSize, [&](int x, int y) {
              const float expected = inputs.view_depth.at(x, y) == kInfinity ? 1 : 0.3f;
              return std::fabs(even.at(x, y) - expected) < 1e-6f;
          }) == "");
    CHECK(content_hash(edge_blur(noise_image(kSize, 1), inputs, {.iterations = 0}).ao) ==
          content_hash(noise_image(kSize, 1)));
}

TEST_CASE("edge blur: nothing crosses a step, however often; on a slanted plane the noise becomes less") {
    const AoInputs step = step_inputs(kSize, StepSide::below, 0.5f, 5);
    Image<float> halves(kSize, 1);
    for (int y = 0; y < kSize.height; ++y) {
        for (int x = 0; x < kSize.width; ++x) halves.at(x, y) = step.view_depth.at(x, y) < 1000 ? 0 : 1;
    }
    CHECK(content_hash(edge_blur(halves, step, {.iterations = 9}).ao) == content_hash(halves));

    const AoInputs plane = tilted_inputs(kSize, 3, -2);
    const auto spread_of = [](const Image<float>& ao) {
        double sum = 0;
        for (int y = 0; y < kSize.height; ++y) {
            for (int x = 0; x < kSize.width; ++x) sum += std::pow(double{ao.at(x, y)} - 0.5, 2);
        }
        return std::sqrt(sum / (kSize.width * kSize.height));
    };
    const Image<float> noisy = noise_image(kSize, 2);
    double before = spread_of(noisy);
    for (const int iterations : {1, 2, 3}) {
        const double after = spread_of(edge_blur(noisy, plane, {.iterations = iterations}).ao);
        CAPTURE(iterations);
        CHECK(after < 0.9 * before);
        before = after;
    }
}

TEST_CASE("edge blur: a texel by itself takes something from the surface around it, but not from the sky") {
    AoInputs inputs = plain_inputs({5, 5}, 8);
    Image<float> dot({5, 5}, 1);
    dot.at(2, 2) = 0;
    inputs.view_depth.at(2, 2) = 4;
    const auto middle = [&] { return edge_blur(dot, inputs, {.iterations = 1}).ao.at(2, 2); };
    // A third of each neighbour at a side, and .85 / 3 of each at a corner.
    const float around = 4 / 3.0f + 4 * 0.85f / 3;
    CHECK(middle() == doctest::Approx(around / (1.2f + around)));
    for (int y = 0; y < 5; ++y) {
        for (int x = 0; x < 5; ++x) {
            if (x != 2 || y != 2) inputs.view_depth.at(x, y) = kInfinity;
        }
    }
    CHECK(middle() == 0);
}

TEST_CASE("edge blur: the same bits for lanes, instruction sets and threads") {
    for (const Size size : {kSize, Size{1, 1}, Size{8, 3}, Size{3, 9}}) {
        AoInputs inputs = plain_inputs(size, 3);
        for (int y = 0; y < size.height; ++y) {
            for (int x = 0; x < size.width; ++x) inputs.view_depth.at(x, y) = 3 + noise(3, x / 2, y);
        }
        const Image<float> ao = noise_image(size, 3);
        const std::string plain = content_hash(edge_blur(ao, inputs, {}, kOneLane).ao);
        CAPTURE(size.width);
        for_every_run({.threads = {1, 3}}, [&](const Run& run) {
            CHECK(content_hash(edge_blur(ao, inputs, {}, run).ao) == plain);
        });
    }
}

TEST_CASE("edge blur: the other kind is X_Jun's; settings out of range are refused by name") {
    const AoInputs inputs = uneven_inputs();
    const Image<float> ao = noise_image(kSize, 3);
    BlurSettings xjun = kXjunBlur;
    xjun.iterations = 2;
    xjun.depth_threshold = 0.1f;
    const EdgeBlurSettings bilateral{.kind = EdgeBlurKind::bilateral, .iterations = 2, .depth = 0.1f};
    CHECK(content_hash(edge_blur(ao, inputs, bilateral).ao) ==
          content_hash(bilateral_blur(ao, inputs, xjun).ao));
    CHECK_THROWS_WITH_AS(validate(EdgeBlurSettings{.iterations = 65}), doctest::Contains("blur_iterations"),
                         UsageError);
    CHECK_THROWS_WITH_AS(validate(EdgeBlurSettings{.depth = -1}), doctest::Contains("blur_depth"),
                         UsageError);
}
