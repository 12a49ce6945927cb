#include "chapters/savings.h"

#include "chapters/progress.h"

namespace crevice {

std::vector<Saving> measure_savings(const Scene& scene, const Camera& camera, const FrameRequest& request,
                                    const std::vector<Skip>& kinds, int pairs) {
    const auto frame_ms = [&](const KeptWork& kept) {
        FrameRequest one = request;
        one.repeats = 1;
        one.run.kept = kept;
        return render_frame(scene, camera, one).passes.back().wall_ms;
    };
    Progress progress("savings", static_cast<long long>(kinds.size()) * pairs);
    std::vector<Saving> savings;
    for (const Skip skip : kinds) {
        std::vector<double> differences;
        for (int i = 0; i < pairs; ++i) {
            const double kept_ms = frame_ms(KeptWork::only(skip));
            differences.push_back(kept_ms - frame_ms(KeptWork()));
            progress.advance();
        }
        savings.push_back({skip, median_interval(std::move(differences))});
    }
    return savings;
}

}  // namespace crevice
