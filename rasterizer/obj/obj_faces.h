// The faces of an OBJ, as its text has them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace crevice {

// Smoothing groups decide which faces share a generated normal.
inline constexpr std::uint32_t kFlatShaded = 0;     // `s off`: the face's own
inline constexpr std::uint32_t kNoSmoothing = ~0u;  // before any `s`: all faces of this kind

// Indices from 0 into the lists of the whole file; they may still be beyond the end of those lists.
inline constexpr std::int32_t kAbsentIndex = -1;  // the file gives none
inline constexpr std::int32_t kBeforeFirst = -2;  // a negative index that counts back beyond the first
struct ObjCorner {
    std::int32_t position, texcoord, normal;
    friend bool operator==(const ObjCorner&, const ObjCorner&) = default;
};

struct ObjFace {
    std::size_t first_corner = 0;  // into ObjFaces::corners
    std::uint32_t corner_count = 0;
    std::int32_t material = -1;  // into ObjText::materials; -1: none
    std::uint32_t line = 0;
    std::uint32_t smoothing = kNoSmoothing;
    friend bool operator==(const ObjFace&, const ObjFace&) = default;
};

struct ObjFaces {
    std::vector<ObjCorner> corners;
    std::vector<ObjFace> faces;
};

}  // namespace crevice
