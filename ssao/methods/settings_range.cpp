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

void require_within(const char* member, double value, double lowest, double highest) {
    std::ostringstream range;
    range << "[" << lowest << ", " << highest << "]";
    require(value >= lowest && value <= highest, member, value, range.str());
}

}  // namespace crevice
