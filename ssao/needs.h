// What a frame of this scene needs, derived from the scene and from the buffers that somebody asked for.
// Passes take the answers as plain values; nothing left out changes a bit of what remains.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "rasterizer/scene/scene.h"

namespace crevice {

// The buffers a frame can produce, by the names of their files.
inline constexpr const char* kBufferNames[] = {"normal", "view_depth", "ndc_depth",
                                               "ao_raw", "ao_blurred", "lit"};
// One more that some methods know (Method::bent_normals); made only when it is asked for by this name.
inline constexpr const char* kBentNormal = "bent_normal";
using WantedBuffers = std::set<std::string>;
WantedBuffers all_buffers();

struct LeftOut {
    std::string what, why;
};

struct Needs {
    bool normal_depth = true;  // the first pass: everything reads its depth
    bool normals = true;       // written by the first pass
    bool ao = true;
    bool blur = true;
    bool bent_normals = false;  // on when they are asked for, or the light reads them
    bool lit = true;
    bool materials = true;  // the first pass keeps which material a pixel shows
    bool shadow = true;
    bool sky = true;
    std::vector<LeftOut> left_out;  // a reason for every "no"
};

// What the AO method and its settings ask for.
struct AoWork {
    bool computed = true;       // false: the method is `none`
    bool reads_normals = true;  // of the first pass
    bool lit_reads_bent_normals = false;
    const char* why_no_blur = nullptr;  // null: its map is denoised
};

// `mapped_normals` as in NormalDepthSettings. With `keep_all` every pass runs that can run, and the result is the
// same.
Needs needs_of(const Scene& scene, const WantedBuffers& wanted, const AoWork& ao, bool keep_all,
               bool mapped_normals = false);

}  // namespace crevice
