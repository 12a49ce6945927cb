// The steps of an error that was taken apart, put together into what a reader asks for.
#pragma once

#include <vector>

#include "chapters/sweep/sweep_results.h"

namespace crevice {

// The steps from truth to frame as three terms: what the depth buffer does not hold (T -> S), what the method's definition
// changes (S -> C), and all that comes of samples, resolution, storage and blur (C -> frame).
struct ErrorTerms {
    double screen_bias = 0, limit_bias = 0, frame_bias = 0;  // add up to the bias
    double screen_rmse = 0, limit_rmse = 0;                  // of each term alone
    double screen_share = 0, limit_share = 0,
           frame_share = 0;  // add up to the mean squared error of the frame

    // What ever more samples would leave: that of the method's limit.
    double floor_bias() const { return screen_bias + limit_bias; }
};
ErrorTerms error_terms(const std::vector<SweepErrorPart>& parts);

// The step with the largest share, the first of equals; null where there are no parts or none adds to the error.
const SweepErrorPart* largest_part(const std::vector<SweepErrorPart>& parts);

}  // namespace crevice
