// From the triangles of an OBJ to a mesh: generated normals, shared vertices, the lab's world.
#pragma once

#include <span>

#include "rasterizer/obj/material_textures.h"
#include "rasterizer/obj/obj_text.h"
#include "rasterizer/obj/obj_triangles.h"
#include "rasterizer/scene/scene.h"

namespace crevice {

struct ObjMesh {
    Mesh mesh;                          // in the lab's world: z negated, winding reversed, v down
    std::size_t generated_normals = 0;  // triangle corners that the file has no normal for
    Tally smoothed_faces;               // ObjReport::smoothed_faces
};

// What the mesh needs to know of the materials; the last one is for faces without.
struct ObjMeshMaterials {
    std::span<const int> of_use;                 // a material for each of ObjText::materials
    std::span<const TexcoordMap> texcoord_maps;  // one a material
    bool normal_maps = false;                    // any has one: the mesh gets tangents
};

// Vertices stand in order of first use, one for each distinct position, texture coordinate and normal.
// Corners without a normal get a generated one (see vertex_normals.h; the faces of one smoothing group share
// it), those without texture coordinates (0, 0) in file space; when no corner has any, or want_texcoords is
// false, the mesh has none. A part is a run of faces of one material.
ObjMesh build_obj_mesh(const ObjText& text, const ObjTriangles& triangles, const ObjMeshMaterials& materials,
                       bool want_texcoords, double crease_angle_rad, const Run& run);

}  // namespace crevice
