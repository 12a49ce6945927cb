// The lab of the browser as its worker meets it: JSON in, JSON and buffers out.
#include <algorithm>
#include <cstdint>
#include <fstream>
#include <set>

#include <doctest/doctest.h>

#include "chapters/lab/lab.h"
#include "chapters/probe/probe_json.h"
#include "chapters/terminal/parse.h"
#include "rasterizer/base/image_summary.h"
#include "tests/tools/scratch_directory.h"

using namespace crevice;
using Json = nlohmann::json;

namespace {

Json frame_request(const std::string& scene, const std::string& method) {
    return {{"ask", "frame"},  {"scene", scene},        {"ao", method},
            {"size", "64x36"}, {"only", all_buffers()}, {"hashes", true}};
}

Json asked(Lab& lab, const Json& request) { return Json::parse(lab.reply(request.dump())); }

// What render_frame() makes of the same words.
Frame plain_frame(const std::string& scene_name, const std::string& method,
                  const std::vector<std::string>& params) {
    const SceneArgument argument = load_scene(scene_name);
    FrameRequest request;
    request.size = {64, 36};
    request.method = &find_method(method);
    request.settings = settings_of(*request.method, params, argument.scene.length_unit);
    return render_frame(argument.scene, argument.scene.camera, request);
}

std::string error_of(const Json& request) {
    Lab lab;
    const Json reply = asked(lab, request);
    REQUIRE(reply.contains("error"));
    return reply["error"];
}

}  // namespace

TEST_CASE("lab: a frame of every method has the bits of the program's") {
    Lab lab;
    for (const Method& method : ao_methods()) {
        CAPTURE(method.name);
        const Json reply = asked(lab, frame_request("cornell", method.name));
        REQUIRE_MESSAGE(reply.contains("buffers"), reply.dump());
        const Frame frame = plain_frame("cornell", method.name, {});
        const Json& buffers = reply["buffers"];
        CHECK(buffers["normal"]["hash"] == content_hash(frame.gbuffer.normal));
        CHECK(buffers["view_depth"]["hash"] == content_hash(frame.gbuffer.view_depth));
        CHECK(buffers["ao_raw"]["hash"] == content_hash(frame.ao_raw));
        CHECK(buffers["ao_blurred"]["hash"] == content_hash(frame.ao_blurred));
        CHECK(buffers["lit"]["hash"] == content_hash(frame.lit));
    }
}

TEST_CASE("lab: what is kept of a scene at rest changes no bit, whatever moves or changes in between") {
    Lab lab;
    const auto eye_at = [](Json request, const char* eye) {
        request["camera"] = {{"eye", eye}};
        return request;
    };
    Json only_ao = frame_request("columns", "xjun");
    only_ao["only"] = {"ao_raw"};
    const Json requests[] = {
        frame_request("columns", "ray_cast"),
        frame_request("columns", "ray_cast"),  // the same eye again: rays and shadow are kept
        eye_at(frame_request("columns", "ray_cast"), "-3,2,-9"),
        only_ao,  // needs no shadow, which stays for the next one
        eye_at(frame_request("columns", "xjun"), "2,3,-8"),
        frame_request("columns_luna", "luna"),
        frame_request("columns_luna", "ray_cast"),
        frame_request("columns", "xjun")};
    std::size_t number = 0;
    for (const Json& request : requests) {
        CAPTURE(number++);
        Lab from_scratch;
        const Json kept = asked(lab, request), made = asked(from_scratch, request);
        REQUIRE_MESSAGE(kept.contains("buffers"), kept.dump());
        for (const auto& item : made["buffers"].items()) {
            const std::string& name = item.key();
            const Json& buffer = item.value();
            CAPTURE(name);
            CHECK(kept["buffers"][name]["hash"] == buffer["hash"]);
        }
    }
    // A pass that was not needed is not timed.
    const auto draws_shadow = [](const Json& reply) {
        return std::ranges::any_of(reply["passes"],
                                   [](const Json& pass) { return pass["name"] == "shadow"; });
    };
    Lab fresh;
    const Json request = frame_request("columns", "xjun");
    const Json first = asked(fresh, request);
    CHECK(draws_shadow(first));
    CHECK(first["unchanged"] == Json::array());
    const Json again = asked(fresh, request);
    CHECK(again["passes"].size() == 1);  // the frame
    CHECK(again["unchanged"] == Json({"normal_depth", "ao", "blur", "shadow", "lit", "sky"}));
    // A probe has all that was drawn.
    asked(fresh, {{"ask", "probe"}, {"x", 30}, {"y", 20}});
    CHECK(asked(fresh, request)["unchanged"] == again["unchanged"]);
}

