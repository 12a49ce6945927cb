// Clipping against the same triangle evaluated pixel by pixel, in long double, without any clipping.
#include "rasterizer/clip.h"

#include <initializer_list>
#include <limits>

#include <doctest/doctest.h>

#include "rasterizer/approx_math.h"
#include "tests/clip_space_scene.h"

using namespace crevice;

namespace {

using Real = long double;
struct Vector3 {
    Real x, y, z;
};
Vector3 cross(Vector3 a, Vector3 b) { return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x}; }
Real dot(Vector3 a, Vector3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
Real length(Vector3 a) { return std::sqrt(dot(a, a)); }

enum class Coverage { outside, inside, too_close_to_tell };

// A triangle in homogeneous screen coordinates (x_px * w, y_px * w, w). The pixel's ray meets its plane at
// sum lambda_i * v_i with lambda_i = line_i . (x_px, y_px, 1), which must all be positive (Olano & Greer 1997), and z must
// be in range there.
class RayReference {
   public:
    RayReference(const std::array<glm::vec4, 3>& p_clip, Size size) {
        std::array<Vector3, 3> v;
        for (std::size_t i = 0; i < 3; ++i) {
            const Real x = p_clip[i].x, y = p_clip[i].y, w = p_clip[i].w;
            v[i] = {(x + w) * size.width / 2, (w - y) * size.height / 2, w};
        }
        const Real volume = dot(v[0], cross(v[1], v[2]));
        edge_on_ = std::abs(volume) <= Real(1e-16) * length(v[0]) * length(v[1]) * length(v[2]);
        if (edge_on_) return;
        Vector3 z = {0, 0, 0};
        for (std::size_t i = 0; i < 3; ++i) {
            const Vector3 c = cross(v[(i + 1) % 3], v[(i + 2) % 3]);
            lines_[i] = {c.x / volume, c.y / volume, c.z / volume};
            const Real at = p_clip[i].z;
            z = {z.x + at * lines_[i].x, z.y + at * lines_[i].y, z.z + at * lines_[i].z};
        }
        lines_[3] = z;                      // z_ndc >= 0
        lines_[4] = {-z.x, -z.y, 1 - z.z};  // z_ndc <= 1
    }

    // `tolerance_px` is how far the snapped outline may be from the true one.
    Coverage at(int column, int row, Real tolerance_px) const {
        if (edge_on_) return Coverage::too_close_to_tell;
        const Vector3 p = {column + Real(0.5), row + Real(0.5), 1};
        Coverage coverage = Coverage::inside;
        for (const Vector3& line : lines_) {
            const Real value = dot(line, p), per_px = std::sqrt(line.x * line.x + line.y * line.y);
            if (value < -tolerance_px * per_px - Real(1e-9)) return Coverage::outside;
            if (value < tolerance_px * per_px + Real(1e-9)) coverage = Coverage::too_close_to_tell;
        }
        return coverage;
    }

   private:
    std::array<Vector3, 5> lines_;
    bool edge_on_;  // or nearly: what is seen of it is up to the rounding
};

// A vertex is snapped by half of 1/256 pixel, after a float division that errs by up to as much again at the guard band.
constexpr Real kSnap_px = Real(1) / kSubpixelSteps;

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
    // The first, the first two, or all three vertices are moved outwards (CTS clip_one, clip_two, clip_three).
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
            return glm::vec4(scale * random.between(-reach, reach), scale * random.between(-reach, reach),
                             scale * random.between(-0.3, 1), scale * w);
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
    const glm::vec4 behind(0, 0.3, -0.5, -1), behind_left(-0.2, 0.1, -0.2, -0.5), behind_right(0.4, 0.2, -0.8, -2);
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

TEST_CASE("vertices that are not numbers take their triangle away, and only theirs") {
    const float nan = std::numeric_limits<float>::quiet_NaN(), inf = std::numeric_limits<float>::infinity();
    for (const float bad : {nan, inf, -inf}) {
        for (int component = 0; component < 4; ++component) {
            CAPTURE(bad);
            CAPTURE(component);
            ClipSpaceScene scene{kSize, {}, {}};
            scene.add_quad({-1, 1, 0.5, 1}, {1, 1, 0.5, 1}, {1, -1, 0.5, 1}, {-1, -1, 0.5, 1});
            glm::vec4 p(0, 0, 0.5, 1);
            p[component] = bad;
            scene.add_triangle({-1, 1, 0.5, 1}, {1, 1, 0.5, 1}, p);
            CHECK(differences(draw(scene).count, 1) == "");
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
