// Everything of a draw that is known before the first pixel: transformed vertices, set-up triangles, and for
// every tile of the picture the list of triangles that may touch it, in submission order. Passes over the
// same view can share one.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "rasterizer/base/run.h"
#include "rasterizer/draw/triangle_setup.h"
#include "rasterizer/draw/vertex_transform.h"
#include "rasterizer/scene/scene.h"
#include "rasterizer/scene/tangent_turn.h"
#include "rasterizer/spaces.h"

namespace crevice {

// A run of consecutive triangles. Blocks are built side by side; tiles read them one after the other.
struct TriangleBlock {
    VertexArray<ScreenTriangle> triangles;
    std::vector<ClippedCorners> clipped;
    std::size_t off_screen = 0;  // triangles beyond one side of the view, left out
    // Bounds of z_ndc within [0, 1] at every pixel that a triangle covers, its bias included.
    double z_lowest = 1, z_highest = 0;
    // One a tile and one more: where its list starts in triangle_of_tile.
    std::vector<std::uint32_t> first_of_tile;
    std::vector<std::uint32_t> triangle_of_tile;  // indices into `triangles`

    // Null for a whole triangle.
    const ClippedCorners* corners_of(const ScreenTriangle& t) const {
        return t.clipped < 0 ? nullptr : &clipped[static_cast<std::size_t>(t.clipped)];
    }
    std::span<const std::uint32_t> triangles_of_tile(int tile) const {
        const auto at = static_cast<std::size_t>(tile);
        return std::span(triangle_of_tile)
            .subspan(first_of_tile[at], first_of_tile[at + 1] - first_of_tile[at]);
    }
};

struct NumberedTriangle {
    const ScreenTriangle* triangle;
    const ClippedCorners* clipped;  // null: the triangle is whole
};

struct ScreenGeometry {
    Size size;
    int tile_size = 64;  // pixels
    Size tiles;          // how many, across and down
    ViewRays rays{glm::vec2(1), {}, true};
    float depth_a = 0, depth_b = 0;  // CameraMatrices
    DepthRange depth_range;
    TransformedVertices vertices;
    std::vector<TangentTurn> tangent_turns;  // one an instance; empty without normals or normal maps
    std::vector<TriangleBlock> blocks;
    int index_bits = 0;  // of a triangle's number; the rest is that of its block
    std::size_t submitted_triangles = 0;
    // Off screen: left out before their vertices were transformed. A mesh without clusters is one.
    std::size_t clusters = 0, off_screen_clusters = 0, triangles_of_off_screen_clusters = 0;

    // A triangle's number: what a visibility buffer holds.
    std::int32_t number_of(std::size_t block, std::uint32_t index) const {
        return static_cast<std::int32_t>(static_cast<std::uint32_t>(block) << index_bits | index);
    }
    NumberedTriangle triangle(std::int32_t number) const {
        const auto bits = static_cast<std::uint32_t>(number);
        const TriangleBlock& block = blocks[bits >> index_bits];
        const ScreenTriangle& t = block.triangles[bits & ((1u << index_bits) - 1)];
        return {&t, block.corners_of(t)};
    }

    // Those of off-screen clusters are among them.
    std::size_t off_screen_triangles() const {
        std::size_t count = triangles_of_off_screen_clusters;
        for (const TriangleBlock& block : blocks) count += block.off_screen;
        return count;
    }
    int tile_count() const { return tiles.width * tiles.height; }
    PixelRect tile_rect(int tile) const {
        const int x0 = tile % tiles.width * tile_size, y0 = tile / tiles.width * tile_size;
        return {x0, y0, std::min(x0 + tile_size, size.width), std::min(y0 + tile_size, size.height)};
    }
    // How many triangles may touch the tile.
    std::uint32_t triangles_of_tile(int tile) const {
        std::uint32_t count = 0;
        for (const TriangleBlock& block : blocks)
            count += static_cast<std::uint32_t>(block.triangles_of_tile(tile).size());
        return count;
    }
};

struct GeometrySettings {
    PositionOrder position_order = PositionOrder::relative;
    bool with_normals = true;
    bool with_clip_positions = false;              // fill TransformedVertices::p_clip
    DepthFormat depth_format = DepthFormat::d32f;  // matters to the unit of the bias only
    DepthBias depth_bias = {};
    bool keep_back_faces = false;  // draw them even where the scene culls them
    NormalMatrix normal_matrix = NormalMatrix::inverse_transpose;
};

ScreenGeometry screen_geometry(const Scene& scene, const Camera& camera, Size size,
                               const GeometrySettings& settings = {}, const Run& run = {});

// The same from positions already in clip space (any w): one instance, vertex normals zero, back faces kept.
ScreenGeometry screen_geometry_from_clip(std::span<const glm::vec4> p_clip,
                                         std::span<const std::array<std::uint32_t, 3>> triangles, Size size,
                                         const SetupSettings& setup = {.cull_back_faces = false},
                                         const Run& run = {});

}  // namespace crevice
