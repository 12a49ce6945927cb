// The program as a user meets it: exit codes, one clear line for each mistake, and the files it leaves.
#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>
#include <tuple>

#include <nlohmann/json.hpp>

#include "rasterizer/base/image_io.h"
#include "rasterizer/base/run.h"
#include "tests/tools/crevice_says.h"
#include "tests/tools/scratch_directory.h"

using namespace crevice;

namespace {

void write_text(const std::filesystem::path& path, const std::string& text) { std::ofstream(path) << text; }

std::string quoted(const std::filesystem::path& path) { return "'" + path.string() + "'"; }

}  // namespace

TEST_CASE("a wrong word is refused with exit code 2 and a line that names it") {
    const ScratchDirectory scratch;
    struct Mistake {
        std::string arguments, named;
    };
    const Mistake mistakes[] = {
        {"", "subcommand"},
        {"rendr columns", "rendr"},
        {"render", "SCENE"},
        {"render columns junk", "junk"},
        {"render columns --siez 3x3", "--siez"},
        {"render columns --size 12", "--size"},
        {"render columns --size 0x10", "0x10"},
        {"render columns --size 12x34x", "12x34x"},
        {"render columns --size 50000x50000", "50000x50000"},
        {"render columns --size 99999999999x1", "99999999999x1"},
        {"render columns --eye 1,2", "--eye"},
        {"render columns --eye 1,2,nan", "nan"},
        {"render columns --eye 0,0,0 --target 0,0,0", "--target: eye and target are the same point"},
        {"render columns --near 12x", "12x"},
        {"render columns --near 0", "--near: near must be above 0"},
        {"render columns --near 5 --far 5", "--far: far must be above near"},
        {"render columns --far 1e999", "1e999"},
        {"render columns --fov-y 180", "--fov-y: the vertical field of view"},
        {"render columns --ortho -1", "--ortho: the height of an orthographic"},
        {"render columns --ao gtoa", "gtoa"},
        {"render columns --ao-scale .3", "--ao-scale"},
        {"render columns --only normals", "normals"},
        {"render columns --only normal,", "--only"},
        {"render columns --only bent_normal",
         "--only: xjun knows no bent normals (bent_normal); give --ao one of gtao"},
        {"render columns --threads -1", "--threads"},
        {"render columns --lanes 3", "--lanes"},
        {"render columns --isa mmx", "mmx"},
        {"render columns --tile 48", "--tile"},
        {"render columns --repeat 0", "--repeat"},
        {"render columns --break", "--break: no pixel is named"},
        {"render columns --break --pixel 1", "--pixel: not a pixel (1)"},
        {"render columns --break --pixel 1,2,3", "--pixel: not a pixel (1,2,3)"},
        {"render columns --size 8x4 --break --pixel 7,4", "--pixel: lies outside the picture of 8x4 (7 4)"},
        {"render columns --size 8x4 --break --pixel -1,0", "--pixel: lies outside the picture of 8x4 (-1 0)"},
        {"render columns --break --pixel 1,2 --pass sky", "sky"},
        {"render columns --break --pixel 1,2 --frames 0-3", "--break: stops in one frame only"},
        {"render columns --pixel 1,2", "--pixel: says where --break is to stop"},
        {"render columns --pass ao", "--pass: says where --break is to stop"},
        {"render columns --break --pixel 1,2 --pass ao", "--break: no debugger watches this program"},
        {"render columns --time 1e30", "--time"},
        {"render columns --param samples", "samples"},
        {"render columns --param samples=0", "samples"},
        {"render columns --param samples=15", "15"},
        {"render columns --param samples=3.5", "3.5"},
        {"render columns --param radius=-1", "radius"},
        {"render columns --param radius=nan", "nan"},
        {"render columns --param fade_start=3 --param fade_end=2", "fade_end"},
        {"render columns --param bias=1", "bias"},
        {"render columns --param depth_format=d32", "d32"},
        {"render columns --ao none --param radius=1", "radius"},
        {"params gtoa", "METHOD: there is no such method (gtoa)"},
        {"chapter 99", "99"},
        {"chapter", "WHICH"},
        {"compare only_one", "B"},
        {"scenes trailing", "trailing"},
    };
    for (const Mistake& mistake : mistakes) {
        CAPTURE(mistake.arguments);
        const bool renders = mistake.arguments.starts_with("render columns");
        const Outcome outcome =
            crevice_says(mistake.arguments + (renders ? " --out " + quoted(scratch.path() / "never") : ""));
        CAPTURE(outcome.text);
        CHECK(outcome.code == 2);
        CHECK(outcome.text.find(mistake.named) != std::string::npos);
        CHECK(std::count(outcome.text.begin(), outcome.text.end(), '\n') == 1);
        CHECK(!std::filesystem::exists(scratch.path() / "never"));
    }
}

