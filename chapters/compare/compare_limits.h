// How far two images may be apart and still pass `crevice compare`.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "ssao/judge/metrics.h"

namespace crevice {

// Of one pair. What is not set is not asked; with nothing set the two must have the same bits.
struct CompareLimits {
    std::optional<double> max_abs = {};        // [0, ~] ImageError::max_abs at most
    std::optional<double> rmse = {};           // [0, ~] ImageError::rmse at most
    std::optional<double> flip = {};           // [0, 1] mean FLIP at most
    std::optional<double> ssim = {};           // [-1, 1] ImageError::ssim at least
    std::optional<long long> max_pixels = {};  // [0, ~] ImageError::differing_pixels at most

    bool any() const { return max_abs || rmse || flip || ssim || max_pixels; }
};

// Limits of each buffer. In a file:
//   {"limits": {"ao_raw": {"max_abs": 1e-6}, "lit": {"flip": 0.02, "max_pixels": 40}}, "default": {"rmse": 0.001}}
struct LimitsOfBuffers {
    CompareLimits otherwise;                     // of buffers that are not named
    std::map<std::string, CompareLimits> named;  // by the file's name without its ending

    const CompareLimits& of(const std::string& buffer) const;
    bool any() const { return otherwise.any() || !named.empty(); }
};

// The name of the file beside goldens that is read without being asked for.
inline constexpr const char* kLimitsFile = "limits.json";

// `otherwise` stands where the file has no "default". Throws InputError "FILE:line: what is wrong (value); what to do".
LimitsOfBuffers limits_from_text(const std::string& text, const std::string& file,
                                 const CompareLimits& otherwise);

// Those limits that a pair exceeds, each as a line such as "RMSE 0.02, limit 0.001"; none: it passes. A NaN exceeds every
// limit. `flip` is the mean, NaN where it was not asked for.
std::vector<std::string> exceeded_limits(const CompareLimits& limits, const ImageError& error, double flip);

}  // namespace crevice
