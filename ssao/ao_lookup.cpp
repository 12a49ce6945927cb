#include "ssao/ao_lookup.h"

#include <algorithm>

namespace crevice {

Image<float> looked_up(Image<float> ao, AoLookup lookup) {
    if (lookup != AoLookup::slip_clamp) return ao;
    for (int y = 1; y < ao.size.height; ++y) std::copy_n(ao.row(0), ao.size.width, ao.row(y));
    return ao;
}

}  // namespace crevice
