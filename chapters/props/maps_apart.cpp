#include "chapters/props/maps_apart.h"

#include <cstdint>

#include "chapters/terminal/number_text.h"

namespace crevice {

std::string bits_of(float value) {
    std::string digits(8, '0');
    auto rest = static_cast<std::uint32_t>(float_bits(value));
    for (std::size_t i = digits.size(); i-- > 0; rest >>= 4) digits[i] = "0123456789abcdef"[rest & 15];
    return digits;
}

MapsApart maps_apart(const OcclusionMaps& a, const OcclusionMaps& b) {
    return {bits_apart(a.sum, b.sum), bits_apart(a.ao, b.ao)};
}

std::vector<std::string> apart_row(const std::string& what, const MapsApart& apart) {
    return {what, std::to_string(apart.sum.texels), std::to_string(apart.ao.texels),
            significant_text(static_cast<double>(apart.ao.most), 2)};
}

Picture apart_picture(const MapsApart& apart) { return grey_picture(apart.sum.steps, 0, 4); }

}  // namespace crevice
