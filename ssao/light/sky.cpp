#include "ssao/light/sky.h"

#include "rasterizer/base/error.h"
#include "rasterizer/base/parallel.h"
#include "rasterizer/base/run.h"
#include "rasterizer/spaces.h"
#include "ssao/light/cube_reflection.h"

namespace crevice {

namespace {

struct SkyRow {
    const DepthBuffer& depth;
    const CubeMap& sky;
    ViewRays rays;
    glm::mat3 world_from_view;
    std::int32_t far_code;
    DepthFunction test;

    template <class F>
    CREVICE_INLINE void draw(Image3& picture, int y) const {
        const Size size = depth.size();
        for (int x = 0; x < size.width; x += kLanes<F>) {
            const Int<F> stored = load<F>(depth.codes.row(y) + x);
            const auto open = depth_passes<F>(test, Int<F>(far_code), stored);
            if (!any(open)) continue;
            const Vec3<F> colour = colour_at<F>(x, y);
            put(picture.x.row(y) + x, open, colour.x);
            put(picture.y.row(y) + x, open, colour.y);
            put(picture.z.row(y) + x, open, colour.z);
        }
    }

    template <class F>
    CREVICE_INLINE Vec3<F> colour_at(int x, int y) const {
        const Size size = depth.size();
        const F v((static_cast<float>(y) + 0.5f) / static_cast<float>(size.height));
        const F u = (F(to_float(lane_index<F>() + Int<F>(x))) + F(0.5f)) / F(static_cast<float>(size.width));
        const Vec3<F> sight = rays.perspective ? rays.p_view(u, v, F(1)) : Vec3<F>{F(0), F(0), F(1)};
        return sample_cube(sky, turned(world_from_view, sight));
    }

    template <class F>
    CREVICE_INLINE static void put(float* at, Mask<F> where, F value) {
        store(at, select(where, value, load<F>(at)));
    }
};

SkyRow sky_row(const DepthBuffer& depth, const Camera& camera, const CubeMap& sky) {
    const CameraMatrices matrices = camera_matrices(camera, depth.size());
    return {depth,
            sky,
            {matrices.ray_scale, depth.size(), camera.projection == Projection::perspective},
            glm::mat3(matrices.relative_from_view),
            depth_code(depth.format, camera.reversed_z ? 0.0f : 1.0f, 0.0),
            camera.reversed_z ? DepthFunction::greater_equal : DepthFunction::less_equal};
}

}  // namespace

std::optional<glm::vec3> sky_at(const DepthBuffer& depth, const Camera& camera, const CubeMap& sky, int x,
                                int y) {
    const SkyRow row = sky_row(depth, camera, sky);
    if (!depth_passes<float>(row.test, row.far_code, depth.codes.at(x, y))) return std::nullopt;
    const Vec3<float> colour = row.colour_at<float>(x, y);
    return glm::vec3(colour.x, colour.y, colour.z);
}

Image3 with_sky(Image3 lit, const DepthBuffer& depth, const Camera& camera, const CubeMap& sky,
                const Run& run) {
    if (lit.size() != depth.size()) {
        throw UsageError("sky: the picture must have the depth buffer's size (widths " +
                         std::to_string(lit.size().width) + " and " + std::to_string(depth.size().width) +
                         "); give buffers of one view");
    }
    validate(run);
    const SkyRow row = sky_row(depth, camera, sky);
    parallel_rows(depth.size().height, run, [&](int first_row, int end_row) {
        run_kernel(run, [&]<class F>(Lanes<F>) {
            for (int y = first_row; y < end_row; ++y) row.draw<F>(lit, y);
        });
    });
    return lit;
}

}  // namespace crevice
