// What a texture's cut-outs come to before it is built.
#pragma once

#include <string>

#include "rasterizer/base/image.h"

namespace crevice {

// Whether all of the alpha is below the cutoff, so that nothing would be drawn.
bool keeps_nothing(const Image<float>& alpha, float cutoff);

// Brings colours and cut-outs to one size, the larger on each axis. Throws InputError, which `name` begins, when that
// would hold more than kMaxTexturePixels.
void bring_to_one_size(Image3& colour, Image<float>& alpha, const std::string& name);

}  // namespace crevice
