#include "ssao/methods/gtao_bent_normals.h"

#include "ssao/methods/gtao_kernel.h"

namespace crevice {

namespace {

// The cosine-weighted mean of all directions over a plane, along its normal.
constexpr float kMeanOfHemisphere = 2.0f / 3;

template <class F>
CREVICE_INLINE Vec3<F> bent_normal(const GtaoKernel& kernel, const TexelPoint<F>& texel) {
    Vec3<F> open = F(kMeanOfHemisphere * static_cast<float>(kernel.plan.slices)) * texel.n;
    kernel.for_each_slice(
        texel, [&](const Slice<F>& slice, int number, F radius_px, F shift) __attribute__((always_inline)) {
            for (const float side : {1.0f, -1.0f}) {
                const F c = kernel.horizon_of(texel, slice, number, side, radius_px, shift).c;
                const SliceVector<F> closed = closed_directions(c, slice.cosine, F(side) * slice.sine);
                open =
                    open - slice.length * (closed.along_v * slice.v + (F(side) * closed.along_t) * slice.t);
            }
        });
    return normalize_or<F>(select<F>(dot(open, texel.n) > F(0), open, texel.n), texel.n);
}

}  // namespace

Image3 gtao_bent_normals(const AoInputs& inputs, const GtaoSettings& settings, const Run& run) {
    validate(settings);
    const GtaoKernel kernel(inputs, settings, run);
    const TileMap tiles = surface_tiles(inputs, run);
    Image3 result(inputs.size(), glm::vec3(0));
    parallel_rows(result.size().height, run, [&](int first_row, int end_row) {
        run_kernel(run, [&]<class F>(Lanes<F>) {
            for (int y = first_row; y < end_row; ++y) {
                for (int x = 0; x < result.size().width; x += kLanes<F>) {
                    if (tiles.tiles.at(x / kTexelTile, y / kTexelTile) != TileWork::done) continue;
                    const TexelPoint<F> texel = texel_point<F>(inputs, x, y);
                    const Vec3<F> bent =
                        select<F>(texel.surface, bent_normal(kernel, texel), Vec3<F>{F(0), F(0), F(0)});
                    store(result.x.row(y) + x, bent.x);
                    store(result.y.row(y) + x, bent.y);
                    store(result.z.row(y) + x, bent.z);
                }
            }
        });
    });
    return result;
}

}  // namespace crevice
