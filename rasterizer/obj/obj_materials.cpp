#include "rasterizer/obj/obj_materials.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <system_error>
#include <utility>

#include "rasterizer/base/error.h"
#include "rasterizer/base/file_bytes.h"
#include "rasterizer/base/float_text.h"
#include "rasterizer/obj/alike_warnings.h"
#include "rasterizer/obj/obj_lines.h"

namespace crevice {
namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t kMaxMtlBytes = std::uintmax_t{64} << 20;

std::string located(const std::string& path, std::size_t line, const std::string& what) {
    return path + ":" + std::to_string(line) + ": " + what;
}

// The MTL files that an OBJ names.
struct Libraries {
    const fs::path& obj_path;
    const FileTree& tree;
    std::vector<MtlFile> files;
    std::vector<std::string> warnings;

    void warn(std::size_t line, const std::string& what) {
        warnings.push_back(located(obj_path.string(), line, what));
    }

    void add_file(const FoundFile& found, const std::string& name, std::size_t line) {
        const bool outside = found.path.empty() && found.outside;
        if (outside) {
            return warn(line, "the material library is outside the OBJ's directory (" + name +
                                  "); not read, --outside-files allows it");
        }
        try {
            if (found.path.empty()) throw InputError(name + ": there is no such file");
            const std::string path = found.path.string();
            const bool known =
                std::any_of(files.begin(), files.end(), [&](const MtlFile& f) { return f.name == path; });
            if (known) return;  // files that were put together name it once for each part
            files.push_back(read_mtl(read_file(found.path, kMaxMtlBytes), path));
        } catch (const InputError& error) {
            warn(line,
                 "the material library cannot be read (" + std::string(error.what()) + "); drawn without it");
        }
    }

    // One name with blanks in it when there is such a file, else several names.
    void add(const MaterialLibrary& library) {
        for (const std::string_view whole :
             {std::string_view(library.names), without_comment(library.names)}) {
            const std::string name(without_quotes(whole));
            const FoundFile found = tree.find(name, tree.directory());
            std::error_code ignored;
            if (fs::is_regular_file(found.path, ignored)) return add_file(found, name, library.line);
        }
        std::string_view rest = library.names;
        for (auto name = take_word(rest); !name.empty(); name = take_word(rest)) {
            add_file(tree.find(std::string(name), tree.directory()), std::string(name), library.line);
        }
    }
};

// The materials of all libraries by name. A name with a # in it is first looked for as it stands, then up to
// what may be a comment. Of several the first counts.
struct MaterialIndex {
    struct Entry {
        MtlMaterial* material = nullptr;
        const MtlFile* file = nullptr;
    };
    std::map<std::string_view, Entry> by_whole_name, by_name;

    explicit MaterialIndex(Libraries& libraries) {
        for (MtlFile& file : libraries.files) {
            for (MtlMaterial& m : file.materials) {
                by_name.emplace(m.name, Entry{&m, &file});
                const bool is_new = by_whole_name.emplace(m.whole_name, Entry{&m, &file}).second;
                if (is_new) continue;
                libraries.warnings.push_back(located(
                    file.name, m.line, "material `" + m.name + "` is there already; the first one is drawn"));
            }
        }
    }
    Entry find(std::string_view name) const {
        if (name.empty()) return {};
        if (const auto at = by_whole_name.find(name); at != by_whole_name.end()) return at->second;
        const auto at = by_name.find(without_quotes(without_comment(name)));
        return at != by_name.end() ? at->second : Entry{};
    }
};

std::string text_of(glm::vec3 k) {
    return shortest_text(k.x) + " " + shortest_text(k.y) + " " + shortest_text(k.z);
}

// What `usemtl` without a name means (Wavefront's OBJ specification, usemtl).
Material unnamed_material() {
    Material white{.name = "white", .specular = glm::vec3(0), .shininess = 1, .texture = nullptr};
    white.diffuse = white.ambient = glm::vec3(1);
    return white;
}

// A reflectance above 1 darkened until it is none, which keeps its hue; nothing for what is no colour at all.
std::optional<glm::vec3> reflectance_of(glm::vec3 k) {
    const float highest = std::max({k.x, k.y, k.z});
    if (!(k.x >= 0 && k.y >= 0 && k.z >= 0) || !std::isfinite(highest)) return std::nullopt;
    return highest > 1 ? k / highest : k;
}

// Brings the numbers of `from` into the range of a Material; what is out of it is a warning of `from`.
struct Conversion {
    MtlMaterial& from;
    const std::string& path;
    const bool has_colour = from.diffuse.has_value();

    void warn(const std::string& what) {
        from.warnings.push_back(located(path, from.line, "material `" + from.name + "` " + what));
    }

