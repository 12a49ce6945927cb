// What rays through the scene say of a view's AO map: how open a texel really is, and whether one of its samples lies.
#pragma once

#include <optional>
#include <vector>

#include "chapters/props/probed_view.h"
#include "ssao/rays/ray_cast.h"

namespace crevice {

// A border that rays do not see: two texels beside or above one another on one plane, of which the map is much darker at the
// first.
struct FalseBorder {
    Texel dark, light;
    float height = 0;  // > 0, difference of the map
};

class RayJudge {
 public:
    static constexpr int kRays = 128;  // a texel

    // Of the same scene, camera and size of the AO map; `seed` is that of the rays. For every texel that shows the surface
    // which a pixel at its centre would show; of the others, edges, nothing is known.
    RayJudge(const SwitchedView& view, const ProbedView& drawn, std::uint32_t seed);

    // Map minus truth, which is given the map's own contrast; 0 where nothing is known.
    Image<float> signed_error(const ProbedView& drawn) const;
    // The texels of open planes, of which even rays twice as long as the radius meet nothing, that are darker than 1 - `by`;
    // the darkest first.
    std::vector<Texel> wrong_texels(const ProbedView& drawn, float by) const;
    // Borders higher than `least`, of which truth has less than a quarter; the highest first.
    std::vector<FalseBorder> false_borders(const ProbedView& drawn, float least) const;

    // Whether the ray from p to the sample's q, which starts a hundredth of the radius above p, meets nothing.
    bool is_free(const Explanation& texel, std::size_t sample) const;
    // Of the samples that take something although their way is free the one that takes most; none: no sample lies.
    std::optional<std::size_t> guilty_sample(const Explanation& texel) const;

 private:
    bool is_open_plane(const ProbedView& drawn, int x, int y) const;

    RayScene rays_;
    glm::mat3 relative_from_view_;
    float radius_;
    Image<float> twice_as_far_;  // accessibility by rays of twice the radius
    Image<float> truth_;         // accessibility
    Image<std::uint8_t> known_;  // 1 where truth is known
};

// Of two explanations of neighbouring texels the sample whose contributions differ most, and its share, [0,1], of what all
// of them differ by.
struct ChangedSample {
    std::size_t sample = 0;
    double share = 0;
};
ChangedSample changed_most(const Explanation& a, const Explanation& b);

}  // namespace crevice
