#include "rasterizer/obj/obj_materials.h"

#include <algorithm>
#include <map>
#include <optional>
#include <system_error>

#include "rasterizer/base/error.h"
#include "rasterizer/base/file_bytes.h"
#include "rasterizer/obj/obj_lines.h"

namespace crevice {
namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t kMaxMtlBytes = std::uintmax_t{64} << 20;

// Finds files that an OBJ names, below its own directory only.
struct FileTree {
    fs::path root;  // canonical

    explicit FileTree(const fs::path& obj_path) {
        const fs::path parent = obj_path.parent_path();
        root = fs::canonical(parent.empty() ? fs::path(".") : parent);
    }

    // The canonical path of `name`, or nothing when it leaves the tree. The file need not exist.
    std::optional<fs::path> find(std::string name) const {
        std::replace(name.begin(), name.end(), '\\', '/');
        std::error_code error;
        const fs::path path = fs::weakly_canonical(root / name, error);
        const fs::path below = error ? fs::path() : path.lexically_relative(root);
        if (below.empty() || *below.begin() == "..") return std::nullopt;
        return path;
    }
};

struct Collected {
    const fs::path& obj_path;
    const FileTree tree;
    std::vector<MtlMaterial> known;
    std::vector<std::string> warnings;
    std::map<fs::path, std::shared_ptr<const Texture>> textures;  // null: could not be read

    void warn(std::size_t line, const std::string& what) {
        warnings.push_back(obj_path.string() + ":" + std::to_string(line) + ": " + what);
    }

    void add_library(const std::string& name, std::size_t line) {
        const std::optional<fs::path> path = tree.find(name);
        if (!path) {
            warn(line, "the material library is outside the OBJ's directory (" + name + "); not read");
            return;
        }
        try {
            std::string text = read_file(*path, kMaxMtlBytes);
            if (text.starts_with("\xEF\xBB\xBF")) text.erase(0, 3);
            for (MtlMaterial& material : parse_mtl(std::move(text))) known.push_back(std::move(material));
        } catch (const InputError& error) {
            warn(line,
                 "the material library cannot be read (" + std::string(error.what()) + "); drawn without it");
        }
    }

    // One name with blanks in it when there is such a file, else several names.
    void add_libraries(const MaterialLibrary& library) {
        const std::optional<fs::path> whole = tree.find(library.names);
        std::error_code ignored;
        if (whole && fs::is_regular_file(*whole, ignored)) return add_library(library.names, library.line);
        std::string_view rest = library.names;
        for (auto name = take_word(rest); !name.empty(); name = take_word(rest)) {
            add_library(std::string(name), library.line);
        }
    }

    std::shared_ptr<const Texture> texture(const MtlMaterial& material, std::size_t line) {
        const std::optional<fs::path> path = tree.find(material.diffuse_map);
        if (!path) {
            warn(line, "the texture of material `" + material.name + "` is outside the OBJ's directory (" +
                           material.diffuse_map + "); drawn without it");
            return nullptr;
        }
        const auto [at, is_new] = textures.emplace(*path, nullptr);
        if (is_new) {
            try {
                at->second = std::make_shared<const Texture>(load_texture(*path));
            } catch (const InputError& error) {
                warn(line, "the texture of material `" + material.name + "` cannot be read (" + error.what() +
                               "); drawn without it");
            }
        }
        return at->second;
    }
};

bool is_reflectance(glm::vec3 k) {
    bool inside = true;
    for (int c = 0; c < 3; ++c) inside = inside && k[c] >= 0 && k[c] <= 1;
    return inside;
}

Material converted(const MtlMaterial& from, std::size_t line, bool want_textures, Collected& collected) {
    Material material;
    material.name = from.name;
    const auto take = [&](const char* keyword, glm::vec3 value, glm::vec3& into) {
        if (is_reflectance(value)) {
            into = value;
        } else {
            collected.warn(line, "material `" + from.name + "` has a " + keyword +
                                     " outside [0, 1]; drawn with the default");
        }
    };
    take("Kd", from.diffuse, material.diffuse);
    take("Ka", from.ambient, material.ambient);
    take("Ks", from.specular, material.specular);
    if (from.shininess >= 0 && from.shininess <= 1000) {
        material.shininess = from.shininess;
    } else {
        collected.warn(line,
                       "material `" + from.name + "` has an Ns outside [0, 1000]; drawn with the default");
    }
    if (from.opacity < 1) {
        collected.warn(line, "material `" + from.name + "` is transparent (d " +
                                 std::to_string(from.opacity) + "); drawn opaque");
    }
    if (want_textures && !from.diffuse_map.empty()) material.texture = collected.texture(from, line);
    return material;
}

}  // namespace

ObjMaterials load_obj_materials(const fs::path& obj_path, std::span<const MaterialLibrary> libraries,
                                std::span<const ObjMaterialUse> used, bool want_textures) {
    Collected collected{
        .obj_path = obj_path, .tree = FileTree(obj_path), .known = {}, .warnings = {}, .textures = {}};
    if (!used.empty()) {
        for (const MaterialLibrary& library : libraries) collected.add_libraries(library);
    }
    ObjMaterials result;
    for (const ObjMaterialUse& use : used) {
        const auto found = std::find_if(collected.known.begin(), collected.known.end(),
                                        [&](const MtlMaterial& m) { return m.name == use.name; });
        result.of_use.push_back(static_cast<int>(result.materials.size()));
        if (found != collected.known.end()) {
            result.materials.push_back(converted(*found, use.line, want_textures, collected));
        } else {
            collected.warn(use.line,
                           "no library has the material (" + use.name + "); drawn in the default grey");
            result.materials.push_back({.name = use.name, .texture = nullptr});
        }
    }
    result.materials.push_back({.name = "default", .texture = nullptr});
    result.warnings = std::move(collected.warnings);
    return result;
}

}  // namespace crevice
