#include "rasterizer/obj/obj_mesh.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <functional>

#include <glm/geometric.hpp>

#include "rasterizer/obj/ear_clip.h"
#include "rasterizer/scene/tangents.h"
#include "rasterizer/scene/vertex_normals.h"

namespace crevice {
namespace {

struct VertexKey {
    std::int32_t position, texcoord;
    std::uint32_t normal;
    int texcoord_map;  // the first material whose texture coordinates are mapped like those of this vertex
    friend bool operator==(const VertexKey&, const VertexKey&) = default;
};

// Numbers distinct keys in order of first use. Open addressing: a key is looked for at its position's slot, so
// that neighbours in the file are neighbours in memory, then where the hash says.
struct VertexNumbers {
    explicit VertexNumbers(std::size_t positions) : slots(std::bit_ceil(2 * positions + 2), kEmpty) {}

    std::vector<VertexKey> keys;
    std::vector<std::uint32_t> slots;  // a power of two of them

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
    bool is_at(std::size_t slot, const VertexKey& key) const {
        return slots[slot] == kEmpty || keys[slots[slot]] == key;
    }
    std::size_t slot_of(const VertexKey& key) const {
        const std::size_t near = static_cast<std::uint32_t>(key.position) & (slots.size() - 1);
        if (is_at(near, key)) return near;
        std::uint64_t hash = static_cast<std::uint32_t>(key.position) * 0x9e3779b97f4a7c15u;
        hash = (hash ^ (hash >> 32) ^ static_cast<std::uint32_t>(key.texcoord)) * 0xbf58476d1ce4e5b9u;
        hash = (hash ^ (hash >> 29) ^ key.normal) * 0x94d049bb133111ebu +
               static_cast<std::uint32_t>(key.texcoord_map);
        std::size_t slot = (hash >> 32) & (slots.size() - 1);
        while (!is_at(slot, key)) slot = (slot + 1) & (slots.size() - 1);
        return slot;
    }
    void grow() {
        slots.assign(slots.size() * 4, kEmpty);
        for (std::uint32_t n = 0; n < keys.size(); ++n) slots[slot_of(keys[n])] = n;
    }
};

// One a triangle; none where all are of one group.
std::vector<std::uint32_t> smoothing_groups(const ObjFaces& faces,
                                            const std::vector<ObjTriangle>& triangles) {
    std::vector<std::uint32_t> groups;
    groups.reserve(triangles.size());
    for (const ObjTriangle& triangle : triangles) groups.push_back(faces.faces[triangle.face].smoothing);
    const bool differ =
        std::adjacent_find(groups.begin(), groups.end(), std::not_equal_to<>()) != groups.end();
    return differ ? groups : std::vector<std::uint32_t>();
}

struct FinalNormals {
    std::vector<glm::vec3> normals;                         // file space, unit
    std::vector<std::array<std::uint32_t, 3>> of_triangle;  // one a corner of ObjTriangles::triangles
    std::size_t generated = 0;
    Tally smoothed;
};

// Of the faces that no `s` stands before, those with a generated normal, of which the first has the number given, far
// from their own: further than at the corners of an icosahedron, 37.4 degrees, which may well mean a sphere. Where two
// faces of a box alone meet it is 45 degrees, at its corners 54.7.
Tally smoothed_faces(const ObjText& text, const ObjTriangles& from, const FinalNormals& final,
                     std::uint32_t first_generated) {
    constexpr double kFarCosine = 0.766;  // 40 degrees
    Tally found;
    std::uint32_t last_found = ~0u;  // no face is the last of so many
    for (std::size_t t = 0; t < from.triangles.size(); ++t) {
        const ObjTriangle& triangle = from.triangles[t];
        const ObjFace& face = text.faces.faces[triangle.face];
        if (face.smoothing != kNoSmoothing || triangle.face == last_found) continue;
        std::array<glm::vec3, 3> corners;
        for (std::size_t k = 0; k < 3; ++k) {
            const auto position = static_cast<std::size_t>(text.faces.corners[triangle.corners[k]].position);
            corners[k] = text.vertices.positions[position];
        }
        const glm::dvec3 area = newell_normal(corners);
        const double least = kFarCosine * std::sqrt(glm::dot(area, area));
        const bool is_far =
            std::any_of(final.of_triangle[t].begin(), final.of_triangle[t].end(), [&](std::uint32_t normal) {
                return normal >= first_generated && glm::dot(area, glm::dvec3(final.normals[normal])) < least;
            });
        if (!is_far) continue;
        found.add(face.line);
        last_found = triangle.face;
    }
    return found;
}

// The file's normals, followed by the generated ones.
FinalNormals final_normals(const ObjText& text, const ObjTriangles& from, double crease_angle_rad,
                           const Run& run) {
    FinalNormals result{.normals = from.normals,
                        .of_triangle = std::vector<std::array<std::uint32_t, 3>>(from.triangles.size()),
                        .smoothed = {}};
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
                static_cast<std::uint32_t>(text.faces.corners[from.triangles[t].corners[k]].position);
        }
    }
    const std::vector<std::uint32_t> groups = smoothing_groups(text.faces, from.triangles);
    const CornerNormals generated =
        angle_weighted_normals(text.vertices.positions, by_position, crease_angle_rad, groups, run);
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
    if (crease_angle_rad >= kSmoothEverywhere_rad)
        result.smoothed = smoothed_faces(text, from, result, first_generated);
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

// Of each material, the first one whose texture coordinates are mapped as its own are.
std::vector<int> first_of_equal_maps(std::span<const TexcoordMap> maps) {
    std::vector<int> first;
    std::vector<int> distinct;
    for (std::size_t m = 0; m < maps.size(); ++m) {
        const auto same = std::find_if(distinct.begin(), distinct.end(),
                                       [&](int d) { return maps[static_cast<std::size_t>(d)] == maps[m]; });
        first.push_back(same != distinct.end() ? *same : static_cast<int>(m));
        if (same == distinct.end()) distinct.push_back(static_cast<int>(m));
    }
    return first;
}

void add_vertices(Mesh& mesh, const std::vector<VertexKey>& keys, const ObjText& text,
                  const std::vector<glm::vec3>& normals, std::span<const TexcoordMap> maps,
                  bool has_texcoords) {
    mesh.positions.reserve(keys.size());
    mesh.normals.reserve(keys.size());
    if (has_texcoords) mesh.texcoords.reserve(keys.size());
    for (const VertexKey& key : keys) {
        const auto position = static_cast<std::size_t>(key.position);
        mesh.positions.push_back(world_from_file(text.vertices.positions[position]));
        mesh.normals.push_back(world_from_file(normals[key.normal]));
        if (!text.vertices.colours.empty()) mesh.colours.push_back(text.vertices.colours[position]);
        if (!has_texcoords) continue;
        const bool absent = key.texcoord == kAbsentIndex;
        const TexcoordMap& map = maps[static_cast<std::size_t>(key.texcoord_map)];
        const glm::vec2 t = absent ? glm::vec2(0) : text.texcoords[static_cast<std::size_t>(key.texcoord)];
        const glm::vec2 mapped = map.scale * t + map.offset;
        const bool finite = std::isfinite(mapped.x) && std::isfinite(mapped.y);
        mesh.texcoords.emplace_back(finite ? mapped.x : 0, finite ? 1 - mapped.y : 1);
    }
}

}  // namespace

