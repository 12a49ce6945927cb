// What parts of a job find, on all threads, where the whole is made of it afterwards: a sum, a largest value.
#pragma once

#include <cstddef>
#include <type_traits>
#include <vector>

#include "rasterizer/base/parallel.h"

namespace crevice {

// What of_block(first, end) returns for blocks of at most `block` items, at least 1, that cover [0, count), in their order.
template <class T, class OfBlock>
std::vector<T> parallel_results(std::size_t count, std::size_t block, const Run& run,
                                const OfBlock& of_block) {
    static_assert(!std::is_same_v<T, bool>);  // several of which share a byte
    std::vector<T> results((count + block - 1) / block);
    parallel_blocks(count, block, run, [&](std::size_t first, std::size_t end) {
        results[first / block] = of_block(first, end);
    });
    return results;
}

}  // namespace crevice
