#include "chapters/notebook/terminal_picture.h"

#include <algorithm>
#include <array>

namespace crevice {

namespace {

using Colour = std::array<int, 3>;

// The mean over [x0, x1) x [y0, y1).
Colour mean_colour(const Picture& picture, int x0, int x1, int y0, int y1) {
    std::array<long long, 3> sum{};
    for (int y = y0; y < y1; ++y) {
        for (int x = x0; x < x1; ++x) {
            const std::size_t pixel =
                static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.size.width) +
                static_cast<std::size_t>(x);
            for (std::size_t c = 0; c < 3; ++c)
                sum[c] += picture.pixels[picture.channels == 1 ? pixel : 3 * pixel + c];
        }
    }
    const long long count = static_cast<long long>(x1 - x0) * (y1 - y0);
    return {static_cast<int>(sum[0] / count), static_cast<int>(sum[1] / count),
            static_cast<int>(sum[2] / count)};
}

std::string colour_code(const char* ground, const Colour& colour) {
    return std::string("\033[") + ground + ";2;" + std::to_string(colour[0]) + ";" +
           std::to_string(colour[1]) + ";" + std::to_string(colour[2]) + "m";
}

}  // namespace

std::string terminal_picture(const Picture& picture, int columns) {
    const int width = std::clamp(columns, 1, picture.size.width);
    const int height = std::max(1, picture.size.height * width / picture.size.width);
    // The pixels that one half of a character covers: never none.
    const auto range = [](int i, int count, int extent) {
        const int begin = i * extent / count;
        return std::array<int, 2>{begin, std::max(begin + 1, (i + 1) * extent / count)};
    };
    std::string text;
    for (int y = 0; y < height; y += 2) {
        const auto upper = range(y, height, picture.size.height);
        const auto lower = range(std::min(y + 1, height - 1), height, picture.size.height);
        for (int x = 0; x < width; ++x) {
            const auto across = range(x, width, picture.size.width);
            text += colour_code("38", mean_colour(picture, across[0], across[1], upper[0], upper[1]));
            text += colour_code("48", mean_colour(picture, across[0], across[1], lower[0], lower[1]));
            text += "▀";
        }
        text += "\033[0m\n";
    }
    return text;
}

}  // namespace crevice
