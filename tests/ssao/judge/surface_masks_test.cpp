#include "ssao/judge/surface_masks.h"

#include <array>
#include <cmath>
#include <string>

#include <doctest/doctest.h>

#include "rasterizer/lanes/approx_math.h"
#include "scenes/builtin_scenes.h"
#include "scenes/shapes.h"
#include "tests/tools/ao_cases.h"
#include "tests/tools/image_checks.h"
#include "tests/tools/small_scenes.h"
#include "tests/tools/special_floats.h"
#include "tests/tools/still_life.h"

using namespace crevice;

namespace {

// How many pixels are of each kind, in the order of SurfaceKind.
std::array<int, 4> counts(const Image<SurfaceKind>& kinds) {
    std::array<int, 4> count{};
    for (int y = 0; y < kinds.size.height; ++y)
        for (int x = 0; x < kinds.size.width; ++x) ++count[static_cast<std::size_t>(kinds.at(x, y))];
    return count;
}

std::string other_kinds_than(const Image<SurfaceKind>& kinds, SurfaceKind kind) {
    return pixels_against(kinds.size, [&](int x, int y) { return kinds.at(x, y) == kind; });
}

Image<SurfaceKind> kinds_of(const Scene& scene, const Camera& camera, Size size) {
    return surface_kinds(normal_depth(scene, camera, size), camera);
}

// A G-buffer made by hand: view depth z_at(x, y), normals to the eye.
template <class DepthAt>
GBuffer handmade(Size size, DepthAt z_at) {
    GBuffer g{Image3(size, {0, 0, -1}), Image<float>(size, 0.0f),
              cleared_depth(size, DepthFormat::d32f, false)};
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) g.view_depth.at(x, y) = z_at(x, y);
    return g;
}

// One scene unit a pixel.
Camera orthographic(Size size) {
    Camera camera;
    camera.projection = Projection::orthographic;
    camera.ortho_height = size.height;
    return camera;
}

constexpr SurfaceKind kSky = SurfaceKind::sky, kEdge = SurfaceKind::edge, kCrease = SurfaceKind::crease,
                      kFlat = SurfaceKind::flat;

}  // namespace

TEST_CASE("surface kinds: a step marks three pixels on either side, in rows and columns") {
    const Size size{24, 20};
    for (const bool sideways : {true, false}) {
        CAPTURE(sideways);
        const auto near_z = [=](int x, int y) { return (sideways ? x : y) < 10; };
        const GBuffer g = handmade(size, [&](int x, int y) { return near_z(x, y) ? 10.0f : 15.0f; });
        const Image<SurfaceKind> kinds = surface_kinds(g, orthographic(size));
        CHECK(pixels_against(size, [&](int x, int y) {
                  const int at = sideways ? x : y;
                  return kinds.at(x, y) == (at >= 7 && at <= 12 ? kEdge : kFlat);
              }) == "");
    }
}

TEST_CASE("surface kinds: a gap is a step when it is wider than four pixels") {
    const Size size{24, 20};
    const auto kinds = [&](float gap) {
        return surface_kinds(handmade(size, [=](int x, int) { return x < 10 ? 20.0f : 20 + gap; }),
                             orthographic(size));
    };
    CHECK(other_kinds_than(kinds(3.99f), kFlat) == "");
    CHECK(kinds(4.01f).at(9, 5) == kEdge);
    CHECK(kinds(-4.01f).at(9, 5) == kEdge);
}

TEST_CASE("surface kinds: in perspective a pixel is as wide as it is at the nearer surface") {
    const Size size{24, 20};
    Camera camera;
    camera.fov_y_rad = radians(60);
    const float threshold = 4 * 10 * 2 * std::tan(static_cast<float>(radians(30))) / 20;  // 2.31 at depth 10
    const auto middle = [&](float left, float right) {
        return surface_kinds(handmade(size, [=](int x, int) { return x < 10 ? left : right; }), camera)
            .at(10, 5);
    };
    for (const float share : {0.99f, 1.01f}) {
        CAPTURE(share);
        const SurfaceKind expected = share > 1 ? kEdge : kFlat;
        CHECK(middle(10, 10 + share * threshold) == expected);
        CHECK(middle(10 + share * threshold, 10) == expected);
    }
}

