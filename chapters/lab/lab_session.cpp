#include "chapters/lab/lab_session.h"

#include <utility>

#include "chapters/study/references.h"
#include "rasterizer/base/error.h"
#include "ssao/judge/metrics.h"
#include "ssao/judge/reference_error.h"
#include "ssao/light/widened_ao.h"

namespace crevice {

namespace {

// Points that one call casts rays from: about 30 ms of them, so that the camera never waits for long.
constexpr std::size_t kPointsAtOnce = 1 << 15;

}  // namespace

const LoadedScene& LabSession::scene(const LabWords& words, bool surfaces) {
    if (!scene_ || scene_->name != words.scene || scene_->crease != words.crease ||
        (surfaces && !scene_->surfaces)) {
        before_ = {};
        scene_ = loaded_scene(words, surfaces, run_);
    }
    return *scene_;
}

const DrawnFrame& LabSession::draw(const LabWords& words) {
    if (drawn_) before_ = std::exchange(drawn_->worked, {});
    drawn_.reset();
    has_all_ = false;
    truth_.reset();
    const LoadedScene& of = scene(words, wants_surfaces(words));
    drawn_ = drawn_frame(of, words, run_, before_);
    return *drawn_;
}

const WorkedFrame& LabSession::worked() {
    if (!drawn_) throw UsageError("frame: there is none yet; draw one first");
    if (!has_all_) {
        before_ = std::exchange(drawn_->worked, {});
        drawn_->request.wanted = all_buffers();
        const Scene& of = scene(drawn_->words, true).argument.scene;
        drawn_->worked = worked_frame(of, drawn_->camera, drawn_->request, {}, std::exchange(before_, {}));
        has_all_ = true;
    }
    return drawn_->worked;
}

PixelProbe LabSession::probe(int x, int y) {
    const WorkedFrame& of_pixel = worked();
    return probe_pixel(scene_->argument.scene, drawn_->request, of_pixel, x, y);
}

TruthSoFar LabSession::cast_truth() {
    const Image<float>& map = lit_map(worked());
    const FrameRequest& request = drawn_->request;
    if (!request.method->computes_ao())
        throw UsageError(std::string("--ao: computes nothing that rays could judge (") +
                         request.method->name + "); give another method");
    if (!truth_) {
        const RayAoSettings question = rays_asking(request.method->question(request.settings.method.ao));
        truth_.emplace(scene_->argument.scene, drawn_->camera, request.size, question, request.run);
        ao_ = ao_at_picture_size(map, request.size, request.run);
    }
    TruthSoFar told;
    told.complete = truth_->cast_from(kPointsAtOnce);
    told.rays = truth_->passes() * ProgressiveTruth::kRaysAPass;
    if (!told.complete || truth_->passes() < ProgressiveTruth::kFewestPasses) return told;
    reference_ = truth_->reference();
    ao_error_ = signed_difference({ao_}, {reference_.mean}).front();
    const MeanError error = mean_error(ao_, reference_, truth_->kinds(), Region::surface);
    told.rmse = error.squared.root();
    told.bias = error.bias;
    told.reference = &reference_;
    told.ao_error = &ao_error_;
    return told;
}

}  // namespace crevice
