// Triangle setup eight at a time: the same triangles, lists and bits as one at a time, in the order of
// submission.
#include "rasterizer/draw/setup_lanes.h"

#include <cstring>
#include <string>

#include <doctest/doctest.h>
#include <glm/gtc/matrix_transform.hpp>

#include "rasterizer/base/run.h"
#include "tests/tools/clip_space_scene.h"
#include "tests/tools/every_run.h"
#include "tests/tools/random_sequence.h"
#include "tests/tools/small_scenes.h"
#include "tests/tools/special_floats.h"

using namespace crevice;

namespace {

// "" when two triangles have the same bits, else the first member that differs.
std::string unlike_member(const ScreenTriangle& a, const ScreenTriangle& b) {
    const auto unlike = [](const auto& left, const auto& right) {
        return std::memcmp(&left, &right, sizeof left) != 0;
    };
    if (unlike(a.x, b.x) || unlike(a.y, b.y)) return "corners";
    if (unlike(a.inverse_w, b.inverse_w)) return "inverse_w";
    if (unlike(a.vertex, b.vertex)) return "vertex";
    if (unlike(a.z0, b.z0) || unlike(a.z_per_e1, b.z_per_e1) || unlike(a.z_per_e2, b.z_per_e2)) return "z";
    if (unlike(a.doubled_area, b.doubled_area)) return "doubled_area";
    if (unlike(a.z_low, b.z_low) || unlike(a.z_high, b.z_high)) return "bounds of z";
    if (unlike(a.depth_bias, b.depth_bias)) return "depth_bias";
    if (!(a.bounds == b.bounds)) return "bounds";
    if (a.clipped != b.clipped || a.instance != b.instance || a.material != b.material) return "origin";
    if (a.back_facing != b.back_facing || a.shows_back != b.shows_back || a.small != b.small) return "flags";
    if (a.covered != b.covered) return "covered pixels";
    return "";
}

std::string difference_of(const ScreenGeometry& a, const ScreenGeometry& b) {
    if (a.blocks.size() != b.blocks.size()) return "number of blocks";
    if (a.off_screen_triangles() != b.off_screen_triangles()) return "off-screen triangles";
    for (std::size_t i = 0; i < a.blocks.size(); ++i) {
        const TriangleBlock &of_a = a.blocks[i], &of_b = b.blocks[i];
        if (of_a.triangles.size() != of_b.triangles.size()) return "number of triangles";
        for (std::size_t k = 0; k < of_a.triangles.size(); ++k) {
            const std::string member = unlike_member(of_a.triangles[k], of_b.triangles[k]);
            if (!member.empty()) return member + " of triangle " + std::to_string(k);
        }
        if (of_a.clipped.size() != of_b.clipped.size()) return "number of clipped pieces";
        for (std::size_t k = 0; k < of_a.clipped.size(); ++k) {
            if (of_a.clipped[k].lambda1 != of_b.clipped[k].lambda1 ||
                of_a.clipped[k].lambda2 != of_b.clipped[k].lambda2)
                return "clipped piece " + std::to_string(k);
        }
        if (of_a.first_of_tile != of_b.first_of_tile || of_a.triangle_of_tile != of_b.triangle_of_tile)
            return "tile lists";
    }
    return "";
}

// Every kind of corner: on the grid or not, shared, far away, tiny triangles.
ProjectedVertex random_corner(RandomSequence& random, int kind) {
    const int reach = kind == 0 ? 300 : (kind == 1 ? 20000 : (1 << 23) - 1);
    const auto rest = [&] { return static_cast<float>(random.between(-0.5, 0.5)); };
    ProjectedVertex v;
    v.x = random.whole(-reach, reach);
    v.y = random.whole(-reach, reach);
    v.x_rest = rest();
    v.y_rest = rest();
    v.z_ndc = static_cast<float>(random.between(0, 1));
    v.inverse_w = static_cast<float>(random.between(0.01, 10));
    return v;
}

// The input of SetupLanes from as many of the triangles as there are lanes.
template <class F>
LaneCorner<F> corner_of(const std::array<std::array<ProjectedVertex, 3>, kMostLanes>& triangles, std::size_t corner) {
    std::array<std::int32_t, kMostLanes> x, y;
    std::array<float, kMostLanes> x_rest, y_rest, z, inverse_w;
    for (std::size_t lane = 0; lane < kMostLanes; ++lane) {
        const ProjectedVertex& v = triangles[lane][corner];
        x[lane] = v.x;
        y[lane] = v.y;
        x_rest[lane] = v.x_rest;
        y_rest[lane] = v.y_rest;
        z[lane] = v.z_ndc;
        inverse_w[lane] = v.inverse_w;
    }
    return {
        load<F>(x.data()), load<F>(y.data()),         load<F>(x_rest.data()),          load<F>(y_rest.data()),
        load<F>(z.data()), load<F>(inverse_w.data()), Int<F>(static_cast<int>(corner))};
}

// Triangles of every fate in any order: drawn, culled, without area, clipped, off screen, not a number.
ClipSpaceScene every_fate(RandomSequence& random, Size size, int count) {
    ClipSpaceScene scene{size, {}, {}};
    const auto anywhere = [&](double reach, double z_low, double z_high) {
        const double w = random.between(0.2, 4);
        const double x = random.between(-reach, reach), y = random.between(-reach, reach);
        return glm::vec4(x * w, y * w, random.between(z_low, z_high) * w, w);
    };
    for (int i = 0; i < count; ++i) {
        const int fate = random.whole(0, 9);
        const double reach = fate == 0 ? 3000 : 1.5;
        const double z_low = fate == 1 ? -0.5 : 0, z_high = fate == 2 ? 1.5 : 1;
        glm::vec4 a = anywhere(reach, z_low, z_high), b = anywhere(reach, z_low, z_high),
                  c = anywhere(reach, z_low, z_high);
        if (fate == 3) c = b;
        if (fate == 4) a = c + 0.5f * (b - c);
        if (fate == 5) b.w = -b.w;
        if (fate == 6) c[random.whole(0, 3)] = kNan;
        if (fate == 7) {
            for (glm::vec4* p : {&a, &b, &c}) p->x = 2 * p->w;
        }
        scene.add_triangle(a, b, c);
    }
    return scene;
}

// Small triangles that face anywhere, all within 1 of the origin.
Mesh many_sides(RandomSequence& random, std::uint32_t triangle_count) {
    Mesh mesh;
    const auto near_by = [&](double reach) {
        return glm::vec3{random.between(-reach, reach), random.between(-reach, reach),
                         random.between(-reach, reach)};
    };
    for (std::uint32_t t = 0; t < triangle_count; ++t) {
        const glm::vec3 centre = near_by(0.5);
        for (int corner = 0; corner < 3; ++corner) mesh.positions.push_back(centre + near_by(0.3));
        mesh.triangles.push_back({3 * t, 3 * t + 1, 3 * t + 2});
    }
    mesh.normals.assign(mesh.positions.size(), {0, 0, -1});
    mesh.parts = {{0, triangle_count, 0}};
    return mesh;
}

}  // namespace

