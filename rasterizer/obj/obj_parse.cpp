#include "rasterizer/obj/obj_parse.h"

#include <map>
#include <sstream>

#include <tiny_obj_loader.h>

namespace crevice {
namespace {

// What the callbacks see: where the statement comes from, and where its result goes.
struct Reading {
    const ObjPrescan& prescan;
    ObjFaces result;
    std::map<std::string, std::int32_t, std::less<>> material_of_name;
    std::int32_t material = -1;
    std::size_t materials_read = 0;
};

// `index` as written: from 1, negative ones back from the `listed_before`, 0 for none.
std::int32_t absolute_index(int index, std::int32_t listed_before) {
    if (index > 0) return index - 1;
    if (index == 0) return kAbsentIndex;
    return -static_cast<std::int64_t>(index) <= listed_before ? listed_before + index : kBeforeFirst;
}

void on_face(void* user, tinyobj::index_t* indices, int count) {
    Reading& reading = *static_cast<Reading*>(user);
    ObjFaces& result = reading.result;
    const FaceOrigin& origin = reading.prescan.face_origins[result.faces.size()];
    result.faces.push_back(
        {result.corners.size(), static_cast<std::uint32_t>(count), reading.material, origin.line});
    for (int i = 0; i < count; ++i) {
        result.corners.push_back({absolute_index(indices[i].vertex_index, origin.positions),
                                  absolute_index(indices[i].texcoord_index, origin.texcoords),
                                  absolute_index(indices[i].normal_index, origin.normals)});
    }
}

void on_material(void* user, const char* name, int) {
    Reading& reading = *static_cast<Reading*>(user);
    const std::size_t line = reading.prescan.material_lines[reading.materials_read++];
    const auto next = static_cast<std::int32_t>(reading.result.materials.size());
    const auto [at, is_new] = reading.material_of_name.emplace(name, next);
    if (is_new) reading.result.materials.push_back({name, line});
    reading.material = at->second;
}

}  // namespace

ObjFaces parse_faces(const ObjPrescan& prescan) {
    Reading reading{.prescan = prescan, .result = {}, .material_of_name = {}};
    reading.result.faces.reserve(prescan.face_origins.size());
    reading.result.corners.reserve(prescan.face_origins.size() * 3);
    tinyobj::callback_t callbacks;
    callbacks.index_cb = on_face;
    callbacks.usemtl_cb = on_material;
    std::istringstream stream(prescan.statements);
    tinyobj::LoadObjWithCallback(stream, callbacks, &reading);
    return std::move(reading.result);
}

std::vector<MtlMaterial> parse_mtl(std::string text) {
    std::map<std::string, int> index_of_name;
    std::vector<tinyobj::material_t> parsed;
    std::string warnings, errors;
    std::istringstream stream(std::move(text));
    tinyobj::LoadMtl(&index_of_name, &parsed, &stream, &warnings, &errors);
    std::vector<MtlMaterial> materials;
    for (const tinyobj::material_t& m : parsed) {
        if (m.name.empty()) continue;  // what tinyobjloader makes of an MTL without materials
        materials.push_back({m.name,
                             {m.ambient[0], m.ambient[1], m.ambient[2]},
                             {m.diffuse[0], m.diffuse[1], m.diffuse[2]},
                             {m.specular[0], m.specular[1], m.specular[2]},
                             m.shininess,
                             m.dissolve,
                             m.diffuse_texname});
    }
    return materials;
}

}  // namespace crevice
