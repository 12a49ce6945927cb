// Which pixels a triangle covers: D3D11.3 functional spec 3.4.2.1, with every answer known exactly.
#include <doctest/doctest.h>

#include "rasterizer/base/error.h"
#include "rasterizer/lanes/approx_math.h"
#include "tests/tools/clip_space_scene.h"
#include "tests/tools/random_sequence.h"

using namespace crevice;

namespace {

// Every triangle's snapped corners against the definition, pixel by pixel.
Image<std::int32_t> count_by_definition(const ClipSpaceScene& scene) {
    Image<std::int32_t> count(scene.size, 0);
    for (const auto& triangle : scene.triangles) {
        std::array<glm::ivec2, 3> corners;
        for (std::size_t i = 0; i < 3; ++i) {
            const ProjectedVertex v = project_vertex(scene.p_clip[triangle[i]], scene.size);
            corners[i] = {v.x, v.y};
        }
        for (int y = 0; y < scene.size.height; ++y) {
            for (int x = 0; x < scene.size.width; ++x) count.at(x, y) += covers_by_definition(corners, x, y);
        }
    }
    return count;
}

// A disc of triangles around one shared vertex, the rim ragged and its corners unevenly spread.
ClipSpaceScene random_fan(RandomSequence& random, Size size, glm::dvec2 centre_px, double rim_px) {
    ClipSpaceScene scene{size, {}, {}};
    const int sectors = random.whole(5, 16);
    const std::uint32_t centre = scene.add(scene.at_screen(centre_px.x, centre_px.y));
    for (int i = 0; i < sectors; ++i) {
        const SineCosine at = sine_cosine(2 * kPi / sectors * (i + random.between(0, 0.95)));
        const double reach = rim_px * random.between(0.8, 1.0);
        scene.add(scene.at_screen(centre_px.x + reach * at.cosine, centre_px.y + reach * at.sine));
    }
    for (int i = 0; i < sectors; ++i) {
        scene.triangles.push_back(
            {centre, static_cast<std::uint32_t>(1 + i), static_cast<std::uint32_t>(1 + (i + 1) % sectors)});
    }
    return scene;
}

// On a pixel centre, on a pixel's edge or corner, anywhere, or off the screen by up to 30 pixels.
glm::dvec2 fan_centre(RandomSequence& random, Size size) {
    const double x = random.whole(4, size.width - 5), y = random.whole(4, size.height - 5);
    switch (random.whole(0, 3)) {
        case 0: return {x + 0.5, y + 0.5};
        case 1: return {x, random.whole(0, 1) == 0 ? y : y + 0.5};
        case 2: return {x + random.between(0, 1), y + random.between(0, 1)};
        default: return {-random.between(0, 30), size.height + random.between(0, 30)};
    }
}

}  // namespace

TEST_CASE("the two halves of a square share no pixel and leave none out") {
    ClipSpaceScene upper{{4, 4}, {}, {}};
    upper.add_triangle(upper.at_screen(0, 0), upper.at_screen(4, 0), upper.at_screen(0, 4));
    ClipSpaceScene lower{{4, 4}, {}, {}};
    lower.add_triangle(lower.at_screen(4, 0), lower.at_screen(4, 4), lower.at_screen(0, 4));
    const CountedDrawing a = draw(upper), b = draw(lower);
    CHECK(total(a.count) == 6);
    CHECK(total(b.count) == 10);
    for (int y = 0; y < 4; ++y) {
        for (int x = 0; x < 4; ++x) {
            CAPTURE(x);
            CAPTURE(y);
            CHECK(a.count.at(x, y) == (x + y <= 2 ? 1 : 0));
            CHECK(a.count.at(x, y) + b.count.at(x, y) == 1);
        }
    }
}

TEST_CASE("a square whose corners are pixel centres keeps its top and left edges only") {
    const double low = 0.5, high = 2.5;
    ClipSpaceScene upper{{4, 4}, {}, {}}, lower{{4, 4}, {}, {}};
    upper.add_triangle(upper.at_screen(low, low), upper.at_screen(high, low), upper.at_screen(low, high));
    lower.add_triangle(lower.at_screen(high, low), lower.at_screen(high, high), lower.at_screen(low, high));
    Image<std::int32_t> upper_expected({4, 4}, 0), lower_expected({4, 4}, 0);
    upper_expected.at(0, 0) = upper_expected.at(1, 0) = upper_expected.at(0, 1) = 1;
    lower_expected.at(1, 1) = 1;
    CHECK(differences(draw(upper).count, upper_expected) == "");
    CHECK(differences(draw(lower).count, lower_expected) == "");
}