TEST_CASE("setup lanes: several triangles at once have the bits of each alone, with every instruction set") {
    int drawn = 0, left_out = 0;
    for (std::uint64_t seed = 0; seed < 3000; ++seed) {
        RandomSequence random(seed);
        std::array<std::array<ProjectedVertex, 3>, kMostLanes> triangles;
        for (auto& triangle : triangles) {
            const int kind = random.whole(0, 2);
            for (ProjectedVertex& v : triangle) v = random_corner(random, kind);
            const int fate = random.whole(0, 7);
            if (fate == 0) triangle[2] = triangle[0];
            if (fate == 1) triangle[1].y = triangle[0].y;
            if (fate == 2) triangle[2].x = triangle[1].x = triangle[0].x;
            if (fate == 3) triangle[1].z_ndc = triangle[2].z_ndc = triangle[0].z_ndc;
        }
        const SetupSettings settings{seed % 2 == 0,
                                     seed % 3 == 0 ? DepthFormat::d16 : DepthFormat::d32f,
                                     {.constant = 2, .slope = 0.5f}};
        for (const Isa isa : kEveryIsa) {
            if (!isa_available(isa)) continue;
            call_for_isa(isa, [&]<class F>(Lanes<F>) {
                const LaneCorner<F> given[3] = {corner_of<F>(triangles, 0), corner_of<F>(triangles, 1),
                                                corner_of<F>(triangles, 2)};
                const Mask<F> every = lane_index<F>() >= Int<F>(0);
                const SetUpTriangles<F> wide(SetupLanes<F>(given, every, settings.cull_back_faces));
                const SnappedCorner<F> a{given[0].x, given[0].y}, b{given[1].x, given[1].y},
                    c{given[2].x, given[2].y};
                SnappedTriangles<F> snapped(a, b, c, every, settings.cull_back_faces);
                std::int32_t covered[kLanes<F>];
                store(covered, snapped.drop_uncovering(a, b, c));
                const unsigned wide_drawn = lane_bits(snapped.drawn);
                for (int lane = 0; lane < kLanes<F>; ++lane) {
                    const auto& corners = triangles[static_cast<std::size_t>(lane)];
                    const auto one = set_up_triangle({&corners[0], &corners[1], &corners[2]}, settings);
                    INFO("seed " << seed << ", lane " << lane << ", " << isa_name(isa));
                    REQUIRE((wide_drawn >> lane & 1) == (one ? 1 : 0));
                    ++(one ? drawn : left_out);
                    if (!one) continue;
                    ScreenTriangle expected = one->triangle, actual;
                    wide.write(lane, settings, actual);
                    actual.covered = static_cast<std::uint16_t>(covered[lane]);
                    actual.vertex = expected.vertex = {};
                    actual.instance = expected.instance = 0;
                    actual.material = expected.material = 0;
                    REQUIRE(unlike_member(actual, expected) == "");
                    REQUIRE(wide.order(lane) == one->order);
                }
            });
        }
    }
    CHECK(drawn > 5000);
    CHECK(left_out > 3000);
}

