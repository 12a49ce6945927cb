// Where texels lie on the surface, and that lookups read nothing but their own chart's.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "tests/tools/baked_scene.h"
#include "tests/tools/ray_checks.h"
#include "tests/tools/small_scenes.h"
#include "tests/tools/still_life.h"

using namespace crevice;

TEST_CASE("lightmap: points lie on their triangles, off the edges, where the texture coordinates say") {
    const Scene scene = still_life();
    const Baked b = baked(scene, {.texels = 128}, 1);
    const TexelCoverage coverage = texel_coverage(b.charts.texcoords, 128);
    for (std::size_t i = 0; i < b.points.texels.points.size(); ++i) {
        const int x = b.points.texels.pixel[i] % 128, y = b.points.texels.pixel[i] / 128;
        const std::int32_t triangle = coverage.triangle.at(x, y);
        CAPTURE(x);
        CAPTURE(y);
        CHECK((b.map.kind.at(x, y) == TexelKind::centre) == (triangle >= 0));
        if (triangle < 0) continue;
        const SurfacePoint& p = b.points.texels.points[i];
        const auto at = static_cast<std::size_t>(triangle);
        const Corners& c = b.rays.triangles[at];
        const glm::vec3 n = geometric_normal(b.rays, triangle);
        CHECK(p.geometric_normal == n);
        CHECK(std::abs(glm::dot(p.position - c[0], n)) < 2e-6f);
        CHECK(glm::length(p.normal) == doctest::Approx(1).epsilon(1e-5));
        glm::vec2 uv(0);
        for (std::size_t k = 0; k < 3; ++k) {
            const glm::vec3 from = c[(k + 1) % 3], to = c[(k + 2) % 3];
            const float weight = glm::dot(glm::cross(to - from, p.position - from), n) /
                                 glm::dot(glm::cross(to - from, c[k] - from), n);
            CHECK(weight > 0);
            uv += weight * b.charts.texcoords[at][k];
        }
        const glm::vec2 off = 128.0f * uv - glm::vec2(float(x) + 0.5f, float(y) + 0.5f);
        CHECK(glm::length(off) < 0.05f);
    }
}

TEST_CASE("lightmap: a texel's point lies in the texel, also where the triangle only touches it") {
    Mesh mesh = quad_mesh({glm::vec3(0, 0, 0), {5, 1, 2}, {1.5f, 2, 0.5f}, {0, 0, 0}}, {0, 0, -1});
    mesh.triangles = {{0, 1, 2}};
    mesh.parts = {{0, 1, 0}};
    const Baked b = baked(scene_of({mesh}), {.texels = 32}, 1);
    const Corners& c = b.rays.triangles[0];
    const glm::vec3 n = geometric_normal(b.rays, 0);
    CHECK(b.map.count(TexelKind::touched) > 20);
    for (std::size_t i = 0; i < b.points.texels.points.size(); ++i) {
        glm::vec2 uv(0);
        for (std::size_t k = 0; k < 3; ++k) {
            const glm::vec3 from = c[(k + 1) % 3], to = c[(k + 2) % 3];
            uv += glm::dot(glm::cross(to - from, b.points.texels.points[i].position - from), n) /
                  glm::dot(glm::cross(to - from, c[k] - from), n) * b.charts.texcoords[0][k];
        }
        const int pixel = b.points.texels.pixel[i];
        const glm::vec2 in = 32.0f * uv - glm::vec2(float(pixel % 32), float(pixel / 32));
        CAPTURE(pixel);
        CHECK(std::min(in.x, in.y) > -0.03f);
        CHECK(std::max(in.x, in.y) < 1.03f);
    }
}

TEST_CASE("lightmap: lookups inside a triangle read its own chart only, be it ever so thin") {
    std::vector<Mesh> meshes = still_life().meshes;
    RandomNumbers random(5);
    for (int i = 0; i < 40; ++i) {
        const glm::vec3 a = random.in_cube(4), along = random.direction(), across = random.direction();
        Mesh thin = quad_mesh({a, a + 3.0f * along, a + 3.0f * along + 1e-3f * across, a},
                              glm::normalize(glm::cross(along, across)));
        thin.triangles = {{0, 1, 2}};
        thin.parts = {{0, 1, 0}};
        meshes.push_back(thin);
    }
    const Baked b = baked(scene_of(meshes), {.texels = 192}, 1);
    CHECK(b.map.count(TexelKind::touched) > 100);
    // The map of chart numbers, dilated: a lookup that reads texels of one chart only gives its number.
    LightmapAo numbers{Image<float>({192, 192}, 1e6f), b.points.kind};
    for (std::size_t i = 0; i < b.charts.rects.size(); ++i) {
        const PixelRect r = b.charts.rects[i];
        for (int y = r.y0; y < r.y1; ++y) {
            for (int x = r.x0; x < r.x1; ++x) numbers.ao.at(x, y) = float(i);
        }
    }
    numbers = dilated(numbers, 1);
    for (std::size_t t = 0; t < b.charts.texcoords.size(); ++t) {
        const auto& [p, q, r] = b.charts.texcoords[t];
        int wrong = 0;
        for (int i = 0; i < 100; ++i) {
            // Corners and edges too.
            const float u = i == 0 || i == 2 ? 0 : (i == 1 ? 1 : random.between(0, 1));
            const float v = i == 1 || i == 0 ? 0 : (i == 2 ? 1 : random.between(0, 1) * (1 - u));
            const glm::vec2 at = p + u * (q - p) + v * (r - p);
            const glm::ivec2 first(glm::floor(192.0f * at - 0.5f));
            for (int k = 0; k < 4; ++k) {
                const int x = first.x + k % 2, y = first.y + k / 2;
                const bool own = b.map.kind.at(x, y) != TexelKind::empty &&
                                 numbers.ao.at(x, y) == float(b.charts.chart[t]);
                // A texel that the lookup gives no weight beyond rounding does not matter.
                const glm::vec2 away = glm::abs(192.0f * at - 0.5f - glm::vec2(float(x), float(y)));
                wrong += !own && away.x < 0.999f && away.y < 0.999f ? 1 : 0;
            }
        }
        CAPTURE(t);
        CHECK(wrong == 0);
    }
}