TEST_CASE("of eight tiny triangles around a pixel centre only the one to the right and below covers it") {
    // Size 3/256 pixel; clockwise from the right, so that triangle 0 spans right and lower-right.
    const std::array<glm::ivec2, 8> directions = {
        {{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}}};
    for (std::size_t i = 0; i < 8; ++i) {
        CAPTURE(i);
        ClipSpaceScene scene{{8, 8}, {}, {}};
        const auto at = [&](glm::ivec2 d) {
            return scene.at_screen(3.5 + d.x * 3 / 256.0, 3.5 + d.y * 3 / 256.0);
        };
        scene.add_triangle(at({0, 0}), at(directions[i]), at(directions[(i + 1) % 8]));
        const CountedDrawing drawing = draw(scene);
        CHECK(total(drawing.count) == (i == 0 ? 1 : 0));
        CHECK(drawing.count.at(3, 3) == (i == 0 ? 1 : 0));
    }
}

TEST_CASE(
    "four triangles that meet near a pixel centre cover each pixel once, for all nine sub-pixel shifts") {
    for (int dy = -1; dy <= 1; ++dy) {
        for (int dx = -1; dx <= 1; ++dx) {
            CAPTURE(dx);
            CAPTURE(dy);
            ClipSpaceScene scene{{8, 8}, {}, {}};
            const std::uint32_t centre = scene.add(scene.at_screen(4.5 + dx / 256.0, 4.5 + dy / 256.0));
            const std::array<std::uint32_t, 4> rim = {
                scene.add(scene.at_screen(0, 0)), scene.add(scene.at_screen(8, 0)),
                scene.add(scene.at_screen(8, 8)), scene.add(scene.at_screen(0, 8))};
            for (std::size_t i = 0; i < 4; ++i) scene.triangles.push_back({centre, rim[i], rim[(i + 1) % 4]});
            CHECK(differences(draw(scene).count, 1) == "");
        }
    }
}

TEST_CASE("random fans cover each pixel exactly once") {
    // 100000 pixels lie outside the guard band: those triangles are clipped first.
    for (const double rim_px : {40.0, 20000.0, 100000.0}) {
        for (std::uint64_t seed = 0; seed < 200; ++seed) {
            CAPTURE(rim_px);
            CAPTURE(seed);
            RandomSequence random(seed);
            const Size size = {64, 64};
            const ClipSpaceScene fan = random_fan(random, size, fan_centre(random, size), rim_px);
            const Image<std::int32_t> count = draw(fan).count;
            if (rim_px < 30000) CHECK(differences(count, count_by_definition(fan)) == "");
            if (rim_px > 30000) CHECK(differences(count, 1) == "");
            int most = 0;
            for (const std::int32_t pixel : count.pixels) most = std::max(most, pixel);
            CHECK(most <= 1);
        }
    }
}

TEST_CASE("random triangles of every size cover what the definition says") {
    RandomSequence random(7);
    for (int i = 0; i < 1500; ++i) {
        CAPTURE(i);
        ClipSpaceScene scene{{32, 32}, {}, {}};
        const double reach = std::array{0.02, 3.0, 40.0, 300.0, 30000.0}[static_cast<std::size_t>(i % 5)];
        const glm::dvec2 near{random.whole(0, 31) + 0.5, random.whole(0, 31) + 0.5};
        const auto corner = [&] {
            return scene.at_screen(near +
                                   glm::dvec2{random.between(-reach, reach), random.between(-reach, reach)});
        };
        const glm::vec4 a = corner(), b = corner(), c = corner();
        scene.add_triangle(a, b, c);
        CHECK(differences(draw(scene).count, count_by_definition(scene)) == "");
    }
}

TEST_CASE("large triangles whose edges just cover, meet or miss the outer pixels of blocks of eight") {
    for (const double shift : {0.5 - 1.0 / 256, 0.5, 0.5 + 1.0 / 256}) {
        ClipSpaceScene scene{{128, 128}, {}, {}};
        const double low = 8 + shift, high = 104 + shift;
        scene.add_quad(scene.at_screen(low, low), scene.at_screen(high, low), scene.at_screen(high, high),
                       scene.at_screen(low, high));
        const Image<std::int32_t> expected = count_by_definition(scene);
        for_every_run({.threads = {1}}, [&](const Run& run) {
            CAPTURE(shift);
            const DepthBuffer before = cleared_depth(scene.size, DepthFormat::d32f, false);
            const ScreenGeometry geometry = geometry_of(scene, {.cull_back_faces = false}, run);
            CHECK(differences(counted(geometry, DepthFunction::always, before, run).count, expected) == "");
        });
    }
}

