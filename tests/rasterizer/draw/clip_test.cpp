// Clipping against the same triangle evaluated pixel by pixel, in long double, without any clipping.
#include "rasterizer/draw/clip.h"

#include <initializer_list>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include "rasterizer/lanes/approx_math.h"
#include "tests/tools/clip_space_scene.h"
#include "tests/tools/random_sequence.h"
#include "tests/tools/ray_reference.h"

using namespace crevice;

namespace {

// A vertex is snapped by half of 1/256 pixel, after a float division that errs by up to as much again at the
// guard band.
constexpr long double kSnap_px = 1.0L / kSubpixelSteps;

// Checks one triangle, in both windings; returns how many pixels were decided to be inside.
int check_against_rays(glm::vec4 a, glm::vec4 b, glm::vec4 c, Size size) {
    ClipSpaceScene scene{size, {}, {}}, reversed{size, {}, {}};
    scene.add_triangle(a, b, c);
    reversed.add_triangle(a, c, b);
    const CountedDrawing drawing = draw(scene), from_behind = draw(reversed);
    const RayReference rays({a, b, c}, size);
    Image<std::int32_t> expected(size, 0), expected_behind(size, 0);
    int inside = 0;
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
            const Coverage coverage = rays.at(x, y, kSnap_px);
            inside += coverage == Coverage::inside;
            const bool unknown = coverage == Coverage::too_close_to_tell;
            expected.at(x, y) = unknown ? drawing.count.at(x, y) : coverage == Coverage::inside;
            expected_behind.at(x, y) = unknown ? from_behind.count.at(x, y) : coverage == Coverage::inside;
        }
    }
    CHECK(differences(drawing.count, expected) == "");
    CHECK(differences(from_behind.count, expected_behind) == "");
    return inside;
}

constexpr Size kSize = {64, 48};

}  // namespace

TEST_CASE("vertices far away in all 26 directions") {
    // The first, the first two, or all three vertices are moved outwards (CTS clip_one, clip_two,
    // clip_three).
    const std::array<glm::vec4, 3> base = {{{-0.5, -0.4, 0.3, 1}, {0.6, -0.3, 0.5, 1}, {0.1, 0.7, 0.6, 1}}};
    int drawn = 0;
    for (const float distance : {2.0f, 100.0f, 30000.0f, 1e5f, 3.4e34f}) {
        for (int direction = 0; direction < 27; ++direction) {
            if (direction == 13) continue;
            const glm::vec4 d(direction % 3 - 1, direction / 3 % 3 - 1, direction / 9 - 1, 0);
            for (std::size_t moved = 1; moved <= 3; ++moved) {
                CAPTURE(distance);
                CAPTURE(direction);
                CAPTURE(moved);
                std::array<glm::vec4, 3> p = base;
                for (std::size_t i = 0; i < moved; ++i) p[i] += distance * d;
                drawn += check_against_rays(p[0], p[1], p[2], kSize) > 0;
            }
        }
    }
    CHECK(drawn > 50);
}

TEST_CASE("random triangles with w of either sign and of every magnitude") {
    RandomSequence random(3);
    int drawn = 0;
    for (int i = 0; i < 3000; ++i) {
        CAPTURE(i);
        const auto vertex = [&] {
            const double scale = i % 4 == 0 ? exp2_of(static_cast<float>(random.between(0, 110))) : 1;
            const double w = random.whole(0, 9) == 0 ? 0 : random.between(-1, 3);
            const double reach = i % 3 == 0 ? 20 : 2;
            return glm::vec4{scale * random.between(-reach, reach), scale * random.between(-reach, reach),
                             scale * random.between(-0.3, 1), scale * w};
        };
        const glm::vec4 a = vertex(), b = vertex(), c = vertex();
        INFO("a " << a.x << " " << a.y << " " << a.z << " " << a.w);
        INFO("b " << b.x << " " << b.y << " " << b.z << " " << b.w);
        INFO("c " << c.x << " " << c.y << " " << c.z << " " << c.w);
        drawn += check_against_rays(a, b, c, kSize) > 0;
    }
    CHECK(drawn > 500);
}

