#include "rasterizer/obj/material_textures.h"

#include <algorithm>
#include <new>
#include <utility>

#include "rasterizer/base/error.h"
#include "rasterizer/base/float_text.h"
#include "rasterizer/base/memory.h"
#include "rasterizer/obj/cutout_images.h"
#include "rasterizer/obj/texel_images.h"
#include "rasterizer/textures/cutout_mips.h"

namespace crevice {

namespace fs = std::filesystem;

namespace {

bool is_named(const MtlTexture& texture) { return !texture.file.empty(); }

}  // namespace

// One material while its pictures are looked for.
struct MaterialTextures::Request {
    MtlMaterial& from;
    const fs::path& mtl;
    const MtlTexture* first = nullptr;  // the statement that says where the faces lie in all of them

    void warn(const MtlTexture& texture, const std::string& what) {
        from.warnings.push_back(mtl.string() + ":" + std::to_string(texture.line) + ": " + what);
    }
    void cannot_be_read(const MtlTexture& texture, const std::string& why) {
        warn(texture,
             "the texture of material `" + from.name + "` cannot be read (" + why + "); drawn without it");
    }
    void takes(const MtlTexture& texture) {
        if (first == nullptr) first = &texture;
        if (first->scale != texture.scale || first->offset != texture.offset ||
            first->clamp != texture.clamp) {
            warn(texture, "-s, -o or -clamp differ between the textures of material `" + from.name + "` (" +
                              texture.file + "); drawn with those of the first (" + first->file + ")");
        }
    }
};

MaterialTextures::MaterialTextures(const FileTree& tree, bool want_surfaces, const Run& run)
    : tree_(tree), want_surfaces_(want_surfaces), run_(run), images_(run) {
    const std::uintmax_t pixels_in_half = memory_bytes() / 2 / kTextureBytesPerPixel;
    pixels_left_ = static_cast<std::int64_t>(
        std::min(pixels_in_half, static_cast<std::uintmax_t>(kMaxTexturePixelsOfObj)));
}

// In the order in which add_to() looks at them; whatever else it looks at is not decoded ahead.
void MaterialTextures::expect(const MtlMaterial& from, const fs::path& mtl) {
    const auto add = [&](const MtlTexture& texture, TextureEncoding encoding) {
        if (!is_named(texture)) return;
        const fs::path path = look_for(texture, mtl).path;
        if (!path.empty()) images_.expect(path, encoding);
    };
    if (want_surfaces_) add(from.diffuse_map, TextureEncoding::srgb);
    if (from.opacity_map.file != from.diffuse_map.file) add(from.opacity_map, TextureEncoding::linear);
    if (!want_surfaces_) return;
    const MtlTexture& bump = is_named(from.bump_map) ? from.bump_map : from.displacement_map;
    add(is_named(from.normal_map) ? from.normal_map : bump, TextureEncoding::linear);
    if (from.specular && *from.specular != glm::vec3(0)) add(from.specular_map, TextureEncoding::srgb);
}

FoundFile MaterialTextures::look_for(const MtlTexture& texture, const fs::path& mtl) const {
    const FoundFile whole = tree_.find(texture.whole_line, mtl.parent_path());
    if (!whole.path.empty() || texture.whole_line == texture.file) return whole;
    return tree_.find(texture.file, mtl.parent_path());
}

// The file of a texture statement, or nothing (""), which is said.
fs::path MaterialTextures::find(Request& request, const MtlTexture& texture) const {
    const FoundFile found = look_for(texture, request.mtl);
    if (found.elsewhere) {
        request.from.notes.push_back({"a texture is not where its path says, or may not be read there",
                                      "the file of that name beside the OBJ or MTL used", texture.line});
    }
    if (found.path.empty() && found.outside) {
        request.warn(texture, "the texture of material `" + request.from.name +
                                  "` is outside the OBJ's directory (" + texture.file +
                                  "); drawn without it, --outside-files allows it");
    } else if (found.path.empty()) {
        request.cannot_be_read(texture, texture.file + ": there is no such file");
    }
    return found.path;
}

DecodedImage MaterialTextures::load(Request& request, const MtlTexture& texture, const fs::path& path,
                                    TextureEncoding encoding) {
    auto [image, orientation, gamma] =
        images_.take(path, encoding, std::min(pixels_left_, kMaxTexturePixels));
    if (orientation != 1) {
        request.from.notes.push_back({"a texture's EXIF orientation would have it turned or mirrored",
                                      "drawn as its pixels are stored", texture.line});
    }
    if (gamma && encoding == TextureEncoding::srgb) {
        request.from.notes.push_back({"a texture's gAMA chunk says that its colours are not sRGB",
                                      "drawn with the exponent that it gives", texture.line});
    }
    pixels_left_ -= std::int64_t{image.colour.size().width} * image.colour.size().height;
    return std::move(image);
}

// What `make` gives; nothing, which is said, when the file cannot be read.
template <class Make>
auto MaterialTextures::unless_unreadable(Request& request, const MtlTexture& texture, const Make& make)
    -> decltype(make()) {
    try {
        return make();
    } catch (const InputError& error) {
        request.cannot_be_read(texture, error.what());
    } catch (const std::bad_alloc&) {
        request.cannot_be_read(texture, "there is not enough memory");
    }
    return {};
}

// The texture of this key; made now unless it was before.
template <class Make>
MaterialTextures::TexturePointer MaterialTextures::once(const std::string& key, Request& request,
                                                        const MtlTexture& texture, const Make& make) {
    const auto [at, is_new] = made_.emplace(key, nullptr);
    if (is_new) at->second = unless_unreadable(request, texture, make);
    return at->second;
}

TexcoordMap MaterialTextures::add_to(Material& material, MtlMaterial& from, const fs::path& mtl) {
    Request request{from, mtl};
    add_colours(material, request);
    if (want_surfaces_) {
        add_normals(material, request);
        add_mean_specular(material, request);
    }
    if (request.first == nullptr) return {};
    if (request.first->clamp) {
        // Beyond the one copy the material is as it would be without; a normal map has no such border.
        const AddressMode mode = material.normal_map ? AddressMode::clamp : AddressMode::border;
        material.sampler.address_u = material.sampler.address_v = mode;
        material.sampler.border = glm::vec4(1);
        from.notes.push_back({"`-clamp on` asks for one copy of a texture",
                              "the plain colour is drawn around it", request.first->line});
    }
    return {request.first->scale, request.first->offset};
}

// Whether the alpha of a picture may be a part of the shape.
bool MaterialTextures::may_cut_out(const MtlTexture& colours, const fs::path& mtl) const {
    const FoundFile found = look_for(colours, mtl);
    try {
        return !found.path.empty() && may_have_alpha(read_image_bytes(found.path));
    } catch (const InputError&) {
        return false;  // nobody wants to see it
    }
}

void MaterialTextures::add_colours(Material& material, Request& request) {
    const MtlTexture &colours = request.from.diffuse_map, &cutouts = request.from.opacity_map;
    fs::path colour_path, cutout_path;
    if (is_named(colours) && (want_surfaces_ || is_named(cutouts) || may_cut_out(colours, request.mtl)))
        colour_path = find(request, colours);
    if (is_named(cutouts)) cutout_path = find(request, cutouts);
    if (colour_path.empty() && cutout_path.empty()) return;

    const MtlTexture& main = colour_path.empty() ? cutouts : colours;
    const std::string key = "colours:" + colour_path.string() + ":" + cutout_path.string() + ":" +
                            std::to_string(static_cast<int>(cutouts.channel));
    material.texture = once(key, request, main, [&]() -> TexturePointer {
        DecodedImage image;
        if (!colour_path.empty()) image = load(request, colours, colour_path, TextureEncoding::srgb);
        if (!cutout_path.empty() && (cutout_path != colour_path || cutouts.channel != TexelChannel::unsaid)) {
            image.alpha = unless_unreadable(request, cutouts, [&] {
                return channel_of(load(request, cutouts, cutout_path, TextureEncoding::linear),
                                  cutouts.channel);
            });
            if (colour_path.empty()) image.colour = Image3(image.alpha.size, glm::vec3(1));
        }
        if (image.colour.empty()) return nullptr;
        if (!image.alpha.empty()) bring_to_one_size(image.colour, image.alpha, main.file);
        if (!image.alpha.empty() && keeps_nothing(image.alpha, kCutoutAlpha)) {
            request.from.notes.push_back(
                {"a texture cuts out the whole of a material", "drawn without cut-outs", main.line});
            image.alpha = {};
        }
        if (image.alpha.empty() && !want_surfaces_) return nullptr;
        Texture texture = build_texture(std::move(image.colour), std::move(image.alpha), run_);
        if (texture.has_alpha()) texture = keep_coverage(texture, kCutoutAlpha);
        return std::make_shared<const Texture>(std::move(texture));
    });
    if (material.texture == nullptr) return;
    request.takes(main);
    if (!cutout_path.empty()) request.takes(cutouts);
    if (material.texture->has_alpha()) material.alpha_cutoff = kCutoutAlpha;
}

// The normal map that a picture makes, or null when it holds nothing that is accepted or cannot be read.
MaterialTextures::TexturePointer MaterialTextures::normals_of(Request& request, const MtlTexture& map,
                                                              Accepted accepted) {
    const fs::path path = find(request, map);
    if (path.empty()) return nullptr;
    const std::string key = "normals:" + path.string() + ":" + shortest_text(map.bump_factor) + ":" +
                            std::to_string(static_cast<int>(map.channel)) + ":" +
                            std::to_string(static_cast<int>(accepted));
    return once(key, request, map, [&]() -> TexturePointer {
        DecodedImage image = load(request, map, path, TextureEncoding::linear);
        const bool normals = accepted == Accepted::as_normals || holds_normals(image.colour);
        if (!normals && accepted == Accepted::normals) return nullptr;
        image.colour =
            normals ? normals_with_green_down(std::move(image.colour), map.bump_factor)
                    : normals_of_heights(channel_of(image, map.channel), kBumpHeight * map.bump_factor);
        return std::make_shared<const Texture>(build_texture(std::move(image.colour), {}, run_));
    });
}

// Of `norm`, else of whichever other picture holds normals, else of heights.
void MaterialTextures::add_normals(Material& material, Request& request) {
    const MtlMaterial& from = request.from;
    const MtlTexture &norm = from.normal_map, &bump = from.bump_map, &disp = from.displacement_map;
    const MtlTexture* used = nullptr;
    const auto take = [&](const MtlTexture& map, Accepted accepted) {
        if (used != nullptr || !is_named(map)) return;
        material.normal_map = normals_of(request, map, accepted);
        if (material.normal_map != nullptr) used = &map;
    };
    take(norm, Accepted::as_normals);
    take(bump, is_named(disp) ? Accepted::normals : Accepted::normals_or_heights);
    take(disp, Accepted::normals);
    if (is_named(disp)) take(bump, Accepted::normals_or_heights);
    if (used != nullptr) request.takes(*used);
    if (is_named(bump) && used != nullptr && used != &bump) {
        request.from.notes.push_back(not_drawn("bump", bump.line));
    }
    if (is_named(disp) && used != &disp) request.from.notes.push_back(not_drawn("disp", disp.line));
}

void MaterialTextures::add_mean_specular(Material& material, Request& request) {
    const MtlTexture& map = request.from.specular_map;
    if (!is_named(map) || material.specular == glm::vec3(0)) return;
    const fs::path path = find(request, map);
    if (path.empty()) return;
    const TexturePointer picture = once("specular:" + path.string(), request, map, [&]() -> TexturePointer {
        return std::make_shared<const Texture>(
            build_texture(load(request, map, path, TextureEncoding::srgb).colour, {}, run_));
    });
    if (picture == nullptr) return;
    material.specular *= glm::vec3(picture->texel(picture->levels().size() - 1, 0, 0));
    request.from.notes.push_back(
        {"`map_Ks` is drawn as its mean colour alone", "which multiplies Ks", map.line});
}

}  // namespace crevice
