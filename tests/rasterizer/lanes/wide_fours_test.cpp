#include "rasterizer/lanes/wide_fours.h"

#include <array>
#include <cstdint>
#include <vector>

#include <doctest/doctest.h>

#include "rasterizer/lanes/isa.h"

using namespace crevice;

namespace {

// Lane i reads the fours that begin at kFirst[i].
constexpr std::int32_t kFirst[kMostLanes] = {0, 13, 5, 5, 40, 2, 21, 36, 7, 1, 30, 12, 40, 33, 0, 18};

struct Numbers {
    std::vector<float> values = std::vector<float>(44);
    std::vector<std::int32_t> codes;
    alignas(64) float shares[kMostLanes];

    Numbers() {
        for (std::size_t i = 0; i < values.size(); ++i) values[i] = 0.37f * static_cast<float>(i * i % 29);
        codes.assign(values.begin(), values.end());
        for (int lane = 0; lane < kMostLanes; ++lane) shares[lane] = static_cast<float>(lane) / kMostLanes;
    }
};

// Number i of each lane, computed in fours.
using OfLanes = float[4][kMostLanes];
template <class F>
CREVICE_INLINE void compute(const Numbers& given, OfLanes& result) {
    Fours<F> share[kFours<F>], mixed[kFours<F>];
    Fours<F, std::int32_t> least[kFours<F>];
    spread_to_fours(load<F>(given.shares), share);
    spread_to_fours(load<F>(kFirst), least);
    for (int k = 0; k < kFours<F>; ++k) {
        const Fours<F> here = gather_fours<F>(given.values.data(), kFirst + k);
        const Fours<F, std::int32_t> whole = gather_fours<F>(given.codes.data(), kFirst + k);
        using V = typename Fours<F>::V;
        mixed[k] = mix(here, {whole.v >= least[k].v ? V{} + 1 : V{}}, share[k]);
    }
    const std::array<F, 4> all = sorted(mixed);
    for (std::size_t i = 0; i < 4; ++i) store(result[i], all[i]);
}

void check(const Numbers& given, const OfLanes& result, int lanes) {
    for (std::size_t i = 0; i < 4; ++i) {
        for (int lane = 0; lane < lanes; ++lane) {
            const std::size_t at = static_cast<std::size_t>(kFirst[lane]) + i;
            CAPTURE(lane);
            CAPTURE(i);
            CHECK(result[i][lane] ==
                  mix(given.values[at], given.codes[at] >= kFirst[lane] ? 1.0f : 0.0f, given.shares[lane]));
        }
    }
}

}  // namespace

TEST_CASE("fours: gathered, computed with and sorted they are what each lane has by itself") {
    const Numbers given;
    OfLanes result;
    compute<float>(given, result);
    check(given, result, 1);
    for (const Isa isa : kEveryIsa) {
        if (!isa_available(isa)) continue;
        INFO(isa_name(isa));
        call_for_isa(isa, [&]<class F>(Lanes<F>) { compute<F>(given, result); });
        check(given, result, lanes_of(isa));
    }
}