TEST_CASE("setup lanes: any number of triangles of any fate, one lane or eight: the same lists") {
    const Size size = {97, 53};
    for (int count = 0; count < 200; ++count) {
        RandomSequence random(static_cast<std::uint64_t>(count));
        const ClipSpaceScene scene = every_fate(random, size, count < 199 ? count % 50 : 4096 * 2 + 3);
        for (const bool cull : {false, true}) {
            const SetupSettings setup{cull, DepthFormat::d24, {.constant = 1, .slope = 1}};
            CAPTURE(count);
            CAPTURE(cull);
            const ScreenGeometry eight = geometry_of(scene, setup, {.threads = 1, .tile_size = 16});
            const ScreenGeometry one = geometry_of(scene, setup, {.threads = 1, .lanes = 1, .tile_size = 16});
            REQUIRE(difference_of(eight, one) == "");
            REQUIRE(eight.submitted_triangles == scene.triangles.size());
        }
    }
}

TEST_CASE("setup lanes: mirrored and turned instances, one lane or eight: the same lists") {
    for (std::uint64_t seed = 0; seed < 12; ++seed) {
        CAPTURE(seed);
        RandomSequence random(seed);
        Scene scene = scene_of({many_sides(random, 156)});  // not a multiple of eight
        scene.two_sided = seed % 2 == 1;
        scene.instances.clear();
        for (int i = 0; i < 4; ++i) {
            const auto side = [&] {
                return static_cast<float>((random.whole(0, 1) * 2 - 1) * random.between(0.5, 2));
            };
            const glm::vec3 stretch{side(), side(), side()};
            const glm::vec3 place{random.between(-2, 2), random.between(-2, 2), random.between(1, 6)};
            scene.instances.push_back({0, glm::scale(glm::translate(glm::mat4(1), place), stretch)});
        }
        const Size size = {61, 45};
        const ScreenGeometry eight = screen_geometry(scene, scene.camera, size, {}, {.threads = 1});
        const ScreenGeometry one = screen_geometry(scene, scene.camera, size, {}, {.threads = 1, .lanes = 1});
        CHECK(difference_of(eight, one) == "");
        std::size_t kept = 0;
        for (const TriangleBlock& block : eight.blocks) kept += block.triangles.size();
        CHECK(kept > 0);
    }
}

TEST_CASE("setup lanes: with ALWAYS the last triangle submitted is the one seen") {
    const Size size = {61, 45};
    for (const int count : {1, 7, 8, 9, 203}) {
        RandomSequence random(static_cast<std::uint64_t>(count));
        ClipSpaceScene all{size, {}, {}};
        Image<std::int32_t> expected(size, depth_code(DepthFormat::d32f, 1.0f, 0.0));
        for (int i = 0; i < count; ++i) {
            const double z = (i + 1) / 1024.0;  // the same at all corners: exact at every pixel
            const double reach = random.whole(0, 4) == 0 ? 60000 : 40;  // some reach beyond the guard band
            const auto corner = [&] {
                const double x = 30 + random.between(-reach, reach), y = 22 + random.between(-reach, reach);
                return all.at_screen(x, y, z);
            };
            ClipSpaceScene alone{size, {corner(), corner(), corner()}, {{0, 1, 2}}};
            all.add_triangle(alone.p_clip[0], alone.p_clip[1], alone.p_clip[2]);
            const CountedDrawing drawn = draw(alone);
            for (int y = 0; y < size.height; ++y) {
                for (int x = 0; x < size.width; ++x) {
                    if (drawn.count.at(x, y) > 0)
                        expected.at(x, y) = depth_code(DepthFormat::d32f, static_cast<float>(z), 0.0);
                }
            }
        }
        CAPTURE(count);
        for_every_run({.tile_sizes = {16, 64}}, [&](const Run& run) {
            CHECK(differences(draw(all, DepthFunction::always, {false}, run).depth.codes, expected) == "");
        });
    }
}
