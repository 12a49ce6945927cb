#include "rasterizer/draw/pixel_fragments.h"

#include <algorithm>
#include <cstdlib>

#include "rasterizer/draw/cutouts.h"

namespace crevice {

namespace {

// Of an edge function at a pixel's centre: the most it comes to anywhere in the pixel's square.
std::int64_t most_in_square(const Edge& edge, std::int64_t at_centre) {
    return at_centre + (std::abs(edge.per_column) + std::abs(edge.per_row)) / 2;
}

// The pixel that is asked about.
struct Pixel {
    int x, y;

    // Whether the outline has a point in common with the closed square: no side of either keeps them apart.
    bool reached_by(const ScreenTriangle& t) const {
        const auto overlaps = [](const std::array<std::int32_t, 3>& at, int pixel) {
            const auto [low, high] = std::minmax_element(at.begin(), at.end());
            return *low <= (pixel + 1) * kSubpixelSteps && *high >= pixel * kSubpixelSteps;
        };
        if (!overlaps(t.x, x) || !overlaps(t.y, y)) return false;
        for (int i = 0; i < 3; ++i) {
            const Edge edge = triangle_edge(t, i);
            if (most_in_square(edge, at_centre(edge)) < 0) return false;
        }
        return true;
    }
    std::int64_t at_centre(const Edge& edge) const { return edge.at(x, y); }
};

// Which triangle of its mesh it is: the first that has these three vertices, in this order or turned over.
std::int64_t mesh_triangle(const Scene& scene, const ScreenGeometry& geometry, const ScreenTriangle& t) {
    const std::uint32_t first = geometry.vertices.first_vertex[t.instance];
    std::array<std::uint32_t, 3> wanted = {t.vertex[0] - first, t.vertex[1] - first, t.vertex[2] - first};
    std::sort(wanted.begin(), wanted.end());
    const Mesh& mesh = scene.meshes[static_cast<std::size_t>(scene.instances[t.instance].mesh)];
    const auto found = std::find_if(mesh.triangles.begin(), mesh.triangles.end(),
                                    [&](std::array<std::uint32_t, 3> vertices) {
                                        std::sort(vertices.begin(), vertices.end());
                                        return vertices == wanted;
                                    });
    return found == mesh.triangles.end() ? -1 : found - mesh.triangles.begin();
}

// The drawing of the pixel, triangle after triangle.
class PixelRaster {
 public:
    PixelRaster(const Scene& scene, const ScreenGeometry& geometry, const NormalDepthSettings& settings,
                bool reversed_z, Pixel pixel, const Run& run)
        : geometry_(geometry),
          format_(settings.depth_format),
          test_(nearest_wins(reversed_z)),
          pixel_(pixel),
          holes_(settings.cutouts ? alpha_holes(scene, geometry, one_lane(run)) : Holes{}) {
        const int tile = pixel.y / geometry.tile_size * geometry.tiles.width + pixel.x / geometry.tile_size;
        hidden_ = hidden_triangles(geometry, format_, reversed_z, tile,
                                   settings.cutouts ? alpha_holes(scene, geometry, run) : Holes{}, run);
        seen_.cleared = seen_.code = depth_code(format_, reversed_z ? 0.0f : 1.0f, 0.0);
    }

    // `number` is kNoTriangle for a triangle that is culled.
    void draw(const ScreenTriangle& t, std::int32_t number, std::int64_t in_mesh) {
        PixelFragment fragment{.triangle = t, .number = number, .mesh_triangle = in_mesh};
        for (int i = 0; i < 3; ++i) {
            const Edge edge = triangle_edge(t, i);
            const auto at = static_cast<std::size_t>(i);
            fragment.edge[at] = pixel_.at_centre(edge);
            fragment.top_or_left[at] = edge.threshold == 0;
            if (fragment.outside_edge < 0 && fragment.edge[at] < edge.threshold) fragment.outside_edge = i;
        }
        if (fragment.outside_edge < 0) {
            const auto e1 = static_cast<float>(fragment.edge[1]), e2 = static_cast<float>(fragment.edge[2]);
            fragment.z_ndc = z_ndc_at(t, e1, e2);
            fragment.code = depth_code(format_, fragment.z_ndc, t.depth_bias);
            fragment.stored = seen_.code;
        }
        fragment.verdict = verdict_of(fragment);
        if (fragment.verdict == FragmentVerdict::kept) {
            for (PixelFragment& before : seen_.fragments) {
                if (before.verdict == FragmentVerdict::kept) before.verdict = FragmentVerdict::drawn_over;
            }
            seen_.code = fragment.code;
            seen_.shown = number;
        }
        seen_.fragments.push_back(fragment);
    }

    PixelFragments seen() && { return std::move(seen_); }

 private:
    static Run one_lane(Run run) {
        run.lanes = 1;
        return run;
    }

    FragmentVerdict verdict_of(const PixelFragment& f) const {
        if (f.number == kNoTriangle) return FragmentVerdict::facing_away;
        if (f.outside_edge >= 0) return FragmentVerdict::outside;
        if (std::find(hidden_.begin(), hidden_.end(), f.number) != hidden_.end())
            return FragmentVerdict::hidden;
        const bool passes = depth_passes<float>(test_, f.code, f.stored);
        if (!passes && f.code != f.stored) return FragmentVerdict::behind;
        if (has_hole(f.number, passes)) return FragmentVerdict::cut_out;
        return passes ? FragmentVerdict::kept : FragmentVerdict::equal;
    }

    bool has_hole(std::int32_t number, bool passes) const {
        const ScreenTriangle& triangle = *geometry_.triangle(number).triangle;
        if (!holes_.may_be_in(triangle)) return false;
        const auto block = static_cast<std::uint32_t>(number) >> geometry_.index_bits;
        std::int32_t kept[1] = {-1};
        const std::int32_t passing[1] = {passes ? -1 : 0};
        holes_.cut_out({geometry_.blocks[block], triangle, pixel_.x, pixel_.y, 1, kept, passing});
        return kept[0] == 0;
    }

    const ScreenGeometry& geometry_;
    const DepthFormat format_;
    const DepthFunction test_;
    const Pixel pixel_;
    const Holes holes_;
    std::vector<std::int32_t> hidden_;
    PixelFragments seen_;
};

}  // namespace

PixelFragments pixel_fragments(const Scene& scene, const Camera& camera, const ScreenGeometry& geometry,
                               const NormalDepthSettings& settings, int x, int y, const Run& run) {
    // Blocks are cut by what is submitted, so that with back faces the same ones come out, and in them the same triangles
    // with back faces between.
    GeometrySettings with_back_faces = geometry_settings(settings);
    with_back_faces.keep_back_faces = true;
    with_back_faces.with_normals = false;
    const ScreenGeometry all = screen_geometry(scene, camera, geometry.size, with_back_faces, run);
    const Pixel pixel{x, y};
    PixelRaster raster(scene, geometry, settings, camera.reversed_z, pixel, run);
    for (std::size_t b = 0; b < all.blocks.size(); ++b) {
        std::uint32_t index = 0;
        for (const ScreenTriangle& t : all.blocks[b].triangles) {
            const bool culled = !scene.two_sided && t.back_facing;
            if (pixel.reached_by(t)) {
                raster.draw(t, culled ? kNoTriangle : geometry.number_of(b, index),
                            mesh_triangle(scene, all, t));
            }
            if (!culled) ++index;
        }
    }
    return std::move(raster).seen();
}

}  // namespace crevice