TEST_CASE("surface kinds: slopes, however steep, have no step; where they meet neither") {
    const Size size{24, 20};
    const auto kinds = [&](auto z_at) {
        return surface_kinds(
            handmade(size, [&](int x, int y) { return z_at(static_cast<float>(x), static_cast<float>(y)); }),
            orthographic(size));
    };
    CHECK(other_kinds_than(kinds([](float x, float y) { return 900 - 30.0f * x + 7.0f * y; }), kFlat) == "");
    // A grazing floor up to a wall; a ridge.
    CHECK(other_kinds_than(kinds([](float x, float) { return x < 12 ? 100 + 25.0f * x : 388.0f; }), kFlat) ==
          "");
    CHECK(other_kinds_than(kinds([](float x, float) { return 300 + 25.0f * std::fabs(x - 12); }), kFlat) ==
          "");
    // The same wall 30 further away.
    CHECK(kinds([](float x, float) { return x < 12 ? 100 + 25.0f * x : 418.0f; }).at(11, 3) == kEdge);
    // A pole one pixel wide.
    CHECK(kinds([](float x, float) { return x == 12 ? 100.0f : 110.0f; }).at(12, 3) == kEdge);
}

TEST_CASE("surface kinds: a fold without a step is a crease, one with a step an edge") {
    const Size size{24, 20};
    GBuffer g = handmade(size, [](int, int) { return 10.0f; });
    const auto turn_right_half = [&](float radians_to_left) {
        const auto turned = sine_cosine(radians_to_left);
        for (int y = 0; y < size.height; ++y)
            for (int x = 12; x < size.width; ++x)
                g.normal.set(x, y, {static_cast<float>(turned.sine), 0, -static_cast<float>(turned.cosine)});
        return surface_kinds(g, orthographic(size));
    };
    CHECK(other_kinds_than(turn_right_half(0.25f), kFlat) == "");  // 14.3 degrees
    const Image<SurfaceKind> kinds = turn_right_half(0.27f);       // 15.5 degrees
    CHECK(pixels_against(size, [&](int x, int y) {
              return kinds.at(x, y) == (x >= 9 && x <= 14 ? kCrease : kFlat);
          }) == "");
    for (int y = 0; y < size.height; ++y)
        for (int x = 12; x < size.width; ++x) g.view_depth.at(x, y) = 20;
    CHECK(surface_kinds(g, orthographic(size)).at(12, 4) == kEdge);
    // A normal that is not known is no fold.
    GBuffer unknown = handmade(size, [](int, int) { return 10.0f; });
    unknown.normal.set(12, 8, {0, 0, 0});
    CHECK(other_kinds_than(surface_kinds(unknown, orthographic(size)), kFlat) == "");
}

TEST_CASE("surface kinds: sky stays sky, and its outline is an edge") {
    const Size size{24, 20};
    const GBuffer g = handmade(size, [](int x, int) { return x < 10 ? 10.0f : kInfinity; });
    const Image<SurfaceKind> kinds = surface_kinds(g, orthographic(size));
    CHECK(pixels_against(size, [&](int x, int y) {
              return kinds.at(x, y) == (x >= 10 ? kSky : x >= 7 ? kEdge : kFlat);
          }) == "");
    CHECK(other_kinds_than(
              surface_kinds(handmade(size, [](int, int) { return kInfinity; }), orthographic(size)), kSky) ==
          "");
    CHECK(other_kinds_than(
              surface_kinds(handmade({1, 1}, [](int, int) { return 5.0f; }), orthographic({1, 1})), kFlat) ==
          "");
}

TEST_CASE("surface kinds: a floor up to the horizon is flat, in perspective too") {
    Scene scene = scene_of({quad_mesh(
        {glm::vec3(-4e4f, -1, 4e4f), {4e4f, -1, 4e4f}, {4e4f, -1, 0.01f}, {-4e4f, -1, 0.01f}}, {0, 1, 0})});
    scene.two_sided = true;
    scene.camera.near_plane = 0.5;
    scene.camera.far_plane = 1e5;
    const Size size{64, 96};
    const Image<SurfaceKind> kinds = kinds_of(scene, scene.camera, size);
    // Row 48 is the first below the horizon; its outline against the sky takes three rows.
    CHECK(pixels_against(size, [&](int x, int y) {
              return kinds.at(x, y) == (y < 48 ? kSky : y < 51 ? kEdge : kFlat);
          }) == "");
}

