#include "ssao/methods/settings_range.h"

#include <cmath>
#include <sstream>
#include <string>

#include "rasterizer/base/error.h"

namespace crevice {

namespace {

void require(bool holds, const char* member, double value, const std::string& range) {
    if (holds) return;
    std::ostringstream text;
    text << member << ": must lie in " << range << " (" << value << "); choose another value";
    throw UsageError(text.str());
}

}  // namespace

void require_length(const char* member, double value) {
    require(value >= 0 && std::isfinite(value), member, value, "[0, inf)");
}

void require_radius(double value) { require_within("radius", value, 0, kLargestRadius); }

void require_within(const char* member, double value, double lowest, double highest) {
    std::ostringstream range;
    range << "[" << lowest << ", " << highest << "]";
    // As members are: 89.9 as a float is a little more than 89.9.
    const bool holds = static_cast<float>(value) >= static_cast<float>(lowest) &&
                       static_cast<float>(value) <= static_cast<float>(highest);
    require(holds, member, value, range.str());
}

}  // namespace crevice
