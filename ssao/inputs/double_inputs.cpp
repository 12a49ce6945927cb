#include "ssao/inputs/double_inputs.h"

#include <limits>
#include <memory>

#include "ssao/inputs/depth_inputs.h"
#include "ssao/inputs/texel_row.h"

namespace crevice {

namespace {

// Depth inputs have no depth map: their texels are the pixels under their centres.
void take_over_pixels(DoubleInputs& numbers, const AoInputs& inputs, const DoubleGBuffer& seen) {
    const Size size = inputs.size(), picture = inputs.picture;
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x)
            numbers.view_depth.at(x, y) =
                seen.view_depth.at(pixel_under_centre(x, size.width, picture.width),
                                   pixel_under_centre(y, size.height, picture.height));
    }
}

void take_over_depth_map(DoubleInputs& numbers, const AoInputs& inputs, const DoubleGBuffer& seen) {
    const Image<double>& depth =
        inputs.fetch.depth == DepthSource::ndc_depth ? seen.ndc_depth : seen.view_depth;
    for (int y = 0; y < inputs.picture.height; ++y) {
        for (int x = 0; x < inputs.picture.width; ++x) {
            if (seen.view_depth.at(x, y) < std::numeric_limits<double>::infinity())
                numbers.depth_map.at(x + 1, y + 1) = depth.at(x, y);
        }
    }
}

// The kernel of texel_fetch.h in double.
void fetch_texels(DoubleInputs& numbers, const AoInputs& inputs, const DoubleGBuffer& seen) {
    const Size size = inputs.size(), picture = inputs.picture;
    const auto columns = texel_axis<double>(size.width, picture.width, inputs.rays, &Vec3<double>::x),
               rows = texel_axis<double>(size.height, picture.height, inputs.rays, &Vec3<double>::y);
    const DoublePixels pixels{seen, numbers.depth_map};
    for (int y = 0; y < size.height; ++y) {
        const TexelRow row(pixels, columns, rows, y);
        for (int x = 0; x < size.width; ++x) {
            const auto texel = row.fetch<double>(inputs, x, true);
            numbers.view_depth.at(x, y) = texel.view_depth;
            numbers.normal[0].at(x, y) = texel.normal.x;
            numbers.normal[1].at(x, y) = texel.normal.y;
            numbers.normal[2].at(x, y) = texel.normal.z;
        }
    }
}

}  // namespace

AoInputs in_double(AoInputs inputs, const DoubleGBuffer* seen) {
    const auto numbers = std::make_shared<DoubleInputs>(
        DoubleInputs{widened(inputs.view_depth),
                     {widened(inputs.normal.x), widened(inputs.normal.y), widened(inputs.normal.z)},
                     widened(inputs.depth_map),
                     inputs.depth_a,
                     inputs.depth_b});
    inputs.in_double = numbers;
    if (seen == nullptr) return inputs;
    numbers->depth_a = seen->depth_a;
    numbers->depth_b = seen->depth_b;
    if (inputs.depth_map.empty()) {
        take_over_pixels(*numbers, inputs, *seen);
    } else {
        take_over_depth_map(*numbers, inputs, *seen);
        fetch_texels(*numbers, inputs, *seen);
    }
    return inputs;
}

}  // namespace crevice
