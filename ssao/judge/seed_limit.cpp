#include "ssao/judge/seed_limit.h"

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "rasterizer/base/error.h"
#include "rasterizer/base/parallel.h"
#include "rasterizer/lanes/approx_math.h"
#include "ssao/rays/ray_cast_ao.h"

namespace crevice {

namespace {

// Sums of one replicate, before the exponent, as the image's pixels.
using ReplicateSums = std::vector<double>;

float with_exponent(double accessibility, float exponent) {
    return saturate(power(static_cast<float>(accessibility), exponent));
}

// How far the power of a mean is off when the mean is off by `error`: by the derivative.
float error_with_exponent(const AoEstimate& before, float exponent) {
    const float slope = exponent * power(before.mean, exponent - 1);
    return before.error * slope;
}

}  // namespace

ReferenceImage seed_limit(const Image<float>& view_depth, float exponent, int seeds, const Run& run,
                          const std::function<void(long long)>& on_progress,
                          const std::function<Image<float>(std::uint32_t seed)>& map_of) {
    if (seeds < kReplicates || seeds > 1 << 20)
        throw UsageError("seeds: must lie in " + std::to_string(kReplicates) + "..1048576 (" +
                         std::to_string(seeds) + "); choose another number");
    const int of_replicate = (seeds + kReplicates - 1) / kReplicates;
    const Size size = view_depth.size;
    std::array<ReplicateSums, kReplicates> sums;
    for (int replicate = 0; replicate < kReplicates; ++replicate) {
        ReplicateSums& sum = sums[static_cast<std::size_t>(replicate)];
        for (int i = 0; i < of_replicate; ++i) {
            const Image<float> ao =
                map_of(kFirstLimitSeed + static_cast<std::uint32_t>(replicate * of_replicate + i));
            if (sum.empty()) sum.assign(ao.pixels.size(), 0);
            for (std::size_t k = 0; k < sum.size(); ++k) sum[k] += static_cast<double>(ao.pixels[k]);
            if (on_progress) on_progress(1);
        }
    }
    ReferenceImage limit{
        Image<float>(size, 1), Image<float>(size, 0), {Image<float>(size, 1), Image<float>(size, 1)}};
    parallel_rows(size.height, run, [&](int first_row, int end_row) {
        for (int y = first_row; y < end_row; ++y) {
            for (int x = 0; x < size.width; ++x) {
                if (view_depth.at(x, y) == std::numeric_limits<float>::infinity()) continue;
                const auto at = static_cast<std::size_t>(limit.mean.row(y) + x - limit.mean.pixels.data());
                std::array<double, kReplicates> means;
                for (std::size_t i = 0; i < kReplicates; ++i) means[i] = sums[i][at] / of_replicate;
                const AoEstimate before = estimate_of(means);
                limit.mean.at(x, y) = with_exponent(before.mean, exponent);
                limit.error.at(x, y) = error_with_exponent(before, exponent);
                for (std::size_t i = 0; i < 2; ++i)
                    limit.half[i].at(x, y) = with_exponent(before.half[i], exponent);
            }
        }
    });
    return limit;
}

}  // namespace crevice