TEST_CASE("lab: parameters of a request change the frame as --param does") {
    Lab lab;
    Json request = frame_request("cornell", "luna");
    request["params"] = {"epsilon=0", "radius=1.5"};
    const Json reply = asked(lab, request);
    CHECK(reply["parameters"]["radius"] == "1.5");
    CHECK(reply["buffers"]["ao_raw"]["hash"] ==
          content_hash(plain_frame("cornell", "luna", {"epsilon=0", "radius=1.5"}).ao_raw));
}

TEST_CASE("lab: the addresses of a reply are those of the buffer's rows") {
    Lab lab;
    const Json reply = asked(lab, frame_request("cornell", "xjun"));
    const Frame frame = plain_frame("cornell", "xjun", {});
    const Json& told = reply["buffers"]["normal"];
    const Image<float>* const planes[] = {&frame.gbuffer.normal.x, &frame.gbuffer.normal.y,
                                          &frame.gbuffer.normal.z};
    REQUIRE(told["shape"] == Json({36, 64, 3}));
    const auto stride = told["stride"].get<std::ptrdiff_t>();
    for (std::size_t c = 0; c < 3; ++c) {
        const auto* const first = reinterpret_cast<const float*>(told["planes"][c].get<std::uintptr_t>());
        for (int y = 0; y < 36; ++y) {
            for (int x = 0; x < 64; ++x) {
                CAPTURE(x);
                CAPTURE(y);
                REQUIRE(first[y * stride + x] == planes[c]->at(x, y));
            }
        }
    }
}

TEST_CASE("lab: eye and target of a reply, given back as words, are the same camera") {
    ScratchDirectory scratch;
    std::ofstream(scratch / "corner.obj")
        << "v 0 0 0\nv 2 0 0\nv 0 2 0\nv 0 0 3\nf 1 2 3\nf 1 3 4\nf 1 4 2\n";
    for (const std::string& scene : {std::string("cornell"), (scratch / "corner.obj").string()}) {
        CAPTURE(scene);
        Lab lab;
        Json request = frame_request(scene, "xjun");
        const Json first = asked(lab, request);
        REQUIRE_MESSAGE(first.contains("camera"), first.dump());
        for (const char* point : {"eye", "target"}) {
            const Json& p = first["camera"][point];
            request["camera"][point] = p[0].dump() + "," + p[1].dump() + "," + p[2].dump();
        }
        const Json again = asked(lab, request);
        CHECK(first["buffers"]["lit"]["hash"] == again["buffers"]["lit"]["hash"]);
    }
}

TEST_CASE("lab: what the program refuses is refused in its words, with its exit code") {
    Json request = frame_request("cornell", "xjun");
    request["params"] = {"radius=-1"};
    const auto says = [](const auto& body) -> std::string {
        try {
            body();
        } catch (const Error& error) {
            return error.what();
        }
        return "nothing";
    };
    CHECK(error_of(request) == says([] { settings_of(find_method("xjun"), {"radius=-1"}); }));
    request = frame_request("cornell", "xjun");
    request["size"] = "64";
    CHECK(error_of(request) == says([] { parse_size("--size", "64"); }));
    CHECK(error_of(frame_request("no_such_scene", "xjun")) == says([] { load_scene("no_such_scene"); }));
    CHECK(error_of(frame_request("cornell", "none_such")).find("--ao: ") == 0);
    Lab lab;
    CHECK(asked(lab, frame_request("no_such_scene", "xjun"))["exit_code"] == 2);
    CHECK(asked(lab, frame_request("no_such.obj", "xjun"))["exit_code"] == 3);
    CHECK(error_of({{"ask", "something"}}).find("something") != std::string::npos);
}

