#include "chapters/props/vbao_slices.h"

#include <bit>
#include <cstdint>

#include "chapters/props/number_words.h"
#include "ssao/methods/slices.h"

namespace crevice {
namespace {

std::string bits(std::uint32_t mask) {
    std::string word;
    for (int k = 0; k < 32; ++k) word += ((mask >> k) & 1u) != 0 ? '1' : '0';
    return word;
}

}  // namespace

Texel shaded_texel(const Image<float>& ao) {
    constexpr int kNear = 4;
    const Texel followed = followed_texel(ao.size);
    Texel darkest = followed;
    if (ao.at(followed.x, followed.y) < 1) return followed;
    for (int y = followed.y - kNear; y <= followed.y + kNear; ++y) {
        for (int x = followed.x - kNear; x <= followed.x + kNear; ++x) {
            if (ao.at(x, y) < ao.at(darkest.x, darkest.y)) darkest = {x, y};
        }
    }
    return darkest;
}

std::vector<SliceSectors> sectors_of_texel(const AoInputs& inputs, const VbaoSettings& settings, Texel at) {
    std::vector<SliceSectors> slices;
    const int count = slice_plan(settings.samples).slices;
    for (int i = 0; i < count; ++i) slices.push_back(slice_sectors(inputs, settings, at.x, at.y, i));
    return slices;
}

std::vector<std::vector<std::string>> sector_rows(const std::vector<SliceSectors>& slices) {
    std::vector<std::vector<std::string>> rows;
    for (const SliceSectors& slice : slices) {
        rows.push_back({std::to_string(rows.size() + 1), bits(slice.closed),
                        std::to_string(std::popcount(slice.closed)), text(slice.lost)});
    }
    return rows;
}

}  // namespace crevice