TEST_CASE("surface kinds: smoothly curved surfaces are flat inside") {
    Scene scene = scene_of({sphere_mesh(1, 128, 96)});
    for (glm::vec3& p : scene.meshes[0].positions) p.z += 4;
    const Size size{96, 96};
    const Image<SurfaceKind> kinds = kinds_of(scene, scene.camera, size);
    const std::array<int, 4> count = counts(kinds);
    CHECK(kinds.at(48, 48) == kFlat);
    CHECK(count[2] == 0);  // no creases
    CHECK(count[1] > 0);   // the outline
    CHECK(count[3] > 2 * count[1]);
}

TEST_CASE("surface kinds of the still life: each where it belongs") {
    const Scene scene = still_life();
    const Size size{128, 96};
    const Image<SurfaceKind> kinds = kinds_of(scene, scene.camera, size);
    const ViewRays rays = {camera_matrices(scene.camera, size).ray_scale, size, true};
    const auto kind_at = [&](glm::vec3 p) {
        const Screen2<float> at = rays.p_screen<float>({p.x, p.y, p.z}, 1 / p.z);
        CAPTURE(at.x);
        CAPTURE(at.y);
        return kinds.at(static_cast<int>(at.x), static_cast<int>(at.y));
    };
    CHECK(kind_at({2, 2, 6}) == kSky);
    CHECK(kind_at({-3, 1, 6}) == kFlat);        // the wall
    CHECK(kind_at({-3, -1, 6}) == kCrease);     // where it meets the floor
    CHECK(kind_at({-0.1f, 1, 6}) == kEdge);     // its end before the sky
    CHECK(kind_at({0, -1, 3}) == kFlat);        // the floor
    CHECK(kind_at({-0.5f, 0, 3.5f}) == kEdge);  // a corner of the box before the wall
    CHECK(kind_at({-1, -1, 3.5f}) == kCrease);  // the box on the floor
}

TEST_CASE("regions: disjoint kinds that cover the picture, whatever it shows") {
    const Size size{61, 47};
    for (const float sky_share : {0.0f, 0.3f, 1.0f}) {
        CAPTURE(sky_share);
        const GBuffer g = made_up_gbuffer(size, sky_share);
        const Image<SurfaceKind> kinds = surface_kinds(g, made_up_camera());
        const auto mask = [&](Region region) { return region_mask(kinds, region); };
        const Image<std::uint8_t> all = mask(Region::all), surface = mask(Region::surface),
                                  edge = mask(Region::edge), crease = mask(Region::crease),
                                  flat = mask(Region::flat);
        CHECK(pixels_against(size, [&](int x, int y) {
                  const bool seen = g.view_depth.at(x, y) < kInfinity;
                  return all.at(x, y) == 1 && surface.at(x, y) == seen &&
                         edge.at(x, y) + crease.at(x, y) + flat.at(x, y) == seen;
              }) == "");
    }
}

TEST_CASE("surface kinds do not depend on the unit of length") {
    const Size size{96, 64};
    const Scene scene = still_life();
    const Image<SurfaceKind> kinds = kinds_of(scene, scene.camera, size);
    for (const int k : {-12, 12}) {
        CAPTURE(k);
        const Scene other = scaled(scene, k);
        const Image<SurfaceKind> found = kinds_of(other, other.camera, size);
        CHECK(pixels_against(size, [&](int x, int y) { return found.at(x, y) == kinds.at(x, y); }) == "");
    }
}

TEST_CASE("every built-in scene has flat surface, and edges where it has sky") {
    for (const BuiltinScene& builtin : builtin_scenes()) {
        CAPTURE(builtin.name);
        const Scene scene = builtin.make();
        const std::array<int, 4> count = counts(kinds_of(scene, scene.camera, {160, 90}));
        const int surface = count[1] + count[2] + count[3];
        if (surface == 0) continue;
        // In a picture this small the stones of the field are mostly outline, and the atrium is mostly carving.
        const std::string name = builtin.name;
        CHECK(count[3] > surface / (name == "field" ? 12 : name == "atrium" ? 16 : 4));
        if (count[0] > 0) CHECK(count[1] > 0);
    }
}
