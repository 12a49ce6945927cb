// A smooth surface wound the wrong way round, without normals of its own: loaded from an OBJ it has two sides, so
// the picture is that of the surface wound the right way.
#include <cmath>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include "chapters/frame/frame.h"
#include "ssao/rays/ray_cast_ao.h"
#include "tests/tools/image_checks.h"
#include "tests/tools/loaded_obj.h"
#include "tests/tools/tutorial_settings.h"

using namespace crevice;

namespace {

constexpr Size kSize{161, 91};
constexpr double kRing = 2, kTube = 0.8;  // radii, scene units

// A torus about the y axis, `around` times `across` quads of two triangles, as an OBJ without `vn`.
LoadedObj loaded_torus(int around, int across, bool reversed) {
    std::string text;
    const auto add = [&](const char* keyword, auto a, auto b, auto c) {
        text += std::string(keyword) + " " + std::to_string(a) + " " + std::to_string(b) + " " +
                std::to_string(c) + "\n";
    };
    const auto number = [&](int i, int j) { return 1 + i % around * across + j % across; };
    for (int i = 0; i < around; ++i) {
        for (int j = 0; j < across; ++j) {
            const double a = 2 * kPi * i / around, b = 2 * kPi * j / across;
            const double from_axis = kRing + kTube * std::cos(b);
            add("v", from_axis * std::cos(a), kTube * std::sin(b), -from_axis * std::sin(a));
        }
    }
    const auto add_face = [&](int a, int b, int c) {
        if (reversed) std::swap(b, c);
        add("f", a, b, c);
    };
    for (int i = 0; i < around; ++i) {
        for (int j = 0; j < across; ++j) {
            add_face(number(i, j), number(i + 1, j), number(i + 1, j + 1));
            add_face(number(i, j), number(i + 1, j + 1), number(i, j + 1));
        }
    }
    return load_text(text);
}

// The normal that mathematics states, not of unit length.
glm::dvec3 torus_normal(const glm::dvec3& p) {
    const double from_axis = std::hypot(p.x, p.z);
    return {p.x - kRing * p.x / from_axis, p.y, p.z - kRing * p.z / from_axis};
}

std::string apart(const Image<float>& a, const Image<float>& b) { return further_apart_than(0, a, b); }
std::string apart(const Image3& a, const Image3& b) {
    return apart(a.x, b.x) + apart(a.y, b.y) + apart(a.z, b.z);
}

}  // namespace

TEST_CASE("reversed winding: every buffer of a smooth torus is that of the torus wound the right way") {
    for (const int around : {12, 64}) {
        const LoadedObj right = loaded_torus(around, 16, false), reversed = loaded_torus(around, 16, true);
        CHECK(
            reversed.report.warnings.empty());  // the winding is the author's word on which side is the front
        for (const char* method : {"xjun", "luna", "gtao"}) {
            CAPTURE(around);
            CAPTURE(std::string(method));
            FrameRequest request;
            request.size = kSize;
            request.method = &find_method(method);
            request.settings = settings_of(*request.method, {});
            const Frame expected = render_frame(right.scene, right.scene.camera, request);
            const Frame found = render_frame(reversed.scene, right.scene.camera, request);
            CHECK(apart(found.gbuffer.view_depth, expected.gbuffer.view_depth) == "");
            CHECK(apart(found.gbuffer.normal, expected.gbuffer.normal) == "");
            CHECK(apart(found.ao_raw, expected.ao_raw) == "");
            CHECK(apart(found.ao_blurred, expected.ao_blurred) == "");
            CHECK(apart(found.lit, expected.lit) == "");
        }
    }
}

TEST_CASE("reversed winding: normals are a torus's own, outward, up to its rims, and rays see the same") {
    const LoadedObj right = loaded_torus(64, 48, false);
    std::vector<float> expected;
    for (const bool reversed : {false, true}) {
        CAPTURE(reversed);
        const LoadedObj torus = loaded_torus(64, 48, reversed);
        const Camera& camera = right.scene.camera;
        const SurfacePoints seen =
            surface_points(torus.scene, camera, normal_depth(torus.scene, camera, kSize));
        REQUIRE(seen.points.size() > 1000);
        for (std::size_t i = 0; i < seen.points.size(); ++i) {
            const SurfacePoint& p = seen.points[i];
            CAPTURE(seen.pixel[i] % kSize.width);
            CAPTURE(seen.pixel[i] / kSize.width);
            const glm::dvec3 truth = glm::normalize(torus_normal(camera.eye + glm::dvec3(p.position)));
            CHECK(glm::dot(glm::dvec3(p.normal), truth) > 0.99);
            CHECK(glm::dot(glm::dvec3(p.geometric_normal), truth) > 0.9);
        }
        const std::vector<float> open =
            ray_cast_ao(ray_scene(torus.scene, camera.eye), seen.points, {.rays = 64, .radius = 1});
        if (!reversed) expected = open;
        CHECK(open == expected);
    }
}
