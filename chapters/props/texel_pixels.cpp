#include "chapters/props/texel_pixels.h"

#include <algorithm>
#include <cmath>

#include "chapters/terminal/number_text.h"

namespace crevice {
namespace {

std::string numbers(float value) { return decimal_text(static_cast<double>(value), 3); }
std::string numbers(glm::vec3 v) { return numbers(v.x) + ", " + numbers(v.y) + ", " + numbers(v.z); }

}  // namespace

PixelsAround::PixelsAround(const AoInputs& inputs)
    : columns(inputs.size().width, inputs.picture.width), rows(inputs.size().height, inputs.picture.height) {}

std::array<Texel, 4> PixelsAround::of(const Texel& at) const {
    const auto x = static_cast<std::size_t>(at.x), y = static_cast<std::size_t>(at.y);
    const int left = columns.first[x], right = columns.second[x], top = rows.first[y],
              bottom = rows.second[y];
    return {{{left, top}, {right, top}, {left, bottom}, {right, bottom}}};
}

Texel most_mixed(const SwitchedAo& nearest, const SwitchedAo& mixed) {
    Texel most;
    float farthest = 0;
    const PixelsAround around(nearest.inputs);
    for (int y = 0; y < nearest.inputs.size().height; ++y) {
        for (int x = 0; x < nearest.inputs.size().width; ++x) {
            float sum = 0;
            for (const Texel& pixel : around.of({x, y}))
                sum += nearest.gbuffer.view_depth.at(pixel.x, pixel.y);
            const float apart = mixed.inputs.view_depth.at(x, y) - nearest.inputs.view_depth.at(x, y);
            if (std::isfinite(sum) && apart > farthest) farthest = apart, most = {x, y};
        }
    }
    return most;
}

std::vector<std::vector<std::string>> pixel_rows(const Texel& at, const SwitchedAo& nearest,
                                                 const SwitchedAo& mixed) {
    std::vector<std::vector<std::string>> rows;
    const char* const names[] = {"upper left pixel", "upper right", "lower left", "lower right"};
    const std::array<Texel, 4> pixels = PixelsAround(nearest.inputs).of(at);
    for (std::size_t i = 0; i < 4; ++i) {
        const auto [x, y] = pixels[i];
        rows.push_back({names[i], numbers(nearest.gbuffer.normal.at(x, y)),
                        numbers(nearest.gbuffer.view_depth.at(x, y))});
    }
    rows.push_back({"mean of the four (X_Jun)", numbers(mixed.inputs.normal.at(at.x, at.y)),
                    numbers(mixed.inputs.view_depth.at(at.x, at.y))});
    rows.push_back({"this lab's texel", numbers(nearest.inputs.normal.at(at.x, at.y)),
                    numbers(nearest.inputs.view_depth.at(at.x, at.y))});
    return rows;
}

SkyTexels sky_texels(const SwitchedAo& shown) {
    SkyTexels sky;
    const PixelsAround around(shown.inputs);
    for (int y = 0; y < shown.raw.size.height; ++y) {
        for (int x = 0; x < shown.raw.size.width; ++x) {
            const std::array<Texel, 4> pixels = around.of({x, y});
            const bool surface = std::any_of(pixels.begin(), pixels.end(), [&](const Texel& pixel) {
                return std::isfinite(shown.gbuffer.view_depth.at(pixel.x, pixel.y));
            });
            if (surface) continue;
            ++sky.count;
            if (shown.raw.at(x, y) != 1) ++sky.darkened;
        }
    }
    return sky;
}

}  // namespace crevice