TEST_CASE("a sliver of 1/256 pixel covers the centres on its left edge and none on its right edge") {
    for (const int side : {1, -1}) {
        CAPTURE(side);
        ClipSpaceScene scene{{8, 8}, {}, {}};
        scene.add_triangle(scene.at_screen(2.5, 0), scene.at_screen(2.5 + side / 256.0, 4),
                           scene.at_screen(2.5, 8));
        const CountedDrawing drawing = draw(scene);
        CHECK(total(drawing.count) == (side == 1 ? 8 : 0));
        for (int y = 0; y < 8; ++y) CHECK(drawing.count.at(2, y) == (side == 1 ? 1 : 0));
    }
}

TEST_CASE("triangles without area draw nothing") {
    const std::vector<std::array<glm::dvec2, 3>> collapsed = {
        {{{1, 1}, {1, 1}, {5, 5}}},
        {{{0, 0}, {2, 2}, {4, 4}}},
        {{{0, 0}, {1 / 1024.0, 0}, {0, 4}}},  // only after snapping
        {{{3.5, 3.5}, {3.5, 3.5}, {3.5, 3.5}}},
        {{{-8, 2.5}, {4, 2.5}, {16, 2.5}}},
    };
    for (std::size_t i = 0; i < collapsed.size(); ++i) {
        CAPTURE(i);
        ClipSpaceScene scene{{8, 8}, {}, {}};
        const auto at = [&](std::size_t k) { return scene.at_screen(collapsed[i][k].x, collapsed[i][k].y); };
        scene.add_triangle(at(0), at(1), at(2));
        CHECK(total(draw(scene).count) == 0);
    }
}

TEST_CASE("moving a triangle by whole pixels moves its pixels and depths, to the bit") {
    RandomSequence random(11);
    const Size size = {128, 128};
    for (int i = 0; i < 100; ++i) {
        CAPTURE(i);
        const int dx = random.whole(-40, 40), dy = random.whole(-40, 40);
        ClipSpaceScene here{size, {}, {}}, there{size, {}, {}};
        for (std::uint32_t k = 0; k < 3; ++k) {
            const double x = 40 + random.whole(0, 48 * 256) / 256.0,
                         y = 40 + random.whole(0, 48 * 256) / 256.0;
            const double z = random.between(0, 1);
            here.add(here.at_screen(x, y, z));
            there.add(there.at_screen(x + dx, y + dy, z));
        }
        here.triangles = there.triangles = {{0, 1, 2}};
        const CountedDrawing a = draw(here), b = draw(there);
        Image<std::int32_t> count(size, 0), codes = cleared_depth(size, a.depth.format, false).codes;
        for (int y = 40; y < 88; ++y) {
            for (int x = 40; x < 88; ++x) {
                count.at(x + dx, y + dy) = a.count.at(x, y);
                codes.at(x + dx, y + dy) = a.depth.codes.at(x, y);
            }
        }
        CHECK(differences(b.count, count) == "");
        CHECK(differences(b.depth.codes, codes) == "");
    }
}

TEST_CASE("a full-screen quad fills pictures of every shape, and nothing outside them") {
    for (const Size size : {Size{1, 1}, {1, 7}, {7, 1}, {3, 5}, {9, 2}, {801, 601}, {32768, 1}, {1, 32768}}) {
        CAPTURE(size.width);
        CAPTURE(size.height);
        for (const float reach : {1.0f, 3.0f, 1000.0f}) {
            CAPTURE(reach);
            ClipSpaceScene scene{size, {}, {}};
            scene.add_quad({-reach, reach, 0.5, 1}, {reach, reach, 0.5, 1}, {reach, -reach, 0.5, 1},
                           {-reach, -reach, 0.5, 1});
            CHECK(differences(draw(scene).count, 1) == "");
            const Run one_lane = {.threads = 1, .lanes = 1};
            const CountedDrawing stepped =
                draw(scene, DepthFunction::always, {.cull_back_faces = false}, one_lane);
            CHECK(differences(stepped.count, 1) == "");
        }
    }
}

TEST_CASE("pictures without pixels, or larger than screen coordinates reach, are refused") {
    for (const Size size : {Size{0, 4}, {4, 0}, {-4, 4}, {32769, 1}, {1, 1000000}}) {
        CAPTURE(size.width);
        CAPTURE(size.height);
        CHECK_THROWS_AS(geometry_of({size, {}, {}}), UsageError);
    }
}
