#include "ssao/judge/reference_error.h"

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "rasterizer/base/error.h"
#include "ssao/judge/flip.h"
#include "ssao/judge/metrics.h"
#include "ssao/judge/percentile.h"

namespace crevice {

namespace {

// Sums of one quantity, block by block.
class BlockSums {
 public:
    explicit BlockSums(Size size)
        : columns_((size.width + kErrorBlock_px - 1) / kErrorBlock_px),
          blocks_(static_cast<std::size_t>(columns_) *
                  static_cast<std::size_t>((size.height + kErrorBlock_px - 1) / kErrorBlock_px)) {}

    void add(int x, int y, double value) {
        Block& block = blocks_[static_cast<std::size_t>(y / kErrorBlock_px * columns_ + x / kErrorBlock_px)];
        block.sum += value;
        ++block.count;
    }

    DebiasedSquare mean_and_error() const {
        Block total;
        int used = 0;
        for (const Block& block : blocks_) {
            total.sum += block.sum;
            total.count += block.count;
            used += block.count > 0;
        }
        if (used == 0) return {};
        const double n = static_cast<double>(total.count), mean = total.sum / n;
        if (used == 1) return {mean, std::numeric_limits<double>::infinity()};
        double squares = 0;
        for (const Block& block : blocks_) {
            const double off = block.sum - mean * static_cast<double>(block.count);
            squares += off * off;
        }
        return {mean, std::sqrt(squares * used / (used - 1)) / n};
    }

 private:
    struct Block {
        double sum = 0;
        long long count = 0;
    };
    int columns_;
    std::vector<Block> blocks_;
};

// The values of one pixel.
struct PixelValues {
    double a, r1, r2, standard_error;

    double r() const { return 0.5 * (r1 + r2); }
    double debiased_square() const { return (a - r1) * (a - r2); }
    bool finite() const {
        return std::isfinite(a) && std::isfinite(r1) && std::isfinite(r2) && std::isfinite(standard_error);
    }
};

PixelValues values_at(const Image<float>& image, const ReferenceImage& reference, int x, int y) {
    const auto at = [=](const Image<float>& from) { return static_cast<double>(from.at(x, y)); };
    return {at(image), at(reference.half[0]), at(reference.half[1]), at(reference.error)};
}

// The same, for functions that have no number to give where one value is not finite.
PixelValues finite_values_at(const Image<float>& image, const ReferenceImage& reference, int x, int y) {
    const PixelValues values = values_at(image, reference, x, y);
    if (values.finite()) return values;
    throw InputError("errors cannot be compared at a NaN or infinity (pixel " + std::to_string(x) + ", " +
                     std::to_string(y) + "); mend the image or the reference first");
}

// What one region's numbers are made of.
class RegionSums {
 public:
    explicit RegionSums(Size size) : squares_(size) {}

    void add(int x, int y, const PixelValues& at) {
        ++error_.pixels;
        if (!at.finite()) {
            ++error_.nan_or_inf;
            return;
        }
        const double r = at.r(), off = at.a - r;
        error_.bias += off;
        error_.mae += std::fabs(off);
        error_.rmse_raw += off * off;
        error_.rel_mse += off * off / (r * r + 0.01);
        error_.reference_error += at.standard_error * at.standard_error;
        squares_.add(x, y, at.debiased_square());
        magnitudes_.push_back(std::fabs(off));
    }

    RegionError means() && {
        if (magnitudes_.empty()) return error_;
        const double n = static_cast<double>(magnitudes_.size());
        RegionError mean = error_;
        mean.bias /= n;
        mean.mae /= n;
        mean.rmse_raw = std::sqrt(mean.rmse_raw / n);
        mean.rel_mse /= n;
        mean.reference_error = std::sqrt(mean.reference_error / n);
        mean.squared = squares_.mean_and_error();
        mean.p50 = percentile(magnitudes_, 50);
        mean.p95 = percentile(magnitudes_, 95);
        mean.p99 = percentile(magnitudes_, 99);
        mean.max_abs = percentile(std::move(magnitudes_), 100);
        return mean;
    }

 private:
    RegionError error_;  // sums in the places of their means
    BlockSums squares_;
    std::vector<double> magnitudes_;
};

void check_sizes(const Image<float>& image, const ReferenceImage& reference,
                 const Image<SurfaceKind>& kinds) {
    for (const Image<float>* plane :
         {&reference.mean, &reference.half[0], &reference.half[1], &reference.error})
        check_same_size(image, *plane);
    if (kinds.size == image.size) return;
    throw InputError("kinds of place for another size (" + std::to_string(kinds.size.width) + "x" +
                     std::to_string(kinds.size.height) + " for an image of " +
                     std::to_string(image.size.width) + "x" + std::to_string(image.size.height) +
                     "); make them from a G-buffer of the image's size");
}

}  // namespace

ReferenceError reference_error(const Image<float>& image, const ReferenceImage& reference,
                               const Image<SurfaceKind>& kinds) {
    check_sizes(image, reference, kinds);
    std::vector<RegionSums> sums(std::size(kRegions), RegionSums(image.size));
    for (int y = 0; y < image.size.height; ++y) {
        for (int x = 0; x < image.size.width; ++x) {
            const PixelValues at = values_at(image, reference, x, y);
            for (const Region region : kRegions) {
                if (contains(region, kinds.at(x, y))) sums[static_cast<std::size_t>(region)].add(x, y, at);
            }
        }
    }
    ReferenceError error;
    for (std::size_t i = 0; i < sums.size(); ++i) error.regions[i] = std::move(sums[i]).means();
    error.ssim = compare_images(image, reference.mean).ssim;
    if (!error.failed()) {
        const Flip seen = flip(displayed(image), displayed(reference.mean));
        error.flip_mean = seen.mean;
        error.flip_p99 = seen.p99;
    }
    return error;
}

MeanError mean_error(const Image<float>& image, const ReferenceImage& reference,
                     const Image<SurfaceKind>& kinds, Region region) {
    check_sizes(image, reference, kinds);
    BlockSums biases(image.size), squares(image.size);
    for (int y = 0; y < image.size.height; ++y) {
        for (int x = 0; x < image.size.width; ++x) {
            if (!contains(region, kinds.at(x, y))) continue;
            const PixelValues at = finite_values_at(image, reference, x, y);
            biases.add(x, y, at.a - at.r());
            squares.add(x, y, at.debiased_square());
        }
    }
    return {biases.mean_and_error().mean, squares.mean_and_error()};
}

MseDifference mse_difference(const Image<float>& a, const Image<float>& b, const ReferenceImage& reference,
                             const Image<SurfaceKind>& kinds, Region region) {
    check_sizes(a, reference, kinds);
    check_same_size(a, b);
    BlockSums differences(a.size);
    for (int y = 0; y < a.size.height; ++y) {
        for (int x = 0; x < a.size.width; ++x) {
            if (!contains(region, kinds.at(x, y))) continue;
            differences.add(x, y,
                            finite_values_at(a, reference, x, y).debiased_square() -
                                finite_values_at(b, reference, x, y).debiased_square());
        }
    }
    const DebiasedSquare found = differences.mean_and_error();
    return {found.mean, found.error};
}

}  // namespace crevice
