// The mistakes of chapters/port_your_pass.md, made by its script: compare tells each as the page says.
#include <cstdlib>

#include <doctest/doctest.h>

#include "rasterizer/base/image_io.h"
#include "tests/tools/crevice_says.h"
#include "tests/tools/error_message.h"
#include "tests/tools/scratch_directory.h"

using namespace crevice;

namespace {

std::string quoted(const std::filesystem::path& path) { return "'" + path.string() + "'"; }

// What compare says of a buffer with a mistake against the one without.
Outcome mistaken(const ScratchDirectory& scratch, const std::string& mistake, const std::string& buffer) {
    const std::string from = quoted(scratch / (buffer + ".npy")), to = quoted(scratch / "mistake.npy");
    const std::string passes = mistake == "world_normals" ? " " + quoted(scratch / "passes.json") : "";
    REQUIRE(std::system(("python3 '" CREVICE_EXAMPLES_DIR "/port_your_pass/mistake.py' " + mistake + " " +
                         from + " " + to + passes)
                            .c_str()) == 0);
    return crevice_says("compare " + to + " " + from);
}

}  // namespace

TEST_CASE("port your pass: each planted mistake is found, and looks as the page says") {
    if (std::system("python3 -c pass") != 0) {
        MESSAGE("python3 was not found");
        return;
    }
    const ScratchDirectory scratch;
    REQUIRE(crevice_says("render columns --eye 4,3,-9 --target 0,0,0 --size 160x90 --out " +
                         quoted(scratch.path()))
                .code == 0);
    const Outcome flipped = mistaken(scratch, "flipped_rows", "ao_raw");
    CHECK(flipped.code == 1);
    // The same values in other places: nothing is brighter or darker on the whole.
    CHECK(contains(flipped.text, "signed bias       "));
    const Planes mistake = read_npy(scratch / "mistake.npy"), right = read_npy(scratch / "ao_raw.npy");
    const int last = right[0].size.height - 1;
    CHECK(mistake[0].at(5, 0) == right[0].at(5, last));
    CHECK(mistake[0].at(7, last) == right[0].at(7, 0));
    CHECK(mistaken(scratch, "srgb", "ao_blurred").code == 1);
    CHECK(mistaken(scratch, "mirrored_z", "normal").code == 1);
    CHECK(contains(mistaken(scratch, "clear_colour", "normal").text, "worst pixel       0 0\n"));  // the sky
    CHECK(mistaken(scratch, "world_normals", "normal").code == 1);
    // The floor's normal is straight up in world space, to the last digits of the matrix.
    const Planes world = read_npy(scratch / "mistake.npy");
    int upright = 0;
    for (int y = 0; y < 90; ++y)
        for (int x = 0; x < 160; ++x) upright += world[1].at(x, y) > 0.99999f ? 1 : 0;
    CHECK(upright > 160 * 90 / 10);
}
