#include "chapters/lab/lab.h"

#include <new>

#include "chapters/lab/catalogue.h"
#include "chapters/probe/probe_json.h"
#include "chapters/terminal/json_text.h"
#include "rasterizer/base/error.h"

namespace crevice {

namespace {

using Json = nlohmann::ordered_json;

Json error_json(const std::string& message, ExitCode code) {
    return {{"error", message}, {"exit_code", static_cast<int>(code)}};
}

}  // namespace

std::string Lab::reply(const std::string& request) {
    Json reply;
    try {
        reply = answer(json_from_text(request));
    } catch (const Error& error) {
        reply = error_json(error.what(), error.code);
    } catch (const std::bad_alloc&) {
        reply = error_json("crevice: not enough memory for this; choose a smaller --size", ExitCode::usage);
    } catch (const std::exception& error) {
        reply = error_json(
            std::string("crevice: this should not have happened (") + error.what() + "); please report it",
            ExitCode::check_failed);
    }
    return json_line(reply);
}

Json Lab::answer(const Json& request) {
    const std::string ask = request.at("ask");
    if (ask == "catalogue") return lab_catalogue();
    if (ask == "frame") return frame(lab_words(request));
    if (ask == "probe") return json_from_text(probe_json(session_.probe(request.at("x"), request.at("y"))));
    if (ask == "truth") return truth();
    if (ask == "forget") {
        *this = Lab();
        return Json::object();
    }
    throw UsageError("ask: there is no such request (" + ask + ")");
}

Json Lab::frame(const LabWords& words) {
    const DrawnFrame& drawn = session_.draw(words);
    return frame_reply(session_.scene(words, false), drawn);
}

Json Lab::truth() {
    const TruthSoFar told = session_.cast_truth();
    Json reply = {{"complete", told.complete}, {"rays", told.rays}, {"buffers", Json::object()}};
    if (told.reference == nullptr) return reply;
    reply["rmse"] = told.rmse;
    reply["bias"] = told.bias;
    reply["buffers"] = {{"truth", buffer_json(told.reference->mean, false)},
                        {"truth_error", buffer_json(told.reference->error, false)},
                        {"ao_error", buffer_json(*told.ao_error, false)}};
    return reply;
}

}  // namespace crevice
