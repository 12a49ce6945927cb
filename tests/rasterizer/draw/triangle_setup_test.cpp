#include "rasterizer/draw/triangle_setup.h"

#include <algorithm>

#include <doctest/doctest.h>

#include "tests/tools/clip_space_scene.h"
#include "tests/tools/random_sequence.h"

using namespace crevice;

namespace {

ProjectedVertex corner_at(std::int32_t x, std::int32_t y) {
    return {.x = x, .y = y, .x_rest = 0, .y_rest = 0, .z_ndc = 0.5f, .inverse_w = 1, .outside = 0};
}
ProjectedVertex corner_at(glm::ivec2 p) { return corner_at(p.x, p.y); }

std::optional<SetUpTriangle> set_up(const std::array<ProjectedVertex, 3>& corners,
                                    bool cull_back_faces = false) {
    return set_up_triangle({&corners[0], &corners[1], &corners[2]}, {.cull_back_faces = cull_back_faces});
}

}  // namespace

TEST_CASE("a span of screen positions holds the pixel centres between its ends, ends included") {
    for (int low = -700; low <= 700; low += 7) {
        for (int high = low; high <= 700; high += 11) {
            int first = 1000, last = -1000;
            for (int pixel = -4; pixel <= 4; ++pixel) {
                const int centre = pixel * kSubpixelSteps + kSubpixelSteps / 2;
                if (low <= centre && centre <= high) {
                    first = std::min(first, pixel);
                    last = std::max(last, pixel);
                }
            }
            const PixelSpan span = covered_centres(low, high);
            if (first > last ? span.first <= span.last : span.first != first || span.last != last) {
                FAIL("[" << low << ", " << high << "] gives " << span.first << " to " << span.last);
            }
        }
    }
}

TEST_CASE("nothing is set up for triangles without area, without a pixel centre, or culled") {
    CHECK_FALSE(set_up({corner_at(256, 256), corner_at(256, 256), corner_at(1280, 1280)}).has_value());
    CHECK_FALSE(set_up({corner_at(0, 0), corner_at(512, 512), corner_at(1024, 1024)}).has_value());
    // Between the centres of a row.
    CHECK_FALSE(set_up({corner_at(0, 130), corner_at(9999, 130), corner_at(50, 380)}).has_value());
    const std::array<ProjectedVertex, 3> clockwise = {corner_at(0, 0), corner_at(1024, 0),
                                                      corner_at(0, 1024)};
    const std::array<ProjectedVertex, 3> reversed = {clockwise[0], clockwise[2], clockwise[1]};
    REQUIRE(set_up(clockwise, true).has_value());
    CHECK_FALSE(set_up(clockwise, true)->triangle.back_facing);
    CHECK_FALSE(set_up(reversed, true).has_value());
    REQUIRE(set_up(reversed, false).has_value());
    CHECK(set_up(reversed, false)->triangle.back_facing);
}

TEST_CASE("corners start at the top, go clockwise, and `order` names them") {
    RandomSequence random(2);
    for (int i = 0; i < 2000; ++i) {
        CAPTURE(i);
        std::array<ProjectedVertex, 3> corners;
        for (ProjectedVertex& c : corners)
            c = corner_at(glm::ivec2{random.whole(-9, 9), random.whole(-9, 9)} * 128);
        const std::optional<SetUpTriangle> result = set_up(corners);
        if (!result) continue;
        const ScreenTriangle& t = result->triangle;
        for (std::size_t k = 0; k < 3; ++k) {
            CHECK(t.x[k] == corners[result->order[k]].x);
            CHECK(t.y[k] == corners[result->order[k]].y);
        }
        CHECK(std::pair(t.y[0], t.x[0]) < std::pair(t.y[1], t.x[1]));
        CHECK(std::pair(t.y[0], t.x[0]) < std::pair(t.y[2], t.x[2]));
        const int doubled_area =
            (t.x[1] - t.x[0]) * (t.y[2] - t.y[0]) - (t.x[2] - t.x[0]) * (t.y[1] - t.y[0]);
        CHECK(doubled_area > 0);
        CHECK(t.doubled_area == static_cast<float>(doubled_area));
    }
}

TEST_CASE("edge functions are exact integers, up to the guard band") {
    RandomSequence random(4);
    const int band = static_cast<int>(kGuardBand_px);
    for (int i = 0; i < 500; ++i) {
        CAPTURE(i);
        const int reach = i % 2 == 0 ? band * kSubpixelSteps : 4096;
        std::array<ProjectedVertex, 3> corners;
        for (ProjectedVertex& c : corners)
            c = corner_at(glm::ivec2{random.whole(-reach, reach), random.whole(-reach, reach)});
        if (i < 2) corners = {corner_at(-reach, -reach), corner_at(reach, -reach), corner_at(reach, reach)};
        const std::optional<SetUpTriangle> result = set_up(corners);
        if (!result) continue;
        const ScreenTriangle& t = result->triangle;
        const int column = random.whole(0, band - 1), row = random.whole(0, band - 1);
        __int128 sum = 0, doubled_area = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            const std::size_t from = (k + 1) % 3, to = (k + 2) % 3;
            const __int128 x = column * kSubpixelSteps + kSubpixelSteps / 2,
                           y = row * kSubpixelSteps + kSubpixelSteps / 2;
            const __int128 dx = t.x[to] - t.x[from], dy = t.y[to] - t.y[from];
            const __int128 expected = dx * (y - t.y[from]) - dy * (x - t.x[from]);
            const Edge edge = triangle_edge(t, static_cast<int>(k));
            const std::int64_t value = edge.at_origin + edge.per_column * column + edge.per_row * row;
            CHECK(value == static_cast<std::int64_t>(expected));
            CHECK(std::abs(value) < std::int64_t{1} << 53);  // exact as a double
            CHECK(edge.threshold == (dy < 0 || (dy == 0 && dx > 0) ? 0 : 1));
            sum += value;
            doubled_area +=
                static_cast<__int128>(t.x[from]) * t.y[to] - static_cast<__int128>(t.x[to]) * t.y[from];
        }
        CHECK(static_cast<std::int64_t>(sum) == static_cast<std::int64_t>(doubled_area));
    }
}

