// Loading an OBJ from a string, and what every loaded scene promises.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include "rasterizer/base/error.h"
#include "rasterizer/obj/obj_load.h"
#include "tests/tools/scratch_directory.h"

namespace crevice {

inline void write_text(const std::filesystem::path& path, const std::string& text) {
    std::ofstream(path, std::ios::binary) << text;
}

inline LoadedObj load_text(const std::string& text, const ObjOptions& options = {}) {
    const ScratchDirectory scratch;
    write_text(scratch / "a.obj", text);
    return load_obj(scratch / "a.obj", options);
}

inline std::string error_of(const std::filesystem::path& path) {
    try {
        load_obj(path);
    } catch (const InputError& error) {
        return error.what();
    }
    return "no error";
}

inline bool has_warning(const ObjReport& report, const std::string& fragment) {
    return std::any_of(report.warnings.begin(), report.warnings.end(),
                       [&](const std::string& w) { return w.find(fragment) != std::string::npos; });
}

inline const Mesh& mesh_of(const LoadedObj& loaded) { return loaded.scene.meshes.at(0); }

// Twice the area vector by the corner order; for a triangle that is clockwise seen from its front in the
// left-handed world it points to the front.
inline glm::dvec3 area2(const Mesh& mesh, const std::array<std::uint32_t, 3>& t) {
    const glm::dvec3 a = mesh.positions[t[0]], b = mesh.positions[t[1]], c = mesh.positions[t[2]];
    return glm::cross(b - a, c - a);
}

// What every loaded scene promises, whatever the file was.
inline void check_whole(const LoadedObj& loaded) {
    const Scene& scene = loaded.scene;
    REQUIRE(scene.meshes.size() == 1);
    REQUIRE(scene.instances.size() == 1);
    CHECK(scene.instances[0].world_from_object == glm::mat4(1.0f));
    CHECK(scene.two_sided);
    CHECK(!scene.materials.empty());
    const Mesh& mesh = mesh_of(loaded);
    CHECK(mesh.normals.size() == mesh.positions.size());
    CHECK((mesh.texcoords.empty() || mesh.texcoords.size() == mesh.positions.size()));
    for (const glm::vec3& n : mesh.normals) CHECK(std::abs(glm::length(glm::dvec3(n)) - 1) < 1e-6);
    std::uint32_t next = 0, seen = 0;
    for (const auto& t : mesh.triangles) {
        for (const std::uint32_t corner : {t[0], t[2], t[1]}) {
            REQUIRE(corner < mesh.positions.size());
            CHECK(corner <= seen);  // vertices stand in order of first use, in the file's winding
            seen = std::max(seen, corner + 1);
        }
        CHECK(glm::length(area2(mesh, t)) > 0);
    }
    CHECK(seen == mesh.positions.size());
    for (const MeshPart& part : mesh.parts) {
        CHECK(part.first_triangle == next);
        CHECK(part.triangle_count > 0);
        CHECK(part.material >= 0);
        CHECK(static_cast<std::size_t>(part.material) < scene.materials.size());
        next += part.triangle_count;
    }
    CHECK(next == mesh.triangles.size());
    validate(scene.camera);
}

inline constexpr const char* kCorners = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\n";  // lines 1 to 4

}  // namespace crevice
