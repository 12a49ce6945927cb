#include "scenes/procedural_textures.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <doctest/doctest.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "rasterizer/base/error.h"
#include "rasterizer/base/image_summary.h"

using namespace crevice;

namespace {

struct NamedSurface {
    const char* name;
    SurfaceMaps (*make)(int side, const Run& run);
    int across, down;  // how often its pattern repeats, but for the noise
};
SurfaceMaps red_cloth(int side, const Run& run = {}) { return cloth_textures({0.4, 0.15, 0.1}, side, run); }
constexpr NamedSurface kSurfaces[] = {
    {"floor tiles", floor_tile_textures, 4, 4},  {"bricks", brick_textures, 4, 5},  // every second course
    {"rough stone", rough_stone_textures, 4, 4}, {"ashlar", ashlar_textures, 2, 3},
    {"limestone", limestone_textures, 4, 4},     {"cloth", red_cloth, 3, 3}};

float at(const Image<float>& image, int x, int y) {
    const int side = image.size.width;
    return image.at((x + side) % side, (y + side) % side);
}

// The difference across the line to the left of a column, or above a row: its mean, which tells of outlines,
// and its lower quartile, which tells of the faint grain between them: in masonry half of a line may be joints.
struct Jump {
    double mean = 0, quartile = 0;
};
Jump jump(const Image<float>& plane, int line, bool of_columns) {
    const int side = plane.size.width;
    std::vector<double> differences;
    Jump result;
    for (int i = 0; i < side; ++i) {
        const float across = of_columns ? at(plane, line, i) - at(plane, line - 1, i)
                                        : at(plane, i, line) - at(plane, i, line - 1);
        differences.push_back(std::abs(static_cast<double>(across)));
        result.mean += differences.back() / side;
    }
    std::nth_element(differences.begin(), differences.begin() + side / 4, differences.end());
    result.quartile = differences[static_cast<std::size_t>(side / 4)];
    return result;
}

// The texture's edges against the lines in it where the pattern repeats: the same things meet there.
void check_that_it_continues(const Image<float>& plane, int repeats_across, int repeats_down) {
    const int side = plane.size.width;
    for (const bool of_columns : {true, false}) {
        const int repeats = of_columns ? repeats_across : repeats_down;
        Jump inside;
        for (int line = 1; line < repeats; ++line) {
            const Jump here = jump(plane, line * side / repeats, of_columns);
            inside = {std::max(inside.mean, here.mean), std::max(inside.quartile, here.quartile)};
        }
        CAPTURE(of_columns);
        CHECK(jump(plane, 0, of_columns).mean <= 1.35 * inside.mean + 1e-7);
        CHECK(jump(plane, 0, of_columns).quartile <= 1.35 * inside.quartile + 1e-7);
    }
}

}  // namespace

TEST_CASE("procedural textures: opposite edges continue each other") {
    for (const NamedSurface& surface : kSurfaces) {
        const std::string name = surface.name;
        CAPTURE(name);
        const SurfaceMaps textures = surface.make(240, {});
        for (const Image<float>& plane : {textures.height, textures.colour.colour(0).x,
                                          textures.normal.colour(0).x, textures.normal.alpha(0)})
            check_that_it_continues(plane, surface.across, surface.down);
    }
    const Texture fence = fence_texture(160);
    check_that_it_continues(fence.colour(0).x, 4, 4);
    check_that_it_continues(fence.alpha(0), 4, 4);
}

TEST_CASE("procedural textures: normals are those of the height field, across the edges too") {
    const float kStored =
        std::sqrt(3.0f) / kTexelOne + 1e-6f;  // each component half a unit of [0,1], so a whole one
    for (const NamedSurface& surface : kSurfaces) {
        const SurfaceMaps textures = surface.make(48, {});
        const Image3& normals = textures.normal.colour(0);
        for (int y = 0; y < 48; ++y) {
            for (int x = 0; x < 48; ++x) {
                CAPTURE(surface.name);
                CAPTURE(x);
                CAPTURE(y);
                const glm::vec3 n = 2.0f * normals.at(x, y) - 1.0f;
                const float du = at(textures.height, x + 1, y) - at(textures.height, x - 1, y),
                            dv = at(textures.height, x, y + 1) - at(textures.height, x, y - 1);
                CHECK(std::abs(glm::length(n) - 1) < kStored);
                CHECK(glm::length(n - glm::normalize(glm::vec3(-24 * du, -24 * dv, 1))) < kStored);
            }
        }
    }
}

