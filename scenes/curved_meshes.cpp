#include "scenes/curved_meshes.h"

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "rasterizer/base/error.h"
#include "scenes/lattice_mesh.h"

namespace crevice {
namespace {

// On the outer side of a step down a profile.
glm::dvec2 outward(glm::dvec2 from, glm::dvec2 to) {
    return glm::normalize(glm::dvec2(from.y - to.y, to.x - from.x));
}

// A smooth piece of a profile: points, normals, and how far along the profile each is, in [0,1].
struct ProfilePoint {
    glm::dvec2 at, normal;
    double along;
};
using ProfilePiece = std::vector<ProfilePoint>;

std::vector<ProfilePiece> smooth_pieces(std::span<const glm::dvec2> profile) {
    const double crease_cosine = sine_cosine(kCrease_rad).cosine;
    std::vector<ProfilePiece> pieces;
    double along = 0;
    glm::dvec2 before(0);  // the outward direction of the step before
    for (std::size_t i = 0; i + 1 < profile.size(); ++i) {
        const glm::dvec2 here = outward(profile[i], profile[i + 1]);
        if (i == 0 || glm::dot(before, here) < crease_cosine) {
            pieces.push_back({{profile[i], here, along}});
        } else {
            pieces.back().back().normal = glm::normalize(before + here);
        }
        along += glm::length(profile[i + 1] - profile[i]);
        pieces.back().push_back({profile[i + 1], here, along});
        before = here;
    }
    for (ProfilePiece& piece : pieces) {
        for (ProfilePoint& point : piece) point.along /= along;
    }
    return pieces;
}

// The normals of a lattice's smooth surface. Where its first and last column are at the same place, as round a
// column, they are the same.
std::vector<glm::vec3> normals_across_seam(const Mesh& mesh, int columns) {
    const auto first_of_row = [columns](std::uint32_t vertex) {
        return vertex - vertex % static_cast<std::uint32_t>(columns);
    };
    std::vector<std::uint32_t> joined(mesh.positions.size());
    for (std::uint32_t v = 0; v < joined.size(); ++v)
        joined[v] = mesh.positions[v] == mesh.positions[first_of_row(v)] ? first_of_row(v) : v;
    Mesh closed = mesh;
    for (auto& triangle : closed.triangles) {
        for (std::uint32_t& vertex : triangle) vertex = joined[vertex];
    }
    const std::vector<glm::vec3> normals = smooth_normals(closed, {.threads = 1});
    std::vector<glm::vec3> all;
    for (const std::uint32_t vertex : joined) all.push_back(normals[vertex]);
    return all;
}

void require(bool good, const char* what) {
    if (!good) throw UsageError(std::string("curved mesh: ") + what);
}

}  // namespace

Mesh curved_mesh(const CurvedSurface& surface, int columns, int rows, glm::dvec2 repeats) {
    require(columns >= 1 && rows >= 1, "there are no squares; give at least one column and one row");
    // Where the surface closes, rounding would leave a crack.
    const bool closed = glm::length(surface(1, 0) - surface(0, 0)) < 1e-9 &&
                        glm::length(surface(1, 1) - surface(0, 1)) < 1e-9;
    Mesh mesh;
    for (int i = 0; i <= rows; ++i) {
        const double v = static_cast<double>(i) / rows;
        for (int j = 0; j <= columns; ++j) {
            const double u = static_cast<double>(j) / columns;
            add_vertex(mesh, surface(closed && j == columns ? 0 : u, v), {0, 1, 0},
                       glm::dvec2(u, v) * repeats);
        }
    }
    add_lattice_triangles(mesh, 0, rows + 1, columns + 1);
    mesh.normals = normals_across_seam(mesh, columns + 1);
    return as_one_part(std::move(mesh));
}

Mesh lathe_mesh(std::span<const glm::dvec2> profile, int slices, glm::dvec2 repeats, int slices_made) {
    require(slices >= 3 && profile.size() >= 2, "too little to turn; give at least 3 slices and 2 points");
    require(slices_made >= 1 && slices_made <= slices,
            "more or less than a turn; give 1 to all of the slices");
    Mesh mesh;
    for (const ProfilePiece& piece : smooth_pieces(profile)) {
        const int first = static_cast<int>(mesh.positions.size());
        for (const ProfilePoint& point : piece) {
            for (int j = 0; j <= slices_made; ++j) {
                const glm::dvec2 around = slice_direction(j, slices);
                add_vertex(mesh, {point.at.x * around.x, point.at.y, point.at.x * around.y},
                           {point.normal.x * around.x, point.normal.y, point.normal.x * around.y},
                           glm::dvec2(static_cast<double>(j) / slices, point.along) * repeats);
            }
        }
        add_lattice_triangles(mesh, first, static_cast<int>(piece.size()), slices_made + 1);
    }
    return as_one_part(std::move(mesh));
}

Mesh lathe_mesh(std::span<const glm::dvec2> profile, int slices, glm::dvec2 repeats) {
    return lathe_mesh(profile, slices, repeats, slices);
}

Mesh frame_mesh(glm::dvec2 half, std::span<const glm::dvec2> profile, double repeats_a_unit) {
    require(profile.size() >= 2, "a profile without length; give at least 2 points");
    // Each side: the way outward, and the way along it to the right as seen from outside.
    static constexpr std::array<std::array<glm::dvec2, 2>, 4> kSides = {
        {{{{0, 1}, {-1, 0}}}, {{{-1, 0}, {0, -1}}}, {{{0, -1}, {1, 0}}}, {{{1, 0}, {0, 1}}}}};
    Mesh mesh;
    for (const auto& [out, right] : kSides) {
        double down = 0;
        for (std::size_t i = 0; i + 1 < profile.size(); ++i) {
            const glm::dvec2 normal = outward(profile[i], profile[i + 1]);
            const double steps[] = {down, down + glm::length(profile[i + 1] - profile[i])};
            const int first = static_cast<int>(mesh.positions.size());
            for (std::size_t k = 0; k < 2; ++k) {
                const glm::dvec2 far_out = half + profile[i + k].x;
                for (const double end : {-1.0, 1.0}) {
                    const glm::dvec2 at = (out + end * right) * far_out;
                    add_vertex(mesh, {at.x, profile[i + k].y, at.y},
                               {normal.x * out.x, normal.y, normal.x * out.y},
                               repeats_a_unit * glm::dvec2(glm::dot(at, right), steps[k]));
                }
            }
            add_lattice_triangles(mesh, first, 2, 2);
            down = steps[1];
        }
    }
    return as_one_part(std::move(mesh));
}

}  // namespace crevice
