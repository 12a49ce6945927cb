// AO and blur as a compute shader does them: the map is cut into groups of threads, each with a small memory
// of its own that it fills once, before all its threads read from it. The bits are those of luna_occlusion()
// and bilateral_blur(): only where a value is read from differs.
// Source: exercise 2 of X_Jun ("can SSAO be done in a compute shader?"); thread groups, groupshared memory
//         and its limit of 32 KB as in Direct3D 11.3, chapter 18 (cs_5_0).
// In:     as the pixel versions
// Out:    as the pixel versions, and how many values were read from the maps
// Reach:  as the pixel versions. A group of the AO pass keeps the depths of its own texels and of an apron
//         around them; a sample beyond reads the map itself (it strays). A group of the blur is a segment of
//         a row or column and keeps five texels more at either end, beyond which nothing reaches.
// Cost:   AO as the pixel version, and up to twice the fetches where samples stray. The blur decides in every
//         pass anew which taps count, as a shader must: several times the pixel version's.
#pragma once

#include <cstdint>

#include "ssao/blur/bilateral_blur.h"
#include "ssao/methods/open_tiles.h"

namespace crevice {

// Side of a group of the AO pass, texels; a thread a texel. The tiles of open_tiles.h, so that a group is
// left out as a whole.
inline constexpr int kAoGroup = kAoTile;
// The widest apron whose depths fit the 32 KB of a group: of half size, a group is 32 (odd sizes: 33) pixels
// wide.
inline constexpr int kWidestApron = 24;
// Texels of a group of the blur.
inline constexpr int kBlurSegment = 128;

// Floats read from the maps, not from a group's own memory. Both are counts of this algorithm, the same on
// every machine; what a cache would catch is not known to them.
struct MapReads {
    std::int64_t grouped = 0;  // to fill the groups' memories, and by samples that stray
    std::int64_t direct = 0;   // what the same threads would read without that memory

    MapReads& operator+=(const MapReads& other) {
        grouped += other.grouped;
        direct += other.direct;
        return *this;
    }
};

struct GroupedAo {
    Image<float> ao;
    Image<float> strays;  // [0, samples] how many of a texel's samples left the apron; 0 without a surface
    MapReads reads;       // of the depth map
};

// luna_occlusion() in groups. `apron_px` in [0, kWidestApron], pixels of the depth map. Throws UsageError.
GroupedAo luna_occlusion_in_groups(const AoInputs& inputs, const LunaSettings& settings, int apron_px = 16,
                                   const Run& run = {});

struct GroupedBlur {
    Image<float> ao;
    MapReads reads;  // of AO, depth and the normals' three components
};

// bilateral_blur() in groups: each iteration a pass across and a pass down, each of which reads a whole map
// and writes another. Throws UsageError.
GroupedBlur bilateral_blur_in_groups(const Image<float>& ao, const AoInputs& inputs,
                                     const BlurSettings& settings = kXjunBlur, const Run& run = {});

}  // namespace crevice
