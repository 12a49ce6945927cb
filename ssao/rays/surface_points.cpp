#include "ssao/rays/surface_points.h"

#include <cmath>
#include <limits>
#include <string>

#include <glm/geometric.hpp>

#include "rasterizer/base/error.h"
#include "rasterizer/base/parallel.h"
#include "rasterizer/draw/cutouts.h"

namespace crevice {

namespace {

// The point of the triangle that is nearest to p, which lies in its plane. Coverage is decided with snapped
// corners, so a pixel at an edge may show a triangle just beyond its end; a point left there would lie below
// the neighbour.
glm::dvec3 nearest_in_triangle(const glm::dvec3& p, const glm::dvec3 (&corner)[3],
                               const glm::dvec3& unit_normal) {
    glm::dvec3 nearest = p;
    double least = std::numeric_limits<double>::infinity();
    bool inside = true;
    for (int i = 0; i < 3; ++i) {
        const glm::dvec3 &from = corner[i], edge = corner[(i + 1) % 3] - from;
        inside = inside && glm::dot(glm::cross(edge, p - from), unit_normal) >= 0;
        const double along = glm::dot(p - from, edge) / glm::dot(edge, edge);
        const glm::dvec3 on_edge = from + (along > 0 ? (along < 1 ? along : 1) : 0) * edge;
        const glm::dvec3 away = p - on_edge;
        if (glm::dot(away, away) >= least) continue;
        least = glm::dot(away, away);
        nearest = on_edge;
    }
    return inside ? p : nearest;
}

// All in double, relative space.
class PointFinder {
 public:
    PointFinder(const Scene& scene, const Camera& camera, const ScreenGeometry& geometry)
        : scene_(scene), eye_(camera.eye), geometry_(geometry) {
        const CameraMatrices matrices = camera_matrices(camera, geometry.size);
        relative_from_view_ = glm::dmat3(glm::mat3(matrices.relative_from_view));
    }

    SurfacePoint at(int x, int y, const GBuffer& g, const ScreenTriangle& t) const {
        // The corners clockwise as seen. A clipped triangle keeps the order in which it was submitted; any other
        // has that in which it was drawn, after snapping.
        const bool turn = t.clipped >= 0 ? t.shows_back : t.back_facing != t.shows_back;
        glm::dvec3 corner[3];
        for (std::size_t i = 0; i < 3; ++i) corner[i] = corner_of(t.instance, t.vertex[turn ? 2 - i : i]);
        const glm::dvec3 face = glm::cross(corner[1] - corner[0], corner[2] - corner[0]);
        const glm::dvec3 seen = seen_position(x, y, g.view_depth.at(x, y));
        // The corners come clockwise as seen, so this is the side that the G-buffer's normal is of: the
        // rasterizer's own word, which a triangle seen nearly edge-on may have against the eye's. A triangle that
        // double finds no area in has no plane: what is seen faces the eye.
        const double area = glm::length(face);
        const glm::dvec3 geometric = area > 0 ? face / area : -glm::normalize(seen);
        const glm::dvec3 in_plane = seen - glm::dot(geometric, seen - corner[0]) * geometric;
        const glm::dvec3 position = area > 0 ? nearest_in_triangle(in_plane, corner, geometric) : seen;
        const glm::dvec3 normal = relative_from_view_ * glm::dvec3(g.normal.at(x, y));
        const double length = glm::length(normal);
        return {glm::vec3(position), glm::vec3(length > 0 ? normal / length : geometric),
                glm::vec3(geometric)};
    }

 private:
    glm::dvec3 corner_of(std::size_t instance, std::uint32_t vertex) const {
        const Instance& placed = scene_.instances[instance];
        const Mesh& mesh = scene_.meshes[static_cast<std::size_t>(placed.mesh)];
        const std::uint32_t first = geometry_.vertices.first_vertex[instance];
        const glm::vec3& p = mesh.positions[vertex - first];
        return glm::dvec3(glm::dmat4(placed.world_from_object) * glm::dvec4(p, 1)) - eye_;
    }
    glm::dvec3 seen_position(int x, int y, double view_depth) const {
        const double u = (x + 0.5) / geometry_.size.width, v = (y + 0.5) / geometry_.size.height;
        const Vec3<double> p = geometry_.rays.p_view<double>(u, v, view_depth);
        return relative_from_view_ * glm::dvec3(p.x, p.y, p.z);
    }

    const Scene& scene_;
    glm::dvec3 eye_;
    const ScreenGeometry& geometry_;
    glm::dmat3 relative_from_view_;
};

}  // namespace

Image<float> picture_of(const SurfacePoints& points, std::span<const float> values, float background) {
    if (values.size() != points.points.size())
        throw InputError("picture of surface points: " + std::to_string(values.size()) + " values for " +
                         std::to_string(points.points.size()) + " points; give one a point");
    Image<float> picture(points.size, background);
    for (std::size_t i = 0; i < values.size(); ++i)
        picture.at(points.pixel[i] % points.size.width, points.pixel[i] / points.size.width) = values[i];
    return picture;
}

SurfacePoints surface_points(const Scene& scene, const Camera& camera, const GBuffer& gbuffer,
                             const Run& run) {
    const Size size = gbuffer.view_depth.size;
    NormalDepthSettings settings;
    settings.depth_format = gbuffer.depth.format;
    const ScreenGeometry geometry = screen_geometry(scene, camera, size, geometry_settings(settings), run);
    const Image<std::int32_t> shown =
        visibility(geometry, gbuffer.depth.format, camera.reversed_z, alpha_holes(scene, geometry, run), run)
            .triangle;
    SurfacePoints points{size, {}, {}};
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
            if (shown.at(x, y) != kNoTriangle) points.pixel.push_back(y * size.width + x);
        }
    }
    points.points.resize(points.pixel.size());
    const PointFinder finder(scene, camera, geometry);
    constexpr int kPiece = 1024;
    const int count = static_cast<int>(points.pixel.size());
    parallel_for((count + kPiece - 1) / kPiece, run, [&](int piece) {
        for (int i = piece * kPiece; i < std::min(count, (piece + 1) * kPiece); ++i) {
            const int pixel = points.pixel[static_cast<std::size_t>(i)];
            const int x = pixel % size.width, y = pixel / size.width;
            points.points[static_cast<std::size_t>(i)] =
                finder.at(x, y, gbuffer, *geometry.triangle(shown.at(x, y)).triangle);
        }
    });
    return points;
}

}  // namespace crevice
