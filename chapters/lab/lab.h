// The lab of the browser without the browser: a request as JSON in, a reply as JSON out, and buffers by their addresses.
//
// A request is an object; "ask" says for what:
//   catalogue   {}                                        what there is (catalogue.h)
//   frame       {"scene", "ao", "params": ["name=value"], "size": "WxH",
//                "camera": {"eye", "target", "fov_y", "near", "far", "ortho"}: words as after the flags of `crevice render`,
//                each may be left out;
//                "only": [buffer], "hashes": bool}        draws a frame (frame_reply.h)
//   probe       {"x", "y"}                                what `crevice probe --json` tells of a pixel of the last frame
//   truth       {}                                        casts some rays more for the last frame that was drawn
//   forget      {}                                        starts anew: files have changed
// A reply is the object that is told with each, or {"error": what the program would say, "exit_code": as it would end}.
#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "chapters/lab/lab_session.h"

namespace crevice {

class Lab {
 public:
    // Never throws. Addresses in a reply hold until the next request.
    std::string reply(const std::string& request);

 private:
    nlohmann::ordered_json answer(const nlohmann::ordered_json& request);
    nlohmann::ordered_json frame(const LabWords& words);
    nlohmann::ordered_json truth();

    LabSession session_;
};

}  // namespace crevice
