// Numbers as JSON holds them.
#pragma once

#include <cmath>

#include <glm/vec3.hpp>
#include <nlohmann/json.hpp>

#include "rasterizer/base/float_text.h"

namespace crevice {

// A double that is written with the fewest digits of the float, where they lead back to it; null for infinities and NaN,
// which JSON knows none of.
inline nlohmann::ordered_json json_number(float value) {
    if (!std::isfinite(value)) return nullptr;
    const std::string text = shortest_text(value);
    double short_one = 0;
    number_from_text(text.data(), text.data() + text.size(), short_one);
    return static_cast<float>(short_one) == value ? short_one : static_cast<double>(value);
}
inline nlohmann::ordered_json json_number(double value) {
    if (!std::isfinite(value)) return nullptr;
    return value;
}

inline nlohmann::ordered_json json_numbers(const glm::vec3& v) {
    return nlohmann::ordered_json::array({json_number(v.x), json_number(v.y), json_number(v.z)});
}
inline nlohmann::ordered_json json_numbers(const glm::dvec3& v) {
    return nlohmann::ordered_json::array({v.x, v.y, v.z});
}

}  // namespace crevice
