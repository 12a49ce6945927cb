// What the tests of ao_tiles() share.
#pragma once

#include <string>

#include "ssao/methods/open_tiles.h"
#include "tests/tools/ao_cases.h"
#include "tests/tools/image_checks.h"

namespace crevice {

inline const KeptWork kEverything = KeptWork::all();

inline Image<float> ao_keeping(const AoInputs& inputs, const LunaSettings& settings, const KeptWork& kept) {
    Run run;
    run.kept = kept;
    return luna_occlusion(inputs, settings, run).ao;
}

// "" when leaving out changes no bit, each kind kept alone included.
inline std::string changed_by_skips(const AoInputs& inputs, const LunaSettings& settings) {
    const Image<float> all_work = ao_keeping(inputs, settings, kEverything);
    std::string result = outside_unit_interval(all_work);
    for (const KeptWork& kept :
         {KeptWork{}, KeptWork::only(Skip::open_tiles), KeptWork::only(Skip::background_pixels)})
        result += further_apart_than(0, all_work, ao_keeping(inputs, settings, kept));
    return result;
}

inline TileWork work_at(const AoInputs& inputs, const LunaSettings& settings, int column, int row) {
    return ao_tiles(inputs, settings).tiles.at(column, row);
}

// A surface of view depth `z`, in both maps, seen orthographically, with a bump of height `height` in columns
// [first, end) of the depth map's picture.
inline AoInputs bump(Size size, float z, float height, int first, int end) {
    AoInputs inputs = plain_inputs(size, z);
    for (int y = 0; y < size.height; ++y) {
        for (int x = first; x < end; ++x) inputs.depth_map.at(x + 1, y + 1) = z - height;
    }
    return inputs;
}

}  // namespace crevice
