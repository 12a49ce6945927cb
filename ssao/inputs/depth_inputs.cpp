#include "ssao/inputs/depth_inputs.h"

#include <limits>

#include "rasterizer/base/parallel.h"

namespace crevice {

AoInputs depth_inputs(const GBuffer& gbuffer, const Camera& camera, float scale, const Run& run) {
    const Size picture = gbuffer.depth.size(), size = ao_map_size(picture, scale);
    const CameraMatrices matrices = camera_matrices(camera, picture);
    AoInputs inputs{{.scale = scale, .texel_centre = TexelCentre::off},
                    picture,
                    Image3(size, glm::vec3(0)),
                    Image<float>(size, std::numeric_limits<float>::infinity()),
                    {},
                    matrices.depth_a,
                    matrices.depth_b,
                    {matrices.ray_scale, picture, camera.projection == Projection::perspective},
                    static_cast<float>(camera.near_plane)};
    parallel_rows(size.height, run, [&](int first_row, int end_row) {
        for (int y = first_row; y < end_row; ++y) {
            const float* const row =
                gbuffer.view_depth.row(pixel_under_centre(y, size.height, picture.height));
            for (int x = 0; x < size.width; ++x)
                inputs.view_depth.at(x, y) = row[pixel_under_centre(x, size.width, picture.width)];
        }
    });
    return inputs;
}

}  // namespace crevice
