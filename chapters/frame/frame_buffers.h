// The buffers of a frame by name: which image each name means, and how that is looked at.
#pragma once

#include <string>

#include "chapters/frame/frame.h"
#include "chapters/notebook/picture.h"

namespace crevice {

// Calls take(name, image) for each of the wanted buffers, an Image<float> or an Image3 of the frame, in the order of
// kBufferNames but with bent normals before the lit image. `ndc_depth` is what ndc_depth() makes of the frame's depth,
// where that is wanted.
template <class Take>
void for_each_buffer(const Frame& frame, const Image<float>& ndc_depth, const WantedBuffers& wanted,
                     const Take& take) {
    const auto offer = [&](const char* name, const auto& image) {
        if (wanted.contains(name)) take(name, image);
    };
    offer("normal", frame.gbuffer.normal);
    offer("view_depth", frame.gbuffer.view_depth);
    offer("ndc_depth", ndc_depth);
    offer("ao_raw", frame.ao_raw);
    offer("ao_blurred", frame.ao_blurred);
    offer(kBentNormal, frame.bent_normal);
    offer("lit", frame.lit);
}

// The picture of a buffer that was drawn with `camera`, without its values.
Picture buffer_picture(const std::string& name, const Image<float>& image, const Camera& camera);
Picture buffer_picture(const std::string& name, const Image3& image, const Camera& camera);

}  // namespace crevice
