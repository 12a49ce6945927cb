#include "rasterizer/base/hash.h"

#include <algorithm>
#include <array>

#include <doctest/doctest.h>

using namespace crevice;

TEST_CASE("hash: every input bit changes every output bit about half of the time") {
    // Of each input the lower 24 bits, of the output the upper 24, which become numbers: the hash shifts by
    // 16 bits once, so the highest input bits reach only the higher output bits.
    constexpr int kTrials = 256;
    for (int input = 0; input < 96; ++input) {
        if (input % 32 >= 24) continue;
        std::array<int, 32> flips{};
        for (std::uint32_t trial = 0; trial < kTrials; ++trial) {
            std::array<std::uint32_t, 3> in = {trial, trial * 7 + 1, trial * 13 + 5};
            const std::uint32_t before = hash_of(in[0], in[1], in[2]);
            in[static_cast<std::size_t>(input / 32)] ^= 1u << (input % 32);
            const std::uint32_t changed = before ^ hash_of(in[0], in[1], in[2]);
            for (std::size_t bit = 0; bit < 32; ++bit) flips[bit] += static_cast<int>(changed >> bit & 1);
        }
        CAPTURE(input);
        const auto [fewest, most] = std::minmax_element(flips.begin() + 8, flips.end());
        CHECK(*fewest > kTrials / 4);
        CHECK(*most < kTrials * 3 / 4);
    }
}

TEST_CASE("hash: the same on every machine, for ever") {
    CHECK(hash_of(1, 0, 0) == 2717828630u);
    CHECK(hash_of(1, 2, 3) == 4204755366u);
    CHECK(hash_of(0xffffffffu, 0xffffffffu, 0xffffffffu) == 2784268096u);
}
