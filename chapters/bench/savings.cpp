#include "chapters/bench/savings.h"

#include "chapters/terminal/progress.h"

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
            // Each goes first in every second pair.
            const double first_ms = frame_ms(i % 2 == 0 ? KeptWork::only(skip) : KeptWork()),
                         second_ms = frame_ms(i % 2 == 0 ? KeptWork() : KeptWork::only(skip));
            differences.push_back(i % 2 == 0 ? first_ms - second_ms : second_ms - first_ms);
            progress.advance();
        }
        savings.push_back({skip, median_interval(std::move(differences))});
    }
    return savings;
}

}  // namespace crevice
