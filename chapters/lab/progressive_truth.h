// Ray-cast truth that refines while somebody looks: every pass casts a few rays more from each pixel.
// Source: the references of a study (chapters/study/references.h); what is asked of rays is the same.
// In:     a scene, a camera, a size; what rays are asked, as rays_asking() says of a method
// Out:    accessibility in [0,1], 1 = open, background 1; standard errors from how far the passes spread
// Cost:   a ray is some 100 ns; a call casts only as many as it is told to, so that others may have a turn.
#pragma once

#include <array>
#include <vector>

#include "ssao/judge/reference_image.h"
#include "ssao/judge/surface_masks.h"
#include "ssao/rays/ray_cast_ao.h"

namespace crevice {

class ProgressiveTruth {
 public:
    // Rays that a pass casts from each point.
    static constexpr int kRaysAPass = 4;
    // Without two there is neither an error nor a second half.
    static constexpr int kFewestPasses = 2;

    // `question.rays` does not matter. Throws UsageError naming the first of its members out of range.
    ProgressiveTruth(const Scene& scene, const Camera& camera, Size size, const RayAoSettings& question,
                     const Run& run = {});

    // Goes on with at most so many points of the present pass; true when that ended it.
    bool cast_from(std::size_t points);

    // Complete passes over the whole picture.
    int passes() const { return passes_; }

    // The mean over all complete passes, of which there must be kFewestPasses.
    ReferenceImage reference() const;

    // What the pixels show, for errors told by region.
    const Image<SurfaceKind>& kinds() const { return kinds_; }

 private:
    void add_pass();

    Run run_;
    RayAoSettings rays_;
    Image<SurfaceKind> kinds_;
    SurfacePoints points_;
    RayScene scene_;
    int passes_ = 0;
    std::size_t cast_ = 0;                     // points of the present pass that are done
    std::vector<float> pass_;                  // what it found, one a point
    std::array<std::vector<double>, 2> sums_;  // over even and over odd passes
    std::vector<double> squares_;              // over all passes
};

}  // namespace crevice