TEST_CASE("one, two or three vertices behind the eye leave no mirrored ghost") {
    const glm::vec4 left(-0.5, -0.5, 0.5, 1), right(0.5, -0.5, 0.5, 1), top(0, 0.5, 0.5, 1);
    // Behind, its mirror image would land inside the picture.
    const glm::vec4 behind(0, 0.3, -0.5, -1), behind_left(-0.2, 0.1, -0.2, -0.5),
        behind_right(0.4, 0.2, -0.8, -2);
    CHECK(check_against_rays(left, right, top, kSize) > 0);
    CHECK(check_against_rays(left, right, behind, kSize) > 0);
    CHECK(check_against_rays(left, behind_right, behind, kSize) >= 0);
    for (const float w : {-1.0f, -1e-30f, 0.0f}) {
        CAPTURE(w);
        ClipSpaceScene scene{kSize, {}, {}};
        for (const glm::vec4 p : {behind, behind_left, behind_right}) scene.add({p.x, p.y, p.z, p.w * -w});
        scene.triangles = {{0, 1, 2}};
        CHECK(total(draw(scene).count) == 0);
    }
}

TEST_CASE("w = 0 exactly, and z = 0 exactly on the near plane") {
    const Size size = kSize;
    // A direction at infinity: the strip from the bottom edge of the picture goes up without end.
    const glm::vec4 a(-0.5, -1, 0, 1), b(0.5, -1, 0, 1), up(0, 1, 0, 0);
    CHECK(check_against_rays(a, b, up, size) >= 0);
    CHECK(check_against_rays(a, {0, 1, 0.5, 0}, {0.3, -1, 0.2, 1}, size) >= 0);
    ClipSpaceScene points_at_infinity{size, {}, {}};
    points_at_infinity.add_triangle({-1, 0, 0, 0}, {1, 0, 0, 0}, {0, 1, 0, 0});
    CHECK(total(draw(points_at_infinity).count) == 0);
    // All zero is no position at all.
    ClipSpaceScene nowhere{size, {}, {}};
    nowhere.add_triangle({-1, -1, 0, 1}, {1, -1, 0.5, 1}, {0, 0, 0, 0});
    CHECK(total(draw(nowhere).count) == 0);
    for (const float z : {0.0f, 1.0f}) {
        CAPTURE(z);
        ClipSpaceScene quad{size, {}, {}};
        quad.add_quad({-1, 1, z, 1}, {1, 1, z, 1}, {1, -1, z, 1}, {-1, -1, z, 1});
        const CountedDrawing drawing = draw(quad);
        CHECK(differences(drawing.count, 1) == "");
        CHECK(differences(drawing.depth.codes, depth_code(DepthFormat::d32f, z, 0)) == "");
    }
    for (const float z : {-1e-30f, 1.0000001f}) {
        CAPTURE(z);
        ClipSpaceScene quad{size, {}, {}};
        quad.add_quad({-1, 1, z, 1}, {1, 1, z, 1}, {1, -1, z, 1}, {-1, -1, z, 1});
        CHECK(total(draw(quad).count) == 0);
    }
}

TEST_CASE("a plane through the eye is seen edge-on, and one just beside it covers its half of the screen") {
    // y_clip = 0 for all vertices: the plane through the eye and the horizon.
    ClipSpaceScene edge_on{kSize, {}, {}};
    edge_on.add_triangle({-40, 0, -1, -1}, {40, 0, -1, -1}, {0, 0, 500, 500});
    CHECK(total(draw(edge_on).count) == 0);
    // The ground 0.5 below the eye, from behind it to far ahead: a wide triangle up to the horizon.
    const glm::vec4 left(-4e4, -0.5, -1.01, -1), right(4e4, -0.5, -1.01, -1), ahead(0, -0.5, 499.99, 500);
    CHECK(check_against_rays(left, right, ahead, kSize) > 1000);
}

TEST_CASE("what is left of a triangle lies inside all planes, and its coordinates say where") {
    RandomSequence random(13);
    for (int i = 0; i < 5000; ++i) {
        CAPTURE(i);
        std::array<glm::dvec4, 3> p;
        for (glm::dvec4& v : p) {
            const double w = random.between(-1, 2), reach = i % 2 == 0 ? 2 : 5000;
            v = glm::dvec4{random.between(-reach, reach), random.between(-reach, reach),
                           random.between(-0.5, 1.5), w};
        }
        if (i % 5 == 0) p[0] = glm::dvec4(0);
        const ClippedPolygon polygon = clip_triangle(p, kSize);
        CHECK((polygon.count == 0 || (polygon.count >= 3 && polygon.count <= kMaxClippedVertices)));
        for (std::size_t k = 0; k < static_cast<std::size_t>(polygon.count); ++k) {
            const ClippedVertex& v = polygon.vertices[k];
            const glm::dvec4 combined =
                (1 - v.lambda1 - v.lambda2) * p[0] + v.lambda1 * p[1] + v.lambda2 * p[2];
            CHECK(glm::distance(combined, v.p_clip) < 1e-9);
            CHECK(v.p_clip.w >= kSmallestW * (1 - 1e-9));
            CHECK(v.p_clip.z >= -1e-12);
            CHECK(v.p_clip.z <= v.p_clip.w + 1e-12);
            const ProjectedVertex on_screen = project_clipped(v, kSize);
            const int reach = static_cast<int>(kGuardBand_px) * kSubpixelSteps + 1;
            CHECK(std::abs(on_screen.x) <= reach);
            CHECK(std::abs(on_screen.y) <= reach);
        }
    }
}

