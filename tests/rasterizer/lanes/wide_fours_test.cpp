#include "rasterizer/lanes/wide_fours.h"

#include <array>
#include <cstdint>
#include <vector>

#include <doctest/doctest.h>

using namespace crevice;

namespace {

// Lane i reads the fours that begin at kFirst[i].
constexpr std::int32_t kFirst[8] = {0, 13, 5, 5, 40, 2, 21, 36};

template <class F>
void check_lanes() {
    std::vector<float> numbers(44);
    for (std::size_t i = 0; i < numbers.size(); ++i) numbers[i] = 0.37f * static_cast<float>(i * i % 29);
    const std::vector<std::int32_t> codes(numbers.begin(), numbers.end());
    alignas(32) float shares[8];
    for (int lane = 0; lane < 8; ++lane) shares[lane] = static_cast<float>(lane) / 8;

    Fours<F> share[kFours<F>], mixed[kFours<F>];
    Fours<F, std::int32_t> least[kFours<F>];
    spread_to_fours(load<F>(shares), share);
    spread_to_fours(load<F>(kFirst), least);
    for (int k = 0; k < kFours<F>; ++k) {
        const Fours<F> here = gather_fours<F>(numbers.data(), kFirst + k);
        const Fours<F, std::int32_t> whole = gather_fours<F>(codes.data(), kFirst + k);
        using V = typename Fours<F>::V;
        mixed[k] = mix(here, {whole.v >= least[k].v ? V{} + 1 : V{}}, share[k]);
    }
    const std::array<F, 4> result = sorted(mixed);
    for (std::size_t i = 0; i < 4; ++i) {
        alignas(32) float of_lanes[8];
        store(of_lanes, result[i]);
        for (int lane = 0; lane < kLanes<F>; ++lane) {
            const std::size_t at = static_cast<std::size_t>(kFirst[lane]) + i;
            CAPTURE(lane);
            CAPTURE(i);
            CHECK(of_lanes[lane] == mix(numbers[at], codes[at] >= kFirst[lane] ? 1.0f : 0.0f, shares[lane]));
        }
    }
}

}  // namespace

TEST_CASE("fours: gathered, computed with and sorted they are what each lane has by itself") {
    check_lanes<float>();
    check_lanes<Wide<4>>();
    check_lanes<Wide<8>>();
}
