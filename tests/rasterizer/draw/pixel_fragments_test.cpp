// The raster of one pixel: what is told of every triangle is what the drawing did.
#include "rasterizer/draw/pixel_fragments.h"

#include <algorithm>
#include <string>

#include <doctest/doctest.h>

#include "tests/tools/random_sequence.h"
#include "tests/tools/small_scenes.h"

using namespace crevice;

namespace {

constexpr Size kSize{24, 18};

struct Drawn {
    Scene scene;
    NormalDepthSettings settings;
    ScreenGeometry geometry;
    GBuffer gbuffer;

    explicit Drawn(Scene shown, NormalDepthSettings with = {}, Size size = kSize)
        : scene(std::move(shown)), settings(with) {
        geometry = screen_geometry(scene, scene.camera, size, geometry_settings(settings));
        gbuffer = normal_depth(scene, geometry, scene.camera.reversed_z, settings);
    }
    PixelFragments at(int x, int y) const {
        return pixel_fragments(scene, scene.camera, geometry, settings, x, y);
    }
};

std::size_t count(const PixelFragments& at, FragmentVerdict verdict) {
    return static_cast<std::size_t>(
        std::count_if(at.fragments.begin(), at.fragments.end(),
                      [&](const PixelFragment& f) { return f.verdict == verdict; }));
}

// Squares that face the eye and fill the picture, each at its depth; the last one perhaps from behind.
Scene squares(const std::vector<float>& depths, bool last_faces_away = false) {
    std::vector<Mesh> meshes;
    for (const float z : depths) meshes.push_back(facing_quad({0, 0, z}, z));
    if (last_faces_away) {
        for (auto& triangle : meshes.back().triangles) std::swap(triangle[1], triangle[2]);
    }
    return scene_of(std::move(meshes));
}

// Triangles strewn before the eye, front faces and back faces.
Scene heap(std::uint64_t seed) {
    RandomSequence random(seed);
    Mesh mesh;
    for (std::uint32_t i = 0; i < 120; ++i) {
        const glm::vec3 centre(random.between(-3, 3), random.between(-2, 2), random.between(2, 9));
        for (int corner = 0; corner < 3; ++corner) {
            const glm::vec3 away(random.between(-2, 2), random.between(-2, 2), random.between(-1, 1));
            mesh.positions.push_back(centre + away);
            mesh.normals.emplace_back(0, 0, -1);
        }
        mesh.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
    }
    mesh.parts = {{0, 120, 0}};
    return scene_of({mesh});
}

}  // namespace

TEST_CASE(
    "pixel fragments: the code that is left and the triangle that is seen are the drawing's, at every "
    "pixel") {
    for (const DepthFormat format : {DepthFormat::d16, DepthFormat::d24, DepthFormat::d32f}) {
        for (const bool reversed : {false, true}) {
            for (const bool two_sided : {false, true}) {
                Scene scene = heap(7);
                scene.camera.reversed_z = reversed;
                scene.two_sided = two_sided;
                const Drawn drawn(scene, {.depth_format = format, .depth_bias = {2, 0.5f}});
                std::size_t kept = 0, facing_away = 0, covered = 0;
                for (int y = 0; y < kSize.height; ++y) {
                    for (int x = 0; x < kSize.width; ++x) {
                        const PixelFragments at = drawn.at(x, y);
                        CAPTURE(x);
                        CAPTURE(y);
                        REQUIRE(at.code == drawn.gbuffer.depth.codes.at(x, y));
                        REQUIRE(at.shown == drawn.gbuffer.triangle.at(x, y));
                        REQUIRE(count(at, FragmentVerdict::kept) == (at.shown == kNoTriangle ? 0 : 1));
                        kept += count(at, FragmentVerdict::kept);
                        covered += count(at, FragmentVerdict::behind) + count(at, FragmentVerdict::hidden);
                        facing_away += count(at, FragmentVerdict::facing_away);
                    }
                }
                CHECK(kept > 100);
                CHECK(covered > 20);
                CHECK((facing_away > 20) == !two_sided);
            }
        }
    }
}

