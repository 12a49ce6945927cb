#include "chapters/diagrams/float_line.h"

#include <algorithm>
#include <bit>
#include <cstdint>

#include "chapters/notebook/svg.h"
#include "chapters/terminal/number_text.h"

namespace crevice {

std::string float_line(float first, const std::string& first_name, float second,
                       const std::string& second_name, const std::string& title) {
    constexpr double kWidth = 600, kLeft = 30, kRight = 570, kLine = 110, kHeight = 170;  // SVG units
    constexpr int kAround = 3;  // floats to either side
    const auto a = std::bit_cast<std::int32_t>(first), b = std::bit_cast<std::int32_t>(second);
    const std::int32_t low = std::min(a, b) - kAround, high = std::max(a, b) + kAround;
    const auto x_of = [&](std::int32_t bits) {
        return kLeft + (kRight - kLeft) * static_cast<double>(bits - low) / static_cast<double>(high - low);
    };
    std::string svg = svg_line({kLeft, kLine}, {kRight, kLine}, kSvgInk);
    for (std::int32_t bits = low; bits <= high; ++bits)
        svg += svg_line({x_of(bits), kLine - 6}, {x_of(bits), kLine + 6}, kSvgSoft);
    const auto marked = [&](std::int32_t bits, float value, const std::string& name, double y,
                            std::string_view colour) {
        return svg_line({x_of(bits), kLine}, {x_of(bits), y > kLine ? y - 14 : y + 6}, colour) +
               svg_dot({x_of(bits), kLine}, 5, colour) +
               svg_text({x_of(bits), y}, name + ": " + decimal_text(static_cast<double>(value), 9),
                        TextAnchor::middle, colour);
    };
    svg += marked(a, first, first_name, kLine - 48, kSvgOpen) +
           marked(b, second, second_name, kLine + 44, kSvgOccluded);
    return svg_picture(title, kWidth, kHeight, svg);
}

}  // namespace crevice
