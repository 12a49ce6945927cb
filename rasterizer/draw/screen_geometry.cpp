#include "rasterizer/draw/screen_geometry.h"

#include <algorithm>
#include <bit>
#include <string>

#include <glm/matrix.hpp>

#include "rasterizer/base/error.h"
#include "rasterizer/base/parallel.h"
#include "rasterizer/draw/triangle_blocks.h"
#include "rasterizer/scene/exact_projection.h"

namespace crevice {

namespace {

// Blocks are made of at least this many triangles; a large draw has about kMostBlocks.
constexpr std::uint32_t kBlockTriangles = 4096;
constexpr std::uint32_t kMostBlocks = 64;

ScreenGeometry empty_geometry(Size size, const Run& run) {
    validate(run);
    constexpr int largest = static_cast<int>(kGuardBand_px);
    if (size.width < 1 || size.height < 1 || size.width > largest || size.height > largest) {
        throw UsageError("size: width and height must lie in 1.." + std::to_string(largest) + " (" +
                         std::to_string(size.width) + "x" + std::to_string(size.height) +
                         "); choose another");
    }
    ScreenGeometry geometry;
    geometry.size = size;
    geometry.tile_size = run.tile_size;
    geometry.tiles = {(size.width + run.tile_size - 1) / run.tile_size,
                      (size.height + run.tile_size - 1) / run.tile_size};
    return geometry;
}

// Consecutive sources together, until a block is large enough.
std::vector<std::span<const BlockSource>> grouped(const std::vector<BlockSource>& sources) {
    std::vector<std::span<const BlockSource>> groups;
    std::size_t all = 0;
    for (const BlockSource& source : sources) all += source.triangles.size();
    const std::size_t enough = std::max(std::size_t{kBlockTriangles}, all / kMostBlocks);
    std::size_t first = 0, triangles = 0;
    for (std::size_t i = 0; i < sources.size(); ++i) {
        triangles += sources[i].triangles.size();
        if (triangles < enough && i + 1 < sources.size()) continue;
        groups.push_back(std::span(sources).subspan(first, i + 1 - first));
        first = i + 1;
        triangles = 0;
    }
    return groups;
}

void build_blocks(ScreenGeometry& geometry, const std::vector<BlockSource>& sources,
                  const SetupSettings& setup, const Run& run) {
    const std::vector<std::span<const BlockSource>> groups = grouped(sources);
    geometry.blocks.resize(groups.size());
    parallel_for(static_cast<int>(groups.size()), run, [&](int i) {
        const auto at = static_cast<std::size_t>(i);
        geometry.blocks[at] = build_block(geometry, groups[at], setup, run);
    });
    for (const BlockSource& source : sources) geometry.submitted_triangles += source.triangles.size();
    geometry.submitted_triangles += geometry.triangles_of_off_screen_clusters;
    std::size_t largest = 0;
    for (const TriangleBlock& block : geometry.blocks) largest = std::max(largest, block.triangles.size());
    geometry.index_bits = static_cast<int>(std::bit_width(largest));
    const std::uint64_t numbers = std::uint64_t{groups.size()} << geometry.index_bits;
    if (numbers > std::uint64_t{1} << 31) {
        throw InputError("scene: too many triangles for 31-bit numbers (" +
                         std::to_string(geometry.submitted_triangles) + "); draw it in parts");
    }
}

void append_sources(std::vector<BlockSource>& sources, BlockSource whole) {
    const auto count = static_cast<std::uint32_t>(whole.triangles.size());
    const std::uint32_t step = std::max(kBlockTriangles, (count + kMostBlocks - 1) / kMostBlocks);
    for (std::uint32_t first = 0; first < count; first += step) {
        BlockSource part = whole;
        part.triangles = whole.triangles.subspan(first, std::min(step, count - first));
        sources.push_back(part);
    }
}

// What of an instance is in view, counted, in the order of its triangles; `whole` are all of them.
void append_in_view(ScreenGeometry& geometry, std::vector<BlockSource>& sources, const Mesh& mesh,
                    const InstanceInView& in_view, const BlockSource& whole) {
    const auto append = [&](std::uint32_t part, std::uint32_t first, std::uint32_t count) {
        BlockSource source = whole;
        source.triangles = whole.triangles.subspan(first, count);
        source.material = mesh.parts[part].material;
        append_sources(sources, source);
    };
    const std::vector<TriangleCluster>& clusters = mesh.clusters.clusters;
    geometry.clusters += std::max(clusters.size(), std::size_t{1});
    if (in_view.whole) {
        for (std::uint32_t part = 0; part < mesh.parts.size(); ++part)
            append(part, mesh.parts[part].first_triangle, mesh.parts[part].triangle_count);
        return;
    }
    std::size_t drawn = 0;
    for (std::size_t i = 0; i < in_view.clusters.size();) {
        // Neighbours together.
        const TriangleCluster& first = clusters[in_view.clusters[i]];
        std::uint32_t count = 0;
        for (; i < in_view.clusters.size(); ++i) {
            const TriangleCluster& next = clusters[in_view.clusters[i]];
            if (next.part != first.part || next.first_triangle != first.first_triangle + count) break;
            count += next.triangle_count;
        }
        append(first.part, first.first_triangle, count);
        drawn += count;
    }
    geometry.off_screen_clusters += std::max(clusters.size(), std::size_t{1}) - in_view.clusters.size();
    geometry.triangles_of_off_screen_clusters += mesh.triangles.size() - drawn;
}

}  // namespace

ScreenGeometry screen_geometry(const Scene& scene, const Camera& camera, Size size,
                               const GeometrySettings& settings, const Run& run) {
    ScreenGeometry geometry = empty_geometry(size, run);
    const CameraMatrices matrices = camera_matrices(camera, size);
    geometry.rays = {matrices.ray_scale, size, camera.projection == Projection::perspective};
    geometry.depth_a = matrices.depth_a;
    geometry.depth_b = matrices.depth_b;
    geometry.depth_range = depth_range(camera);
    if (settings.with_normals) geometry.tangent_turns = tangent_turns(scene, matrices);
    // The other orders of the product are shown with their own roundings.
    const bool from_exact = settings.position_order == PositionOrder::relative;
    geometry.vertices =
        transform_vertices(scene, camera, size,
                           {settings.position_order, settings.with_normals,
                            settings.with_clip_positions || !from_exact, settings.normal_matrix},
                           run);
    const ExactClip exact{&scene, camera.eye, clip_from_relative(camera, size)};
    std::vector<BlockSource> sources;
    for (std::size_t i = 0; i < scene.instances.size(); ++i) {
        const Mesh& mesh = scene.meshes[static_cast<std::size_t>(scene.instances[i].mesh)];
        const bool mirrored = glm::determinant(glm::mat3(scene.instances[i].world_from_object)) < 0;
        const BlockSource whole{
            mesh.triangles, geometry.vertices.first_vertex[i], static_cast<std::uint32_t>(i), 0,
            mirrored,       from_exact ? &exact : nullptr};
        append_in_view(geometry, sources, mesh, geometry.vertices.in_view[i], whole);
    }
    const SetupSettings setup{!scene.two_sided && !settings.keep_back_faces, settings.depth_format,
                              settings.depth_bias};
    build_blocks(geometry, sources, setup, run);
    return geometry;
}

ScreenGeometry screen_geometry_from_clip(std::span<const glm::vec4> p_clip,
                                         std::span<const std::array<std::uint32_t, 3>> triangles, Size size,
                                         const SetupSettings& setup, const Run& run) {
    ScreenGeometry geometry = empty_geometry(size, run);
    TransformedVertices& vertices = geometry.vertices;
    vertices.first_vertex = {0};
    vertices.in_view = {InstanceInView{}};
    vertices.with_normals = true;
    vertices.n_view.resize(p_clip.size());
    std::fill(vertices.n_view.begin(), vertices.n_view.end(), glm::vec3(0));
    vertices.p_clip.resize(p_clip.size());
    std::copy(p_clip.begin(), p_clip.end(), vertices.p_clip.begin());
    vertices.projected.resize(p_clip.size());
    for (std::size_t i = 0; i < p_clip.size(); ++i)
        vertices.projected.set(i, project_vertex(p_clip[i], size));
    std::vector<BlockSource> sources;
    append_sources(sources, {triangles, 0, 0, 0, false, nullptr});
    build_blocks(geometry, sources, setup, run);
    return geometry;
}

}  // namespace crevice
