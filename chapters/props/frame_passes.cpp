#include "chapters/props/frame_passes.h"

namespace crevice {

std::vector<GraphPass> frame_passes(const AoInputs& inputs) {
    const char* const kFloat = "one 32-bit float";
    const char* const kFourFloats = "four 32-bit floats";
    const Size picture = inputs.picture, ao_map = inputs.size();
    const GraphImage normals{"normal, view depth", kFourFloats, picture, 16, {"2a texels"}};
    const GraphImage depth{"depth buffer", "D32_FLOAT", picture, 4, {"4 light"}};
    const GraphImage filtered{"depth map, with a border", kFloat, inputs.depth_map.size, 4, {"2b occlusion"}};
    const GraphImage texels{
        "normal, view depth of texels", kFourFloats, ao_map, 16, {"2b occlusion", "3a rows", "3b columns"}};
    const GraphImage raw{"raw AO map", kFloat, ao_map, 4, {"3a rows"}};
    const GraphImage between{"AO map between the halves", kFloat, ao_map, 4, {"3b columns"}};
    const GraphImage blurred{"blurred AO map", kFloat, ao_map, 4, {"3a rows", "4 light"}};
    const GraphImage lit{"picture", "R8G8B8A8_UNORM", picture, 4, {}};
    return {{"1 normals, depth", "triangles", {normals, depth}},
            {"2a texels", "", {filtered, texels}},
            {"2b occlusion", "random vectors", {raw}},
            {"3a rows", "", {between}},
            {"3b columns", "", {blurred}},
            {"4 light", "triangles, textures", {lit}}};
}

}  // namespace crevice
