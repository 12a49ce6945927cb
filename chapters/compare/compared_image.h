// One file that `crevice compare` is given, as the images in it.
#pragma once

#include <filesystem>
#include <iosfwd>
#include <string>
#include <vector>

#include "rasterizer/base/npy.h"

namespace crevice {

// What a file holds, as it stands there.
struct ComparedImage {
    std::string layer = {};  // of an EXR; "" where the file is the image
    Planes planes = {};
    Image<float> alpha = {};  // empty: it has none
    bool linear = true;       // its values are proportional to light, or no light at all; else sRGB codes
    bool light = false;       // R, G and B of an EXR
    bool picture = false;     // of a PNG or TIFF, where grey may be stored as three equal components
};

// .npy of floats, halves, doubles, bytes or words with one to four components, .pfm, .png, .tif and .exr. Codes of PNG and
// TIFF count as k/255, or as k/65535 where there are 16 bits, as the file encodes them. Of an EXR each layer is an image;
// of all others there is one. On `warnings`: doubles that no float holds. Throws InputError when the file cannot be read or
// is of another kind, UsageError for one whose library the program was built without.
std::vector<ComparedImage> compared_images(const std::filesystem::path& path, std::ostream& warnings);

// By its ending, in any case of letters.
bool is_compared_kind(const std::filesystem::path& path);
bool is_layered_kind(const std::filesystem::path& path);
// "a .npy, a .pfm ...": what is compared.
inline constexpr const char* kComparedKinds = "a .npy, a .pfm, a .png, a .tif or an .exr";

}  // namespace crevice
