#include "ssao/bakes/lightmap_ao.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "rasterizer/base/parallel.h"
#include "rasterizer/scene/world_mesh.h"
#include "ssao/bakes/cast_in_pieces.h"
#include "ssao/bakes/flat_cells.h"
#include "ssao/bakes/square_clip.h"
#include "ssao/inputs/random_vectors.h"

namespace crevice {

namespace {

// How far from the edges of its triangle a point stays, texels; less in triangles that are thinner. The
// floats of positions are far finer than that.
constexpr double kFromEdges_texels = 1.0 / 64;
constexpr double kLargestLeastWeight = 0.25;

using MapTriangle = std::array<glm::dvec2, 3>;

MapTriangle in_texels(const LightmapCharts& charts, std::size_t triangle) {
    const TriangleTexcoords& t = charts.texcoords[triangle];
    const double side = charts.texels;
    return {side * glm::dvec2(t[0]), side * glm::dvec2(t[1]), side * glm::dvec2(t[2])};
}

// The corners' weights at a place in the map, kept off the edges. A triangle without area in the map has its
// middle everywhere.
glm::dvec3 weights_at(const MapTriangle& t, glm::dvec2 at) {
    const double whole = cross(t[1] - t[0], t[2] - t[0]);
    if (whole == 0) return glm::dvec3(1.0 / 3);
    glm::dvec3 weights(0);
    for (int i = 0; i < 3; ++i) {
        const glm::dvec2 from = t[static_cast<std::size_t>((i + 1) % 3)],
                         to = t[static_cast<std::size_t>((i + 2) % 3)];
        const double least = kFromEdges_texels * glm::length(to - from) / std::abs(whole);
        weights[i] = std::max(cross(from - at, to - at) / whole, std::min(least, kLargestLeastWeight));
    }
    return weights / (weights.x + weights.y + weights.z);
}

// From a triangle and weights of its corners to the point.
class PointMaker {
 public:
    PointMaker(const Scene& scene, const RayScene& rays) : scene_(scene), rays_(rays) {
        for (const Instance& instance : scene.instances)
            normals_.push_back(world_normals(mesh_of(instance), instance.world_from_object));
    }

    SurfacePoint at(std::size_t triangle, const glm::dvec3& weights) const {
        const TriangleSource& source = rays_.sources[triangle];
        const auto instance = static_cast<std::size_t>(source.instance);
        const auto& vertices =
            mesh_of(scene_.instances[instance]).triangles[static_cast<std::size_t>(source.triangle)];
        glm::dvec3 position(0), normal(0);
        for (int i = 0; i < 3; ++i) {
            const auto corner = static_cast<std::size_t>(i);
            position += weights[i] * glm::dvec3(rays_.triangles[triangle][corner]);
            normal += weights[i] * glm::dvec3(normals_[instance][vertices[corner]]);
        }
        const glm::vec3 face = geometric_normal(rays_, static_cast<std::int32_t>(triangle));
        const double length = glm::length(normal);
        const glm::vec3 shown = length > 0 ? glm::vec3(normal / length) : face;
        return {glm::vec3(position), shown, glm::dot(shown, face) < 0 ? -face : face};
    }

 private:
    const Mesh& mesh_of(const Instance& instance) const {
        return scene_.meshes[static_cast<std::size_t>(instance.mesh)];
    }

