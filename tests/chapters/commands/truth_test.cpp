// `crevice truth` as a user meets it.
#include <algorithm>
#include <filesystem>
#include <fstream>

#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

#include "rasterizer/base/image_io.h"
#include "rasterizer/base/image_summary.h"
#include "tests/tools/crevice_says.h"
#include "tests/tools/scratch_directory.h"

using namespace crevice;

namespace {

std::string quoted(const std::filesystem::path& path) { return "'" + path.string() + "'"; }

nlohmann::json report_in(const std::filesystem::path& out) {
    std::ifstream stream(out / "passes.json");
    return nlohmann::json::parse(stream);
}

}  // namespace

TEST_CASE("truth: a wrong word is refused with exit code 2 and one line that names it") {
    const ScratchDirectory scratch;
    const std::pair<std::string, std::string> mistakes[] = {
        {"", "SCENE"},
        {"columns --rays 0", "--rays"},
        {"columns --rays 1048577", "--rays"},
        {"columns --rays 12x", "12x"},
        {"columns --radius 0", "--radius"},
        {"columns --radius -1", "--radius"},
        {"columns --radius nan", "nan"},
        {"columns --error 0", "--error"},
        {"columns --error x", "--error"},
        {"columns --weight cos", "cosine or uniform"},
        {"columns --hemisphere face", "interpolated or geometric"},
        {"columns --seed -1", "--seed"},
        {"columns --limit-seeds 7", "--limit-seeds"},
        {"columns --ao none", "none"},
        {"columns --param radius=0", "radius"},
        {"columns --size 0x3", "0x3"},
        {"columns --no-cache --cache x", "--no-cache"},
    };
    for (const auto& mistake : mistakes) {
        const std::string &arguments = mistake.first, &named = mistake.second;
        CAPTURE(arguments);
        const Outcome outcome = crevice_says(
            "truth " + arguments + (arguments.empty() ? "" : " --out " + quoted(scratch / "never")));
        CAPTURE(outcome.text);
        CHECK(outcome.code == 2);
        CHECK(outcome.text.find(named) != std::string::npos);
        CHECK(std::count(outcome.text.begin(), outcome.text.end(), '\n') == 1);
        CHECK(!std::filesystem::exists(scratch / "never"));
    }
    CHECK(crevice_says("truth no_such_scene --no-cache").code == 2);
    CHECK(crevice_says("truth cornell --size 8x8 --rays 8 --no-cache --out /proc/nowhere").code == 4);
}

TEST_CASE("truth writes each reference with its error, and a passes.json that describes them") {
    const ScratchDirectory scratch;
    const std::string arguments = "truth sphere_on_plane --size 48x27 --rays 64 --limit-seeds 16 --no-cache";
    const Outcome outcome = crevice_says(arguments + " --out " + quoted(scratch / "a"));
    CAPTURE(outcome.text);
    REQUIRE(outcome.code == 0);
    const nlohmann::json report = report_in(scratch / "a");
    CHECK(report["scene"] == "sphere_on_plane");
    CHECK(report["size"] == nlohmann::json({48, 27}));
    CHECK(report["method"] == "xjun");
    CHECK(report["radius"] == 0.5);
    CHECK(report["weight"] == "cosine");
    CHECK(report["hemisphere"] == "interpolated");
    CHECK(report["warnings"].empty());
    REQUIRE(report["references"].size() == 4);
    for (const std::string name : {"truth_hard", "truth_soft", "truth_screen", "truth_limit"}) {
        for (const std::string& part : {name, name + "_error"}) {
            CAPTURE(part);
            const Planes planes = read_npy(scratch / "a" / (part + ".npy"));
            REQUIRE(planes.size() == 1);
            CHECK(planes[0].size == Size{48, 27});
            CHECK(std::filesystem::exists(scratch / "a" / (part + ".png")));
            CHECK(report["buffers"][part]["hash"] == content_hash(planes[0]));
            CHECK(report["buffers"][part]["nan"] == 0);
        }
    }
    // The same bits from one thread, one lane, the slowest instruction set.
    const Outcome again =
        crevice_says(arguments + " --threads 1 --lanes 1 --isa baseline --out " + quoted(scratch / "b"));
    REQUIRE(again.code == 0);
    CHECK(report_in(scratch / "b")["buffers"] == report["buffers"]);
}

TEST_CASE("truth: unbounded rays, a far eye and a scene without triangles are told") {
    const ScratchDirectory scratch;
    const std::string small =
        " --size 16x9 --rays 8 --limit-seeds 0 --no-cache --out " + quoted(scratch / "out");
    const Outcome unbounded = crevice_says("truth cornell --radius inf" + small);
    CAPTURE(unbounded.text);
    REQUIRE(unbounded.code == 0);
    CHECK(report_in(scratch / "out")["radius"] == "inf");
    CHECK(report_in(scratch / "out")["references"].size() == 3);
    const Outcome far = crevice_says(
        "truth sphere_on_plane --eye 0,100000,1 --target 0,0,0 --fov-y .1 --radius .001 --far 1000000" +
        small);
    CAPTURE(far.text);
    REQUIRE(far.code == 0);
    CHECK(far.text.find("offset-exceeds-radius/100") != std::string::npos);
    CHECK(report_in(scratch / "out")["warnings"].size() == 1);
    const Outcome empty = crevice_says("truth empty" + small);
    CHECK(empty.code == 0);
    CHECK(empty.text.find("0 triangles") != std::string::npos);
    CHECK(report_in(scratch / "out")["references"][0]["mean"] == 1);
}
