#include "rasterizer/obj/obj_triangles.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <utility>

#include <glm/geometric.hpp>

#include "rasterizer/base/parallel.h"
#include "rasterizer/obj/ear_clip.h"
#include "rasterizer/obj/mtl_texture.h"

namespace crevice {
namespace {

bool is_finite(glm::vec3 v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

template <class T>
bool is_listed(std::int32_t index, const std::vector<T>& list) {
    return index >= 0 && static_cast<std::size_t>(index) < list.size();
}

// v / |v| (in double no float overflows or underflows), or 0 when v is zero or not finite.
glm::vec3 unit_or_zero(glm::dvec3 v) {
    const double length = std::sqrt(glm::dot(v, v));
    return length > 0 && std::isfinite(length) ? glm::vec3(v / length) : glm::vec3(0);
}

// Reads a block of faces, one after the other.
struct Builder {
    const ObjText& text;
    std::span<const glm::vec3> normals;                      // the file's, unit or 0
    std::span<std::int32_t> corner_normal, corner_texcoord;  // of all corners; those of the block are written
    std::vector<ObjTriangle> triangles = {};
    std::vector<glm::vec3> added_normals = {};  // they are numbered behind the file's
    ObjReport report = {};
    std::vector<glm::vec3> outline = {};  // of the face in hand

    const glm::vec3& position(std::size_t corner) const {
        return text.vertices.positions[static_cast<std::size_t>(text.faces.corners[corner].position)];
    }

    // Collects the outline of a face; false when the face cannot be drawn.
    bool take_outline(const ObjFace& face) {
        outline.clear();
        for (std::uint32_t i = 0; i < face.corner_count; ++i) {
            const std::size_t corner = face.first_corner + i;
            if (!is_listed(text.faces.corners[corner].position, text.vertices.positions)) {
                report.missing_vertices.add(face.line);
                return false;
            }
            outline.push_back(position(corner));
        }
        for (const glm::vec3& p : outline) {
            if (is_finite(p)) continue;
            report.not_finite.add(face.line);
            return false;
        }
        return true;
    }

    void add_triangle(std::uint32_t face_index, std::size_t a, std::size_t b, std::size_t c) {
        const std::size_t first = text.faces.faces[face_index].first_corner;
        triangles.push_back({{first + a, first + b, first + c}, face_index});
    }

    void triangulate(std::uint32_t face_index) {
        if (outline.size() == 3) return add_triangle(face_index, 0, 1, 2);
        if (outline.size() == 4) {
            const QuadCut cut = quad_cut({outline[0], outline[1], outline[2], outline[3]});
            if (cut == QuadCut::first_third) {
                add_triangle(face_index, 0, 1, 2);
                return add_triangle(face_index, 0, 2, 3);
            }
            if (cut == QuadCut::second_fourth) {
                add_triangle(face_index, 0, 1, 3);
                return add_triangle(face_index, 1, 2, 3);
            }
        }
        const Triangulation cut = ear_clip(outline);
        if (cut.self_intersecting) report.self_intersecting.add(text.faces.faces[face_index].line);
        for (const auto& [a, b, c] : cut.triangles) add_triangle(face_index, a, b, c);
    }

    // Drops those triangles from `begin` on that have no area.
    void drop_flat(std::size_t begin) {
        std::size_t kept = begin;
        for (std::size_t t = begin; t < triangles.size(); ++t) {
            const auto& [a, b, c] = triangles[t].corners;
            const std::array<glm::vec3, 3> p = {position(a), position(b), position(c)};
            if (newell_normal(p) != glm::dvec3(0)) triangles[kept++] = triangles[t];
        }
        triangles.resize(kept);
    }

    // Gives the corners of a face their normals and texture coordinates as far as the file has them, and
    // turns its triangles round when they face away from those normals.
    void resolve_corners(const ObjFace& face, std::size_t first_triangle) {
        const glm::dvec3 geometric = newell_normal(outline);
        glm::dvec3 sum(0);
        for (std::size_t c = face.first_corner; c < face.first_corner + face.corner_count; ++c) {
            const std::int32_t n = text.faces.corners[c].normal, t = text.faces.corners[c].texcoord;
            if (is_listed(n, text.normals)) {
                corner_normal[c] = n;
                sum += glm::dvec3(normals[static_cast<std::size_t>(n)]);
            } else if (n != kAbsentIndex) {
                report.missing_normals.add(face.line);
            }
            const glm::vec2 uv =
                is_listed(t, text.texcoords) ? text.texcoords[static_cast<std::size_t>(t)] : glm::vec2(NAN);
            const bool usable = std::isfinite(uv.x) && std::isfinite(uv.y);
            if (usable) corner_texcoord[c] = t;
            if (std::max(std::abs(uv.x), std::abs(uv.y)) > kMostTextureCopies)
                report.far_texcoords.add(face.line);
            if (!usable && t != kAbsentIndex) report.missing_texcoords.add(face.line);
        }
        const bool reversed = glm::dot(geometric, sum) < 0;
        if (reversed) {
            report.reversed.add(face.line);
            for (std::size_t t = first_triangle; t < triangles.size(); ++t) {
                std::swap(triangles[t].corners[1], triangles[t].corners[2]);
            }
        }
        use_face_normal(face, reversed ? -geometric : geometric);
    }

    // Gives the normal of the face to corners whose own is useless, and to those without one where the face
    // is shaded flat.
    void use_face_normal(const ObjFace& face, glm::dvec3 geometric) {
        // Where the outline crosses itself so that its areas cancel, the face has no normal: one is
        // generated.
        const glm::vec3 own = unit_or_zero(geometric);
        std::int32_t of_face = kAbsentIndex;
        for (std::size_t c = face.first_corner; c < face.first_corner + face.corner_count; ++c) {
            const std::int32_t n = corner_normal[c];
            const bool absent = n == kAbsentIndex;
            if (absent ? face.smoothing != kFlatShaded : normals[static_cast<std::size_t>(n)] != glm::vec3(0))
                continue;
            if (!absent) report.replaced_normals.add(face.line);
            if (of_face == kAbsentIndex && own != glm::vec3(0)) {
                of_face = static_cast<std::int32_t>(normals.size() + added_normals.size());
                added_normals.push_back(own);
            }
            corner_normal[c] = of_face;
        }
    }

    void add_face(std::uint32_t face_index) {
        const ObjFace& face = text.faces.faces[face_index];
        if (!take_outline(face)) return;
        const std::size_t first = triangles.size();
        triangulate(face_index);
        drop_flat(first);
        if (triangles.size() == first) return report.zero_area.add(face.line);
        resolve_corners(face, first);
    }
};

// Puts together what the blocks of faces have made: triangles, and the normals that faces added.
void join(std::vector<Builder>& builders, std::size_t block, const ObjFaces& faces, ObjTriangles& made,
          const Run& run) {
    const auto of_file = static_cast<std::int32_t>(made.normals.size());
    std::vector<std::size_t> first_triangle;
    std::vector<std::int32_t> added_before;
    std::size_t triangles = 0;
    for (const Builder& builder : builders) {
        first_triangle.push_back(triangles);
        added_before.push_back(static_cast<std::int32_t>(made.normals.size()) - of_file);
        triangles += builder.triangles.size();
        made.normals.insert(made.normals.end(), builder.added_normals.begin(), builder.added_normals.end());
        made.report.add_tallies(builder.report);
    }
    made.triangles.resize(triangles);
    parallel_blocks(faces.faces.size(), block, run, [&](std::size_t first, std::size_t end) {
        const std::size_t i = first / block;
        const std::vector<ObjTriangle> own = std::move(builders[i].triangles);
        std::copy(own.begin(), own.end(),
                  made.triangles.begin() + static_cast<std::ptrdiff_t>(first_triangle[i]));
        if (builders[i].added_normals.empty()) return;
        const ObjFace& last = faces.faces[end - 1];
        for (std::size_t c = faces.faces[first].first_corner; c < last.first_corner + last.corner_count; ++c)
            if (made.corner_normal[c] >= of_file) made.corner_normal[c] += added_before[i];
    });
}

}  // namespace

ObjTriangles triangulate_obj(const ObjText& text, const Run& run) {
    constexpr std::size_t kBlock = 16384;  // faces
    const std::vector<ObjFace>& faces = text.faces.faces;
    ObjTriangles made;
    made.normals.resize(text.normals.size());
    std::transform(text.normals.begin(), text.normals.end(), made.normals.begin(), unit_or_zero);
    made.corner_normal.assign(text.faces.corners.size(), kAbsentIndex);
    made.corner_texcoord.assign(text.faces.corners.size(), kAbsentIndex);
    const std::size_t blocks = (faces.size() + kBlock - 1) / kBlock;
    std::vector<Builder> builders(blocks,
                                  Builder{text, made.normals, made.corner_normal, made.corner_texcoord});
    parallel_blocks(faces.size(), kBlock, run, [&](std::size_t first, std::size_t end) {
        Builder& builder = builders[first / kBlock];
        builder.triangles.reserve(end - first);
        for (std::size_t f = first; f < end; ++f) builder.add_face(static_cast<std::uint32_t>(f));
    });
    join(builders, kBlock, text.faces, made, run);
    return made;
}

}  // namespace crevice