TEST_CASE("a vertex on the guard band keeps its place, on whichever side rounding puts it") {
    RandomSequence random(5);
    for (const int width : {61, 64, 100, 255}) {
        const Size size = {width, 20};
        for (int i = 0; i < 500; ++i) {
            CAPTURE(width);
            CAPTURE(i);
            const double w = static_cast<float>(random.between(0.5, 2));
            const double x_ndc = (i % 2 == 0 ? 2 : -2) * static_cast<double>(kGuardBand_px) / width - 1;
            const glm::vec4 p(x_ndc * w * (1 + random.whole(-3, 3) * 0x1p-24), 0.9 * w, 0.5 * w, w);
            CHECK(check_against_rays({-0.9f, -0.9f, 0.5f, 1}, p, {0.9f, -0.8f, 0.5f, 1}, size) > 0);
        }
    }
}

TEST_CASE("a mesh that runs from behind the eye to beyond the far plane covers each of its pixels once") {
    // The ground y_view = -1, a jittered grid of 13x13 vertices; a field of view of 90 degrees, near 0.1,
    // far 20.
    const Size size = {96, 96};
    for (std::uint64_t seed = 0; seed < 40; ++seed) {
        CAPTURE(seed);
        RandomSequence random(seed);
        const double spread = seed % 2 == 0 ? 6 : 5000;  // up to the guard band and far beyond it
        ClipSpaceScene scene{size, {}, {}};
        for (int row = 0; row < 13; ++row) {
            for (int column = 0; column < 13; ++column) {
                const double x = spread * (column - 6 + random.between(-0.3, 0.3));
                const double z = 3 * (row - 3 + random.between(-0.3, 0.3));
                scene.add(glm::vec4(x, -1, 20 / 19.9 * (z - 0.1), z));
            }
        }
        for (std::uint32_t i = 0; i < 12 * 12; ++i) {
            const std::uint32_t a = i / 12 * 13 + i % 12;
            scene.triangles.push_back({a, a + 1, a + 14});
            scene.triangles.push_back({a, a + 14, a + 13});
        }
        const Image<std::int32_t> count = draw(scene).count;
        Image<std::int32_t> expected(size, 0);
        for (int y = 0; y < size.height; ++y) {
            for (int x = 0; x < size.width; ++x) {
                // Row y shows the ground at z = 48 / (y + 0.5 - 48); the far plane at 20 is cut at row 50.4.
                expected.at(x, y) = y > 50 ? 1 : y < 50 ? 0 : count.at(x, y);
            }
        }
        CHECK(differences(count, expected) == "");
    }
}

TEST_CASE("abc, bca and cab of a clipped triangle cover the same pixels") {
    RandomSequence random(9);
    for (int i = 0; i < 1000; ++i) {
        CAPTURE(i);
        ClipSpaceScene scene{kSize, {}, {}};
        for (int k = 0; k < 3; ++k) {
            const double w = random.between(-1, 2), reach = i % 2 == 0 ? 2 : 2000;
            scene.add(glm::vec4{random.between(-reach, reach), random.between(-reach, reach),
                                random.between(-0.5, 1.5), w});
        }
        scene.triangles = {{0, 1, 2}};
        const CountedDrawing expected = draw(scene);
        for (const std::array<std::uint32_t, 3>& order :
             {std::array<std::uint32_t, 3>{1, 2, 0}, {2, 0, 1}, {0, 2, 1}}) {
            INFO("order " << order[0] << order[1] << order[2]);
            scene.triangles = {order};
            CHECK(differences(draw(scene).count, expected.count) == "");
        }
    }
}