    const Scene& scene_;
    const RayScene& rays_;
    std::vector<std::vector<glm::vec3>> normals_;  // world, of each instance
};

struct TexelOwners {
    Image<std::int32_t> triangle;  // -1: none
    Image<TexelKind> kind;         // empty, centre or touched
};

// Calls body(x, y) for the texels of the map that a triangle's bounding box reaches.
template <class Body>
void for_texels_around(const MapTriangle& t, int texels, const Body& body) {
    const auto texel = [&](glm::dvec2 at) {
        return glm::clamp(glm::ivec2(at), glm::ivec2(0), glm::ivec2(texels - 1));
    };
    const glm::ivec2 first = texel(glm::min(t[0], glm::min(t[1], t[2])));
    const glm::ivec2 last = texel(glm::max(t[0], glm::max(t[1], t[2])));
    for (int y = first.y; y <= last.y; ++y) {
        for (int x = first.x; x <= last.x; ++x) body(x, y);
    }
}

TexelOwners texel_owners(const LightmapCharts& charts, const Run& run) {
    TexelCoverage coverage = texel_coverage(charts.texcoords, charts.texels, run);
    TexelOwners owners{std::move(coverage.triangle), Image<TexelKind>(coverage.times.size, TexelKind::empty)};
    for (int y = 0; y < charts.texels; ++y) {
        for (int x = 0; x < charts.texels; ++x) {
            if (owners.triangle.at(x, y) >= 0) owners.kind.at(x, y) = TexelKind::centre;
        }
    }
    for (std::size_t i = 0; i < charts.texcoords.size(); ++i) {
        const MapTriangle t = in_texels(charts, i);
        for_texels_around(t, charts.texels, [&](int x, int y) {
            if (owners.triangle.at(x, y) >= 0 || !middle_in_square(t, {x, y})) return;
            owners.triangle.at(x, y) = static_cast<std::int32_t>(i);
            owners.kind.at(x, y) = TexelKind::touched;
        });
    }
    return owners;
}

// Where in the map the rays of a texel start.
glm::dvec2 place_in_map(const MapTriangle& t, TexelKind kind, int x, int y) {
    const glm::dvec2 centre(x + 0.5, y + 0.5);
    return kind == TexelKind::centre ? centre : middle_in_square(t, {x, y}).value_or(centre);
}

}  // namespace

LightmapPoints lightmap_points(const Scene& scene, const RayScene& rays, const LightmapCharts& charts,
                               const Run& run) {
    TexelOwners owners = texel_owners(charts, run);
    const Size size = owners.triangle.size;
    SurfacePoints texels{size, {}, {}};
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
            if (owners.triangle.at(x, y) >= 0) texels.pixel.push_back(y * size.width + x);
        }
    }
    const PointMaker maker(scene, rays);
    texels.points.resize(texels.pixel.size());
    const auto count = static_cast<int>(texels.pixel.size());
    constexpr int kBand = 1024;
    parallel_for((count + kBand - 1) / kBand, run, [&](int band) {
        for (int i = band * kBand; i < std::min(count, (band + 1) * kBand); ++i) {
            const int pixel = texels.pixel[static_cast<std::size_t>(i)];
            const int x = pixel % size.width, y = pixel / size.width;
            const auto triangle = static_cast<std::size_t>(owners.triangle.at(x, y));
            const MapTriangle t = in_texels(charts, triangle);
            texels.points[static_cast<std::size_t>(i)] =
                maker.at(triangle, weights_at(t, place_in_map(t, owners.kind.at(x, y), x, y)));
        }
    });
    return {std::move(texels), std::move(owners.kind)};
}

std::size_t LightmapAo::count(TexelKind of_kind) const {
    std::size_t total = 0;
    for (int y = 0; y < kind.size.height; ++y)
        total += static_cast<std::size_t>(std::count(kind.row(y), kind.row(y) + kind.size.width, of_kind));
    return total;
}

LightmapAo lightmap_ao(const RayScene& rays, const LightmapCharts& charts, const LightmapPoints& points,
                       const RayAoSettings& settings, const Run& run,
                       const std::function<void(long long)>& on_progress) {
    validate(settings);
    validate(run);
    const std::span<const SurfacePoint> all = points.texels.points;
    const auto seed_of = [&](std::uint32_t piece) { return hash_of(settings.seed, piece, 0); };
    const std::vector<float> open = cast_in_pieces(rays, all, settings, seed_of, run, on_progress);
    LightmapAo result{picture_of(points.texels, open), points.kind,
                      static_cast<long long>(all.size()) * settings.rays, lifted_far(all, settings.radius)};
    return dilated(std::move(result), charts.gutter);
}

LightmapAo dilated(LightmapAo map, int rounds) {
    const Size size = map.ao.size;
    for (int round = 0; round < rounds; ++round) {
        const Image<TexelKind> before = map.kind;
        for (int y = 0; y < size.height; ++y) {
            for (int x = 0; x < size.width; ++x) {
                if (before.at(x, y) != TexelKind::empty) continue;
                double sum = 0;
                int count = 0;
                for (int ny = std::max(y - 1, 0); ny <= std::min(y + 1, size.height - 1); ++ny) {
                    for (int nx = std::max(x - 1, 0); nx <= std::min(x + 1, size.width - 1); ++nx) {
                        if (before.at(nx, ny) == TexelKind::empty) continue;
                        sum += static_cast<double>(map.ao.at(nx, ny));
                        ++count;
                    }
                }
                if (count == 0) continue;
                map.ao.at(x, y) = static_cast<float>(sum / count);
                map.kind.at(x, y) = TexelKind::dilated;
            }
        }
    }
    return map;
}

float lightmap_at(const Image<float>& map, glm::vec2 texcoord) {
    const auto texels = glm::vec2(map.size.width, map.size.height);
    const glm::vec2 at = glm::clamp(texcoord * texels - 0.5f, glm::vec2(0), texels - 1.0f);
    const glm::ivec2 first(at);
    const glm::ivec2 second = glm::min(first + 1, glm::ivec2(map.size.width - 1, map.size.height - 1));
    const glm::vec2 between = at - glm::vec2(first);
    const float above = mix(map.at(first.x, first.y), map.at(second.x, first.y), between.x);
    const float below = mix(map.at(first.x, second.y), map.at(second.x, second.y), between.x);
    return mix(above, below, between.y);
}

}  // namespace crevice