TEST_CASE("procedural textures: colours and factors in [0,1], neither black nor burnt out, bumps of use") {
    for (const NamedSurface& surface : kSurfaces) {
        CAPTURE(surface.name);
        const SurfaceMaps textures = surface.make(64, {});
        CHECK(textures.colour.levels().size() == 7);
        CHECK(textures.normal.has_alpha());
        CHECK(!textures.colour.has_alpha());
        const BufferStatistics colour = buffer_statistics(textures.colour.colour(0)),
                               factor = buffer_statistics(textures.normal.alpha(0)),
                               height = buffer_statistics(textures.height);
        CHECK(colour.min > 0);
        CHECK(colour.max < 0.9f);
        CHECK(colour.mean > 0.1);
        CHECK(factor.min >= 0);
        CHECK(factor.max <= 1);
        CHECK(factor.max > factor.min + 0.1f);
        CHECK(height.max - height.min > 0.005f);
        CHECK(height.max - height.min < 0.1f);
        CHECK(buffer_statistics(textures.normal.colour(0).z).min > 0.6f);  // nothing steeper than 78 degrees
    }
}

TEST_CASE("procedural textures: another side is the same surface sampled otherwise") {
    for (const NamedSurface& surface : kSurfaces) {
        const SurfaceMaps coarse = surface.make(16, {}), fine = surface.make(48, {});
        for (int y = 0; y < 16; ++y) {
            for (int x = 0; x < 16; ++x) {
                CAPTURE(surface.name);
                CAPTURE(x);
                CAPTURE(y);
                CHECK(std::abs(coarse.height.at(x, y) - fine.height.at(3 * x + 1, 3 * y + 1)) < 1e-6f);
                CHECK(glm::length(glm::vec3(coarse.colour.texel(0, x, y)) -
                                  glm::vec3(fine.colour.texel(0, 3 * x + 1, 3 * y + 1))) < 1e-5f);
            }
        }
    }
}

TEST_CASE("procedural textures: the leaf has a free rim, a midrib and no foreign colour outside") {
    const Texture leaf = leaf_texture(96);
    const Image<float>& alpha = leaf.alpha(0);
    const BufferStatistics statistics = buffer_statistics(alpha);
    CHECK(statistics.min == 0);
    CHECK(statistics.max == 1);
    CHECK(statistics.mean > 0.25);
    CHECK(statistics.mean < 0.6);
    for (int i = 0; i < 96; ++i) {
        CAPTURE(i);
        CHECK(alpha.at(i, 0) == 0);
        CHECK(alpha.at(i, 95) == 0);
        CHECK(alpha.at(0, i) == 0);
        CHECK(alpha.at(95, i) == 0);
    }
    for (int y = 8; y < 70; ++y) {
        CAPTURE(y);
        CHECK(alpha.at(48, y) == 1);  // from below the tip down the middle
        for (int x = 0; x < 96; ++x) {
            const glm::vec3 c = glm::vec3(leaf.texel(0, x, y));
            CHECK((c.y > c.x && c.x > c.z));  // green, also where alpha is 0
        }
    }
    CHECK(alpha.at(48, 88) > 0);  // the stalk
}

