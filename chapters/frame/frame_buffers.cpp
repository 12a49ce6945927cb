#include "chapters/frame/frame_buffers.h"

namespace crevice {

Picture buffer_picture(const std::string& name, const Image<float>& image, const Camera& camera) {
    if (name == "view_depth") return view_depth_picture(image, PictureValues::left);
    if (name == "ndc_depth") return ndc_depth_picture(image, camera.reversed_z, PictureValues::left);
    return ao_picture(image, PictureValues::left);
}

Picture buffer_picture(const std::string& name, const Image3& image, const Camera&) {
    return name == "lit" ? lit_picture(image) : normal_picture(image, PictureValues::left);
}

}  // namespace crevice
