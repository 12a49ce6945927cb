#include "ssao/bakes/lightmap_charts.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>

#include <glm/geometric.hpp>

#include "rasterizer/base/error.h"
#include "ssao/bakes/chart_growth.h"
#include "ssao/bakes/shelf_packing.h"

namespace crevice {

namespace {

constexpr int kLeastTexels = 16, kMostTexels = 4096, kLeastGutter = 2, kMostGutter = 64;
// From one try to the next the density falls by this factor.
constexpr double kLessDense = 0.98;

// Corners at the same place within an instance become one point.
std::vector<std::uint32_t> welded_points(const RayScene& rays) {
    struct Corner {
        std::int32_t instance;
        glm::vec3 at;
        std::uint32_t index;
    };
    const auto place = [](const Corner& c) { return std::tie(c.instance, c.at.x, c.at.y, c.at.z); };
    std::vector<Corner> corners;
    corners.reserve(3 * rays.triangles.size());
    for (std::size_t i = 0; i < rays.triangles.size(); ++i) {
        for (const glm::vec3& at : rays.triangles[i])
            corners.push_back({rays.sources[i].instance, at, static_cast<std::uint32_t>(corners.size())});
    }
    std::sort(corners.begin(), corners.end(),
              [&](const Corner& a, const Corner& b) { return place(a) < place(b); });
    std::vector<std::uint32_t> points(corners.size());
    std::uint32_t point = 0;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        if (i > 0 && place(corners[i - 1]) != place(corners[i])) ++point;
        points[corners[i].index] = point;
    }
    return points;
}

std::vector<WeldedTriangle> welded_triangles(const RayScene& rays) {
    const std::vector<std::uint32_t> points = welded_points(rays);
    std::vector<WeldedTriangle> triangles;
    triangles.reserve(rays.triangles.size());
    for (std::size_t i = 0; i < rays.triangles.size(); ++i) {
        const glm::dvec3 a = rays.triangles[i][0], b = rays.triangles[i][1], c = rays.triangles[i][2];
        const glm::dvec3 face = glm::cross(b - a, c - a);
        const double length = glm::length(face);
        triangles.push_back(
            {{a, b, c}, {points[3 * i], points[3 * i + 1], points[3 * i + 2]}, face / length, length / 2});
    }
    return triangles;
}

// A chart starts one texel inside its rectangle: a lookup reads up to a texel further out than it is.
constexpr int kRim = 1;

Size size_in_texels(const FlatChart& chart, double density) {
    const auto side = [&](double length) { return static_cast<int>(length * density + 0.5) + 2 * kRim; };
    return {side(chart.extent.x), side(chart.extent.y)};
}

struct PackedCharts {
    double density;
    std::vector<Size> sizes;
    std::vector<glm::ivec2> corners;
};

// Nothing when they do not fit at any density.
std::optional<PackedCharts> packed(const std::vector<FlatChart>& charts, double area,
                                   const ChartSettings& settings) {
    double longest = 0;
    for (const FlatChart& chart : charts) longest = std::max(longest, chart.extent.x);
    // No chart may be longer than the map, which also keeps its size within an int.
    double density = std::min(settings.texels / std::sqrt(area), settings.texels / longest);
    for (; density * longest >= 0.5; density *= kLessDense) {
        PackedCharts result{density, {}, {}};
        for (const FlatChart& chart : charts) result.sizes.push_back(size_in_texels(chart, density));
        const auto corners = pack_shelves(result.sizes, settings.texels, settings.gutter);
        if (!corners) continue;
        result.corners = *corners;
        return result;
    }
    return std::nullopt;
}

LightmapCharts charts_of_surface(const RayScene& rays, const ChartSettings& settings) {
    LightmapCharts result{settings.texels, settings.gutter, 0, {}, {}, {}, {}};
    const std::vector<WeldedTriangle> triangles = welded_triangles(rays);
    if (triangles.empty()) return result;
    double area = 0;
    for (const WeldedTriangle& t : triangles) area += t.area;
    const std::vector<FlatChart> charts = grow_charts(triangles);
    const std::optional<PackedCharts> places = packed(charts, area, settings);
    if (!places)
        throw UsageError("lightmap: " + std::to_string(charts.size()) +
                         (charts.size() == 1 ? " chart does" : " charts do") + " not fit (" +
                         std::to_string(settings.texels) + " texels a side); give it more texels");
    result.density = places->density;
    result.texcoords.resize(triangles.size());
    result.chart.resize(triangles.size());
    for (std::size_t i = 0; i < charts.size(); ++i) {
        const glm::ivec2 corner = places->corners[i];
        const Size size = places->sizes[i];
        result.rects.push_back({corner.x, corner.y, corner.x + size.width, corner.y + size.height});
        for (const FlatTriangle& t : charts[i].triangles) {
            result.chart[t.triangle] = static_cast<std::int32_t>(i);
            for (std::size_t k = 0; k < 3; ++k) {
                const glm::dvec2 at = glm::dvec2(corner + kRim) + places->density * t.corners[k];
                result.texcoords[t.triangle][k] = at / double(settings.texels);
            }
        }
    }
    return result;
}

// ---- the meshes' own coordinates

double area_of(const TriangleTexcoords& t) {
    const glm::dvec2 a = glm::dvec2(t[1]) - glm::dvec2(t[0]), b = glm::dvec2(t[2]) - glm::dvec2(t[0]);
    return std::abs(a.x * b.y - a.y * b.x) / 2;
}

// Fills result.texcoords; returns why they cannot serve, or "".
std::string take_mesh_texcoords(const Scene& scene, const RayScene& rays, LightmapCharts& result) {
    for (const TriangleSource& source : rays.sources) {
        const Instance& instance = scene.instances[static_cast<std::size_t>(source.instance)];
        const Mesh& mesh = scene.meshes[static_cast<std::size_t>(instance.mesh)];
        const std::string name = "mesh " + std::to_string(instance.mesh);
        if (mesh.texcoords.empty()) return name + " has none";
        TriangleTexcoords corners;
        for (std::size_t i = 0; i < 3; ++i) {
            corners[i] = mesh.texcoords[mesh.triangles[static_cast<std::size_t>(source.triangle)][i]];
            const bool inside =
                corners[i].x >= 0 && corners[i].x <= 1 && corners[i].y >= 0 && corners[i].y <= 1;
            if (!inside)
                return name + ", triangle " + std::to_string(source.triangle) + " lies outside [0,1]";
        }
        result.texcoords.push_back(corners);
    }
    return "";
}

std::string texels_covered_twice(const LightmapCharts& charts, const Run& run) {
    const TexelCoverage coverage = texel_coverage(charts.texcoords, charts.texels, run);
    long long twice = 0;
    for (int y = 0; y < charts.texels; ++y) {
        for (int x = 0; x < charts.texels; ++x) twice += coverage.times.at(x, y) > 1 ? 1 : 0;
    }
    return twice == 0 ? ""
                      : "they overlap (" + std::to_string(twice) +
                            (twice == 1 ? " texel is" : " texels are") + " covered twice)";
}

LightmapCharts charts_of_meshes(const Scene& scene, const RayScene& rays, const ChartSettings& settings,
                                const Run& run) {
    LightmapCharts result{settings.texels, settings.gutter, 0, {}, {}, {}, {}};
    result.note = take_mesh_texcoords(scene, rays, result);
    if (result.note.empty()) result.note = texels_covered_twice(result, run);
    if (!result.note.empty()) return result;
    result.chart.assign(rays.triangles.size(), 0);
    result.rects = {{0, 0, settings.texels, settings.texels}};
    double in_map = 0, in_scene = 0;
    for (const TriangleTexcoords& t : result.texcoords) in_map += area_of(t);
    for (const WeldedTriangle& t : welded_triangles(rays)) in_scene += t.area;
    result.density = in_scene > 0 ? settings.texels * std::sqrt(in_map / in_scene) : 0;
    return result;
}

void require_whole_within(const char* name, int value, int least, int most) {
    if (value >= least && value <= most) return;
    throw UsageError(std::string(name) + ": must lie in " + std::to_string(least) + ".." +
                     std::to_string(most) + " (" + std::to_string(value) + "); choose another number");
}

}  // namespace

void validate(const ChartSettings& settings) {
    require_whole_within("texels", settings.texels, kLeastTexels, kMostTexels);
    require_whole_within("gutter", settings.gutter, kLeastGutter, kMostGutter);
}

LightmapCharts lightmap_charts(const Scene& scene, const RayScene& rays, const ChartSettings& settings,
                               const Run& run) {
    validate(settings);
    validate(run);
    std::string note;
    if (settings.mesh_texcoords) {
        LightmapCharts own = charts_of_meshes(scene, rays, settings, run);
        if (own.note.empty()) return own;
        note = "texture coordinates of the meshes cannot be used: " + own.note;
    }
    LightmapCharts charts = charts_of_surface(rays, settings);
    charts.note = note;
    return charts;
}

}  // namespace crevice
