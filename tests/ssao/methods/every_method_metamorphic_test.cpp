// What every row of the table of methods must hold when the same thing is drawn in another way: elsewhere, in another order,
// mirrored, cut out, cut up, again. No reference is needed: the map is compared with the method's own.
// Lanes, instruction sets, threads, tiles and kept work: every_method_test.cpp; scales: every_method_extremes_test.cpp.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <doctest/doctest.h>

#include "ssao/judge/percentile.h"
#include "ssao/judge/reference_image.h"
#include "ssao/rays/ray_cast_map.h"
#include "tests/tools/image_checks.h"
#include "tests/tools/method_maps.h"
#include "tests/tools/random_sequence.h"
#include "tests/tools/small_scenes.h"
#include "tests/tools/special_floats.h"
#include "tests/tools/still_life.h"

using namespace crevice;

namespace {

// The still life with its vertices on a grid that floats keep when it is moved by 2^18.
Scene still_life_on_grid() {
    Scene scene = still_life();
    for (Mesh& mesh : scene.meshes) {
        for (glm::vec3& p : mesh.positions) p = glm::round(16.0f * p) / 16.0f;
    }
    return scene;
}

// Each triangle as four, by the middles of its edges, which floats hold here. Normals must not vary over a triangle.
Mesh cut_up(const Mesh& mesh) {
    Mesh result = mesh;
    result.texcoords.clear();
    result.triangles.clear();
    const auto middle = [&](std::uint32_t a, std::uint32_t b) {
        result.positions.push_back(0.5f * (mesh.positions[a] + mesh.positions[b]));
        result.normals.push_back(mesh.normals[a]);
        return static_cast<std::uint32_t>(result.positions.size() - 1);
    };
    for (const auto& [a, b, c] : mesh.triangles) {
        const std::uint32_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
        for (const auto& t : {std::array{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}})
            result.triangles.push_back(t);
    }
    result.parts = {{0, static_cast<std::uint32_t>(result.triangles.size()), 0}};
    return result;
}

void shuffle(Mesh& mesh, RandomSequence& random) {
    for (int i = static_cast<int>(mesh.triangles.size()) - 1; i > 0; --i)
        std::swap(mesh.triangles[static_cast<std::size_t>(i)],
                  mesh.triangles[static_cast<std::size_t>(random.whole(0, i))]);
}

Scene mirrored(Scene scene) {
    for (Mesh& mesh : scene.meshes) {
        for (glm::vec3& p : mesh.positions) p.x = -p.x;
        for (glm::vec3& n : mesh.normals) n.x = -n.x;
        for (auto& t : mesh.triangles) std::swap(t[1], t[2]);
    }
    scene.camera.eye.x = -scene.camera.eye.x;
    scene.camera.target.x = -scene.camera.target.x;
    return scene;
}

// The share of the texels that hold(x, y) is false for.
template <class Holds>
double share_against(Size size, const Holds& holds) {
    double count = 0;
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) count += holds(x, y) ? 0 : 1;
    }
    return count / (static_cast<double>(size.width) * size.height);
}

double mean_of(const Image<float>& image) {
    double sum = 0;
    for (int y = 0; y < image.size.height; ++y) {
        for (int x = 0; x < image.size.width; ++x) sum += static_cast<double>(image.at(x, y));
    }
    return sum / (static_cast<double>(image.size.width) * image.size.height);
}

}  // namespace

TEST_CASE("every method: scene and camera moved together by 2^18 leave the same bits") {
    const Scene here = still_life_on_grid();
    Scene there = here;
    const glm::dvec3 far_away(0x1p18, -0x1p18, 0x1p18);
    for (Mesh& mesh : there.meshes) {
        for (glm::vec3& p : mesh.positions) p += glm::vec3(far_away);
    }
    there.camera.eye += far_away;
    there.camera.target += far_away;
    for (const Method* method : computing_methods()) {
        CAPTURE(std::string(method->name));
        CHECK(hashes(maps_of(*method, there)) == hashes(maps_of(*method, here)));
    }
}