TEST_CASE("input that cannot be read gives exit code 3, output that cannot be written 4") {
    const ScratchDirectory scratch;
    write_text(scratch.path() / "text.obj", "this is not a mesh\n");
    write_text(scratch.path() / "file", "in the way\n");
    struct Case {
        std::string arguments;
        int code;
    };
    const Case cases[] = {
        {"render no_such_scene", 2},
        {"render no_such_file.obj", 3},
        {"render " + quoted(scratch.path()), 3},
        {"render " + quoted(scratch.path() / "text.obj"), 3},
        {"compare " + quoted(scratch.path() / "a.npy") + " " + quoted(scratch.path() / "b.npy"), 3},
        {"render wall_corner --size 8x8 --out " + quoted(scratch.path() / "file"), 4},
        {"render wall_corner --size 8x8 --out /dev/full", 4},
        {"render wall_corner --size 8x8 --out /proc/nowhere", 4},
        {"chapter 01 --size 32x18 --quiet --out " + quoted(scratch.path() / "file"), 4},
    };
    for (const Case& c : cases) {
        CAPTURE(c.arguments);
        const Outcome outcome = crevice_says(c.arguments);
        CAPTURE(outcome.text);
        CHECK(outcome.code == c.code);
        CHECK(outcome.text.find("; ") != std::string::npos);
    }
}

TEST_CASE("render writes the six buffers and a passes.json that describes them") {
    const ScratchDirectory scratch;
    const Outcome outcome = crevice_says(
        "render columns_luna --ao luna --size 64x36 --repeat 3 --threads 2 --out " + quoted(scratch.path()));
    CAPTURE(outcome.text);
    REQUIRE(outcome.code == 0);
    std::ifstream file(scratch.path() / "passes.json");
    const nlohmann::json report = nlohmann::json::parse(file);
    CHECK(report["scene"] == "columns_luna");
    CHECK(report["size"] == nlohmann::json({64, 36}));
    CHECK(report["method"] == "luna");
    CHECK(report["threads"] == 2);
    CHECK(report["lanes"] == lane_count(Run{}));
    const char* const passes[] = {"normal_depth", "ao", "blur", "shadow", "lit", "sky", "frame"};
    REQUIRE(report["passes"].size() == std::size(passes));
    for (std::size_t i = 0; i < std::size(passes); ++i) {
        CHECK(report["passes"][i]["name"] == passes[i]);
        CHECK(report["passes"][i]["runs"] == 3);
        CHECK(report["passes"][i]["wall_ms"].get<double>() > 0);
    }
    for (const auto& item : report["left_out"]) CHECK(!item["why"].get<std::string>().empty());
    const char* const buffers[] = {"normal", "view_depth", "ndc_depth", "ao_raw", "ao_blurred", "lit"};
    CHECK(report["buffers"].size() == std::size(buffers));
    for (const char* name : buffers) {
        CAPTURE(name);
        const Planes planes = read_npy(scratch.path() / (std::string(name) + ".npy"));
        const auto& described = report["buffers"][name];
        CHECK(described["shape"][0] == planes[0].size.height);
        CHECK(described["shape"][1] == planes[0].size.width);
        CHECK(described["nan"] == 0);
        Image3 colour;
        if (planes.size() == 3)
            std::tie(colour.x, colour.y, colour.z) = std::tie(planes[0], planes[1], planes[2]);
        CHECK(described["hash"] == (planes.size() == 1 ? content_hash(planes[0]) : content_hash(colour)));
        CHECK(std::filesystem::file_size(scratch.path() / (std::string(name) + ".png")) > 0);
    }
    CHECK(report["buffers"]["ao_raw"]["shape"] == nlohmann::json({18, 32}));
}

