#include "ssao/blur/edge_blur.h"

#include <algorithm>
#include <limits>

#include "rasterizer/base/parallel.h"
#include "ssao/blur/bilateral_blur.h"
#include "ssao/methods/settings_range.h"

namespace crevice {

namespace {

// XeGTAO's constants. Depths of one surface differ less than this share of the depth.
constexpr float kEdgeShare = 0.011f;
// The texel's own weight in the last iteration; in those before it is a fifth of that.
constexpr float kOwnWeight = 1.2f, kOwnWeightBefore = kOwnWeight / 5;
// Of a neighbour across a corner, by either way around it.
constexpr float kDiagonalWeight = 0.85f * 0.5f;
// A texel that goes on to fewer neighbours than this takes a little from all of them, against single dots.
constexpr float kFewNeighbours = 1.5f, kLeak = 0.5f;

// A map with one texel more all around, in whole groups of pixels.
template <class T>
Image<T> with_apron(const Image<T>& map, T beyond) {
    Image<T> result({round_up(map.size.width, kRowAlignment) + 2, map.size.height + 2}, beyond);
    for (int y = 0; y < map.size.height; ++y) std::copy_n(map.row(y), map.size.width, result.row(y + 1) + 1);
    return result;
}

// The outermost texels go on beyond the map, so that slopes are known there.
Image<float> depth_with_apron(const Image<float>& depth) {
    Image<float> result = with_apron(depth, std::numeric_limits<float>::infinity());
    const Size size = depth.size;
    for (int y = 1; y <= size.height; ++y) {
        result.at(0, y) = result.at(1, y);
        result.at(size.width + 1, y) = result.at(size.width, y);
    }
    std::copy_n(result.row(1), size.width + 2, result.row(0));
    std::copy_n(result.row(size.height), size.width + 2, result.row(size.height + 1));
    return result;
}

// Where the map ends nothing goes on.
void end_at_border(PackedEdges& edges, Size size) {
    const auto end = [&](int x, int y, int side) { edges.bits.at(x + 1, y + 1) &= ~(3 << side); };
    for (int y = 0; y < size.height; ++y) {
        edges.bits.at(size.width + 1, y + 1) = 0;  // what lanes beyond the map have written there
        end(0, y, PackedEdges::kLeft);
        end(size.width - 1, y, PackedEdges::kRight);
    }
    for (int x = 0; x < size.width; ++x) {
        end(x, 0, PackedEdges::kTop);
        end(x, size.height - 1, PackedEdges::kBottom);
    }
}

// The depths to both sides of a texel, relative to its own, and how far its surface goes on there, from 0 to 3.
template <class F>
struct TwoSides {
    Int<F> before, after;

    CREVICE_INLINE TwoSides(F to_before, F to_after, F inverse_width)
        : before(continued(to_before, 0.5f * (to_before + to_after), inverse_width)),
          after(continued(to_after, 0.5f * (to_before + to_after), inverse_width)) {}

 private:
    // A plane's depths on both sides are as far below as above: what remains of them is how it bends. It is NaN beside
    // the background, where the depth alone counts.
    CREVICE_INLINE static Int<F> continued(F apart, F bent, F inverse_width) {
        const F difference = absolute(apart), curvature = absolute(bent);
        const F least = select(curvature < difference, curvature, difference);
        constexpr float kSteps = 2.9f;  // XeGTAO's, a little less than 3
        return to_int(saturate(F(1.25f) - least * inverse_width) * F(kSteps) + F(0.5f));
    }
};

// How much the neighbours of a group of texels count.
template <class F>
struct EdgeWeights {
    using Edges = PackedEdges;
    Mask<F> surface;
    F left, right, top, bottom, top_left, top_right, bottom_left, bottom_right;

    // The rows of packed edges above, at and below the texels; `x` in them.
    CREVICE_INLINE EdgeWeights(const std::int32_t* above, const std::int32_t* row, const std::int32_t* below,
                               int x) {
        const Int<F> own = load<F>(row + x), l = load<F>(row + x - 1), r = load<F>(row + x + 1),
                     t = load<F>(above + x), b = load<F>(below + x);
        surface = shows(own);
        // Both neighbours must say so.
        left = side(own, Edges::kLeft) * side(l, Edges::kRight);
        right = side(own, Edges::kRight) * side(r, Edges::kLeft);
        top = side(own, Edges::kTop) * side(t, Edges::kBottom);
        bottom = side(own, Edges::kBottom) * side(b, Edges::kTop);
        const F leak =
            F(kLeak / kFewNeighbours) * saturate(F(kFewNeighbours) - (left + right + top + bottom));
        left = select(shows(l), saturate(left + leak), F(0));
        right = select(shows(r), saturate(right + leak), F(0));
        top = select(shows(t), saturate(top + leak), F(0));
        bottom = select(shows(b), saturate(bottom + leak), F(0));
        const F diagonal(kDiagonalWeight);
        top_left = diagonal * (left * side(l, Edges::kTop) + top * side(t, Edges::kLeft));
        top_right = diagonal * (top * side(t, Edges::kRight) + right * side(r, Edges::kTop));
        bottom_left = diagonal * (bottom * side(b, Edges::kLeft) + left * side(l, Edges::kBottom));
        bottom_right = diagonal * (right * side(r, Edges::kBottom) + bottom * side(b, Edges::kRight));
    }