TEST_CASE("every method: triangles in another order, or each sent twice, leave the same bits") {
    const Scene scene = still_life();
    Scene shuffled = scene, twice = scene;
    RandomSequence random(7);
    for (Mesh& mesh : shuffled.meshes) shuffle(mesh, random);
    for (Mesh& mesh : twice.meshes) {
        const auto once = mesh.triangles;
        mesh.triangles.insert(mesh.triangles.end(), once.begin(), once.end());
        mesh.parts = {{0, static_cast<std::uint32_t>(mesh.triangles.size()), 0}};
    }
    for (const Method* method : computing_methods()) {
        CAPTURE(std::string(method->name));
        const Maps expected = maps_of(*method, scene);
        for (const Scene* other : {&shuffled, &twice}) {
            const Maps maps = maps_of(*method, *other);
            // A vertex shares its rays out to its triangles, in their order: in another order, or with more of them, they
            // are other rays.
            if (method->bake)
                CHECK(std::fabs(mean_of(maps.raw.ao) - mean_of(expected.raw.ao)) < 0.005);
            else
                CHECK(hashes(maps) == hashes(expected));
        }
    }
}

TEST_CASE("every method: mirrored scene and camera show the mirrored surfaces, as open on the average") {
    const Scene scene = still_life(), other = mirrored(scene);
    const Size size = {64, 48};
    const GBuffer g = normal_depth(scene, scene.camera, size), h = normal_depth(other, other.camera, size);
    const auto opposite = [&](int x) { return size.width - 1 - x; };
    // Top and left edges become top and right ones: a pixel whose centre lies on an edge changes its side.
    CHECK(share_against(size, [&](int x, int y) {
              const float here = g.view_depth.at(x, y), there = h.view_depth.at(opposite(x), y);
              return here == there || std::fabs(here - there) < 1e-5f * here;
          }) < 0.01);
    for (const Method* method : computing_methods()) {
        CAPTURE(std::string(method->name));
        const RayScene rays = ray_scene(scene, scene.camera.eye),
                       of_other = ray_scene(other, other.camera.eye);
        const MethodSettings settings = full_size(*method);
        const auto limit = [&](const Scene& of, const GBuffer& seen, const RayScene& cast) {
            return method->limit({of, of.camera, seen, &cast}, settings.ao, 16, {}, {});
        };
        // The noise of a texel is not mirrored with it: that of 16 seeds is left.
        const ReferenceImage here = limit(scene, g, rays), there = limit(other, h, of_other);
        CHECK(std::fabs(mean_of(here.mean) - mean_of(there.mean)) < 0.002);
    }
}

TEST_CASE("every method: triangles cut into four by the middles of their edges change next to nothing") {
    Scene whole = still_life_on_grid();
    whole.meshes.pop_back();  // the sphere, whose normals vary
    whole.instances.pop_back();
    Scene pieces = whole;
    for (Mesh& mesh : pieces.meshes) mesh = cut_up(mesh);
    // The middles are snapped to the screen's grid, which bends edges by up to 1/512 pixel: a pixel whose centre lies on one
    // may change sides.
    const GBuffer g = normal_depth(whole, whole.camera, kMethodMaps),
                  h = normal_depth(pieces, pieces.camera, kMethodMaps);
    const double changed = share_against(kMethodMaps, [&](int x, int y) {
        const float a = g.view_depth.at(x, y), b = h.view_depth.at(x, y);
        return a == b || std::fabs(a - b) < 1e-5f * a;
    });
    CHECK(changed * kMethodMaps.width * kMethodMaps.height <= 3);
    for (const Method* method : computing_methods()) {
        CAPTURE(std::string(method->name));
        const Image<float> a = maps_of(*method, whole).raw.ao, b = maps_of(*method, pieces).raw.ao;
        // A bake has new vertices, and is finer between the old ones.
        CHECK(std::fabs(mean_of(a) - mean_of(b)) < (method->bake ? 0.05 : 0.002));
        if (method->bake) continue;
        // The texels around such a pixel.
        CHECK(share_against(a.size,
                            [&](int x, int y) { return std::fabs(a.at(x, y) - b.at(x, y)) < 1e-4f; }) < 0.02);
    }
}