    void check_reflectance(const char* keyword, std::optional<glm::vec3>& value) {
        if (!value) return;
        const std::optional<glm::vec3> drawn = reflectance_of(*value);
        if (drawn == value) return;
        warn("has a " + std::string(keyword) + " outside [0, 1] (" + text_of(*value) + "); drawn with " +
             (drawn ? text_of(*drawn) : "the default"));
        value = drawn;
    }

    Material numbers() {
        Material material;
        material.name = from.name;
        check_reflectance("Kd", from.diffuse);
        check_reflectance("Ka", from.ambient);
        check_reflectance("Ks", from.specular);
        material.diffuse = from.diffuse.value_or(material.diffuse);
        material.ambient = from.ambient.value_or(material.diffuse);
        material.specular = from.specular.value_or(glm::vec3(0));
        const float shininess = from.shininess.value_or(1);
        if (shininess >= 0 && shininess <= 1000) {
            material.shininess = shininess;
        } else {
            warn("has an Ns outside [0, 1000] (" + shortest_text(shininess) + "); drawn with the default");
        }
        return material;
    }

    void note(const char* what, const char* done) { from.notes.push_back({what, done, from.line}); }

    // Some exporters write `d 0` or `Tr 1` for what they show as solid.
    void check_opacity() {
        const float opacity = from.opacity.value_or(1 - from.transparency.value_or(0));
        if (opacity <= 0) {
            note("a material would be wholly invisible (d 0 or Tr 1)", "drawn opaque");
        } else if (opacity < 1) {
            note("a material is transparent (d below 1)", "drawn opaque");
        }
    }

    // A colour that only the texture tells, and textures that nothing else tells.
    void complete(Material& material) {
        if (!has_colour && material.texture != nullptr) {
            material.diffuse = material.ambient = glm::vec3(1);
            note("a material has no Kd (colour)", "its texture is drawn as it is");
        } else if (!has_colour) {
            note("a material has no Kd (colour)", "drawn in the default grey");
        }
        const std::string& ambient_file = from.ambient_map.file;
        if (!ambient_file.empty() && ambient_file != from.diffuse_map.file) {
            from.notes.push_back(not_drawn("map_Ka", from.ambient_map.line));
        }
    }
};

}  // namespace

ObjMaterials load_obj_materials(const fs::path& obj_path, std::span<const MaterialLibrary> libraries,
                                std::span<const ObjMaterialUse> used, const MaterialFiles& files) {
    const FileTree tree(obj_path, files.outside);
    Libraries known{obj_path, tree, {}, {}};
    if (!used.empty()) {
        for (const MaterialLibrary& library : libraries) known.add(library);
    }
    const MaterialIndex index(known);
    MaterialTextures textures(tree, files.surfaces, files.run);
    for (const ObjMaterialUse& use : used) {
        if (const auto [from, file] = index.find(use.name); from != nullptr)
            textures.expect(*from, file->name);
    }
    ObjMaterials result;
    std::map<const MtlMaterial*, int> converted;
    std::map<const MtlFile*, std::vector<MtlNote>> notes;
    for (const ObjMaterialUse& use : used) {
        const auto [from, file] = index.find(use.name);
        const auto next = static_cast<int>(result.materials.size());
        if (from == nullptr) {
            const bool unnamed = use.name.empty();
            if (!unnamed)
                known.warn(use.line,
                           "no library has the material (" + use.name + "); drawn in the default grey");
            result.of_use.push_back(next);
            result.materials.push_back(unnamed ? unnamed_material()
                                               : Material{.name = use.name, .texture = nullptr});
            result.texcoord_maps.emplace_back();
            continue;
        }
        const auto [at, is_new] = converted.emplace(from, next);
        result.of_use.push_back(at->second);
        if (!is_new) continue;
        Conversion conversion{*from, file->name};
        Material material = conversion.numbers();
        conversion.check_opacity();
        result.texcoord_maps.push_back(textures.add_to(material, *from, file->name));
        conversion.complete(material);
        result.materials.push_back(std::move(material));
        known.warnings.insert(known.warnings.end(), from->warnings.begin(), from->warnings.end());
        notes[file].insert(notes[file].end(), from->notes.begin(), from->notes.end());
    }
    for (const MtlFile& file : known.files) {
        known.warnings.insert(known.warnings.end(), file.warnings.begin(), file.warnings.end());
        add_notes(known.warnings, file.name, notes[&file]);
    }
    result.materials.push_back({.name = "default", .texture = nullptr});
    result.texcoord_maps.emplace_back();
    result.warnings = std::move(known.warnings);
    return result;
}

}  // namespace crevice
