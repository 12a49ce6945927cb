#include "ssao/judge/error_parts.h"

#include <cmath>
#include <stdexcept>

#include "rasterizer/base/error.h"
#include "rasterizer/base/float_text.h"
#include "ssao/judge/metrics.h"

namespace crevice {

namespace {

const Image<float>& second_half(const ChainImage& image) {
    return image.second.empty() ? image.first : image.second;
}

void check_finite(const Image<float>& image, const std::string& step) {
    for (int y = 0; y < image.size.height; ++y) {
        for (int x = 0; x < image.size.width; ++x) {
            if (std::isfinite(image.at(x, y))) continue;
            throw InputError("the image of step \"" + step + "\" is not finite at pixel " +
                             std::to_string(x) + ", " + std::to_string(y) + " (" +
                             shortest_text(image.at(x, y)) +
                             "); its error has no parts until that is mended");
        }
    }
}

void check_chain(std::span<const ChainImage> chain) {
    if (chain.size() < 2)
        throw InputError("a chain of " + std::to_string(chain.size()) +
                         " images has no steps; give the truth and at least one more");
    for (const ChainImage& image : chain) {
        check_same_size(chain[0].first, image.first);
        check_same_size(chain[0].first, second_half(image));
        check_finite(image.first, image.step);
        check_finite(second_half(image), image.step);
    }
}

// What one image is more than another at one pixel, in both halves.
struct Change {
    double first = 0, second = 0;

    double mean() const { return 0.5 * (first + second); }
};
Change change_at(const ChainImage& before, const ChainImage& after, int x, int y) {
    const auto at = [=](const Image<float>& image) { return static_cast<double>(image.at(x, y)); };
    return {at(after.first) - at(before.first), at(second_half(after)) - at(second_half(before))};
}

// A sum over pixels and the sum of their magnitudes. Rows are summed first, so that rounding grows with the
// picture's sides and not with its area.
struct CheckedSum {
    double value = 0, magnitude = 0;

    void add(double term) {
        value += term;
        magnitude += std::fabs(term);
    }
    void add(const CheckedSum& row) {
        value += row.value;
        magnitude += row.magnitude;
    }
};
struct PartSums {
    CheckedSum bias, square, share;

    void add(const PartSums& row) {
        bias.add(row.bias);
        square.add(row.square);
        share.add(row.share);
    }
};

PartSums sums_of(const ChainImage& before, const ChainImage& after, std::span<const ChainImage> chain,
                 const Image<std::uint8_t>& counted) {
    PartSums sums;
    for (int y = 0; y < counted.size.height; ++y) {
        PartSums row;
        for (int x = 0; x < counted.size.width; ++x) {
            if (counted.at(x, y) == 0) continue;
            const Change part = change_at(before, after, x, y);
            const Change total = change_at(chain.front(), chain.back(), x, y);
            row.bias.add(part.mean());
            row.square.add(part.first * part.second);
            row.share.add(0.5 * (part.first * total.second + part.second * total.first));
        }
        sums.add(row);
    }
    return sums;
}

ErrorPart part_of(const std::string& step, const PartSums& sums, double pixels) {
    const double mse = sums.square.value / pixels;
    return {step, sums.bias.value / pixels, mse, mse > 0 ? std::sqrt(mse) : 0, sums.share.value / pixels, {}};
}

Image<float> difference_of(const ChainImage& before, const ChainImage& after) {
    Image<float> difference(before.first.size, 0.0f);
    for (int y = 0; y < difference.size.height; ++y) {
        for (int x = 0; x < difference.size.width; ++x)
            difference.at(x, y) = static_cast<float>(change_at(before, after, x, y).mean());
    }
    return difference;
}

void check_adds_up(const char* what, const CheckedSum& parts, const CheckedSum& total) {
    const double off = std::fabs(parts.value - total.value);
    if (off <= 1e-12 * (parts.magnitude + total.magnitude)) return;
    throw std::logic_error(std::string("the parts of an error do not add up to it (") + what + " off by " +
                           shortest_text(off) + ")");
}

}  // namespace

ErrorParts error_parts(std::span<const ChainImage> chain, const Image<std::uint8_t>& counted) {
    check_chain(chain);
    if (counted.size != chain[0].first.size)
        throw InputError("a mask of another size than the chain's images; make it for these images");
    ErrorParts result;
    for (int y = 0; y < counted.size.height; ++y) {
        for (int x = 0; x < counted.size.width; ++x) result.pixels += counted.at(x, y) != 0;
    }
    if (result.pixels == 0)
        throw InputError("no pixel counts (0 of the mask); give a mask with pixels, or none");
    const double pixels = static_cast<double>(result.pixels);
    PartSums all;
    for (std::size_t i = 1; i < chain.size(); ++i) {
        const PartSums sums = sums_of(chain[i - 1], chain[i], chain, counted);
        result.parts.push_back(part_of(chain[i].step, sums, pixels));
        result.parts.back().difference = difference_of(chain[i - 1], chain[i]);
        all.add(sums);
    }
    const PartSums total = sums_of(chain.front(), chain.back(), chain, counted);
    check_adds_up("bias", all.bias, total.bias);
    check_adds_up("squared error", all.share, total.square);
    result.total = part_of("", total, pixels);
    result.total.difference = difference_of(chain.front(), chain.back());
    return result;
}

ErrorParts error_parts(std::span<const ChainImage> chain) {
    check_chain(chain);
    return error_parts(chain, Image<std::uint8_t>(chain[0].first.size, 1));
}

}  // namespace crevice
