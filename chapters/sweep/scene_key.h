// Which scene a result was made from.
#pragma once

#include <string>

#include "rasterizer/scene/scene.h"

namespace crevice {

// 16 hex digits, the hash of all that a sweep reads of a scene: its triangles and where they stand, what is cut out of them,
// its camera and units. Of an OBJ file it follows from the bytes of the file, its materials and the textures that cut out;
// colours and comments do not count.
std::string scene_key(const Scene& scene);

}  // namespace crevice
