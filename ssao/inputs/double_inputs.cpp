#include "ssao/inputs/double_inputs.h"

#include <limits>
#include <utility>

#include "rasterizer/base/error.h"

namespace crevice {

namespace {

Image<double> widened(const Image<float>& image) {
    Image<double> result(image.size);
    for (std::size_t i = 0; i < image.pixels.size(); ++i) result.pixels[i] = image.pixels[i];
    return result;
}

void take_over(DoubleInputs& numbers, const AoInputs& inputs, const DoubleGBuffer& seen) {
    if (!(inputs.size() == inputs.picture))
        throw UsageError("ao_scale: numbers in double are those of pixels (0.5); choose 1");
    const double a = seen.depth_a, b = seen.depth_b;
    numbers.depth_a = a;
    numbers.depth_b = b;
    const bool from_ndc = inputs.fetch.depth == DepthSource::ndc_depth;
    for (int y = 0; y < inputs.picture.height; ++y) {
        for (int x = 0; x < inputs.picture.width; ++x) {
            const double z = seen.view_depth.at(x, y), ndc = seen.ndc_depth.at(x, y);
            if (!(z < std::numeric_limits<double>::infinity())) continue;
            const double z_of_ndc = inputs.rays.perspective ? b / (ndc - a) : (ndc - a) / b;
            numbers.view_depth.at(x, y) = from_ndc ? z_of_ndc : z;
            for (std::size_t i = 0; i < 3; ++i) numbers.normal[i].at(x, y) = seen.normal[i].at(x, y);
            if (numbers.depth_map.empty()) continue;  // depth_inputs() makes none
            numbers.depth_map.at(x + 1, y + 1) = from_ndc ? ndc : z;
        }
    }
}

}  // namespace

AoInputs in_double(AoInputs inputs, const DoubleGBuffer* seen) {
    DoubleInputs numbers{widened(inputs.view_depth),
                         {widened(inputs.normal.x), widened(inputs.normal.y), widened(inputs.normal.z)},
                         widened(inputs.depth_map),
                         inputs.depth_a,
                         inputs.depth_b};
    if (seen != nullptr) take_over(numbers, inputs, *seen);
    inputs.in_double = std::make_shared<const DoubleInputs>(std::move(numbers));
    return inputs;
}

}  // namespace crevice
