#include "ssao/judge/fitted_power.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "rasterizer/base/error.h"
#include "rasterizer/lanes/approx_math.h"
#include "ssao/judge/metrics.h"

namespace crevice {

namespace {

// One counted pixel: a^g is exp(g log_image).
struct Sample {
    double log_image;  // -inf where a is 0
    double reference;
};

void append_samples(std::vector<Sample>& samples, const PowerExample& example) {
    check_same_size(example.image, example.reference);
    if (example.counted.size != example.image.size)
        throw InputError("a mask of another size than its image; make it for this image");
    for (int y = 0; y < example.image.size.height; ++y) {
        for (int x = 0; x < example.image.size.width; ++x) {
            if (example.counted.at(x, y) == 0) continue;
            const double a = example.image.at(x, y), r = example.reference.at(x, y);
            if (!std::isfinite(a) || !std::isfinite(r)) {
                throw InputError("no exponent can be fitted to a NaN or infinity (pixel " +
                                 std::to_string(x) + ", " + std::to_string(y) +
                                 "); mend the image or the reference first");
            }
            samples.push_back({std::log(std::clamp(a, 0.0, 1.0)), r});
        }
    }
}

double mean_square(const std::vector<Sample>& samples, double exponent) {
    double sum = 0;
    for (const Sample& sample : samples) {
        const double off = std::exp(exponent * sample.log_image) - sample.reference;
        sum += off * off;
    }
    return sum / static_cast<double>(samples.size());
}

// Where `value_at` is smallest between low and high, if it has one minimum there.
template <class ValueAt>
double golden_section(double low, double high, double tolerance, ValueAt value_at) {
    const double share = (std::sqrt(5.0) - 1) / 2;
    double left = high - share * (high - low), right = low + share * (high - low);
    double at_left = value_at(left), at_right = value_at(right);
    while (high - low > tolerance) {
        if (at_left <= at_right) {
            high = right;
            right = left;
            at_right = at_left;
            left = high - share * (high - low);
            at_left = value_at(left);
        } else {
            low = left;
            left = right;
            at_left = at_right;
            right = low + share * (high - low);
            at_right = value_at(right);
        }
    }
    return 0.5 * (low + high);
}

}  // namespace

FittedPower fitted_power(std::span<const PowerExample> examples) {
    std::vector<Sample> samples;
    for (const PowerExample& example : examples) append_samples(samples, example);
    if (samples.empty())
        throw UsageError("no exponent can be fitted to 0 pixels; give an image with pixels that count");
    const auto square_at = [&](double log_exponent) { return mean_square(samples, std::exp(log_exponent)); };

    constexpr int kSteps = 20;  // on either side of exponent 1
    const double step = std::log(kHighestExponent) / kSteps;
    int best = 0;
    double smallest = mean_square(samples, 1);
    FittedPower fitted{1, std::sqrt(smallest), std::sqrt(smallest), false};
    for (int i = -kSteps; i <= kSteps; ++i) {
        const double square = square_at(i * step);
        if (square < smallest) {
            smallest = square;
            best = i;
        }
    }
    fitted.at_bound = best == -kSteps || best == kSteps;
    const double log_exponent =
        fitted.at_bound ? best * step : golden_section((best - 1) * step, (best + 1) * step, 1e-6, square_at);
    const double square = square_at(log_exponent);
    if (square < fitted.rmse_before * fitted.rmse_before) {
        fitted.exponent = std::exp(log_exponent);
        fitted.rmse = std::sqrt(square);
    }
    return fitted;
}

Image<float> to_power(const Image<float>& image, double exponent) {
    Image<float> result = image;
    for (float& value : result.pixels) value = power(saturate(value), static_cast<float>(exponent));
    return result;
}

}  // namespace crevice
