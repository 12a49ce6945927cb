// Perspective-correct interpolation against long double, and the values that must come out exact.
#include <algorithm>

#include <doctest/doctest.h>

#include "rasterizer/draw/triangle_pixels.h"
#include "tests/tools/clip_space_scene.h"
#include "tests/tools/every_run.h"
#include "tests/tools/random_sequence.h"

using namespace crevice;

namespace {

constexpr double kUnit = 0x1p-24;  // half the last bit of a float near 1

struct Interpolated {
    Image<float> value, view_depth;
    CountedDrawing drawing;
};

// An attribute of the vertices and the view depth at every pixel that shows a triangle.
Interpolated interpolate(const ClipSpaceScene& scene, const std::vector<float>& attribute) {
    Interpolated result{Image<float>(scene.size, -1e30f), Image<float>(scene.size, -1e30f), draw(scene)};
    const ScreenGeometry geometry = geometry_of(scene);
    const Image<std::int32_t> shown = drawn_again(
        geometry, cleared_depth(scene.size, DepthFormat::d32f, false), DepthFunction::always, {}, kPlainRun);
    for (int y = 0; y < scene.size.height; ++y) {
        for (int x = 0; x < scene.size.width; ++x) {
            if (shown.at(x, y) == kNoTriangle) continue;
            const TrianglePixels<float> pixel(geometry.triangle(shown.at(x, y)), true, x, y);
            const auto& vertex = pixel.triangle.vertex;
            result.value.at(x, y) =
                pixel.here.interpolate(attribute[vertex[0]], attribute[vertex[1]], attribute[vertex[2]]);
            result.view_depth.at(x, y) = pixel.view_depth(geometry);
        }
    }
    return result;
}

// Calls body(x, y) for every pixel that was drawn.
template <class Body>
void for_drawn(const Interpolated& i, const Body& body) {
    for (int y = 0; y < i.value.size.height; ++y) {
        for (int x = 0; x < i.value.size.width; ++x) {
            if (i.drawing.count.at(x, y) > 0) body(x, y);
        }
    }
}

struct Truth {
    long double value, view_depth;
};

// A triangle's attribute at a screen position from its clip-space corners, without a rounding that matters.
Truth truth_at(const ClipSpaceScene& scene, const std::vector<float>& attribute, long double px,
               long double py) {
    std::array<long double, 3> x, y, w, share;
    for (std::size_t i = 0; i < 3; ++i) {
        w[i] = scene.p_clip[i].w;
        x[i] = (scene.p_clip[i].x / w[i] + 1) * scene.size.width / 2;
        y[i] = (1 - scene.p_clip[i].y / w[i]) * scene.size.height / 2;
    }
    long double sum = 0, area = 0, value = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t a = (i + 1) % 3, b = (i + 2) % 3;
        const long double edge = (x[b] - x[a]) * (py - y[a]) - (y[b] - y[a]) * (px - x[a]);
        area += edge;
        share[i] = edge / w[i];
        sum += share[i];
    }
    for (std::size_t i = 0; i < 3; ++i) value += share[i] / sum * attribute[i];
    return {value, area / sum};
}

// The largest error of attribute and view depth (relative) over a triangle, in units.
struct Errors {
    double value = 0, view_depth = 0;
};
Errors largest_errors(const ClipSpaceScene& scene, const std::vector<float>& attribute) {
    Errors worst;
    const Interpolated i = interpolate(scene, attribute);
    for_drawn(i, [&](int x, int y) {
        const Truth truth = truth_at(scene, attribute, x + 0.5L, y + 0.5L);
        const long double depth_error = i.view_depth.at(x, y) / truth.view_depth - 1;
        worst.value =
            std::max(worst.value, static_cast<double>(std::abs(i.value.at(x, y) - truth.value)) / kUnit);
        worst.view_depth = std::max(worst.view_depth, static_cast<double>(std::abs(depth_error)) / kUnit);
    });
    return worst;
}

}  // namespace

TEST_CASE("an attribute of 0 at w = 1 and 1 at w = 3 is 1/4 half-way on the screen") {
    ClipSpaceScene scene{{16, 16}, {}, {}};
    // The pixel centre (8.5, 8.5) lies half-way between the columns 4.5 and 12.5.
    scene.add_triangle(scene.at_screen(4.5, 0, 0.5, 1), scene.at_screen(12.5, 0, 0.5, 3),
                       scene.at_screen(12.5, 17, 0.5, 3));
    scene.add_triangle(scene.at_screen(4.5, 0, 0.5, 1), scene.at_screen(12.5, 17, 0.5, 3),
                       scene.at_screen(4.5, 17, 0.5, 1));
    const Interpolated i = interpolate(scene, {0, 1, 1, 0, 1, 0});
    REQUIRE(i.drawing.count.at(8, 8) == 1);
    CHECK(std::abs(static_cast<double>(i.value.at(8, 8)) - 0.25) <= 2 * kUnit);
    CHECK(std::abs(static_cast<double>(i.view_depth.at(8, 8)) - 1.5) <= 4 * kUnit);
}

