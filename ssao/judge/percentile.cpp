#include "ssao/judge/percentile.h"

#include <algorithm>
#include <string>

#include "rasterizer/base/error.h"

namespace crevice {

double percentile(std::vector<double> values, int percent) {
    if (values.empty() || percent < 1 || percent > 100) {
        throw UsageError("no percentile " + std::to_string(percent) + " of " + std::to_string(values.size()) +
                         " values; ask for 1 to 100 of at least one value");
    }
    const std::size_t rank = (values.size() * static_cast<std::size_t>(percent) + 99) / 100;
    const auto at = values.begin() + static_cast<std::ptrdiff_t>(rank - 1);
    std::nth_element(values.begin(), at, values.end());
    return *at;
}

}  // namespace crevice
