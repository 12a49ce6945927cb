#include "rasterizer/textures/cube_map.h"

#include <algorithm>
#include <string>

#include <glm/geometric.hpp>

#include "rasterizer/base/error.h"
#include "rasterizer/base/image.h"
#include "rasterizer/base/parallel.h"
#include "rasterizer/textures/paint_cube_map.h"

namespace crevice {

namespace {

// Rows are handed out in bands of this many.
constexpr int kRowsAtOnce = 16;

CubeMap empty_cube_map(int side) {
    const bool power_of_two = side > 0 && (side & (side - 1)) == 0;
    if (!power_of_two || side > kLargestCubeSide) {
        throw UsageError("cube map: its side must be a power of two up to " +
                         std::to_string(kLargestCubeSide) + " (" + std::to_string(side) +
                         "); give another side");
    }
    CubeMap cube;
    cube.side = side;
    std::int32_t texels = 0;
    for (int level_side = side; level_side >= 1; level_side /= 2) {
        cube.level_start.push_back(texels);
        cube.level_side.push_back(level_side);
        texels += kCubeFaces * (level_side + 2) * (level_side + 2);
    }
    cube.rgba.assign(4 * static_cast<std::size_t>(texels), 0.0f);
    return cube;
}

void set_texel(CubeMap& cube, std::size_t at, glm::vec3 colour) {
    for (std::size_t c = 0; c < 3; ++c) cube.rgba[4 * at + c] = colour[static_cast<int>(c)];
}

double texel_centre(int i, int side) { return (2.0 * i + 1) / side - 1; }

// The texel next to one at a face's edge, across the edge. Exactly one of column and row is -1 or the side.
glm::vec3 texel_across(const CubeMap& cube, int level, int face, int column, int row) {
    const int side = cube.level_side[static_cast<std::size_t>(level)];
    const auto on_face = [&](int i) { return i < 0 ? -1.0 : (i >= side ? 1.0 : texel_centre(i, side)); };
    // From the edge half a texel back along the face's axis: the middle of the neighbour's first texel.
    const glm::dvec3 p =
        cube_direction(face, on_face(column), on_face(row)) - (1.0 / side) * cube_direction(face, 0, 0);
    const CubePoint<double> at = cube_point<double>({p.x, p.y, p.z});
    const auto texel_at = [&](double a) { return static_cast<int>(0.5 * (a + 1) * side); };
    return cube.texel(level, at.face, texel_at(at.u), texel_at(at.v));
}

void fill_rim(CubeMap& cube, int level, int face) {
    const int side = cube.level_side[static_cast<std::size_t>(level)];
    const auto fill = [&](int column, int row) {
        set_texel(cube, cube.texel_index(level, face, column, row),
                  texel_across(cube, level, face, column, row));
    };
    for (int i = 0; i < side; ++i) {
        fill(-1, i);
        fill(side, i);
        fill(i, -1);
        fill(i, side);
    }
    for (const int row : {-1, side}) {
        for (const int column : {-1, side}) {
            const int inner_column = column < 0 ? 0 : side - 1, inner_row = row < 0 ? 0 : side - 1;
            const glm::vec3 sum = cube.texel(level, face, inner_column, inner_row) +
                                  cube.texel(level, face, column, inner_row) +
                                  cube.texel(level, face, inner_column, row);
            set_texel(cube, cube.texel_index(level, face, column, row), sum / 3.0f);
        }
    }
}

void fill_from_level_above(CubeMap& cube, int level) {
    const int side = cube.level_side[static_cast<std::size_t>(level)];
    for (int face = 0; face < kCubeFaces; ++face) {
        for (int y = 0; y < side; ++y) {
            for (int x = 0; x < side; ++x) {
                const auto above = [&](int column, int row) {
                    return cube.texel(level - 1, face, 2 * x + column, 2 * y + row);
                };
                const glm::vec3 sum = (above(0, 0) + above(1, 0)) + (above(0, 1) + above(1, 1));
                set_texel(cube, cube.texel_index(level, face, x, y), 0.25f * sum);
            }
        }
    }
}

}  // namespace

glm::dvec3 cube_direction(int face, double u, double v) {
    switch (face) {
        case 0: return {1, -v, -u};
        case 1: return {-1, -v, u};
        case 2: return {u, 1, v};
        case 3: return {u, -1, -v};
        case 4: return {u, -v, 1};
        default: return {-u, -v, -1};
    }
}

CubeMap paint_cube_map(int side, const std::function<void(const CubeRow& row)>& paint, const Run& run) {
    CubeMap cube = empty_cube_map(side);
    const int bands = (side + kRowsAtOnce - 1) / kRowsAtOnce;
    parallel_for(kCubeFaces * bands, run, [&](int item) {
        const int face = item / bands, first = item % bands * kRowsAtOnce;
        const auto room = static_cast<std::size_t>(round_up(side, kRowAlignment));
        std::array<std::vector<float>, 3> towards, rgb;
        for (std::vector<float>& row : towards) row.assign(room, 1.0f);
        for (std::vector<float>& row : rgb) row.resize(room);
        const CubeRow row{side,
                          {towards[0].data(), towards[1].data(), towards[2].data()},
                          {rgb[0].data(), rgb[1].data(), rgb[2].data()}};
        for (int y = first; y < first + kRowsAtOnce && y < side; ++y) {
            for (int x = 0; x < side; ++x) {
                const glm::vec3 direction(
                    glm::normalize(cube_direction(face, texel_centre(x, side), texel_centre(y, side))));
                for (std::size_t c = 0; c < 3; ++c)
                    towards[c][static_cast<std::size_t>(x)] = direction[static_cast<int>(c)];
            }
            paint(row);
            for (int x = 0; x < side; ++x)
                set_texel(cube, cube.texel_index(0, face, x, y),
                          {row.rgb[0][x], row.rgb[1][x], row.rgb[2][x]});
        }
    });
    for (int level = 0; level < cube.levels(); ++level) {
        if (level > 0) fill_from_level_above(cube, level);
        for (int face = 0; face < kCubeFaces; ++face) fill_rim(cube, level, face);
    }
    return cube;
}

CubeMap build_cube_map(int side, const std::function<glm::vec3(glm::vec3 direction)>& colour_of,
                       const Run& run) {
    const auto paint_row = [&](const CubeRow& row) {
        for (int x = 0; x < row.count; ++x) {
            const glm::vec3 colour =
                colour_of({row.direction[0][x], row.direction[1][x], row.direction[2][x]});
            for (int c = 0; c < 3; ++c) row.rgb[c][x] = colour[c];
        }
    };
    return paint_cube_map(side, paint_row, run);
}

}  // namespace crevice
