// Places in the map: every triangle in its chart, charts apart, one density, the same on every run.
#include <doctest/doctest.h>

#include <cmath>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "rasterizer/base/error.h"
#include "scenes/builtin_scenes.h"
#include "scenes/shapes.h"
#include "ssao/bakes/lightmap_charts.h"
#include "tests/tools/small_scenes.h"
#include "tests/tools/still_life.h"

using namespace crevice;

namespace {

struct Charted {
    Scene scene;
    RayScene rays;
    LightmapCharts charts;
};
Charted charted(Scene scene, const ChartSettings& settings = {}, const Run& run = {}) {
    RayScene rays = ray_scene(scene, {0, 0, 0}, run);
    LightmapCharts charts = lightmap_charts(scene, rays, settings, run);
    return {std::move(scene), std::move(rays), std::move(charts)};
}

double area_in_texels(const LightmapCharts& charts, std::size_t i) {
    const glm::dvec2 a = charts.texcoords[i][0], b = charts.texcoords[i][1], c = charts.texcoords[i][2];
    return 0.5 * std::abs((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x)) * charts.texels *
           charts.texels;
}
double area_in_scene(const RayScene& rays, std::size_t i) {
    const glm::dvec3 a = rays.triangles[i][0], b = rays.triangles[i][1], c = rays.triangles[i][2];
    return 0.5 * glm::length(glm::cross(b - a, c - a));
}

// Triangles inside their charts' rectangles, one texel off the sides; rectangles in the map, apart.
void check_places(const LightmapCharts& charts) {
    const auto side = static_cast<float>(charts.texels);
    for (std::size_t i = 0; i < charts.texcoords.size(); ++i) {
        const PixelRect& r = charts.rects[static_cast<std::size_t>(charts.chart[i])];
        bool inside = true;
        for (const glm::vec2& at : charts.texcoords[i]) {
            const glm::vec2 texel = side * at;
            inside = inside && texel.x > float(r.x0) + 0.99f && texel.x < float(r.x1) - 0.49f &&
                     texel.y > float(r.y0) + 0.99f && texel.y < float(r.y1) - 0.49f;
        }
        CAPTURE(i);
        CHECK(inside);
    }
    for (std::size_t i = 0; i < charts.rects.size(); ++i) {
        const PixelRect a = charts.rects[i];
        bool apart = true;
        for (std::size_t k = 0; k < i; ++k) {
            const PixelRect b = charts.rects[k];
            const int gap = charts.gutter;
            apart = apart &&
                    (a.x0 >= b.x1 + gap || b.x0 >= a.x1 + gap || a.y0 >= b.y1 + gap || b.y0 >= a.y1 + gap);
        }
        CAPTURE(i);
        CHECK(apart);
        CHECK(common_part(a, {0, 0, charts.texels, charts.texels}) == a);
    }
}

// Each texel centre covered at most once, by a triangle whose chart's rectangle it lies in.
void check_coverage(const LightmapCharts& charts) {
    const TexelCoverage coverage = texel_coverage(charts.texcoords, charts.texels);
    long long covered = 0, twice = 0, outside = 0;
    for (int y = 0; y < charts.texels; ++y) {
        for (int x = 0; x < charts.texels; ++x) {
            const std::int32_t t = coverage.triangle.at(x, y);
            if (t < 0) continue;
            ++covered;
            twice += coverage.times.at(x, y) > 1 ? 1 : 0;
            const PixelRect& r =
                charts.rects[static_cast<std::size_t>(charts.chart[static_cast<std::size_t>(t)])];
            outside += x < r.x0 || x >= r.x1 || y < r.y0 || y >= r.y1 ? 1 : 0;
        }
    }
    CHECK(covered > 0);
    CHECK(twice == 0);
    CHECK(outside == 0);
}

const ChartSettings kOwn = {.texels = 64, .mesh_texcoords = true};

}  // namespace

TEST_CASE("lightmap charts: triangles lie in their charts, charts are apart, no texel is used twice") {
    for (const char* name : {"cornell", "columns", "sphere_on_plane", "noise_wall"}) {
        CAPTURE(name);
        const ChartSettings settings{.texels = 512, .gutter = name[0] == 'c' ? 3 : 2};
        const LightmapCharts charts = charted(find_builtin_scene(name)->make(), settings).charts;
        check_places(charts);
        check_coverage(charts);
        CHECK(charts.note.empty());
    }
}

TEST_CASE("lightmap charts: flat faces have the density that is told, a good part of the map is used") {
    const auto [scene, rays, charts] = charted(cornell_scene(), {.texels = 256});
    CHECK(charts.rects.size() < rays.triangles.size());
    double used = 0;
    for (std::size_t i = 0; i < rays.triangles.size(); ++i) {
        const double texels = area_in_texels(charts, i);
        used += texels;
        CAPTURE(i);
        CHECK(texels ==
              doctest::Approx(area_in_scene(rays, i) * charts.density * charts.density).epsilon(1e-3));
    }
    CHECK(used > 0.5 * 256 * 256);
}

