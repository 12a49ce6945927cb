// Frames of scenes that are hard on numbers, and what one asks of them: for chapter 22.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "chapters/frame/frame.h"
#include "chapters/props/switched_ao.h"
#include "chapters/stability/stiff_scenes.h"

namespace crevice {

// Throws UsageError as settings_of().
Frame drawn(const Scene& scene, const Camera& camera, Size size, const std::string& method,
            const Words& words = {});
Frame drawn(const StiffView& view, Size size, const std::string& method = "xjun", const Words& words = {});

// The first warning that the frame gave; kNoWarning where it gave none.
inline constexpr const char* kNoWarning = "nothing to say";
std::string first_warning(const Frame& frame);
// How often the frame has counted the loss of this name; 0 for a name it does not know.
std::size_t lost(const Frame& frame, const std::string& name);

// Of the picture's pixels, that show a surface.
double covered_share(const Frame& frame);
// Of two images of one size.
double largest_difference(const Image<float>& a, const Image<float>& b);
int texels_below(const Image<float>& ao, float limit);

// What Luna, who reads the depth buffer, makes of an open plane tilted by 60 degrees in each depth format between three
// pairs of near and far planes: the rows of a table; in how many of them the frame warns; the largest share of the AO
// that is lost where it does not.
struct FormatLosses {
    std::vector<std::vector<std::string>> rows;
    int warned = 0;
    double worst_silent = 0;
};
FormatLosses format_losses();

// The view with all lengths times 2^-60 ... 2^60, a row for each: the factor, the largest difference of the AO from that of
// the view as it is, the frame's first warning.
struct ScaledFrames {
    std::vector<std::vector<std::string>> rows;
    bool agree = true;           // up to 2^40 either way
    bool beyond_is_said = true;  // beyond, each frame that differs has a warning
};
ScaledFrames scaled_frames(const StiffView& view, Size size);

// The largest share of an open plane's AO that one of the methods loses, over tilts up to 89.99 degrees.
double worst_grazing_loss(const std::vector<std::string>& methods);

// Of the methods' AO of a block, for radii from 0 to 1e6 scene units: whether all values are numbers from 0 to 1, and
// the largest share that is lost where the radius is below a hundredth.
struct RadiusExtremes {
    bool in_range = true;
    double worst_tiny = 0;
};
RadiusExtremes radius_extremes(const std::vector<std::string>& methods);

}  // namespace crevice
