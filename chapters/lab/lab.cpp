#include "chapters/lab/lab.h"

#include <new>

#include "chapters/lab/catalogue.h"
#include "chapters/probe/probe_json.h"
#include "chapters/study/references.h"
#include "rasterizer/base/error.h"
#include "ssao/judge/metrics.h"
#include "ssao/judge/reference_error.h"
#include "ssao/light/widened_ao.h"

namespace crevice {

namespace {

using Json = nlohmann::ordered_json;

// Points that one request casts rays from: about 30 ms of them, so that the camera never waits for long.
constexpr std::size_t kPointsAtOnce = 1 << 15;

Json error_json(const std::string& message, ExitCode code) {
    return {{"error", message}, {"exit_code", static_cast<int>(code)}};
}

}  // namespace

std::string Lab::reply(const std::string& request) {
    Json reply;
    try {
        reply = answer(nlohmann::json::parse(request));
    } catch (const Error& error) {
        reply = error_json(error.what(), error.code);
    } catch (const std::bad_alloc&) {
        reply = error_json("crevice: not enough memory for this; choose a smaller --size", ExitCode::usage);
    } catch (const std::exception& error) {
        reply = error_json(
            std::string("crevice: this should not have happened (") + error.what() + "); please report it",
            ExitCode::check_failed);
    }
    return reply.dump(-1, ' ', false, Json::error_handler_t::replace);
}

Json Lab::answer(const nlohmann::json& request) {
    const std::string ask = request.at("ask");
    if (ask == "catalogue") return lab_catalogue();
    if (ask == "frame") return frame(lab_words(request));
    if (ask == "probe") return probe(request.at("x"), request.at("y"));
    if (ask == "truth") return truth();
    if (ask == "forget") {
        *this = Lab();
        return Json::object();
    }
    throw UsageError("ask: there is no such request (" + ask + ")");
}

void Lab::use_scene(const std::string& name, bool surfaces) {
    if (scene_ && scene_->name == name && (scene_->surfaces || !surfaces)) return;
    scene_ = loaded_scene(name, surfaces, Run{});
}

Json Lab::frame(const LabWords& words) {
    drawn_.reset();
    worked_.reset();
    truth_.reset();
    use_scene(words.scene, wants_surfaces(words));
    drawn_ = drawn_frame(*scene_, words, Run{});
    return frame_reply(*scene_, *drawn_);
}

const WorkedFrame& Lab::worked() {
    if (!drawn_) throw UsageError("frame: there is none yet; draw one first");
    if (!worked_) {
        use_scene(drawn_->words.scene, true);
        drawn_->request.wanted = all_buffers();
        worked_ = worked_frame(scene_->argument.scene, drawn_->camera, drawn_->request);
    }
    return *worked_;
}

Json Lab::probe(int x, int y) {
    const WorkedFrame& of_pixel = worked();
    return Json::parse(probe_json(probe_pixel(scene_->argument.scene, drawn_->request, of_pixel, x, y)));
}

Json Lab::truth() {
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
    const bool complete = truth_->cast_from(kPointsAtOnce);
    Json reply = {{"complete", complete},
                  {"rays", truth_->passes() * ProgressiveTruth::kRaysAPass},
                  {"buffers", Json::object()}};
    if (!complete || truth_->passes() < ProgressiveTruth::kFewestPasses) return reply;
    reference_ = truth_->reference();
    ao_error_ = signed_difference({ao_}, {reference_.mean}).front();
    const MeanError error = mean_error(ao_, reference_, truth_->kinds(), Region::surface);
    reply["rmse"] = error.squared.root();
    reply["bias"] = error.bias;
    reply["buffers"] = {{"truth", buffer_json(reference_.mean, false)},
                        {"truth_error", buffer_json(reference_.error, false)},
                        {"ao_error", buffer_json(ao_error_, false)}};
    return reply;
}

}  // namespace crevice
