#include "ssao/blur/packed_edges.h"

#include <limits>

#include "rasterizer/base/parallel.h"

namespace crevice {

namespace {

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

}  // namespace

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

}  // namespace crevice
