#include "rasterizer/base/parallel.h"

#include <atomic>
#include <stdexcept>
#include <vector>

#include <doctest/doctest.h>

using namespace crevice;

namespace {

// How many items of the outer loop this thread has begun and not ended.
thread_local int begun_here = 0;

}  // namespace

TEST_CASE("loops within loops do every item once, and no thread has two items of the outer loop at a time") {
    constexpr int kOuter = 40, kInner = 50;
    for (const int threads : {1, 2, 5}) {
        CAPTURE(threads);
        const Run run{.threads = threads};
        std::vector<std::atomic<int>> done(kOuter * kInner);
        std::atomic<int> most_begun = 0;
        parallel_for(kOuter, run, [&](int i) {
            if (++begun_here > most_begun) most_begun = begun_here;
            parallel_for(kInner, run, [&](int k) { ++done[static_cast<std::size_t>(i * kInner + k)]; });
            --begun_here;
        });
        CHECK(most_begun == 1);
        for (const std::atomic<int>& times : done) CHECK(times == 1);
    }
}

TEST_CASE("what an item throws, the loop throws, also from a loop within; the next loop is as before") {
    for (const int threads : {1, 3}) {
        CAPTURE(threads);
        const Run run{.threads = threads};
        CHECK_THROWS_AS(parallel_for(8, run,
                                     [&](int i) {
                                         parallel_for(8, run, [i](int k) {
                                             if (i * 8 + k == 37) throw std::runtime_error("37");
                                         });
                                     }),
                        std::runtime_error);
        std::atomic<int> done = 0;
        parallel_for(100, run, [&](int) { ++done; });
        CHECK(done == 100);
    }
}