TEST_CASE(
    "lab: the catalogue offers each parameter of the table, but those of a history, and no name twice") {
    Lab lab;
    const Json catalogue = asked(lab, {{"ask", "catalogue"}});
    CHECK(catalogue["methods"].size() == ao_methods().size());
    for (const Json& row : catalogue["methods"]) {
        CAPTURE(row["name"].get<std::string>());
        std::set<std::string> offered, wanted;
        for (const Json& parameter : row["parameters"]) {
            CHECK(offered.insert(parameter["name"]).second);
            CHECK(parameter["range"] != "");
        }
        for (const auto& parameter : frame_parameters(find_method(row["name"])))
            wanted.insert(parameter.name);
        for (const auto& parameter : history_parameters()) wanted.erase(parameter.name);
        CHECK(offered == wanted);
    }
}

TEST_CASE("lab: a pixel of the last frame is told as the program's probe tells it") {
    Lab lab;
    CHECK(asked(lab, {{"ask", "probe"}, {"x", 1}, {"y", 1}}).contains("error"));
    for (const char* method : {"xjun", "gtao", "ray_cast", "none"}) {
        CAPTURE(method);
        asked(lab, frame_request("cornell", method));
        const Json told = asked(lab, {{"ask", "probe"}, {"x", 30}, {"y", 20}});
        const SceneArgument argument = load_scene("cornell");
        FrameRequest request;
        request.size = {64, 36};
        request.method = &find_method(method);
        request.settings = settings_of(*request.method, {}, argument.scene.length_unit);
        const PixelProbe probe = probe_pixel(argument.scene, argument.scene.camera, request, 30, 20);
        CHECK(told == Json::parse(probe_json(probe)));
    }
    const Json outside = asked(lab, {{"ask", "probe"}, {"x", 64}, {"y", 0}});
    CHECK(outside["error"].get<std::string>().find("64x36") != std::string::npos);
    CHECK(outside["exit_code"] == 2);
}

TEST_CASE("lab: truth is told from the second pass on, and judges the AO of the last frame") {
    Lab lab;
    asked(lab, frame_request("cornell", "xjun"));
    Json reply;
    while (!reply.contains("rmse")) reply = asked(lab, {{"ask", "truth"}});
    CHECK(reply["rays"] == ProgressiveTruth::kFewestPasses * ProgressiveTruth::kRaysAPass);
    CHECK(reply["buffers"]["ao_error"]["shape"] == Json({36, 64}));
    CHECK(reply["buffers"]["truth"]["mean"].get<double>() > 0.3);
    CHECK(reply["rmse"].get<double>() < 0.5);
    asked(lab, frame_request("cornell", "none"));
    CHECK(asked(lab, {{"ask", "truth"}})["exit_code"] == 2);
}

TEST_CASE("lab: after files have changed and were forgotten, a scene is read anew") {
    ScratchDirectory scratch;
    const std::string path = (scratch / "one.obj").string();
    std::ofstream(path) << "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
    Lab lab;
    CHECK(asked(lab, frame_request(path, "xjun"))["scene"]["triangles"] == 1);
    std::ofstream(path) << "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 1\nf 1 2 3\nf 2 4 3\n";
    asked(lab, {{"ask", "forget"}});
    CHECK(asked(lab, frame_request(path, "xjun"))["scene"]["triangles"] == 2);
    std::ofstream(path) << "v 0 0 zero\n";
    asked(lab, {{"ask", "forget"}});
    const Json reply = asked(lab, frame_request(path, "xjun"));
    CHECK(reply["error"].get<std::string>().find(path + ":1: ") == 0);
    CHECK(reply["exit_code"] == 3);
}
