// What a method sees that reads depths alone.
#include "ssao/inputs/depth_inputs.h"

#include <doctest/doctest.h>

#include "tests/tools/ao_cases.h"
#include "tests/tools/image_checks.h"

using namespace crevice;

TEST_CASE(
    "depth inputs: the pixel under each texel's centre, of pictures of even and odd sides, without normals") {
    for (const Size size : {Size{16, 12}, {15, 11}, {1, 1}}) {
        for (const float scale : {0.5f, 1.0f}) {
            GBuffer g = made_up_gbuffer(size, 0.2f);
            g.normal = Image3();
            const AoInputs inputs = depth_inputs(g, made_up_camera(), scale);
            CAPTURE(size.width);
            CAPTURE(scale);
            CHECK(inputs.size() == ao_map_size(size, scale));
            CHECK(pixels_against(inputs.size(), [&](int x, int y) {
                      const auto pixel = [&](int i, int texels, int pixels) {
                          return static_cast<int>((i + 0.5) * pixels / texels);
                      };
                      return inputs.view_depth.at(x, y) ==
                                 g.view_depth.at(pixel(x, inputs.size().width, size.width),
                                                 pixel(y, inputs.size().height, size.height)) &&
                             inputs.normal.at(x, y) == glm::vec3(0);
                  }) == "");
        }
    }
}

TEST_CASE("depth inputs: rays, planes and sizes are those of the methods that read normals too") {
    const GBuffer g = made_up_gbuffer({16, 12}, 0.2f);
    const AoInputs both = ao_inputs(g, made_up_camera(), {}),
                   depths = depth_inputs(g, made_up_camera(), 0.5f);
    CHECK(depths.picture == both.picture);
    CHECK(depths.rays.ray_scale == both.rays.ray_scale);
    CHECK(depths.rays.perspective == both.rays.perspective);
    CHECK(depths.near_plane == both.near_plane);
    CHECK(depths.fetch.scale == 0.5f);
}
