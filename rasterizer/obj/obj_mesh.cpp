#include "rasterizer/obj/obj_mesh.h"

#include <algorithm>

#include "rasterizer/scene/vertex_normals.h"

namespace crevice {
namespace {

struct VertexKey {
    std::int32_t position, texcoord;
    std::uint32_t normal;
    friend bool operator==(const VertexKey&, const VertexKey&) = default;
};

// Numbers distinct keys in order of first use. Open addressing; the hash decides only where a key is looked
// for.
struct VertexNumbers {
    std::vector<VertexKey> keys;
    std::vector<std::uint32_t> slots = std::vector<std::uint32_t>(1024, kEmpty);  // a power of two of them

    static constexpr std::uint32_t kEmpty = ~0u;

    std::uint32_t number_of(const VertexKey& key) {
        const std::size_t slot = slot_of(key);
        if (slots[slot] != kEmpty) return slots[slot];
        const auto number = static_cast<std::uint32_t>(keys.size());
        slots[slot] = number;
        keys.push_back(key);
        if (keys.size() * 2 > slots.size()) grow();
        return number;
    }

 private:
    std::size_t slot_of(const VertexKey& key) const {
        std::uint64_t hash = static_cast<std::uint32_t>(key.position) * 0x9e3779b97f4a7c15u;
        hash = (hash ^ (hash >> 32) ^ static_cast<std::uint32_t>(key.texcoord)) * 0xbf58476d1ce4e5b9u;
        hash = (hash ^ (hash >> 29) ^ key.normal) * 0x94d049bb133111ebu;
        std::size_t slot = (hash >> 32) & (slots.size() - 1);
        while (slots[slot] != kEmpty && keys[slots[slot]] != key) slot = (slot + 1) & (slots.size() - 1);
        return slot;
    }
    void grow() {
        slots.assign(slots.size() * 4, kEmpty);
        for (std::uint32_t n = 0; n < keys.size(); ++n) slots[slot_of(keys[n])] = n;
    }
};

struct FinalNormals {
    std::vector<glm::vec3> normals;                         // file space, unit
    std::vector<std::array<std::uint32_t, 3>> of_triangle;  // one a corner of ObjTriangles::triangles
    std::size_t generated = 0;
};

// The file's normals, followed by the generated ones.
FinalNormals final_normals(const ObjPrescan& prescan, const ObjFaces& faces, const ObjTriangles& from,
                           double crease_angle_rad) {
    FinalNormals result{from.normals, std::vector<std::array<std::uint32_t, 3>>(from.triangles.size())};
    for (std::size_t t = 0; t < from.triangles.size(); ++t) {
        for (std::size_t k = 0; k < 3; ++k) {
            const std::int32_t normal = from.corner_normal[from.triangles[t].corners[k]];
            result.of_triangle[t][k] = static_cast<std::uint32_t>(normal);
            result.generated += normal == kAbsentIndex;
        }
    }
    if (result.generated == 0) return result;

    std::vector<std::array<std::uint32_t, 3>> by_position(from.triangles.size());
    for (std::size_t t = 0; t < from.triangles.size(); ++t) {
        for (std::size_t k = 0; k < 3; ++k) {
            by_position[t][k] =
                static_cast<std::uint32_t>(faces.corners[from.triangles[t].corners[k]].position);
        }
    }
    const CornerNormals generated = angle_weighted_normals(prescan.positions, by_position, crease_angle_rad);
    const auto first_generated = static_cast<std::uint32_t>(result.normals.size());
    result.normals.insert(result.normals.end(), generated.normals.begin(), generated.normals.end());
    for (std::size_t t = 0; t < from.triangles.size(); ++t) {
        for (std::size_t k = 0; k < 3; ++k) {
            std::uint32_t& normal = result.of_triangle[t][k];
            if (normal == static_cast<std::uint32_t>(kAbsentIndex)) {
                normal = first_generated + generated.of_triangle[t][k];
            }
        }
    }
    return result;
}

// File space is right-handed, the lab's world left-handed.
glm::vec3 world_from_file(glm::vec3 v) { return {v.x, v.y, -v.z}; }

void add_to_parts(std::vector<MeshPart>& parts, int material) {
    if (parts.empty() || parts.back().material != material) {
        const std::uint32_t first =
            parts.empty() ? 0 : parts.back().first_triangle + parts.back().triangle_count;
        parts.push_back({first, 0, material});
    }
    ++parts.back().triangle_count;
}

}  // namespace

ObjMesh build_obj_mesh(const ObjPrescan& prescan, const ObjFaces& faces, const ObjTriangles& triangles,
                       std::span<const int> material_of_use, int no_material, bool want_texcoords,
                       double crease_angle_rad) {
    const FinalNormals normals = final_normals(prescan, faces, triangles, crease_angle_rad);
    ObjMesh result{{}, normals.generated};
    Mesh& mesh = result.mesh;
    mesh.triangles.reserve(triangles.triangles.size());
    VertexNumbers vertices;
    bool has_texcoords = false;
    for (std::size_t t = 0; t < triangles.triangles.size(); ++t) {
        const ObjTriangle& triangle = triangles.triangles[t];
        std::array<std::uint32_t, 3> numbers;
        for (std::size_t k = 0; k < 3; ++k) {
            const std::size_t corner = triangle.corners[k];
            const std::int32_t texcoord = want_texcoords ? triangles.corner_texcoord[corner] : kAbsentIndex;
            has_texcoords = has_texcoords || texcoord != kAbsentIndex;
            numbers[k] =
                vertices.number_of({faces.corners[corner].position, texcoord, normals.of_triangle[t][k]});
        }
        mesh.triangles.push_back({numbers[0], numbers[2], numbers[1]});
        const std::int32_t material = faces.faces[triangle.face].material;
        add_to_parts(mesh.parts,
                     material < 0 ? no_material : material_of_use[static_cast<std::size_t>(material)]);
    }
    mesh.positions.reserve(vertices.keys.size());
    mesh.normals.reserve(vertices.keys.size());
    if (has_texcoords) mesh.texcoords.reserve(vertices.keys.size());
    for (const VertexKey& key : vertices.keys) {
        mesh.positions.push_back(world_from_file(prescan.positions[static_cast<std::size_t>(key.position)]));
        mesh.normals.push_back(world_from_file(normals.normals[key.normal]));
        if (!has_texcoords) continue;
        const bool absent = key.texcoord == kAbsentIndex;
        const glm::vec2 t = absent ? glm::vec2(0) : prescan.texcoords[static_cast<std::size_t>(key.texcoord)];
        mesh.texcoords.emplace_back(t.x, 1 - t.y);
    }
    return result;
}

}  // namespace crevice