TEST_CASE("procedural textures: the fence is wire with holes in every diamond") {
    const Texture fence = fence_texture(128);
    const Image<float>& alpha = fence.alpha(0);
    // Two families of wires, 0.15 of a spacing wide, that cross: 1 - 0.85^2.
    CHECK(std::abs(buffer_statistics(alpha).mean - 0.2775) < 0.005);
    // Wires lie where u + v is (k + 1/2) / 4 and where u - v is k / 4: crossings and holes alternate.
    for (int row = 0; row < 8; ++row) {
        for (int column = 0; column < 8; ++column) {
            CAPTURE(row);
            CAPTURE(column);
            CHECK(alpha.at(16 * column + 8, 16 * row + 8) == ((row + column) % 2 == 0 ? 1 : 0));
        }
    }
    const BufferStatistics colour = buffer_statistics(fence.colour(0));
    CHECK(colour.min > 0);
    CHECK(colour.max <= 1);
}

TEST_CASE(
    "procedural textures: a chain hangs down, links within links, and half of it on is its other side") {
    const int side = 120;
    const Image<float> alpha = chain_texture(side).alpha(0);
    for (int y = 0; y < side; ++y) {
        CAPTURE(y);
        double metal = 0;
        for (int x = 0; x < side; ++x) {
            metal += alpha.at(x, y) / side;
            CHECK(alpha.at(x, y) == alpha.at(side - 1 - x, y));
        }
        CHECK(metal > 0.05);  // nowhere is the chain torn
        CHECK(metal < 0.5);
        CHECK((alpha.at(0, y) == 0 && alpha.at(side - 1, y) == 0));
    }
    CHECK(alpha.at(side / 2, 0) == 1);         // the bar of a link seen from its side
    CHECK(alpha.at(side / 2, side / 2) == 0);  // the hole of one seen from the front
}

TEST_CASE("procedural textures: the same bits everywhere") {
    const auto hashes = [](const SurfaceMaps& textures) {
        return content_hash(textures.colour.colour(0)) + " " + content_hash(textures.normal.colour(1)) + " " +
               content_hash(textures.normal.alpha(0)) + " " + content_hash(textures.height);
    };
    CHECK(hashes(floor_tile_textures(64)) ==
          "cb14c0bf0eacec6b 22582d9999f8535f 00cae2709b26b21b 4e337e3a71f7560f");
    CHECK(hashes(brick_textures(64)) ==
          "de1427ef2dacd18f 52cff3f187911c6a 8db83784b279c4a9 8e8999c635724d7e");
    CHECK(hashes(rough_stone_textures(64)) ==
          "05fa3f42dac9072e d9a525ead63d3160 816cfa2a88ae8712 1654f0074373f90a");
    CHECK(hashes(ashlar_textures(64)) ==
          "4d99aefc0d46a068 cbf51d765a1a507f e5afdb935b50b4b6 80074edc7d1c1803");
    CHECK(hashes(limestone_textures(64)) ==
          "d6276f38eda6bed4 6e408eca1d299e72 f7b3717405ed5a17 18a59ba8a3dd443a");
    CHECK(hashes(red_cloth(64)) == "d2a6a0bda0b438ef 8c1b73f1fd406826 8cc5546dc732c8ec fc7c2fe05d795a7b");
    const Texture leaf = leaf_texture(64), fence = fence_texture(64), chain = chain_texture(64);
    CHECK(content_hash(chain.colour(0)) + " " + content_hash(chain.alpha(2)) ==
          "21aa4579e1d42e16 7c83e88e49573e94");
    CHECK(content_hash(leaf.colour(0)) + " " + content_hash(leaf.alpha(2)) ==
          "cdf3f88fca747d8f 3d5b69593213906c");
    CHECK(content_hash(fence.colour(0)) + " " + content_hash(fence.alpha(2)) ==
          "89df4c2283ca3f2c 2fcb890b1317f524");
}

TEST_CASE("procedural textures: a side out of range is named") {
    for (const int side : {-1, 0, 7, 4097}) {
        CAPTURE(side);
        CHECK_THROWS_WITH_AS(brick_textures(side), doctest::Contains("8 to 4096"), UsageError);
        CHECK_THROWS_WITH_AS(leaf_texture(side), doctest::Contains("8 to 4096"), UsageError);
    }
    CHECK(fence_texture(8).colour(0).size() == Size{8, 8});
    CHECK(rough_stone_textures(9).height.size == Size{9, 9});
}