TEST_CASE("attributes and view depth against long double, w from 0.1 to 4 and from 1 to 2^20") {
    for (const bool extreme : {false, true}) {
        CAPTURE(extreme);
        RandomSequence random(extreme ? 2 : 1);
        Errors worst;
        for (int i = 0; i < 300; ++i) {
            ClipSpaceScene scene{{64, 64}, {}, {}};
            std::vector<float> attribute;
            // On the grid of 1/256 pixel, and w in steps of 1/64 or a power of two: clip-space positions are
            // exact, snapping moves nothing.
            for (int k = 0; k < 3; ++k) {
                const double x = random.whole(-4096, 20480) / 256.0, y = random.whole(-4096, 20480) / 256.0;
                const int exponent = k < 2 ? 20 * k : random.whole(0, 20);
                const double w = extreme ? std::ldexp(1.0, exponent) : random.whole(7, 256) / 64.0;
                scene.add(scene.at_screen(x, y, 0.5, w));
                attribute.push_back(static_cast<float>(random.between(-1, 1)));
            }
            scene.triangles = {{0, 1, 2}};
            const Errors errors = largest_errors(scene, attribute);
            worst = {std::max(worst.value, errors.value), std::max(worst.view_depth, errors.view_depth)};
        }
        CHECK(worst.value < 8);
        CHECK(worst.view_depth < 6);
    }
}

TEST_CASE("a constant attribute is constant to the bit, clipped or not") {
    RandomSequence random(3);
    int drawn = 0;
    for (int i = 0; i < 300; ++i) {
        CAPTURE(i);
        ClipSpaceScene scene{{64, 64}, {}, {}};
        const bool clipped = i % 2 == 1;
        for (int k = 0; k < 3; ++k) {
            const double w = random.between(0.1, 4), z = clipped ? random.between(-1, 1.5) : 0.5;
            scene.add(scene.at_screen(glm::dvec2{random.between(-40, 104), random.between(-40, 104)}, z, w));
        }
        scene.triangles = {{0, 1, 2}};
        const float constant = static_cast<float>(random.between(-10, 10));
        const Interpolated result = interpolate(scene, {constant, constant, constant});
        int different = 0;
        for_drawn(result, [&](int x, int y) {
            ++drawn;
            different += float_bits(result.value.at(x, y)) != float_bits(constant);
        });
        CHECK(different == 0);
    }
    CHECK(drawn > 10000);
}

TEST_CASE("clipping leaves attributes where they were") {
    // A floor from behind the eye to far ahead: what is left of it after clipping must carry the attributes
    // of the whole.
    RandomSequence random(4);
    std::int64_t drawn = 0;
    for (int i = 0; i < 100; ++i) {
        CAPTURE(i);
        ClipSpaceScene scene{{64, 64}, {}, {}};
        std::vector<float> attribute;
        for (int k = 0; k < 3; ++k) {
            const double w = k == 0 ? -random.between(0.5, 2) : random.between(2, 8);
            scene.add(glm::vec4{random.between(-6, 6), random.between(-6, 6), w - 1, w});
            attribute.push_back(static_cast<float>(random.between(-1, 1)));
        }
        scene.triangles = {{0, 1, 2}};
        const Interpolated result = interpolate(scene, attribute);
        // Snapping moves the corners by up to 1/512 pixel, and the attribute with them.
        for_drawn(result, [&](int x, int y) {
            const double here = static_cast<double>(truth_at(scene, attribute, x + 0.5L, y + 0.5L).value);
            double allowed = 1e-5;
            for (const glm::dvec2 d : {glm::dvec2(1, 0), {-1, 0}, {0, 1}, {0, -1}}) {
                const Truth moved = truth_at(scene, attribute, x + 0.5L + d.x / 256, y + 0.5L + d.y / 256);
                allowed = std::max(allowed, 2 * std::abs(static_cast<double>(moved.value) - here));
            }
            if (!(std::abs(static_cast<double>(result.value.at(x, y)) - here) < allowed)) {
                FAIL("at " << x << "," << y << ": " << result.value.at(x, y) << " instead of " << here);
            }
        });
        drawn += total(result.drawing.count);
    }
    CHECK(drawn > 10000);
}

TEST_CASE("an orthographic plane z = x / 256 is (2i + 1) / 512 at pixel i, exactly") {
    for (const bool other_diagonal : {false, true}) {
        CAPTURE(other_diagonal);
        ClipSpaceScene scene{{256, 256}, {}, {}};
        const glm::vec4 a(-1, 1, 0, 1), b(1, 1, 1, 1), c(1, -1, 1, 1), d(-1, -1, 0, 1);
        if (other_diagonal) {
            scene.add_quad(b, c, d, a);
        } else {
            scene.add_quad(a, b, c, d);
        }
        const Image<float> depth = ndc_depth(draw(scene).depth);
        for (int x = 0; x < 256; ++x) {
            CAPTURE(x);
            for (const int y : {0, 1, 100, 255}) CHECK(depth.at(x, y) == static_cast<float>(2 * x + 1) / 512);
        }
    }
}

TEST_CASE("one plane drawn as two triangles steps by at most one quantum along their edge") {
    RandomSequence random(5);
    double worst = 0;
    for (int i = 0; i < 100; ++i) {
        ClipSpaceScene one_way{{64, 64}, {}, {}}, other_way{{64, 64}, {}, {}};
        const double z = random.between(0.3, 0.7);
        const double slope_x = random.between(-0.1, 0.1), slope_y = random.between(-0.1, 0.1);
        const auto at = [&](double x, double y) { return glm::vec4(x, y, z + slope_x * x + slope_y * y, 1); };
        one_way.add_quad(at(-1, 1), at(1, 1), at(1, -1), at(-1, -1));
        other_way.add_quad(at(1, 1), at(1, -1), at(-1, -1), at(-1, 1));
        const Image<float> a = ndc_depth(draw(one_way).depth), b = ndc_depth(draw(other_way).depth);
        for (int y = 0; y < 64; ++y) {
            for (int x = 0; x < 64; ++x) {
                worst = std::max(worst,
                                 std::abs(static_cast<double>(a.at(x, y)) - static_cast<double>(b.at(x, y))));
            }
        }
    }
    CAPTURE(worst / kUnit);
    CHECK(worst <= kUnit);
}
