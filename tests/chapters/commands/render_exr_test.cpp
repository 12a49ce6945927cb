// `crevice render --format exr`: one file, the same bits as the .npy files, and a passes.json that says the same.
#include <filesystem>
#include <fstream>

#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

#include "chapters/images/exr.h"
#include "rasterizer/base/error.h"
#include "tests/tools/crevice_says.h"
#include "tests/tools/error_message.h"
#include "tests/tools/has_openexr.h"
#include "tests/tools/scratch_directory.h"

using namespace crevice;
namespace fs = std::filesystem;

namespace {

std::string quoted(const fs::path& path) { return "'" + path.string() + "'"; }

nlohmann::json passes_in(const fs::path& directory) {
    std::ifstream stream(directory / "passes.json");
    return nlohmann::json::parse(stream);
}

}  // namespace

TEST_CASE("render --format exr: every buffer has the bits of its .npy, whatever the size of the AO map") {
    if (!has_openexr()) return;
    for (const char* words :
         {"columns", "columns --ao-scale 1", "columns --ao gtao --only normal,bent_normal,ao_raw"}) {
        CAPTURE(std::string(words));
        const ScratchDirectory npy, exr;
        const std::string render = std::string("render ") + words + " --size 66x38 --out ";
        REQUIRE(crevice_says(render + quoted(npy.path())).code == 0);
        const Outcome outcome = crevice_says(render + quoted(exr.path()) + " --format exr");
        REQUIRE(outcome.code == 0);
        CHECK(contains(outcome.text, "frame.exr: normal.X normal.Y normal.Z"));
        const nlohmann::json of_npy = passes_in(npy.path()), of_exr = passes_in(exr.path());
        CHECK(of_npy["buffers"] == of_exr["buffers"]);
        const Outcome compared =
            crevice_says("compare " + quoted(exr / "frame.exr") + " " + quoted(npy.path()));
        CAPTURE(compared.text);
        CHECK(compared.code == 0);
        CHECK(contains(compared.text, "0 of " + std::to_string(of_npy["buffers"].size()) + " differ"));
        std::size_t files = 0;
        for (const fs::directory_entry& entry : fs::directory_iterator(exr.path())) {
            (void)entry;
            ++files;
        }
        CHECK(files == 2);  // frame.exr and passes.json
    }
}

TEST_CASE("render --format: what is none is named, and a film keeps its buffers in EXRs, too") {
    CHECK(crevice_says("render columns --format png").code == 2);
    if (!has_openexr()) {
        const Outcome outcome = crevice_says("render columns --format exr");
        CHECK(outcome.code == 2);
        CHECK(contains(outcome.text, "--format exr: this program was built without OpenEXR"));
        return;
    }
    const ScratchDirectory scratch;
    REQUIRE(crevice_says("render wall_corner --size 16x9 --frames 0-1 --frame-buffers --format exr --out " +
                         quoted(scratch.path()))
                .code == 0);
    CHECK(fs::exists(scratch / "frame_0001/frame.exr"));
    CHECK(!fs::exists(scratch / "frame_0001/normal.npy"));
}