TEST_CASE("abc, bca, cab and their mirror images draw the same pixels and depths, to the bit") {
    RandomSequence random(6);
    for (int i = 0; i < 200; ++i) {
        CAPTURE(i);
        ClipSpaceScene scene{{64, 64}, {}, {}};
        for (int k = 0; k < 3; ++k) {
            const double w = random.between(0.1, 4);
            const glm::dvec2 p_px{random.between(-40, 104), random.between(-40, 104)};
            scene.add(scene.at_screen(p_px, random.between(0, 1), w));
        }
        scene.triangles = {{0, 1, 2}};
        const CountedDrawing expected = draw(scene);
        for (const std::array<std::uint32_t, 3>& order :
             {std::array<std::uint32_t, 3>{1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}}) {
            INFO("order " << order[0] << order[1] << order[2]);
            scene.triangles = {order};
            const CountedDrawing drawing = draw(scene);
            CHECK(differences(drawing.count, expected.count) == "");
            CHECK(differences(drawing.depth.codes, expected.depth.codes) == "");
        }
    }
}

TEST_CASE("depth is that of the true plane, not of its snapped corners") {
    RandomSequence random(8);
    for (int i = 0; i < 200; ++i) {
        CAPTURE(i);
        const Size size = {64, 64};
        ClipSpaceScene scene{size, {}, {}};
        // z_ndc = 0.5 + slope_x * x_ndc + slope_y * y_ndc, steep: the whole depth range over the picture.
        const double slope_x = random.between(-0.2, 0.2), slope_y = random.between(-0.2, 0.2);
        const auto corner = [&](double x_ndc, double y_ndc) {
            const glm::vec4 p{x_ndc + random.between(-0.2, 0.2), y_ndc + random.between(-0.2, 0.2), 0, 1};
            return glm::vec4(
                p.x, p.y, 0.5 + slope_x * static_cast<double>(p.x) + slope_y * static_cast<double>(p.y), 1);
        };
        const glm::vec4 a = corner(-0.8, 0.8), b = corner(0.8, 0.7), c = corner(0, -0.8);
        scene.add_triangle(a, b, c);
        const CountedDrawing drawing = draw(scene);
        const Image<float> depth = ndc_depth(drawing.depth);
        double worst = 0;
        for (int y = 0; y < size.height; ++y) {
            for (int x = 0; x < size.width; ++x) {
                if (drawing.count.at(x, y) == 0) continue;
                const double truth = 0.5 + slope_x * ((x + 0.5) / 32 - 1) + slope_y * (1 - (y + 0.5) / 32);
                worst = std::max(worst, std::abs(static_cast<double>(depth.at(x, y)) - truth));
            }
        }
        CHECK(worst < 4 * 0x1p-24);
    }
}

TEST_CASE("slivers keep their depth near the range of their corners") {
    RandomSequence random(10);
    int drawn = 0;
    for (int i = 0; i < 4000; ++i) {
        CAPTURE(i);
        // Three corners within 1/100 pixel of a column of pixel centres.
        ClipSpaceScene scene{{32, 32}, {}, {}};
        std::array<double, 3> z;
        for (double& value : z) {
            value = random.between(0.01, 0.9);
            const double x = 8.5 + random.between(-0.01, 0.01), y = random.between(0, 32);
            scene.add(i % 2 == 0 ? scene.at_screen(x, y, value) : scene.at_screen(y, x, value));
        }
        scene.triangles = {{0, 1, 2}};
        const double low = *std::min_element(z.begin(), z.end()),
                     high = *std::max_element(z.begin(), z.end());
        const CountedDrawing drawing = draw(scene);
        const Image<float> depth = ndc_depth(drawing.depth);
        for (int y = 0; y < 32; ++y) {
            for (int x = 0; x < 32; ++x) {
                if (drawing.count.at(x, y) == 0) continue;
                ++drawn;
                const double value = static_cast<double>(depth.at(x, y)), reach = 0.26 * (high - low);
                if (!(value > low - reach && value < high + reach)) {
                    FAIL("depth " << value << " at " << x << "," << y << " for corners from " << low << " to "
                                  << high);
                }
            }
        }
    }
    CHECK(drawn > 1000);
}

TEST_CASE("slivers with corners near and far keep 1/w above zero") {
    RandomSequence random(12);
    int set_up_slivers = 0;
    for (int i = 0; i < 4000; ++i) {
        CAPTURE(i);
        ClipSpaceScene scene{{32, 32}, {}, {}};
        for (int k = 0; k < 3; ++k) {
            const double w = k == 0 ? random.between(0.1, 1) : random.between(1, 1000);
            scene.add(scene.at_screen(glm::dvec2{8.5 + random.between(-0.01, 0.01), random.between(0, 32)},
                                      0.5, w));
        }
        scene.triangles = {{0, 1, 2}};
        float lowest = 1e30f;
        for (const glm::vec4& p : scene.p_clip) lowest = std::min(lowest, 1 / p.w);
        const ScreenGeometry geometry = geometry_of(scene);
        for (const ScreenTriangle& t : geometry.blocks[0].triangles) {
            ++set_up_slivers;
            for (const float inverse_w : t.inverse_w) CHECK(inverse_w >= 0.5f * lowest);
        }
    }
    CHECK(set_up_slivers > 500);
}