TEST_CASE("every method: a part of a picture is what it is drawn by itself, beyond the reach of the border") {
    // From above, orthographic, 16 pixels a unit. The part is the lower right quarter: it begins at a multiple of the side of
    // every method's pattern.
    constexpr int kSide = 128, kPart = 64;
    Scene scene = still_life_on_grid();
    scene.camera.projection = Projection::orthographic;
    scene.camera.up = {0, 0, 1};
    scene.camera.eye = {-2, 4, 6};
    scene.camera.target = {-2, 0, 6};
    scene.camera.ortho_height = 8;
    Scene part = scene;
    part.camera.ortho_height = 4;
    part.camera.eye += glm::dvec3(2, 0, -2);
    part.camera.target += glm::dvec3(2, 0, -2);
    const GBuffer g = normal_depth(scene, scene.camera, {kSide, kSide}),
                  h = normal_depth(part, part.camera, {kPart, kPart});
    CHECK(pixels_against({kPart, kPart}, [&](int x, int y) {
              return h.view_depth.at(x, y) == g.view_depth.at(x + kPart, y + kPart) &&
                     h.normal.at(x, y) == g.normal.at(x + kPart, y + kPart);
          }) == "");
    for (const Method* method : computing_methods()) {
        CAPTURE(std::string(method->name));
        MethodSettings settings = with_value(*method, full_size(*method), "radius", 0.5);
        // The tutorials lay their random vectors over the whole picture, however large it is: none.
        settings = with_value(*method, settings, "random_vectors", 2);
        settings = with_value(*method, settings, "bias", 0);  // so that enough is dark
        const Maps all = maps_of(*method, scene, {kSide, kSide}, settings),
                   cut = maps_of(*method, part, {kPart, kPart}, settings);
        const int border = static_cast<int>(std::ceil(method->reach_px(cut.raw.inputs, settings.ao, 1)));
        std::vector<double> off;
        double shift = 0;
        int darker = 0;
        for (int y = border; y < kPart - border; ++y) {
            for (int x = border; x < kPart - border; ++x) {
                const float a = all.raw.ao.at(x + kPart, y + kPart), b = cut.raw.ao.at(x, y);
                off.push_back(std::fabs(a - b));
                shift += static_cast<double>(a) - static_cast<double>(b);
                darker += a < 1 ? 1 : 0;
            }
        }
        REQUIRE(off.size() > 1000);
        CHECK(darker > 20);
        if (value_of(*method, settings, "pattern") == static_cast<double>(RayPattern::independent)) {
            // A texel's rays follow from its number in the map: they are other rays.
            CHECK(std::fabs(shift) < 0.01 * static_cast<double>(off.size()));
            continue;
        }
        // The tutorials' samples are points that are projected from where their texel is, and depths are mixed there.
        const bool projects = value_of(*method, settings, "random_vectors").has_value();
        CHECK(percentile(off, 100) <= (projects ? 1e-5 : 0));
    }
}

TEST_CASE("every method: a hundred renders are one, other scenes and sizes between them") {
    const Scene scene = still_life(), other = mirrored(scene);
    const Size size = {16, 12};
    for (const Method* method : computing_methods()) {
        CAPTURE(std::string(method->name));
        const std::string first = hashes(maps_of(*method, scene, size));
        int unlike = 0;
        for (int i = 0; i < 100; ++i) {
            if (i % 25 == 0) maps_of(*method, other, {41, 9});
            unlike += hashes(maps_of(*method, scene, size)) != first;
        }
        CHECK(unlike == 0);
    }
}
