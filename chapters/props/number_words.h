// Numbers as the chapters' texts show them: three digits after the point.
#pragma once

#include <string>

#include <glm/vec3.hpp>

#include "chapters/terminal/number_text.h"
#include "rasterizer/lanes/vec3.h"

namespace crevice {

inline std::string text(float value) { return decimal_text(static_cast<double>(value), 3); }
inline std::string text(glm::vec3 v) { return text(v.x) + ", " + text(v.y) + ", " + text(v.z); }
inline std::string text(Vec3<float> v) { return text(v.x) + ", " + text(v.y) + ", " + text(v.z); }

}  // namespace crevice
