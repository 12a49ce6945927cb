#include "chapters/sweep/error_terms.h"

namespace crevice {

ErrorTerms error_terms(const std::vector<SweepErrorPart>& parts) {
    ErrorTerms terms;
    for (const SweepErrorPart& part : parts) {
        if (part.step == "depth buffer") {
            terms.screen_bias = part.bias;
            terms.screen_rmse = part.rmse;
            terms.screen_share = part.share;
        } else if (part.step == "definition") {
            terms.limit_bias = part.bias;
            terms.limit_rmse = part.rmse;
            terms.limit_share = part.share;
        } else {
            terms.frame_bias += part.bias;
            terms.frame_share += part.share;
        }
    }
    return terms;
}

const SweepErrorPart* largest_part(const std::vector<SweepErrorPart>& parts) {
    const SweepErrorPart* largest = nullptr;
    for (const SweepErrorPart& part : parts) {
        if (part.share > 0 && (largest == nullptr || part.share > largest->share)) largest = &part;
    }
    return largest;
}

}  // namespace crevice
