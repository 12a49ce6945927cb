#include "chapters/props/noise_by_samples.h"

#include <cmath>

#include "ssao/judge/metrics.h"
#include "ssao/methods/luna_occlusion.h"

namespace crevice {

NoiseBySamples noise_by_samples(const AoInputs& inputs, const Image<float>& limit,
                                const std::vector<int>& samples, std::uint32_t seed) {
    NoiseBySamples noise{{}, {"measured", {}, {}}, {"1 / sqrt(N)", {}, {}, {}, {}, PlotStyle::smooth}};
    for (const int count : samples) {
        noise.maps.push_back(luna_occlusion(inputs, {.samples = count, .exponent = 1, .seed = seed}, {}).ao);
        noise.measured.x.push_back(count);
        noise.measured.y.push_back(compare_images(noise.maps.back(), limit).rmse);
    }
    for (int i = 10; i <= 10 * samples.back(); ++i) {
        noise.ideal.x.push_back(0.1 * i);
        noise.ideal.y.push_back(noise.measured.y[0] / std::sqrt(0.1 * i));
    }
    return noise;
}

}  // namespace crevice
