#include "ssao/judge/surface_masks.h"

#include <algorithm>
#include <cmath>

namespace crevice {

namespace {

using PixelMask = Image<std::uint8_t>;

// View depth as a number that is linear over the screen on a plane; 0: sky, for no surface has it.
struct PlaneDepth {
    Image<double> value;
    bool perspective = true;
    double pixel_size = 0;  // scene units a pixel is wide; perspective: times view depth

    bool sky(int x, int y) const { return value.at(x, y) == 0; }
};

PlaneDepth plane_depth(const GBuffer& gbuffer, const Camera& camera) {
    const Size size = gbuffer.view_depth.size;
    const CameraMatrices matrices = camera_matrices(camera, size);
    PlaneDepth depth{Image<double>(size, 0.0), camera.projection == Projection::perspective,
                     2.0 * static_cast<double>(matrices.ray_scale.y) / size.height};
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
            const double z = gbuffer.view_depth.at(x, y);
            if (std::isfinite(z)) depth.value.at(x, y) = depth.perspective ? 1 / z : z;
        }
    }
    return depth;
}

struct Pixel {
    int x = 0, y = 0;
};

// The smallest magnitude of a number that goes from `a` to `b` in a straight line.
double nearest_to_zero(double a, double b) {
    const bool crosses = (a <= 0) != (b <= 0) || a == 0;
    return crosses ? 0 : std::min(std::fabs(a), std::fabs(b));
}

// Whether the surfaces of neighbours p and q do not meet; both are surfaces, the pixels lie one `along`
// apart.
bool step_between(const PlaneDepth& depth, Pixel p, Pixel q, Pixel along) {
    const Size size = depth.value.size;
    // The pixel behind `from`, in which its surface is assumed to go on; itself where there is none.
    const auto value_behind = [&](Pixel from, int way) {
        const Pixel b = {from.x + way * along.x, from.y + way * along.y};
        const bool inside = b.x >= 0 && b.y >= 0 && b.x < size.width && b.y < size.height;
        return depth.value.at(inside && !depth.sky(b.x, b.y) ? b.x : from.x,
                              inside && !depth.sky(b.x, b.y) ? b.y : from.y);
    };
    const double at_p = depth.value.at(p.x, p.y), at_q = depth.value.at(q.x, q.y);
    const double gap_at_p = at_p - (2 * at_q - value_behind(q, 1)),
                 gap_at_q = (2 * at_p - value_behind(p, -1)) - at_q;
    const double gap = nearest_to_zero(gap_at_p, gap_at_q);
    // Perspective: a gap of 1/z is |gap| z_p z_q long, and a pixel pixel_size * min(z_p, z_q) wide.
    const double relative_gap = depth.perspective ? gap / std::min(at_p, at_q) : gap;
    return relative_gap > kStepGap_px * depth.pixel_size;
}

bool normals_differ(const Image3& normals, Pixel p, Pixel q) {
    const Vec3<float> a = spread<float>(normals.at(p.x, p.y)), b = spread<float>(normals.at(q.x, q.y));
    const bool known = dot(a, a) > 0 && dot(b, b) > 0;
    return known && dot(a, b) < kFoldCosine;
}

// The pixels on both sides of a step, and those on both sides of a fold.
struct Lines {
    PixelMask steps, folds;
};

Lines lines_of(const PlaneDepth& depth, const Image3& normals) {
    const Size size = depth.value.size;
    Lines lines{PixelMask(size, 0), PixelMask(size, 0)};
    const auto look_at = [&](Pixel p, Pixel along) {
        const Pixel q = {p.x + along.x, p.y + along.y};
        const bool sky_p = depth.sky(p.x, p.y), sky_q = depth.sky(q.x, q.y);
        if (sky_p && sky_q) return;
        if (sky_p != sky_q || step_between(depth, p, q, along)) {
            lines.steps.at(p.x, p.y) = lines.steps.at(q.x, q.y) = 1;
        } else if (normals_differ(normals, p, q)) {
            lines.folds.at(p.x, p.y) = lines.folds.at(q.x, q.y) = 1;
        }
    };
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
            if (x + 1 < size.width) look_at({x, y}, {1, 0});
            if (y + 1 < size.height) look_at({x, y}, {0, 1});
        }
    }
    return lines;
}

// The square neighbourhoods of all marked pixels. Those touch their line, so that it reaches one pixel less
// far from them than from itself.
PixelMask near(const PixelMask& marked) {
    constexpr int kGrowth = kMaskReach_px - 1;
    const Size size = marked.size;
    PixelMask rows(size, 0), grown(size, 0);
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
            const int first = std::max(x - kGrowth, 0), last = std::min(x + kGrowth, size.width - 1);
            rows.at(x, y) = *std::max_element(marked.row(y) + first, marked.row(y) + last + 1);
        }
    }
    for (int y = 0; y < size.height; ++y) {
        const int first = std::max(y - kGrowth, 0), last = std::min(y + kGrowth, size.height - 1);
        for (int from = first; from <= last; ++from) {
            for (int x = 0; x < size.width; ++x) grown.at(x, y) |= rows.at(x, from);
        }
    }
    return grown;
}

}  // namespace

Image<SurfaceKind> surface_kinds(const GBuffer& gbuffer, const Camera& camera) {
    const PlaneDepth depth = plane_depth(gbuffer, camera);
    const Lines lines = lines_of(depth, gbuffer.normal);
    const PixelMask near_steps = near(lines.steps), near_folds = near(lines.folds);
    Image<SurfaceKind> kinds(depth.value.size, SurfaceKind::flat);
    for (int y = 0; y < kinds.size.height; ++y) {
        for (int x = 0; x < kinds.size.width; ++x) {
            SurfaceKind& kind = kinds.at(x, y);
            if (near_folds.at(x, y) != 0) kind = SurfaceKind::crease;
            if (near_steps.at(x, y) != 0) kind = SurfaceKind::edge;
            if (depth.sky(x, y)) kind = SurfaceKind::sky;
        }
    }
    return kinds;
}

const char* region_name(Region region) {
    switch (region) {
        case Region::all: return "all";
        case Region::surface: return "surface";
        case Region::edge: return "edge";
        case Region::crease: return "crease";
        case Region::flat: return "flat";
    }
    return "";
}

bool contains(Region region, SurfaceKind kind) {
    switch (region) {
        case Region::all: return true;
        case Region::surface: return kind != SurfaceKind::sky;
        case Region::edge: return kind == SurfaceKind::edge;
        case Region::crease: return kind == SurfaceKind::crease;
        case Region::flat: return kind == SurfaceKind::flat;
    }
    return false;
}

Image<std::uint8_t> region_mask(const Image<SurfaceKind>& kinds, Region region) {
    Image<std::uint8_t> mask(kinds.size, 0);
    for (int y = 0; y < mask.size.height; ++y) {
        for (int x = 0; x < mask.size.width; ++x) mask.at(x, y) = contains(region, kinds.at(x, y));
    }
    return mask;
}

}  // namespace crevice