 private:
    CREVICE_INLINE static F side(Int<F> edges, int first_bit) {
        return F(to_float((edges >> first_bit) & Int<F>(3))) * F(1.0f / 3);
    }
    CREVICE_INLINE static Mask<F> shows(Int<F> edges) {
        return (edges & Int<F>(Edges::kSurface)) != Int<F>(0);
    }
};

// One iteration. No value is more than `largest`; rounding may take a mean there.
Image<float> blurred(const Image<float>& map, const PackedEdges& edges, float own_weight, float background,
                     float largest, const Run& run) {
    Image<float> result(map.size, background);
    const Image<float> values = with_apron(map, background);
    parallel_rows(map.size.height, run, [&](int first_row, int end_row) {
        run_kernel(run, [&]<class F>(Lanes<F>) {
            for (int y = first_row; y < end_row; ++y) {
                const float *const above = values.row(y), *const row = values.row(y + 1),
                                   *const below = values.row(y + 2);
                for (int x = 0; x < map.size.width; x += kLanes<F>) {
                    const EdgeWeights<F> w(edges.bits.row(y), edges.bits.row(y + 1), edges.bits.row(y + 2),
                                           x + 1);
                    F sum = F(own_weight) * load<F>(row + x + 1), total(own_weight);
                    const auto add = [&](F weight, const float* at) __attribute__((always_inline)) {
                        sum = sum + weight * load<F>(at);
                        total = total + weight;
                    };
                    add(w.left, row + x), add(w.right, row + x + 2);
                    add(w.top, above + x + 1), add(w.bottom, below + x + 1);
                    add(w.top_left, above + x), add(w.top_right, above + x + 2);
                    add(w.bottom_left, below + x), add(w.bottom_right, below + x + 2);
                    store(result.row(y) + x,
                          select(w.surface, min_of(sum / total, F(largest)), F(background)));
                }
            }
        });
    });
    return result;
}

std::vector<Parameter<EdgeBlurSettings>> blur_parameters() {
    using S = EdgeBlurSettings;
    return {
        choice<S, EdgeBlurKind>("blur_kind", "XeGTAO's by edges, or the tutorials' with X_Jun's weights",
                                &S::kind,
                                {{"edges", EdgeBlurKind::edges}, {"bilateral", EdgeBlurKind::bilateral}}),
        whole("blur_iterations", 0, 64, "0: no blur; by edges 1 is XeGTAO's sharp, 2 its medium, 3 its soft",
              &S::iterations),
        number("blur_depth", "[0, inf)", kSceneUnit,
               "of the bilateral blur: neighbours whose depth differs more do not count", &S::depth),
    };
}

}  // namespace

void validate(const EdgeBlurSettings& s) {
    require_within("blur_iterations", s.iterations, 0, 64);
    require_length("blur_depth", s.depth);
}

PackedEdges packed_edges(const AoInputs& inputs, const Run& run) {
    const Size size = inputs.size();
    const Image<float> depth = depth_with_apron(inputs.view_depth);
    // An orthographic view counts as one of 60 degrees at the distance where that is as high.
    constexpr float kInverseTangent = 1.7320508f;
    const float orthographic_depth = kInverseTangent * inputs.rays.ray_scale.y;
    PackedEdges edges{with_apron(Image<std::int32_t>(size, 0), 0)};
    parallel_rows(size.height, run, [&](int first_row, int end_row) {
        run_kernel(run, [&]<class F>(Lanes<F>) {
            for (int y = first_row; y < end_row; ++y) {
                const float* const row = depth.row(y + 1) + 1;
                for (int x = 0; x < size.width; x += kLanes<F>) {
                    const F z = load<F>(row + x);
                    const Mask<F> surface = z < F(std::numeric_limits<float>::infinity());
                    const F width = F(kEdgeShare) * (inputs.rays.perspective ? z : F(orthographic_depth));
                    const F inverse = F(1) / select(surface, width, F(1));
                    const TwoSides<F> across(load<F>(row + x - 1) - z, load<F>(row + x + 1) - z, inverse);
                    const TwoSides<F> down(load<F>(depth.row(y) + 1 + x) - z,
                                           load<F>(depth.row(y + 2) + 1 + x) - z, inverse);
                    const Int<F> bits = (across.before << PackedEdges::kLeft) |
                                        (across.after << PackedEdges::kRight) |
                                        (down.before << PackedEdges::kTop) | down.after;
                    store(edges.bits.row(y + 1) + x + 1,
                          select(surface, bits | Int<F>(PackedEdges::kSurface), Int<F>(0)));
                }
            }
        });
    });
    end_at_border(edges, size);
    return edges;
}

namespace {

// How much a texel counts itself in iteration i of n, from 1 on.
float own_weight(int i, int n) { return i == n ? kOwnWeight : kOwnWeightBefore; }

template <class F>
CREVICE_INLINE Vec3<F> load3(const Image3& image, int x, int y) {
    return {load<F>(image.x.row(y) + x), load<F>(image.y.row(y) + x), load<F>(image.z.row(y) + x)};
}

// of(a, b) for the vectors of two maps.
template <class Of>
Image3 map_vectors(const Image3& a, const Image3& b, const Run& run, const Of& of) {
    Image3 result(a.size());
    parallel_rows(a.size().height, run, [&](int first_row, int end_row) {
        run_kernel(run, [&]<class F>(Lanes<F>) {
            for (int y = first_row; y < end_row; ++y) {
                for (int x = 0; x < a.size().width; x += kLanes<F>) {
                    const Vec3<F> v = of.template operator()<F>(load3<F>(a, x, y), load3<F>(b, x, y));
                    store(result.x.row(y) + x, v.x);
                    store(result.y.row(y) + x, v.y);
                    store(result.z.row(y) + x, v.z);
                }
            }
        });
    });
    return result;
}

}  // namespace

AoMap edge_blur(const Image<float>& ao, const AoInputs& inputs, const EdgeBlurSettings& settings,
                const Run& run) {
    validate(settings);
    if (settings.kind == EdgeBlurKind::bilateral) {
        BlurSettings blur = kXjunBlur;
        blur.iterations = settings.iterations;
        blur.depth_threshold = settings.depth;
        return bilateral_blur(ao, inputs, blur, run);
    }
    AoMap map{ao, TileMap(ao.size, kBlurTile)};
    if (settings.iterations == 0) return map;
    const PackedEdges edges = packed_edges(inputs, run);
    for (int i = 1; i <= settings.iterations; ++i)
        map.ao = blurred(map.ao, edges, own_weight(i, settings.iterations), 1, 1, run);
    return map;
}

Image3 edge_blur(const Image3& bent_normals, const AoInputs& inputs, const EdgeBlurSettings& settings,
                 const Run& run) {
    validate(settings);
    if (settings.iterations == 0) return bent_normals;
    const PackedEdges edges = packed_edges(inputs, run);
    Image3 deviation = map_vectors(
        bent_normals, inputs.normal, run,
        []<class F>(Vec3<F> bent, Vec3<F> n) __attribute__((always_inline)) { return bent - n; });
    for (int i = 1; i <= settings.iterations; ++i) {
        for (Image<float>* plane : {&deviation.x, &deviation.y, &deviation.z})
            *plane = blurred(*plane, edges, own_weight(i, settings.iterations), 0, 2, run);
    }
    return map_vectors(
        deviation, inputs.normal, run, []<class F>(Vec3<F> by, Vec3<F> n) __attribute__((always_inline)) {
            return normalize_or<F>(n + by, n);
        });
}

Denoiser edge_denoiser() {
    Denoiser denoiser;
    denoiser.defaults = AnySettings::of(EdgeBlurSettings{});
    denoiser.parameters = within<AnySettings>(
        blur_parameters(), [](auto& settings) -> auto& { return settings.template as<EdgeBlurSettings>(); });
    denoiser.validate = [](const AnySettings& settings) { validate(settings.as<EdgeBlurSettings>()); };
    denoiser.denoised = [](const RawAo& raw, const AnySettings& settings, const Run& run) {
        return edge_blur(raw.ao, raw.inputs, settings.as<EdgeBlurSettings>(), run);
    };
    denoiser.directions = [](const Image3& directions, const AoInputs& inputs, const AnySettings& settings,
                             const Run& run) {
        return edge_blur(directions, inputs, settings.as<EdgeBlurSettings>(), run);
    };
    return denoiser;
}

}  // namespace crevice
