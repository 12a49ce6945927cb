#include "ssao/bakes/vertex_ao.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <span>
#include <tuple>

#include <glm/geometric.hpp>

#include "rasterizer/scene/world_mesh.h"
#include "ssao/bakes/cast_in_pieces.h"
#include "ssao/inputs/random_vectors.h"

namespace crevice {

namespace {

// The vertices of a triangle, as indices into its instance's mesh.
const std::array<std::uint32_t, 3>& vertices_of(const Scene& scene, const TriangleSource& source) {
    const auto mesh =
        static_cast<std::size_t>(scene.instances[static_cast<std::size_t>(source.instance)].mesh);
    return scene.meshes[mesh].triangles[static_cast<std::size_t>(source.triangle)];
}

// All open; `unused` is counted.
VertexAo open_everywhere(const Scene& scene, const RayScene& rays) {
    VertexAo ao;
    std::vector<std::vector<bool>> used;
    for (const Instance& instance : scene.instances) {
        const Mesh& mesh = scene.meshes[static_cast<std::size_t>(instance.mesh)];
        ao.accessibility.emplace_back(mesh.positions.size(), 1.0f);
        used.emplace_back(mesh.positions.size(), false);
    }
    for (const TriangleSource& source : rays.sources) {
        for (const std::uint32_t vertex : vertices_of(scene, source))
            used[static_cast<std::size_t>(source.instance)][vertex] = true;
    }
    for (const std::vector<bool>& of_instance : used)
        ao.unused += static_cast<std::size_t>(std::count(of_instance.begin(), of_instance.end(), false));
    return ao;
}

glm::dvec3 centroid(const Corners& c) {
    return (glm::dvec3(c[0]) + glm::dvec3(c[1]) + glm::dvec3(c[2])) / 3.0;
}

double area_of(const Corners& c) {
    const glm::dvec3 a = c[0];
    return 0.5 * glm::length(glm::cross(glm::dvec3(c[1]) - a, glm::dvec3(c[2]) - a));
}

// One corner of a triangle. Corners at one place with one normal belong together.
struct Corner {
    glm::vec3 position, normal;  // relative; the normal is unit, or 0: there is none
    std::int32_t triangle;       // of RayScene
    std::uint32_t index;         // 0, 1, 2 in the triangle

    auto place() const {
        // + 0: -0 and 0 are one place.
        return std::tuple(position.x + 0.0f, position.y + 0.0f, position.z + 0.0f, normal.x + 0.0f,
                          normal.y + 0.0f, normal.z + 0.0f);
    }
};

// All corners, those that belong together side by side, in an order that does not hang on the sort.
std::vector<Corner> corners_by_place(const Scene& scene, const RayScene& rays) {
    std::vector<std::vector<glm::vec3>> normals;
    for (const Instance& instance : scene.instances)
        normals.push_back(
            world_normals(scene.meshes[static_cast<std::size_t>(instance.mesh)], instance.world_from_object));
    std::vector<Corner> corners;
    corners.reserve(3 * rays.triangles.size());
    for (std::size_t t = 0; t < rays.triangles.size(); ++t) {
        const auto triangle = static_cast<std::int32_t>(t);
        const auto& vertices = vertices_of(scene, rays.sources[t]);
        for (std::uint32_t i = 0; i < 3; ++i) {
            glm::vec3 n = normals[static_cast<std::size_t>(rays.sources[t].instance)][vertices[i]];
            if (!(glm::dot(n, n) > 0.5f)) n = glm::vec3(0);
            corners.push_back({rays.triangles[t][i], n, triangle, i});
        }
    }
    std::sort(corners.begin(), corners.end(), [](const Corner& a, const Corner& b) {
        return std::tuple(a.place(), a.triangle, a.index) < std::tuple(b.place(), b.triangle, b.index);
    });
    return corners;
}

// Where the rays of a corner start.
SurfacePoint point_of(const RayScene& rays, const Corner& corner) {
    const Corners& triangle = rays.triangles[static_cast<std::size_t>(corner.triangle)];
    const glm::dvec3 from = triangle[corner.index];
    const glm::dvec3 start = from + static_cast<double>(kInward) * (centroid(triangle) - from);
    const glm::vec3 face = geometric_normal(rays, corner.triangle);
    if (corner.normal == glm::vec3(0)) return {glm::vec3(start), face, face};
    // The side that the vertex normal says is the outer one.
    return {glm::vec3(start), corner.normal, glm::dot(face, corner.normal) < 0 ? -face : face};
}

// Corners [first, end) of corners_by_place(), which share a value.
struct Place {
    std::size_t first, end;
};

std::vector<Place> places_of(const std::vector<Corner>& corners) {
    std::vector<Place> places;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        if (places.empty() || corners[i].place() != corners[places.back().first].place())
            places.push_back({i, i});
        places.back().end = i + 1;
    }
    return places;
}

double mean_by_area(const RayScene& rays, const std::vector<Corner>& corners, const std::vector<float>& open,
                    const Place& place) {
    double sum = 0, total = 0;
    for (std::size_t i = place.first; i < place.end; ++i) {
        const double area = area_of(rays.triangles[static_cast<std::size_t>(corners[i].triangle)]);
        sum += area * static_cast<double>(open[i]);
        total += area;
    }
    return sum / total;
}

// Each vertex the mean of the triangles that use it; `open` one a triangle.
VertexAo means_of_triangles(const Scene& scene, const RayScene& rays, const std::vector<float>& open) {
    VertexAo ao = open_everywhere(scene, rays);
    std::vector<std::vector<double>> sum, count;
    for (const std::vector<float>& of_instance : ao.accessibility) sum.emplace_back(of_instance.size(), 0.0);
    count = sum;
    for (std::size_t i = 0; i < open.size(); ++i) {
        const auto instance = static_cast<std::size_t>(rays.sources[i].instance);
        for (const std::uint32_t vertex : vertices_of(scene, rays.sources[i])) {
            sum[instance][vertex] += static_cast<double>(open[i]);
            count[instance][vertex] += 1;
        }
    }
    for (std::size_t i = 0; i < sum.size(); ++i) {
        for (std::size_t v = 0; v < sum[i].size(); ++v) {
            if (count[i][v] > 0) ao.accessibility[i][v] = static_cast<float>(sum[i][v] / count[i][v]);
        }
    }
    return ao;
}

}  // namespace

