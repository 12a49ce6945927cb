// From the triangles of an OBJ to a mesh: generated normals, shared vertices, the lab's world.
#pragma once

#include <span>

#include "rasterizer/obj/obj_parse.h"
#include "rasterizer/obj/obj_prescan.h"
#include "rasterizer/obj/obj_triangles.h"
#include "rasterizer/scene/scene.h"

namespace crevice {

struct ObjMesh {
    Mesh mesh;                          // in the lab's world: z negated, winding reversed, v down
    std::size_t generated_normals = 0;  // triangle corners that the file has no normal for
};

// Vertices stand in order of first use, one for each distinct position, texture coordinate and normal.
// Corners without a normal get a generated one (see vertex_normals.h), those without texture coordinates (0,
// 0) in file space; when no corner has any, or want_texcoords is false, the mesh has none. A part is a run of
// faces of one material: material_of_use maps the faces' materials, no_material is for faces without.
ObjMesh build_obj_mesh(const ObjPrescan& prescan, const ObjFaces& faces, const ObjTriangles& triangles,
                       std::span<const int> material_of_use, int no_material, bool want_texcoords,
                       double crease_angle_rad);

}  // namespace crevice
