#include "chapters/props/blur_likeness.h"

#include <algorithm>
#include <cmath>

#include "chapters/terminal/number_text.h"

namespace crevice {
namespace {

// Without a minus in front of a zero.
std::string rounded_text(float value, int decimals) {
    const float step = std::pow(10.0f, static_cast<float>(-decimals));
    return decimal_text(std::fabs(value) < step / 2 ? 0 : static_cast<double>(value), decimals);
}

}  // namespace

Likeness likeness(const AoInputs& inputs, int x, int y, int tap_x, int tap_y) {
    return {dot(spread<float>(inputs.normal.at(x, y)), spread<float>(inputs.normal.at(tap_x, tap_y))),
            std::fabs(inputs.view_depth.at(x, y) - inputs.view_depth.at(tap_x, tap_y))};
}

Texel texel_at_a_step(const AoInputs& inputs, const BlurSettings& blur) {
    Texel best;
    float least = 1e30f;
    for (int y = 0; y < inputs.size().height; ++y) {
        for (int x = kBlurRadius; x + kBlurRadius < inputs.size().width; ++x) {
            int counting = 0;
            float farthest = 0;
            for (int i = -kBlurRadius; i <= kBlurRadius; ++i) {
                const Likeness tap = likeness(inputs, x, y, x + i, y);
                counting += tap.counts(blur) ? 1 : 0;
                farthest = std::max(farthest, tap.apart);
            }
            if (counting >= 6 && counting <= 8 && farthest > 2 * blur.depth_threshold && farthest < least)
                least = farthest, best = {x, y};
        }
    }
    return best;
}

TapsOfTexel taps_of(const AoInputs& inputs, const Image<float>& ao, const BlurSettings& blur, Texel texel) {
    TapsOfTexel result;
    for (int i = -kBlurRadius; i <= kBlurRadius; ++i) {
        const Likeness like = likeness(inputs, texel.x, texel.y, texel.x + i, texel.y);
        const bool counts = like.counts(blur);
        const float weight = blur.weights[static_cast<std::size_t>(i + kBlurRadius)];
        result.taps.push_back({texel.x + i, counts});
        result.kept_weight += counts ? static_cast<double>(weight) : 0;
        result.rows.push_back({std::to_string(i), rounded_text(weight, 2), rounded_text(like.cosine, 3),
                               rounded_text(like.apart, 3), counts ? "counts" : "rejected",
                               rounded_text(ao.at(texel.x + i, texel.y), 4)});
    }
    return result;
}

}  // namespace crevice
