#include "chapters/props/neighbour_likeness.h"

#include "chapters/props/switched_ao.h"

namespace crevice {

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

BandsAndGrain bands_and_grain(const AoInputs& inputs, const LunaSettings& settings, const Image<float>& limit,
                              std::uint32_t first_seed, int seeds) {
    LunaSettings turned = settings, unturned = settings;
    unturned.random_vectors = RandomVectors::none;
    const auto likeness = [&](const LunaSettings& drawn) {
        return likeness_of_neighbours(difference_of(luna_occlusion(inputs, drawn, {}).ao, limit));
    };
    BandsAndGrain result;
    for (int i = 0; i < seeds; ++i) {
        turned.seed = unturned.seed = first_seed + static_cast<std::uint32_t>(i);
        const double of_bands = likeness(unturned), of_grain = likeness(turned);
        result.bands += of_bands / seeds;
        result.grain += of_grain / seeds;
        result.more_alike_in_bands += of_bands > of_grain ? 1 : 0;
    }
    return result;
}

}  // namespace crevice
