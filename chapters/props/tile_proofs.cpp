#include "chapters/props/tile_proofs.h"

#include <algorithm>
#include <cmath>

#include "chapters/diagrams/depth_section.h"
#include "scenes/builtin_scenes.h"
#include "scenes/composing.h"
#include "scenes/shapes.h"

namespace crevice {

namespace {

constexpr glm::vec3 kBackground(0.13f, 0.19f, 0.42f), kOpen(0.16f, 0.62f, 0.3f), kLitOnce(0.95f, 0.75f, 0.2f);
constexpr float kTint = 0.75f;

TileTexels texels_of(const TileMap& map, int column, int row) {
    return {column * map.tile_px, row * map.tile_px, std::min((column + 1) * map.tile_px, map.picture.width),
            std::min((row + 1) * map.tile_px, map.picture.height)};
}

// Nearest and farthest view depth of a tile's texels.
struct DepthRangeOfTile {
    float nearest = 1e30f, farthest = -1e30f;
};
DepthRangeOfTile depths_of(const AoInputs& inputs, const TileTexels& tile) {
    DepthRangeOfTile range;
    for (int y = tile.y0; y < tile.y1; ++y) {
        for (int x = tile.x0; x < tile.x1; ++x) {
            range.nearest = std::min(range.nearest, inputs.view_depth.at(x, y));
            range.farthest = std::max(range.farthest, inputs.view_depth.at(x, y));
        }
    }
    return range;
}

// Whether something nearer lies above or below a texel than to its sides.
bool nearer_upright(const AoInputs& inputs, const HarmedTexel& texel, double half_width) {
    const auto nearest = [&](glm::vec2 towards) {
        double z = 1e30;
        for (const SectionPoint& p : depth_section(inputs, {texel.x, texel.y, towards}, half_width))
            z = std::min(z, p.z);
        return z;
    };
    return nearest({0, 1}) < nearest({1, 0});
}

}  // namespace

Picture painted(const Image3& lit, const TileMap& map) {
    Image3 image = lit;
    for (int y = 0; y < lit.size().height && map.tile_px > 0; ++y) {
        for (int x = 0; x < lit.size().width; ++x) {
            const int tile_x = x * map.picture.width / lit.size().width / map.tile_px,
                      tile_y = y * map.picture.height / lit.size().height / map.tile_px;
            const TileWork work = map.tiles.at(tile_x, tile_y);
            if (work == TileWork::done) continue;
            const glm::vec3 paint = work == TileWork::background ? kBackground
                                    : work == TileWork::open     ? kOpen
                                                                 : kLitOnce;
            const float shade = (tile_x + tile_y) % 2 == 0 ? 1.0f : 0.85f;
            image.set(x, y, (1 - kTint) * lit.at(x, y) + kTint * shade * paint);
        }
    }
    Picture picture = lit_picture(image);
    picture.mapping = "the lit picture; painted blue: background, green: open, yellow: lit once";
    return picture;
}

Scene crates_from_above(Size picture) {
    Scene scene = empty_scene();
    scene.instances.push_back(placed(add_mesh(scene, grid_mesh(40, 40, 2, 2)), {0, 0, 0}));
    const int crate = add_mesh(scene, box_mesh({1, 0.5f, 1}));
    for (int row = -1; row <= 1; ++row) {
        for (int column = -2; column <= 2; ++column)
            scene.instances.push_back(
                placed(crate, {2.3f * static_cast<float>(column) + 0.3f * static_cast<float>(row), 0.25f,
                               1.9f * static_cast<float>(row)}));
    }
    scene.camera.eye = {0, 7 * std::min(1.0, picture.height / 360.0), 0};
    scene.camera.target = {0, 0, 0.1};
    return scene;
}

TileMap own_depths_only(const AoInputs& inputs, const LunaSettings& settings) {
    TileMap map(inputs.size(), kAoTile);
    for (int row = 0; row < map.tiles.size.height; ++row) {
        for (int column = 0; column < map.tiles.size.width; ++column) {
            const DepthRangeOfTile range = depths_of(inputs, texels_of(map, column, row));
            if (range.farthest - range.nearest <= settings.epsilon)
                map.tiles.at(column, row) = TileWork::open;
        }
    }
    return map;
}

TileMap corners_only(const AoInputs& inputs) {
    TileMap map(inputs.size(), kAoTile);
    for (int row = 0; row < map.tiles.size.height; ++row) {
        for (int column = 0; column < map.tiles.size.width; ++column) {
            const TileTexels t = texels_of(map, column, row);
            const auto sky = [&](int x, int y) { return std::isinf(inputs.view_depth.at(x, y)); };
            if (sky(t.x0, t.y0) && sky(t.x1 - 1, t.y0) && sky(t.x0, t.y1 - 1) && sky(t.x1 - 1, t.y1 - 1))
                map.tiles.at(column, row) = TileWork::background;
        }
    }
    return map;
}

Image<float> with_ones(Image<float> ao, const TileMap& map) {
    for (int row = 0; row < map.tiles.size.height; ++row) {
        for (int column = 0; column < map.tiles.size.width; ++column) {
            if (map.tiles.at(column, row) == TileWork::done) continue;
            const TileTexels t = texels_of(map, column, row);
            for (int y = t.y0; y < t.y1; ++y) std::fill(ao.row(y) + t.x0, ao.row(y) + t.x1, 1.0f);
        }
    }
    return ao;
}

HarmedTexel most_harmed(const TileMap& naive, const TileMap& right, const Image<float>& ao) {
    HarmedTexel harmed;
    float darkest = 2;
    for (int y = 0; y < ao.size.height; ++y) {
        for (int x = 0; x < ao.size.width; ++x) {
            const int column = x / kAoTile, row = y / kAoTile;
            const bool taken = naive.tiles.at(column, row) == TileWork::open;
            if (!taken || right.tiles.at(column, row) == TileWork::open || ao.at(x, y) >= darkest) continue;
            darkest = ao.at(x, y);
            harmed = {x, y, texels_of(naive, column, row)};
        }
    }
    return harmed;
}

std::string tile_diagram(const AoInputs& inputs, const LunaSettings& settings, const HarmedTexel& texel) {
    const bool upright = nearer_upright(inputs, texel, static_cast<double>(settings.radius));
    const TileTexels& tile = texel.tile;
    const DepthRangeOfTile range = depths_of(inputs, tile);
    const Size size = inputs.size();
    const auto z = static_cast<double>(range.farthest);
    const auto across = [&](int x, int y) {
        const Vec3<float> p =
            inputs.rays.p_view(static_cast<float>(x) / static_cast<float>(size.width),
                               static_cast<float>(y) / static_cast<float>(size.height), range.farthest);
        return static_cast<double>(upright ? p.y : p.x);
    };
    const double a = across(tile.x0, tile.y0), b = across(tile.x1, tile.y1), low = std::min(a, b),
                 high = std::max(a, b);
    const double pixel = 2 * static_cast<double>(inputs.rays.ray_scale.y) * z / inputs.picture.height,
                 reach = sample_reach_px(inputs, settings, static_cast<double>(range.nearest)) * pixel,
                 margin = 0.25 * (high - low), width = high - low + 2 * reach + 2 * margin;
    const double front = z - static_cast<double>(settings.epsilon), bar = z - 0.7 * width;
    const SectionPlane plane{texel.x, texel.y, upright ? glm::vec2(0, 1) : glm::vec2(1, 0)};
    SectionDrawing drawing({z - width, low - reach - margin}, {z + 0.2 * width, high + reach + margin});
    drawing.surface(depth_section(inputs, plane, width));
    drawing.segment({front, low - reach}, {front, high + reach}, kSvgOccluded, true);
    drawing.segment({bar, low - reach}, {bar, high + reach}, kSvgOpen);
    drawing.segment({bar - 0.04 * width, low}, {bar - 0.04 * width, high}, kSvgPoint);
    drawing.words({bar - 0.04 * width, (low + high) / 2}, -56, 4, "the tile");
    drawing.words({bar, (low + high) / 2}, 8, 4, "what its samples reach");
    drawing.words({front, high + reach}, -90, 14, "epsilon in front");
    return drawing.svg("What can a tile's samples meet?", upright ? "y" : "x");
}

}  // namespace crevice