TEST_CASE("a file whose name is no UTF-8 is drawn, and passes.json is UTF-8 all the same") {
    const ScratchDirectory scratch;
    const std::filesystem::path obj = scratch.path() / "caf\xe9.obj";
    write_text(obj, "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    const Outcome outcome =
        crevice_says("render " + quoted(obj) + " --size 16x9 --out " + quoted(scratch.path() / "out"));
    CAPTURE(outcome.text);
    REQUIRE(outcome.code == 0);
    std::ifstream file(scratch.path() / "out" / "passes.json");
    const std::string scene = nlohmann::json::parse(file)["scene"];
    CHECK(scene.ends_with("caf\xef\xbf\xbd.obj"));
}

TEST_CASE("a vertex that stretches the scene is named in the coordinates of its file") {
    const ScratchDirectory scratch;
    std::ofstream(scratch / "a.obj")
        << "v 0 0 0\nv 4 0 0\nv 4 3 0\nv 0 3 0\nv 0 0 4\nv 4 0 4\nf 1 2 3 4\nf 1 5 6 2\n"
           "v 1 1 -80\nv 2 1 -80\nv 1 2 -80.5\nf -3 -2 -1\n";
    const std::string render = "render " + quoted(scratch.path() / "a.obj") +
                               " --size 16x9 --ao none --only normal --out " + quoted(scratch.path() / "out");
    const Outcome outcome = crevice_says(render);
    CHECK(outcome.code == 0);
    CHECK(outcome.text.find("the vertex at 1, 2, -80.5 makes the scene 1") != std::string::npos);
}

TEST_CASE("--only writes just those buffers, with the same bits as a whole frame") {
    const ScratchDirectory all, one;
    REQUIRE(crevice_says("render columns --size 64x36 --keep-all --out " + quoted(all.path())).code == 0);
    REQUIRE(crevice_says("render columns --size 64x36 --only ao_raw --out " + quoted(one.path())).code == 0);
    CHECK(!std::filesystem::exists(one.path() / "lit.npy"));
    CHECK(
        crevice_says("compare " + quoted(all.path() / "ao_raw.npy") + " " + quoted(one.path() / "ao_raw.npy"))
            .code == 0);
    const Outcome other =
        crevice_says("compare --out " + quoted(one.path()) + " " + quoted(all.path() / "ao_raw.npy") + " " +
                     quoted(all.path() / "ao_blurred.npy"));
    CAPTURE(other.text);
    CHECK(other.code == 1);
}

TEST_CASE("the lists name every scene, method and parameter") {
    const Outcome scenes = crevice_says("scenes"), methods = crevice_says("methods"),
                  params = crevice_says("params xjun");
    CHECK(scenes.code == 0);
    for (const char* name : {"columns", "columns_luna", "sphere_on_plane", "wall_corner", "trench", "cornell",
                             "atrium", "noise_wall", "empty"}) {
        CAPTURE(name);
        CHECK(scenes.text.find(name) != std::string::npos);
    }
    for (const char* name : {"xjun", "luna", "none"}) CHECK(methods.text.find(name) != std::string::npos);
    for (const char* name : {"samples", "radius", "fade_start", "fade_end", "epsilon", "exponent", "seed",
                             "blur_iterations", "as_published"}) {
        CAPTURE(name);
        CHECK(params.text.find(name) != std::string::npos);
    }
    CHECK(crevice_says("--help").code == 0);
    CHECK(crevice_says("render --help").code == 0);
}
