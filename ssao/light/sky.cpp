#include "ssao/light/sky.h"

#include <utility>

#include "rasterizer/base/error.h"
#include "rasterizer/base/parallel.h"
#include "rasterizer/base/run.h"
#include "rasterizer/spaces.h"
#include "ssao/light/cube_reflection.h"

namespace crevice {

namespace {

// Which pixels show nothing but the sky.
struct Background {
    const DepthBuffer& depth;
    std::int32_t far_code;
    DepthFunction test;

    Background(const DepthBuffer& of_depth, const Camera& camera)
        : depth(of_depth),
          far_code(depth_code(of_depth.format, camera.reversed_z ? 0.0f : 1.0f, 0.0)),
          test(camera.reversed_z ? DepthFunction::greater_equal : DepthFunction::less_equal) {}

    // They get the colours of `sky`.
    template <class F, class Sky>
    CREVICE_INLINE void fill_row(Image3& picture, int y, const Sky& sky) const {
        for (int x = 0; x < depth.size().width; x += kLanes<F>) {
            const Int<F> stored = load<F>(depth.codes.row(y) + x);
            const auto open = depth_passes<F>(test, Int<F>(far_code), stored);
            if (!any(open)) continue;
            const Vec3<F> colour = sky.template colour_at<F>(x, y);
            put(picture.x.row(y) + x, open, colour.x);
            put(picture.y.row(y) + x, open, colour.y);
            put(picture.z.row(y) + x, open, colour.z);
        }
    }

 private:
    template <class F>
    CREVICE_INLINE static void put(float* at, Mask<F> where, F value) {
        store(at, select(where, value, load<F>(at)));
    }
};

// The cube map along each pixel's line of sight.
struct SeenSky {
    const CubeMap& sky;
    Size size;
    CameraMatrices matrices;
    ViewRays rays;
    glm::mat3 world_from_view;

    SeenSky(const CubeMap& cube, const Camera& camera, Size picture)
        : sky(cube),
          size(picture),
          matrices(camera_matrices(camera, picture)),
          rays{matrices.ray_scale, picture, camera.projection == Projection::perspective},
          world_from_view(matrices.relative_from_view) {}

    template <class F>
    CREVICE_INLINE Vec3<F> colour_at(int x, int y) const {
        const F v((static_cast<float>(y) + 0.5f) / static_cast<float>(size.height));
        const F u = (F(to_float(lane_index<F>() + Int<F>(x))) + F(0.5f)) / F(static_cast<float>(size.width));
        const Vec3<F> sight = rays.perspective ? rays.p_view(u, v, F(1)) : Vec3<F>{F(0), F(0), F(1)};
        return sample_cube(sky, turned(world_from_view, sight));
    }
};

// What another picture shows there.
struct DrawnSky {
    const Image3& picture;

    template <class F>
    CREVICE_INLINE Vec3<F> colour_at(int x, int y) const {
        return {load<F>(picture.x.row(y) + x), load<F>(picture.y.row(y) + x), load<F>(picture.z.row(y) + x)};
    }
};

template <class Sky>
Image3 filled(Image3 lit, const Background& background, const Sky& sky, const Run& run) {
    const Size size = background.depth.size();
    if (lit.size() != size) {
        throw UsageError("sky: the picture must have the depth buffer's size (widths " +
                         std::to_string(lit.size().width) + " and " + std::to_string(size.width) +
                         "); give buffers of one view");
    }
    validate(run);
    parallel_rows(size.height, run, [&](int first_row, int end_row) {
        run_kernel(run, [&]<class F>(Lanes<F>) {
            for (int y = first_row; y < end_row; ++y) background.fill_row<F>(lit, y, sky);
        });
    });
    return lit;
}

}  // namespace

std::optional<glm::vec3> sky_at(const DepthBuffer& depth, const Camera& camera, const CubeMap& sky, int x,
                                int y) {
    const Background background(depth, camera);
    if (!depth_passes<float>(background.test, background.far_code, depth.codes.at(x, y))) return std::nullopt;
    const Vec3<float> colour = SeenSky(sky, camera, depth.size()).colour_at<float>(x, y);
    return glm::vec3(colour.x, colour.y, colour.z);
}

Image3 with_sky(Image3 lit, const DepthBuffer& depth, const Camera& camera, const CubeMap& sky,
                const Run& run) {
    return filled(std::move(lit), Background(depth, camera), SeenSky(sky, camera, depth.size()), run);
}

Image3 with_sky(Image3 lit, const DepthBuffer& depth, const Camera& camera, const Image3& before,
                const Run& run) {
    return filled(std::move(lit), Background(depth, camera), DrawnSky{before}, run);
}

}  // namespace crevice
