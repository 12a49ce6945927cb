// Triangles given on the screen or in clip space, and how often each pixel is drawn, for tests of exact coverage.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include "rasterizer/draw/visibility.h"
#include "tests/tools/every_run.h"
#include "tests/tools/image_checks.h"

namespace crevice {

struct ClipSpaceScene {
    Size size;
    std::vector<glm::vec4> p_clip;
    std::vector<std::array<std::uint32_t, 3>> triangles;

    std::uint32_t add(glm::vec4 p) {
        p_clip.push_back(p);
        return static_cast<std::uint32_t>(p_clip.size() - 1);
    }
    // Three new vertices.
    void add_triangle(glm::vec4 a, glm::vec4 b, glm::vec4 c) {
        triangles.push_back({add(a), add(b), add(c)});
    }
    // A quad of two triangles abc and acd that share vertices a and c.
    void add_quad(glm::vec4 a, glm::vec4 b, glm::vec4 c, glm::vec4 d) {
        const std::uint32_t i = add(a), j = add(b), k = add(c), l = add(d);
        triangles.push_back({i, j, k});
        triangles.push_back({i, k, l});
    }

    // The clip-space position that lands on a screen position. Without a rounding error when the sides of the
    // picture and w are powers of two and the position is a whole number of 1/256 pixels.
    glm::vec4 at_screen(double x_px, double y_px, double z_ndc = 0.5, double w = 1) const {
        const double x_ndc = x_px / (size.width * 0.5) - 1, y_ndc = 1 - y_px / (size.height * 0.5);
        return glm::vec4(x_ndc * w, y_ndc * w, z_ndc * w, w);
    }
    glm::vec4 at_screen(glm::dvec2 p_px, double z_ndc = 0.5, double w = 1) const {
        return at_screen(p_px.x, p_px.y, z_ndc, w);
    }
};

struct CountedDrawing {
    Image<std::int32_t> count;  // how many fragments passed at each pixel
    DepthBuffer depth;
};

// Adds 1 wherever a fragment passes, and cuts nothing out.
inline Holes counting(Image<std::int32_t>& count) {
    return [&count](const FragmentGroup& group) {
        for (int i = 0; i < group.lanes; ++i) {
            if (group.passes[i] != 0) ++count.at(group.x + i, group.y);
        }
    };
}

inline ScreenGeometry geometry_of(const ClipSpaceScene& scene,
                                  const SetupSettings& setup = {.cull_back_faces = false},
                                  const Run& run = kPlainRun) {
    return screen_geometry_from_clip(scene.p_clip, scene.triangles, scene.size, setup, run);
}

// How often each pixel passes `test` over `before`, and the depths that are left. They must be those that a
// drawing leaves which asks nobody about holes.
inline CountedDrawing counted(const ScreenGeometry& geometry, DepthFunction test, const DepthBuffer& before,
                              const Run& run = kPlainRun) {
    Image<std::int32_t> count(geometry.size, 0);
    DepthBuffer depth = drawn_over(before, geometry, test, counting(count), run).depth;
    const DepthBuffer unasked = drawn_over(before, geometry, test, {}, run).depth;
    for (int y = 0; y < geometry.size.height; ++y) {
        for (int x = 0; x < geometry.size.width; ++x) {
            if (depth.codes.at(x, y) != unasked.codes.at(x, y))
                throw std::logic_error("asking about holes changed a depth at (" + std::to_string(x) + "," +
                                       std::to_string(y) + ")");
        }
    }
    return {std::move(count), std::move(depth)};
}

inline CountedDrawing draw(const ClipSpaceScene& scene, DepthFunction test = DepthFunction::always,
                           const SetupSettings& setup = {.cull_back_faces = false},
                           const Run& run = kPlainRun) {
    return counted(geometry_of(scene, setup, run), test, cleared_depth(scene.size, setup.format, false), run);
}

// Whether a triangle of corners in 1/256 pixel covers a pixel, in either winding: its centre, moved right by
// an infinitely small amount and down by a still smaller one, lies inside. That is the top-left rule in other
// words.
inline bool covers_by_definition(const std::array<glm::ivec2, 3>& corners, int column, int row) {
    const std::int64_t x = column * kSubpixelSteps + kSubpixelSteps / 2,
                       y = row * kSubpixelSteps + kSubpixelSteps / 2;
    int positive = 0, negative = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        const glm::ivec2 a = corners[i], b = corners[(i + 1) % 3];
        const std::int64_t dx = b.x - a.x, dy = b.y - a.y;
        const std::int64_t side = dx * (y - a.y) - dy * (x - a.x);
        const std::int64_t decides = side != 0 ? side : (dy != 0 ? -dy : dx);
        positive += decides > 0;
        negative += decides < 0;
    }
    return positive == 3 || negative == 3;
}

}  // namespace crevice
