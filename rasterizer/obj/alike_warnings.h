// What a file has wrong a thousand times is said a few times.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "rasterizer/obj/mtl_read.h"

namespace crevice {

// So many warnings of a kind are said in full.
inline constexpr std::size_t kMostAlike = 8;

// `warnings` ("path:line: what is wrong (value); what was done") with at most kMostAlike of a kind: warnings
// are of one kind when they differ only in where they stand, in what is in brackets and in the names of
// materials. In the place of the next one stands how many more there are, with its path and line.
std::vector<std::string> few_of_each_kind(const std::vector<std::string>& warnings);

// One line for all that share a note; of a file that is something else, a few say enough. `path` is that of the MTL.
void add_notes(std::vector<std::string>& warnings, const std::string& path,
               const std::vector<MtlNote>& notes);

}  // namespace crevice
