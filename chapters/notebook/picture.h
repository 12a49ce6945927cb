// From buffers to 8-bit pictures. Each mapping is told in one line, Picture::mapping, which `render` prints.
//
// A byte is floor(255 v + 1/2) of v clamped to [0,1]. A pixel with a NaN is magenta, so that it is seen (a
// grey picture then becomes RGB); infinities are clamped like any value unless they are the background.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "rasterizer/base/image.h"
#include "rasterizer/base/image_io.h"
#include "rasterizer/base/image_summary.h"
#include "rasterizer/base/run.h"

namespace crevice {

struct Picture {
    Size size;
    int channels = 0;                  // 1 grey, 3 RGB
    std::vector<std::uint8_t> pixels;  // height x width x channels, row 0 = top, no padding
    std::string mapping;               // how the values became bytes, one line
    BufferStatistics statistics;       // of the values before the mapping
    Planes values;                     // those values; none where the bytes say as much: lit images, colours
};

// Whether a picture holds its values, for pages that show them, or only its bytes, for files.
enum class PictureValues { kept, left };

// The scale that all signed differences of AO share, so that pictures of different methods can be compared.
inline constexpr float kDifferenceScale = 0.25f;

// Unit normals: RGB = n / 2 + 1/2; the background, where n = 0, black.
Picture normal_picture(const Image3& normals, PictureValues values = PictureValues::kept);
// View depth: affine from white at the nearest to dark grey at the farthest finite depth; infinity is black.
Picture view_depth_picture(const Image<float>& view_depth, PictureValues values = PictureValues::kept);
// Ndc depth, not linear in distance: the nearest white, as in view depth; [nearest, 1) from white to black, background 1
// black. Reversed z: (0, nearest] from black to white, background 0 black.
Picture ndc_depth_picture(const Image<float>& ndc_depth, bool reversed_z = false,
                          PictureValues values = PictureValues::kept);
// Accessibility: black 0 (closed) to white 1 (open), linear.
Picture ao_picture(const Image<float>& ao, PictureValues values = PictureValues::kept);
// Linear light in [0,1], encoded with the sRGB curve.
Picture lit_picture(const Image3& lit);
// Colours in [0,1] that are meant for display already, as they are.
Picture colour_picture(const Image3& colours);
// Signed differences: -scale blue, 0 white, +scale red. Of three components the one farthest from 0 is shown.
Picture difference_picture(const Image<float>& difference, float scale = kDifferenceScale);
Picture difference_picture(const Image3& difference, float scale = kDifferenceScale);
// 0 black, everything else white.
Picture mask_picture(const Image<float>& mask);
Picture mask_picture(const Image<std::uint8_t>& mask);
// Any other buffer: black at `low` (and below) to white at `high`, affine. `low` < `high`.
Picture grey_picture(const Image<float>& values, float low, float high);

// "min 0.25, mean 0.8, max 1", and how many values are NaN or infinite where there are any.
std::string statistics_text(const BufferStatistics& statistics);

// The values of a picture as a grey PNG, 4 times as high for each component: the bytes of all values of one
// significance lie together, the lowest on top. page.js reads it.
std::string values_png(const Planes& values);

// Writes a PNG. Throws OutputError when the size does not fit a PNG or the file cannot be written.
void write_picture(const std::filesystem::path& path, const Picture& picture, const Run& run = {});

}  // namespace crevice
