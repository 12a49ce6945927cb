// A texture with its mip chain: colours in linear light, or the values of a normal map; alpha where there is
// any.
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include <glm/vec4.hpp>

#include "rasterizer/base/cache_line_array.h"
#include "rasterizer/base/run.h"
#include "rasterizer/textures/image_file.h"
#include "rasterizer/textures/rgba.h"

namespace crevice {

// How far a stored value may be off: half a unit of Rgba16, and what a float rounds where it is brought to units.
inline constexpr float kTexelError = 0.504f / kTexelOne;

// All levels lie in one block, texel by texel (Rgba16: four times 16 bits). RGB in [0,1], linear light; alpha in
// [0,1], linear: 0 is not there, 1 is (everywhere if there is none). A value is off by at most kTexelError, and not
// at all if it is a multiple of 1 / 255 or 1 / 256; what is out of range is clamped, and NaN counts as 0.
class Texture {
 public:
    // Where a level lies in texels(). One column more repeats the first one behind the last, and one row more the
    // first row: so the four neighbours that a filter mixes are two loads of two texels, also across the edge.
    struct Level {
        Size size;
        std::int32_t first = 0;   // its texel (0, 0)
        std::int32_t stride = 0;  // from a texel to the one below: see stride_of
    };

    // Adds the next level: [0] is the full size, each next max(1, half) of the one before. Throws
    // UsageError when it is empty or has another size, when `alpha` is neither empty nor of its size, when
    // it has alpha and the levels before have none (or the other way round), or when the texels become
    // more than an index counts.
    void add_level(const Image3& colour, const Image<float>& alpha = {}, const Run& run = {.threads = 1});

    const std::vector<Level>& levels() const { return levels_; }
    Size size() const { return levels_.front().size; }  // of the full size; at least one level
    const Rgba16* texels() const { return texels_.data(); }
    bool has_alpha() const { return has_alpha_; }

    glm::vec4 texel(std::size_t level, int x, int y) const;
    // A level as pictures of their own. Alpha is empty where the texture has none.
    Image3 colour(std::size_t level) const;
    Image<float> alpha(std::size_t level) const;

 private:
    std::vector<Level> levels_;
    CacheLineArray<Rgba16> texels_;
    bool has_alpha_ = false;
};

// The mip chain of a linear-light image: each level is max(1, half) of the one above and its box-filtered
// mean (odd sizes weigh by area), down to 1x1, of which only what is stored is rounded. Alpha likewise, if given;
// colours are not weighted by it, since it may mean anything (in a normal map it is the shininess), so a cut-out's
// colours must go on beyond its outline. Under an alpha test the mean of alpha keeps its sum, not its coverage: see
// keep_coverage. Throws UsageError as Texture::add_level does.
Texture build_texture(Image3 base, Image<float> alpha = {}, const Run& run = {.threads = 1});

// The picture in a file (image_file.h) as a texture. Throws InputError as decode_image does.
Texture load_texture(const std::filesystem::path& path, TextureEncoding encoding = TextureEncoding::srgb);

}  // namespace crevice
