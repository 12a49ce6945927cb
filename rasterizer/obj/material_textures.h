// The pictures of an OBJ's materials: colours, cut-outs and normals.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "rasterizer/obj/file_tree.h"
#include "rasterizer/obj/images_ahead.h"
#include "rasterizer/obj/mtl_read.h"
#include "rasterizer/scene/scene.h"

namespace crevice {

// Where a material's faces lie in its pictures: scale * uv + offset, v up as in the file.
struct TexcoordMap {
    glm::vec2 scale = glm::vec2(1), offset = glm::vec2(0);
    friend bool operator==(const TexcoordMap&, const TexcoordMap&) = default;
};

// All pictures of an OBJ together: 3 GB when they are decoded and have their mip levels. Less where that
// would be more than half of the machine's memory.
inline constexpr std::int64_t kMaxTexturePixelsOfObj = std::int64_t{1} << 28;

// From this alpha on a texel is there (glTF's default, too).
inline constexpr float kCutoutAlpha = 0.5f;

// From black to white a height map of `-bm 1` rises by this part of the texture's width.
inline constexpr float kBumpHeight = 0.01f;

// Each picture is read once, whatever number of materials shows it.
//   map_Kd        colours; where it has alpha, texels below kCutoutAlpha are cut out
//   map_d         cut-outs: its alpha where it has some, else its luminance, or the channel that -imfchan
//                 names. The map_Kd itself is asked for its alpha alone
//   norm, map_Kn  normals: red along +u, green along +v of the file, which points up; -bm steepens them
//   bump          the same where the picture holds normals, else heights, of which normals are made
//   disp          normals where it holds them; heights are not drawn
//   map_Ks        its mean colour, which multiplies Ks
// Pixels are taken as they are stored; a JPEG whose EXIF orientation would have it turned is a note. Blender
// does not turn it either, and there texture coordinates are made. Colours of a PNG whose gAMA chunk says that they are
// not sRGB are read by it, which is a note, too.
// Without want_surfaces only what cuts out is read: it is part of a shape. What cannot be read, lies outside
// the OBJ's directory or would be wholly cut out is a warning, and drawn without.
class MaterialTextures {
 public:
    MaterialTextures(const FileTree& tree, bool want_surfaces, const Run& run);

    // That add_to() will come with this material, after those that were expected before: its pictures are decoded
    // together with others.
    void expect(const MtlMaterial& from, const std::filesystem::path& mtl);

    // `mtl` is the path of the MTL, and `from` one of its materials, which gets the warnings and notes.
    TexcoordMap add_to(Material& material, MtlMaterial& from, const std::filesystem::path& mtl);

 private:
    using TexturePointer = std::shared_ptr<const Texture>;

    enum class Accepted { as_normals, normals, normals_or_heights };  // as_normals: whatever they look like
    struct Request;

    FoundFile look_for(const MtlTexture& texture, const std::filesystem::path& mtl) const;
    std::filesystem::path find(Request& request, const MtlTexture& texture) const;
    bool may_cut_out(const MtlTexture& colours, const std::filesystem::path& mtl) const;
    DecodedImage load(Request& request, const MtlTexture& texture, const std::filesystem::path& path,
                      TextureEncoding encoding);
    template <class Make>
    static auto unless_unreadable(Request& request, const MtlTexture& texture, const Make& make)
        -> decltype(make());
    template <class Make>
    TexturePointer once(const std::string& key, Request& request, const MtlTexture& texture,
                        const Make& make);
    TexturePointer normals_of(Request& request, const MtlTexture& map, Accepted accepted);
    void add_colours(Material& material, Request& request);
    void add_normals(Material& material, Request& request);
    void add_mean_specular(Material& material, Request& request);

    const FileTree& tree_;
    const bool want_surfaces_;
    const Run run_;
    ImagesAhead images_;
    std::int64_t pixels_left_;
    std::map<std::string, TexturePointer> made_;  // null: could not be
};

}  // namespace crevice
