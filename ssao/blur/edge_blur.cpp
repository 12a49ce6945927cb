#include "ssao/blur/edge_blur.h"

#include <algorithm>
#include <string>

#include "rasterizer/base/parallel.h"
#include "ssao/blur/bilateral_blur.h"
#include "ssao/blur/packed_edges.h"
#include "ssao/methods/settings_range.h"

namespace crevice {

namespace {

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
            F(kEdgeBlurLeak / kEdgeBlurFew) * saturate(F(kEdgeBlurFew) - (left + right + top + bottom));
        left = select(shows(l), saturate(left + leak), F(0));
        right = select(shows(r), saturate(right + leak), F(0));
        top = select(shows(t), saturate(top + leak), F(0));
        bottom = select(shows(b), saturate(bottom + leak), F(0));
        const F diagonal(kEdgeBlurDiagonal);
        top_left = diagonal * (left * side(l, Edges::kTop) + top * side(t, Edges::kLeft));
        top_right = diagonal * (top * side(t, Edges::kRight) + right * side(r, Edges::kTop));
        bottom_left = diagonal * (bottom * side(b, Edges::kLeft) + left * side(l, Edges::kBottom));
        bottom_right = diagonal * (right * side(r, Edges::kBottom) + bottom * side(b, Edges::kRight));
    }

    // visit(weight, columns to the right, rows down) for the eight neighbours, in the order of the sum.
    template <class Visit>
    CREVICE_INLINE void each_neighbour(const Visit& visit) const {
        visit(left, -1, 0), visit(right, 1, 0), visit(top, 0, -1), visit(bottom, 0, 1);
        visit(top_left, -1, -1), visit(top_right, 1, -1), visit(bottom_left, -1, 1),
            visit(bottom_right, 1, 1);
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
                    const float* const rows[] = {above + x + 1, row + x + 1, below + x + 1};
                    w.each_neighbour([&](F weight, int right, int down) __attribute__((always_inline)) {
                        sum = sum + weight * load<F>(rows[1 + down] + right);
                        total = total + weight;
                    });
                    store(result.row(y) + x,
                          select(w.surface, min_of(sum / total, F(largest)), F(background)));
                }
            }
        });
    });
    return result;
}

std::vector<Parameter<EdgeBlurSettings>> edge_blur_parameters() {
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

namespace {

// How much a texel counts itself in iteration i of n, from 1 on.
float own_weight(int i, int n) { return i == n ? kEdgeBlurOwn : kEdgeBlurOwnBefore; }

template <class F>
CREVICE_INLINE Vec3<F> load3(const Image3& image, int x, int y) {
    return {load<F>(image.x.row(y) + x), load<F>(image.y.row(y) + x), load<F>(image.z.row(y) + x)};
}

// Of EdgeBlurKind::bilateral.
BlurSettings bilateral_settings(const EdgeBlurSettings& settings) {
    BlurSettings blur = kXjunBlur;
    blur.iterations = settings.iterations;
    blur.depth_threshold = settings.depth;
    return blur;
}

ExplainedPass explained_pass(const Image<float>& map, const PackedEdges& edges, float own_weight, int x,
                             int y) {
    const EdgeWeights<float> w(edges.bits.row(y), edges.bits.row(y + 1), edges.bits.row(y + 2), x + 1);
    ExplainedPass pass;
    if (!w.surface) {
        pass.last_step = "no surface: 1";
        return pass;
    }
    pass.last_step = "sum / total, at most 1";
    pass.taps.push_back({x, y, map.at(x, y), own_weight, "the texel itself"});
    w.each_neighbour([&](float weight, int right, int down) {
        ExplainedTap tap{x + right, y + down, 1, weight, "outside the map"};
        if (tap.x >= 0 && tap.y >= 0 && tap.x < map.size.width && tap.y < map.size.height) {
            tap.value = map.at(tap.x, tap.y);
            tap.verdict = weight > 0 ? "counts" : "an edge lies between";
        }
        pass.taps.push_back(tap);
    });
    pass.value = std::min(pass.sum() / pass.total(), 1.0f);
    return pass;
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
    if (settings.kind == EdgeBlurKind::bilateral)
        return bilateral_blur(ao, inputs, bilateral_settings(settings), run);
    AoMap map{ao, TileMap(ao.size, kBlurTile)};
    if (settings.iterations == 0) return map;
    const PackedEdges edges = packed_edges(inputs, run);
    for (int i = 1; i <= settings.iterations; ++i)
        map.ao = blurred(map.ao, edges, own_weight(i, settings.iterations), 1, 1, run);
    return map;
}

std::vector<ExplainedPass> explain_edge_blur(const Image<float>& ao, const AoInputs& inputs,
                                             const EdgeBlurSettings& settings, int x, int y) {
    validate(settings);
    if (settings.kind == EdgeBlurKind::bilateral)
        return explain_bilateral_blur(ao, inputs, bilateral_settings(settings), x, y);
    std::vector<ExplainedPass> passes;
    const PackedEdges edges = packed_edges(inputs, {.threads = 1});
    Image<float> map = ao;
    for (int i = 1; i <= settings.iterations; ++i) {
        const float own = own_weight(i, settings.iterations);
        passes.push_back(explained_pass(map, edges, own, x, y));
        passes.back().name = "iteration " + std::to_string(i);
        map = blurred(map, edges, own, 1, 1, {.threads = 1});
    }
    return passes;
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
        edge_blur_parameters(),
        [](auto& settings) -> auto& { return settings.template as<EdgeBlurSettings>(); });
    denoiser.validate = [](const AnySettings& settings) { validate(settings.as<EdgeBlurSettings>()); };
    denoiser.denoised = [](const RawAo& raw, const AnySettings& settings, const Run& run) {
        return edge_blur(raw.ao, raw.inputs, settings.as<EdgeBlurSettings>(), run);
    };
    denoiser.explain = [](const RawAo& raw, const AnySettings& settings, int x, int y) {
        return explain_edge_blur(raw.ao, raw.inputs, settings.as<EdgeBlurSettings>(), x, y);
    };
    denoiser.directions = [](const Image3& directions, const AoInputs& inputs, const AnySettings& settings,
                             const Run& run) {
        return edge_blur(directions, inputs, settings.as<EdgeBlurSettings>(), run);
    };
    return denoiser;
}

}  // namespace crevice