TEST_CASE("lightmap charts: curved faces lose no more than half their texels") {
    const auto [scene, rays, charts] = charted(find_builtin_scene("columns")->make());
    int thin = 0;
    for (std::size_t i = 0; i < rays.triangles.size(); ++i) {
        const double flat = area_in_scene(rays, i) * charts.density * charts.density;
        thin += area_in_texels(charts, i) < 0.49 * flat - 1e-3 ? 1 : 0;
    }
    CHECK(thin == 0);
}

TEST_CASE("lightmap charts: vertices that are split for texture or normals do not split charts") {
    // A cylinder's seam has each vertex twice.
    Mesh tube = cylinder_mesh(1, 1, 2, 64, 2);
    const auto many = charted(scene_of({tube})).charts.rects.size();
    Mesh apart = tube;
    for (auto* of_vertices : {&apart.positions, &apart.normals}) {
        std::vector<glm::vec3> corners;
        for (const auto& triangle : tube.triangles) {
            for (const std::uint32_t v : triangle) corners.push_back((*of_vertices)[v]);
        }
        *of_vertices = corners;
    }
    apart.texcoords.clear();
    for (std::uint32_t i = 0; i < apart.triangles.size(); ++i)
        apart.triangles[i] = {3 * i, 3 * i + 1, 3 * i + 2};
    CHECK(charted(scene_of({apart})).charts.rects.size() == many);
    CHECK(many < 16);
}

TEST_CASE("lightmap charts: each instance has its own, also where instances touch") {
    Scene scene = scene_of({grid_mesh(2, 2, 2, 2)});
    scene.instances.push_back({0, glm::translate(glm::mat4(1), glm::vec3(2, 0, 0))});
    const LightmapCharts charts = charted(scene).charts;
    CHECK(charts.rects.size() == 2);
    check_coverage(charts);
}

TEST_CASE("lightmap charts: the meshes' own coordinates where they can serve") {
    const Mesh quad = facing_quad({0, 0, 2}, 1);
    const auto [scene, rays, charts] = charted(scene_of({quad}), kOwn);
    CHECK(charts.note == "");
    CHECK(charts.density == doctest::Approx(32));
    CHECK(charts.texcoords[0][1] == glm::vec2(1, 0));
    CHECK(charts.rects == std::vector<PixelRect>{{0, 0, 64, 64}});

    Mesh untextured = quad, outside = quad;
    untextured.texcoords.clear();
    outside.texcoords[2].x = 1.5f;
    const auto note_of = [](const Scene& s) {
        const LightmapCharts other = charted(s, kOwn).charts;
        check_places(other);
        check_coverage(other);
        return other.note;
    };
    CHECK(note_of(scene_of({untextured})).find("mesh 0 has none") != std::string::npos);
    CHECK(note_of(scene_of({quad, outside})).find("mesh 1, triangle 0 lies outside") != std::string::npos);
    CHECK(note_of(scene_of({quad, facing_quad({5, 0, 2}, 1)})).find("overlap (4096") != std::string::npos);
    // Not asked for, not used.
    CHECK(charted(scene_of({quad}), {.texels = 64}).charts.texcoords[0][1] != glm::vec2(1, 0));
}

TEST_CASE("lightmap charts: the same whatever the threads, and in other units") {
    const auto first = charted(still_life(), {.texels = 128}).charts;
    for (const int threads : {1, 2, 7}) {
        Run run;
        run.threads = threads;
        CAPTURE(threads);
        CHECK(charted(still_life(), {.texels = 128}, run).charts.texcoords == first.texcoords);
    }
    for (const int k : {-20, 20}) {
        const auto other = charted(scaled(still_life(), k), {.texels = 128}).charts;
        CAPTURE(k);
        CHECK(other.texcoords == first.texcoords);
        CHECK(other.density == std::ldexp(first.density, -k));
    }
}

TEST_CASE("lightmap charts: what has no area has no place, and nothing is nothing") {
    Mesh mesh = facing_quad({0, 0, 2}, 1);
    mesh.triangles.push_back({0, 1, 1});
    mesh.parts[0].triangle_count = 3;
    CHECK(charted(scene_of({mesh})).charts.texcoords.size() == 2);
    const LightmapCharts none = charted(empty_scene()).charts;
    CHECK(none.texcoords.empty());
    CHECK(none.rects.empty());
}

TEST_CASE("lightmap charts: bad settings and a map that is too small are named") {
    const auto message = [](const Scene& scene, const ChartSettings& settings) -> std::string {
        try {
            charted(scene, settings);
        } catch (const UsageError& error) {
            return error.what();
        }
        return "";
    };
    CHECK(message(still_life(), {.texels = 15}).find("texels: must lie in 16..4096 (15)") !=
          std::string::npos);
    CHECK(message(still_life(), {.texels = 4097}).find("(4097)") != std::string::npos);
    CHECK(message(still_life(), {.gutter = 1}).find("gutter: must lie in 2..64 (1)") != std::string::npos);
    CHECK(message(still_life(), {.gutter = 65}).find("(65)") != std::string::npos);
    CHECK(message(columns_scene(), {.texels = 16}).find("charts do not fit (16 texels a side)") !=
          std::string::npos);
}
