// passes.json on what was left out: the counts of the frame itself, the time that saved, and what loading
// took.
#include <cstdlib>
#include <fstream>
#include <string>

#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

#include "chapters/frame/frame.h"
#include "chapters/frame/scene_argument.h"
#include "tests/tools/scratch_directory.h"

using namespace crevice;

namespace {

Frame frame_of_columns() {
    const Scene scene = load_scene("columns").scene;
    FrameRequest request;
    request.size = {160, 90};
    request.method = &find_method("xjun");
    request.settings = settings_of(*request.method);
    request.run.tile_size = 16;
    return render_frame(scene, scene.camera, request);
}

// passes.json of the same frame, drawn by the program.
nlohmann::json report_of(const std::string& options) {
    const ScratchDirectory scratch;
    const std::string out = "'" + scratch.path().string() + "'";
    const std::string command = std::string(CREVICE_PROGRAM) + " render columns --size 160x90 --tile 16 " +
                                options + " --out " + out + " >" + out + "/said 2>&1 </dev/null";
    CAPTURE(command);
    REQUIRE(std::system(command.c_str()) == 0);
    std::ifstream file(scratch / "passes.json");
    return nlohmann::json::parse(file);
}

// Null when there is none.
nlohmann::json entry_of(const nlohmann::json& report, Skip skip) {
    for (const nlohmann::json& entry : report["left_out"]) {
        if (entry["what"] == skip_name(skip)) return entry;
    }
    return nullptr;
}

}  // namespace

TEST_CASE("left-out report: the frame's counts, with the time saved when frames are repeated") {
    const nlohmann::json repeated = report_of("--repeat 2"), once = report_of(""),
                         kept = report_of("--repeat 2 --keep-all");
    int told = 0;
    for (const SkippedWork& work : frame_of_columns().skipped) {
        INFO("kind " << std::string(skip_name(work.skip)));
        const nlohmann::json entry = entry_of(repeated, work.skip), untimed = entry_of(once, work.skip);
        CHECK(entry_of(kept, work.skip).is_null());
        CHECK(entry.is_null() == (work.count == 0));
        CHECK(untimed.is_null() == (work.count == 0));
        if (work.count == 0) continue;
        ++told;
        for (const nlohmann::json& either : {entry, untimed}) {
            CHECK(either["why"] == skip_reason(work.skip));
            CHECK(either["count"] == work.count);
            CHECK(either["of"] == work.of);
            CHECK(either["unit"] == work.unit);
        }
        CHECK(entry["saved_ms"].is_number());
        REQUIRE(entry["saved_ms_interval"].size() == 2);
        CHECK(entry["saved_ms_interval"][0] <= entry["saved_ms"]);
        CHECK(entry["saved_ms"] <= entry["saved_ms_interval"][1]);
        CHECK(!untimed.contains("saved_ms"));
    }
    CHECK(told >= 4);
}

TEST_CASE("left-out report: the steps of loading, each with its time") {
    const nlohmann::json report = report_of("");
    REQUIRE(!report["loading"].empty());
    for (const nlohmann::json& step : report["loading"]) {
        CHECK(!step["step"].get<std::string>().empty());
        CHECK(step["wall_ms"].get<double>() >= 0);
    }
}