TEST_CASE("pixel fragments: in their order, each with the code that it met") {
    const PixelFragments at = Drawn(squares({5, 3, 4, 3})).at(5, 9);
    REQUIRE(at.fragments.size() == 4);
    const FragmentVerdict expected[] = {FragmentVerdict::drawn_over, FragmentVerdict::kept,
                                        FragmentVerdict::behind, FragmentVerdict::equal};
    for (std::size_t i = 0; i < 4; ++i) {
        CAPTURE(i);
        CHECK(at.fragments[i].verdict == expected[i]);
        CHECK(at.fragments[i].triangle.instance == i);
    }
    CHECK(at.fragments[0].stored == at.cleared);
    CHECK(at.fragments[1].stored == at.fragments[0].code);
    CHECK(at.fragments[2].stored == at.fragments[1].code);
    CHECK(at.fragments[3].stored == at.fragments[3].code);
    CHECK(at.code == at.fragments[1].code);
}

TEST_CASE("pixel fragments: a back face is told of where it is culled, and drawn where it is not") {
    Scene scene = squares({5, 3}, true);
    const PixelFragments culled = Drawn(scene).at(5, 9);
    REQUIRE(culled.fragments.size() == 2);
    CHECK(culled.fragments[0].verdict == FragmentVerdict::kept);
    CHECK(culled.fragments[1].verdict == FragmentVerdict::facing_away);
    CHECK(culled.fragments[1].number == kNoTriangle);
    scene.two_sided = true;
    CHECK(Drawn(scene).at(5, 9).fragments[1].verdict == FragmentVerdict::kept);
}

TEST_CASE(
    "pixel fragments: of a centre on an edge that two triangles share one has it, the other says which "
    "edge") {
    // The diagonal of a square around the middle of the picture goes through pixel centres.
    const Drawn drawn(squares({4}), {}, {15, 15});
    int on_edge = 0;
    for (int i = 1; i < 14; ++i) {
        const PixelFragments at = drawn.at(i, i);
        for (const PixelFragment& f : at.fragments) {
            const bool outside = f.verdict == FragmentVerdict::outside;
            CHECK(outside == (f.outside_edge >= 0));
            if (!outside) continue;
            const auto edge = static_cast<std::size_t>(f.outside_edge);
            if (f.edge[edge] != 0) continue;
            ++on_edge;
            CHECK(!f.top_or_left[edge]);
        }
        CHECK(count(at, FragmentVerdict::kept) <= 1);
    }
    CHECK(on_edge > 3);
}

TEST_CASE(
    "pixel fragments: one that reaches into the square without its centre is told of, one beside it is not") {
    // 1/8 pixel of the next column, on either side of the middle of the picture.
    Scene scene = scene_of({facing_quad({0, 0, 4}, 1)});
    scene.camera.projection = Projection::orthographic;
    scene.camera.ortho_height = 16;
    scene.instances[0].world_from_object[3][0] = 0.125f;
    const Drawn drawn(scene, {}, {16, 16});
    const auto fragments = [&](int x) { return drawn.at(x, 7).fragments; };
    CHECK(fragments(6).empty());
    CHECK(count(drawn.at(7, 7), FragmentVerdict::kept) == 1);
    REQUIRE(!fragments(9).empty());
    for (const PixelFragment& f : fragments(9)) CHECK(f.verdict == FragmentVerdict::outside);
    CHECK(fragments(10).empty());
}

TEST_CASE("pixel fragments: what is left out as hidden is what the drawing left out") {
    std::vector<float> depths = {2};
    for (int i = 0; i < 100; ++i) depths.push_back(3 + 0.01f * static_cast<float>(i));
    for (const int tile_size : {16, 64}) {
        Drawn drawn(squares(depths));
        Run run;
        run.tile_size = tile_size;
        drawn.geometry =
            screen_geometry(drawn.scene, drawn.scene.camera, kSize, geometry_settings(drawn.settings), run);
        const Visibility seen = visibility(drawn.geometry, DepthFormat::d32f, false, {}, run);
        for (int tile = 0; tile < drawn.geometry.tile_count(); ++tile) {
            CHECK(hidden_triangles(drawn.geometry, DepthFormat::d32f, false, tile, {}, run).size() ==
                  seen.tiles[static_cast<std::size_t>(tile)].hidden);
        }
        const PixelFragments at =
            pixel_fragments(drawn.scene, drawn.scene.camera, drawn.geometry, drawn.settings, 12, 9, run);
        CHECK(count(at, FragmentVerdict::hidden) > 20);
        run.kept = KeptWork::all();
        const PixelFragments kept =
            pixel_fragments(drawn.scene, drawn.scene.camera, drawn.geometry, drawn.settings, 12, 9, run);
        CHECK(count(kept, FragmentVerdict::hidden) == 0);
        CHECK(kept.code == at.code);
    }
}
