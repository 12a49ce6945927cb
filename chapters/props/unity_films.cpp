#include "chapters/props/unity_films.h"

#include <algorithm>
#include <cstdint>
#include <utility>

#include "chapters/terminal/number_text.h"
#include "ssao/methods/unity.h"

namespace crevice {
namespace {

std::vector<Picture> with_slider(const std::vector<Image<float>>& maps) {
    std::vector<Picture> frames;
    for (const Image<float>& map : maps) {
        Picture frame = ao_picture(map);
        const auto rows = static_cast<std::size_t>(map.size.height), row = frame.pixels.size() / rows;
        for (std::size_t i = frame.pixels.size() - std::min<std::size_t>(4, rows) * row;
             i < frame.pixels.size(); ++i)
            frame.pixels[i] = (i % row) * maps.size() < (frames.size() + 1) * row ? 60 : 200;
        frames.push_back(std::move(frame));
    }
    return frames;
}

}  // namespace

UnityFilms unity_films(const JudgedView& view, const MethodMap& shown) {
    std::vector<Image<float>> radii, counts, seeds;
    for (int i = 1; i <= 12; ++i)
        radii.push_back(view.map("unity", {"radius=" + decimal_text(0.1 * i, 1)}).raw.ao);
    for (int count = 4; count <= 64; count *= 2)
        counts.push_back(view.map("unity", {"samples=" + std::to_string(count)}).raw.ao);
    UnitySettings drawn = shown.settings.ao.as<UnitySettings>();
    drawn.samples = 16;
    for (drawn.seed = 1; drawn.seed <= 8; ++drawn.seed)
        seeds.push_back(unity_ao(shown.raw.inputs, drawn, {}).ao);
    return {with_slider(radii), with_slider(counts), with_slider(seeds)};
}

}  // namespace crevice
