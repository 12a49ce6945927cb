// Tiles of the AO map that are left out, at the limits: occluders just in and out of reach, ranges of exactly
// epsilon, borders, corners, and values that are no depths.
#include <cmath>

#include <doctest/doctest.h>

#include "tests/tools/ao_cases.h"
#include "tests/tools/image_checks.h"
#include "tests/tools/open_tiles_checks.h"
#include "tests/tools/special_floats.h"

using namespace crevice;

TEST_CASE("a depth range of exactly epsilon is open, the next float beyond it is not") {
    LunaSettings settings;
    settings.epsilon = 0.5;
    settings.radius = 4;
    const Size size = {64, 64};
    for (const float z : {10.0f, 1000.0f}) {
        CAPTURE(z);
        const AoInputs at_epsilon = bump(size, z, 0.5f, 30, 34);
        CHECK(other_than(ao_keeping(at_epsilon, settings, kEverything), 1) == "");
        CHECK(changed_by_skips(at_epsilon, settings) == "");
        const AoInputs beyond = bump(size, z, z - std::nextafter(z - 0.5f, 0.0f), 30, 34);
        CHECK(other_than(ao_keeping(beyond, settings, kEverything), 1) != "");
        CHECK(changed_by_skips(beyond, settings) == "");
    }
}

TEST_CASE("an occluder just in and just out of reach of a tile") {
    // Orthographic, a unit a pixel: the samples of the tile's columns 16 to 31 stay within the radius, the
    // filter reads one pixel more.
    LunaSettings settings;
    settings.radius = 5;
    settings.exponent = 1;
    int seen = 0;
    for (int column = 32; column < 64; ++column) {
        CAPTURE(column);
        const AoInputs inputs = bump({64, 64}, 10, 0.5f, column, column + 1);
        CHECK(changed_by_skips(inputs, settings) == "");
        const Image<float> ao = ao_keeping(inputs, settings, kEverything);
        bool shaded = false;
        for (int y = 16; y < 32; ++y) {
            for (int x = 16; x < 32; ++x) shaded = shaded || ao.at(x, y) < 1;
        }
        seen += shaded;
        const TileWork work = work_at(inputs, settings, 1, 1);
        if (shaded) CHECK(work == TileWork::done);
        // Blocks of 16 pixels: an occluder beyond the block that ends the reach is not found.
        if (column >= 48) CHECK(work == TileWork::open);
    }
    CHECK(seen >= 4);
}

TEST_CASE("in perspective the reach grows towards the eye: an occluder at every distance from its tiles") {
    LunaSettings settings;
    settings.exponent = 1;
    std::size_t open = 0;
    for (const float radius : {0.3f, 0.5f, 0.7f, 1.0f}) {
        for (int column = 31; column < 112; column += 4) {
            CAPTURE(radius);
            CAPTURE(column);
            AoInputs inputs = bump({192, 24}, 10, 0.5f, column, column + 1);
            inputs.rays.perspective = true;
            inputs.rays.ray_scale = {0.25f, 0.03f};
            settings.radius = radius;
            CHECK(changed_by_skips(inputs, settings) == "");
            open += ao_tiles(inputs, settings).count(TileWork::open);
        }
    }
    CHECK(open > 100);
}

TEST_CASE("as published samples reach five times as far, and the tiles know it") {
    const AoInputs inputs = bump({160, 48}, 10, 0.5f, 64, 65);
    LunaSettings settings;
    settings.radius = 8;
    CHECK(work_at(inputs, settings, 1, 1) == TileWork::open);
    settings.as_published = true;
    CHECK(work_at(inputs, settings, 1, 1) == TileWork::done);
    CHECK(work_at(inputs, settings, 6, 1) == TileWork::done);
    settings.radius = 1;
    CHECK(work_at(inputs, settings, 1, 1) == TileWork::open);
    CHECK(changed_by_skips(inputs, settings) == "");
}

TEST_CASE("one covered texel in a tile's corner: that tile has a surface, the others have none") {
    const Size size = {48, 40};
    for (const int x : {0, 15, 16, 31, 47}) {
        for (const int y : {0, 15, 16, 32, 39}) {
            CAPTURE(x);
            CAPTURE(y);
            AoInputs inputs = plain_inputs(size, 10);
            for (float& z : inputs.view_depth.pixels) z = kInfinity;
            inputs.view_depth.at(x, y) = 10;
            inputs.depth_map.at(x + 1, y + 1) = 9.5f;
            LunaSettings settings;
            settings.radius = 2;
            CHECK(changed_by_skips(inputs, settings) == "");
            const TileMap map = ao_tiles(inputs, settings);
            CHECK(map.count(TileWork::background) == map.count() - 1);
            CHECK(map.tiles.at(x / kAoTile, y / kAoTile) != TileWork::background);
        }
    }
}

TEST_CASE("the border of the map counts as what it holds") {
    AoInputs inputs = plain_inputs({64, 64}, 10);
    LunaSettings settings;
    settings.radius = 3;
    CHECK(ao_tiles(inputs, settings).count(TileWork::open) == 16);
    for (const int column : {0, 65}) {
        CAPTURE(column);
        AoInputs near_border = inputs;
        for (int y = 0; y < near_border.depth_map.size.height; ++y)
            near_border.depth_map.at(column, y) = 9.5f;
        CHECK(other_than(ao_keeping(near_border, settings, kEverything), 1) != "");
        CHECK(changed_by_skips(near_border, settings) == "");
        const TileMap map = ao_tiles(near_border, settings);
        CHECK(map.tiles.at(column == 0 ? 0 : 3, 1) == TileWork::done);
        CHECK(map.tiles.at(column == 0 ? 3 : 0, 1) == TileWork::open);
    }
}

TEST_CASE("a background so far that filtering beside it undershoots: the tiles allow for it") {
    // Between 10 and 1e8 the filter's rounding alone reaches units, far more than epsilon.
    AoInputs inputs = plain_inputs({64, 64}, 10);
    for (int y = 0; y < inputs.depth_map.size.height; ++y) {
        for (int x = 0; x < inputs.depth_map.size.width; ++x) {
            if (x > 40) inputs.depth_map.at(x, y) = 1e8f;
        }
    }
    LunaSettings settings;
    settings.radius = 6;
    CHECK(changed_by_skips(inputs, settings) == "");
    CHECK(work_at(inputs, settings, 2, 1) == TileWork::done);
    CHECK(work_at(inputs, settings, 0, 1) == TileWork::open);
}

TEST_CASE("NaN and infinity in a buffer: no skip changes a bit") {
    for (const float odd : {kNan, kInfinity}) {
        CAPTURE(odd);
        AoInputs inputs = bump({64, 64}, 10, 0.5f, 50, 52);
        inputs.depth_map.at(20, 20) = odd;
        inputs.view_depth.at(40, 8) = odd;
        LunaSettings settings;
        settings.radius = 3;
        CHECK(changed_by_skips(inputs, settings) == "");
        CHECK(ao_tiles(inputs, settings).count(TileWork::open) > 0);
    }
}