ObjMesh build_obj_mesh(const ObjText& text, const ObjTriangles& triangles, const ObjMeshMaterials& materials,
                       bool want_texcoords, double crease_angle_rad, const Run& run) {
    const FinalNormals normals = final_normals(text, triangles, crease_angle_rad, run);
    const std::vector<int> texcoord_map_of = first_of_equal_maps(materials.texcoord_maps);
    ObjMesh result{{}, normals.generated, normals.smoothed};
    Mesh& mesh = result.mesh;
    mesh.triangles.reserve(triangles.triangles.size());
    VertexNumbers vertices(text.vertices.positions.size());
    bool has_texcoords = false;
    for (std::size_t t = 0; t < triangles.triangles.size(); ++t) {
        const ObjTriangle& triangle = triangles.triangles[t];
        const std::int32_t use = text.faces.faces[triangle.face].material;
        const int material = use < 0 ? static_cast<int>(texcoord_map_of.size()) - 1
                                     : materials.of_use[static_cast<std::size_t>(use)];
        std::array<std::uint32_t, 3> numbers;
        for (std::size_t k = 0; k < 3; ++k) {
            const std::size_t corner = triangle.corners[k];
            const std::int32_t texcoord = want_texcoords ? triangles.corner_texcoord[corner] : kAbsentIndex;
            has_texcoords = has_texcoords || texcoord != kAbsentIndex;
            const int texcoord_map = want_texcoords ? texcoord_map_of[static_cast<std::size_t>(material)] : 0;
            numbers[k] = vertices.number_of(
                {text.faces.corners[corner].position, texcoord, normals.of_triangle[t][k], texcoord_map});
        }
        mesh.triangles.push_back({numbers[0], numbers[2], numbers[1]});
        add_to_parts(mesh.parts, material);
    }
    add_vertices(mesh, vertices.keys, text, normals.normals, materials.texcoord_maps, has_texcoords);
    if (materials.normal_maps && has_texcoords) {
        mesh.tangents = vertex_tangents(mesh.positions, mesh.normals, mesh.texcoords, mesh.triangles);
    }
    return result;
}

}  // namespace crevice
