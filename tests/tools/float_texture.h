// A texture as it would be if nothing were rounded but floats: what a stored one is held against.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include <glm/vec4.hpp>

#include "rasterizer/base/image.h"
#include "rasterizer/textures/sampler.h"

namespace crevice {

class FloatTexture {
 public:
    static constexpr float kOne = 1;

    // Alpha is 1 where there is none.
    FloatTexture(const Image3& base, const Image<float>& alpha) {
        Level level{base.size(), {}};
        for (int y = 0; y < level.size.height; ++y) {
            for (int x = 0; x < level.size.width; ++x)
                level.texels.emplace_back(base.at(x, y), alpha.empty() ? 1.0f : alpha.at(x, y));
        }
        levels_.push_back(level);
        while (levels_.back().size != Size{1, 1}) levels_.push_back(below(levels_.back()));
    }

    std::size_t level_count() const { return levels_.size(); }
    Size size(std::size_t level) const { return levels_[level].size; }
    glm::vec4 texel(std::size_t level, int x, int y) const { return levels_[level].at(x, y); }
    glm::vec4 border(const Sampler& sampler) const { return sampler.border; }

 private:
    struct Level {
        Size size;
        std::vector<glm::vec4> texels;
        glm::vec4 at(int x, int y) const { return texels[static_cast<std::size_t>(y * size.width + x)]; }
    };

    // How much of pixel `above` of `from` lies in pixel `i` of `to`, as a part of the latter.
    static double share(int above, int from, int i, int to) {
        const double low = static_cast<double>(i) * from / to, high = (i + 1.0) * from / to;
        return std::max(0.0, std::min(high, above + 1.0) - std::max(low, static_cast<double>(above))) * to /
               from;
    }
    static Level below(const Level& above) {
        Level level{{std::max(1, above.size.width / 2), std::max(1, above.size.height / 2)}, {}};
        const auto first = [](int i, int from, int to) { return i * from / to; };
        for (int y = 0; y < level.size.height; ++y) {
            for (int x = 0; x < level.size.width; ++x) {
                glm::dvec4 mean(0);
                const int left = first(x, above.size.width, level.size.width),
                          top = first(y, above.size.height, level.size.height);
                for (int row = top; row < std::min(top + 3, above.size.height); ++row) {
                    for (int column = left; column < std::min(left + 3, above.size.width); ++column) {
                        mean += share(column, above.size.width, x, level.size.width) *
                                share(row, above.size.height, y, level.size.height) *
                                glm::dvec4(above.at(column, row));
                    }
                }
                level.texels.emplace_back(mean);
            }
        }
        return level;
    }

    std::vector<Level> levels_;
};

}  // namespace crevice
