#include "ssao/rays/hemisphere_directions.h"

#include "rasterizer/base/image.h"
#include "ssao/inputs/random_vectors.h"

namespace crevice {

SquarePoints::SquarePoints(int count, RaySequence sequence)
    : count_(count), sequence_(sequence), second_(static_cast<std::size_t>(round_up(count, kPointGroup))) {
    for (std::uint32_t i = 0; i < second_.size(); ++i) {
        // Sobol's direction numbers of the second coordinate are Pascal's triangle modulo 2.
        std::uint32_t direction = 1;
        for (std::uint32_t index = i; index != 0; index >>= 1, direction ^= direction << 1) {
            if ((index & 1) != 0) second_[i] ^= direction;
        }
    }
}

std::uint32_t SquarePoints::scramble_seed(std::uint32_t seed, std::uint32_t stream,
                                          std::uint32_t coordinate) {
    // Scrambling takes the first digit from the lowest bit alone, which hash_of leaves alike in neighbouring
    // streams.
    return mixed_bits(crevice::hash_of(seed, stream, coordinate));
}

}  // namespace crevice
