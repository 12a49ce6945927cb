#include "chapters/props/neighbour_likeness.h"

#include <cmath>

#include "ssao/judge/metrics.h"
#include "ssao/methods/luna_occlusion.h"

namespace crevice {
namespace {

double mean_square(const Image<float>& a, const Image<float>& b) {
    const double rmse = compare_images(a, b).rmse;
    return rmse * rmse;
}

}  // namespace

double likeness_of_neighbours(const Image<float>& error) {
    double product = 0, square = 0;
    for (int y = 0; y < error.size.height; ++y) {
        for (int x = 0; x + 1 < error.size.width; ++x) {
            const double own = error.at(x, y), next = error.at(x + 1, y);
            product += own * next;
            square += own * own;
        }
    }
    return product / square;
}

BandsAndGrain bands_and_grain(const SwitchedAo& shown, const Image<float>& limit, std::uint32_t first_seed,
                              int seeds) {
    LunaSettings turned = shown.settings, unturned = shown.settings;
    unturned.random_vectors = RandomVectors::none;
    const Image<float> limit_blurred = bilateral_blur(limit, shown.inputs, shown.blur).ao;
    // Squares until all seeds are there.
    const auto add = [&](MapErrors& errors, const LunaSettings& drawn) {
        const Image<float> map = luna_occlusion(shown.inputs, drawn, {}).ao;
        const double likeness = likeness_of_neighbours(difference_of(map, limit));
        errors.likeness += likeness / seeds;
        errors.raw += mean_square(map, limit) / seeds;
        errors.blurred +=
            mean_square(bilateral_blur(map, shown.inputs, shown.blur).ao, limit_blurred) / seeds;
        return likeness;
    };
    BandsAndGrain result;
    for (int i = 0; i < seeds; ++i) {
        turned.seed = unturned.seed = first_seed + static_cast<std::uint32_t>(i);
        if (add(result.bands, unturned) > add(result.grain, turned)) ++result.more_alike_in_bands;
    }
    for (MapErrors* const errors : {&result.bands, &result.grain}) {
        errors->raw = std::sqrt(errors->raw);
        errors->blurred = std::sqrt(errors->blurred);
    }
    return result;
}

}  // namespace crevice