std::vector<SurfacePoint> triangle_centroids(const RayScene& rays) {
    std::vector<SurfacePoint> points;
    points.reserve(rays.triangles.size());
    for (std::size_t i = 0; i < rays.triangles.size(); ++i) {
        const glm::vec3 normal = geometric_normal(rays, static_cast<std::int32_t>(i));
        points.push_back({glm::vec3(centroid(rays.triangles[i])), normal, normal});
    }
    return points;
}

VertexAo vertex_ao_from_centroids(const Scene& scene, const RayScene& rays, const RayAoSettings& settings,
                                  const Run& run, const TrianglesDone& on_progress) {
    validate(settings);
    validate(run);
    const std::vector<SurfacePoint> points = triangle_centroids(rays);
    const auto seed_of = [&](std::uint32_t piece) { return hash_of(settings.seed, 0, piece); };
    const std::vector<float> open = cast_in_pieces(rays, points, settings, seed_of, run, on_progress);
    VertexAo ao = means_of_triangles(scene, rays, open);
    ao.rays_cast = static_cast<long long>(points.size()) * settings.rays;
    ao.lifted_far = lifted_far(points, settings.radius);
    return ao;
}

VertexAo vertex_ao_from_corners(const Scene& scene, const RayScene& rays, const RayAoSettings& settings,
                                const Run& run, const TrianglesDone& on_progress) {
    validate(settings);
    validate(run);
    VertexAo ao = open_everywhere(scene, rays);
    const std::vector<Corner> corners = corners_by_place(scene, rays);
    const std::vector<Place> places = places_of(corners);
    // The corners that are given the same number of rays are cast from together.
    std::map<int, std::vector<std::size_t>> corners_by_rays;
    for (const Place& place : places) {
        const auto count = static_cast<long long>(place.end - place.first);
        const auto each = static_cast<int>((settings.rays + count - 1) / count);
        for (std::size_t i = place.first; i < place.end; ++i) corners_by_rays[each].push_back(i);
    }
    std::vector<float> open(corners.size());
    long long corners_done = 0;
    for (const auto& [each, indices] : corners_by_rays) {
        std::vector<SurfacePoint> points;
        for (const std::size_t i : indices) points.push_back(point_of(rays, corners[i]));
        RayAoSettings share = settings;
        share.rays = each;
        const auto seed_of = [&](std::uint32_t piece) {
            return hash_of(settings.seed, static_cast<std::uint32_t>(share.rays), piece);
        };
        const std::vector<float> values =
            cast_in_pieces(rays, points, share, seed_of, run, [&](long long more) {
                const long long before = corners_done / 3;
                corners_done += more;
                if (on_progress) on_progress(corners_done / 3 - before);
            });
        for (std::size_t i = 0; i < indices.size(); ++i) open[indices[i]] = values[i];
        ao.rays_cast += static_cast<long long>(points.size()) * each;
        ao.lifted_far += lifted_far(points, settings.radius);
    }
    for (const Place& place : places) {
        const auto value = static_cast<float>(mean_by_area(rays, corners, open, place));
        for (std::size_t i = place.first; i < place.end; ++i) {
            const TriangleSource& source = rays.sources[static_cast<std::size_t>(corners[i].triangle)];
            const std::uint32_t vertex = vertices_of(scene, source)[corners[i].index];
            ao.accessibility[static_cast<std::size_t>(source.instance)][vertex] = value;
        }
    }
    return ao;
}

std::vector<float> joined(const VertexAo& ao) {
    std::vector<float> values;
    for (const std::vector<float>& of_instance : ao.accessibility)
        values.insert(values.end(), of_instance.begin(), of_instance.end());
    return values;
}

}  // namespace crevice
