// `crevice render --normals --depth`: AO of buffers that another program drew.
#include "chapters/commands/given_buffers.h"

#include <cmath>
#include <fstream>
#include <limits>
#include <string>

#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

#include "rasterizer/base/image_io.h"
#include "tests/tools/crevice_says.h"
#include "tests/tools/schema_checks.h"
#include "tests/tools/scratch_directory.h"

using namespace crevice;

namespace {

std::string quoted(const std::filesystem::path& path) { return "'" + path.string() + "'"; }

std::string bytes_of(const std::filesystem::path& path) {
    std::ifstream stream(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

bool contains(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

// A wall of 8 x 6 pixels, 5 away, with a pixel of sky.
struct Wall {
    ScratchDirectory scratch;
    Image3 normal = Image3({8, 6}, glm::vec3(0, 0, -1));
    Image<float> depth = Image<float>({8, 6}, 5.0f);

    Wall() { depth.at(7, 0) = std::numeric_limits<float>::infinity(); }
    Outcome run(const std::string& more = "--fov-y 60") const {
        write_npy(scratch / "n.npy", normal);
        write_npy(scratch / "d.npy", depth);
        return crevice_says("render --normals " + quoted(scratch / "n.npy") + " --depth " +
                            quoted(scratch / "d.npy") + " " + more + " --out " + quoted(scratch / "out"));
    }
};

}  // namespace

TEST_CASE("given buffers: what render drew gives its own AO and blur, with every screen-space method") {
    const ScratchDirectory scratch;
    for (const Method& method : ao_methods()) {
        if (!method.computes_ao() || method.casts_rays || method.bake) continue;
        CAPTURE(std::string(method.name));
        const std::string ao = std::string(" --ao ") + method.name, view = " --fov-y 45 --near 1 --far 1000";
        const std::filesystem::path drawn = scratch / "drawn", given = scratch / "given";
        REQUIRE(crevice_says("render columns --size 64x36" + ao + view + " --out " + quoted(drawn)).code ==
                0);
        const Outcome outcome =
            crevice_says("render --normals " + quoted(drawn / "normal.npy") + " --depth " +
                         quoted(drawn / "view_depth.npy") + ao + view + " --out " + quoted(given));
        CAPTURE(outcome.text);
        REQUIRE(outcome.code == 0);
        for (const char* name : {"ao_raw.npy", "ao_blurred.npy"}) {
            // Depths that were rounded for a depth buffer are not those computed anew, by an ulp.
            const Image<float> theirs = read_npy(given / name).front(), ours = read_npy(drawn / name).front();
            const float most = method.name == std::string("luna") ? 1e-4f : 0.0f;
            for (int y = 0; y < ours.size.height; ++y)
                for (int x = 0; x < ours.size.width; ++x)
                    CHECK(std::abs(theirs.at(x, y) - ours.at(x, y)) <= most);
        }
        CHECK(!std::filesystem::exists(given / "lit.npy"));
        std::ifstream stream(given / "passes.json");
        CHECK(stored_schema("passes.schema.json").against(nlohmann::json::parse(stream)) == "");
    }
}

TEST_CASE("given buffers: what is wrong with them is said in one line") {
    struct Row {
        const char* what;
        int code;
        std::string said;
        void (*spoil)(Wall&);
    };
    const Row rows[] = {
        {"nothing", 0, "ao_blurred.png", [](Wall&) {}},
        {"two sizes", 3, "of two sizes",
         [](Wall& w) {
             w.depth = Image<float>({8, 5}, 5.0f);
         }},
        {"a depth of 0", 3, "not in front of the eye (0) at pixel (2, 1)",
         [](Wall& w) { w.depth.at(2, 1) = 0; }},
        {"a depth of NaN", 3, "not in front of the eye (nan) at pixel (2, 1)",
         [](Wall& w) { w.depth.at(2, 1) = NAN; }},
        {"depths of the other handedness", 3, "not in front of the eye (-5)",
         [](Wall& w) {
             w.depth = Image<float>({8, 6}, -5.0f);
         }},
        {"a normal of NaN", 3, "n.npy: no direction where view_depth has a surface",
         [](Wall& w) { w.normal.set(2, 1, glm::vec3(NAN)); }},
        {"a normal of 0", 3, "at pixel (2, 1)); give unit normals",
         [](Wall& w) { w.normal.set(2, 1, glm::vec3(0)); }},
        {"a long normal", 0,
         "n.npy: 1 normal is not unit (of 47, the first 2 long at pixel (2, 1)); made unit",
         [](Wall& w) {
             w.normal.set(2, 1, {0, 0, -2});
         }},
        {"normals of the other handedness", 0, "most normals face away from the eye (47 of 47 have z > 0)",
         [](Wall& w) {
             w.normal = Image3({8, 6}, glm::vec3(0, 0, 1));
         }},
        {"no surface", 0, "d.npy: no surface anywhere",
         [](Wall& w) {
             w.depth = Image<float>({8, 6}, INFINITY);
         }},
        {"metres as if they were light years", 0, "d.npy: the radius is less than a pixel everywhere (0.5",
         [](Wall& w) {
             w.depth = Image<float>({8, 6}, 5e20f);
         }},
        {"metres as if they were atoms", 0, "d.npy: the radius is larger than all that is seen (0.5",
         [](Wall& w) {
             w.depth = Image<float>({8, 6}, 5e-5f);
         }},
        {"rubbish in the sky", 0, "ao_blurred.png", [](Wall& w) { w.normal.set(7, 0, glm::vec3(NAN)); }},
    };
    for (const Row& row : rows) {
        CAPTURE(row.what);
        Wall wall;
        row.spoil(wall);
        const Outcome outcome = wall.run();
        CAPTURE(outcome.text);
        CHECK(outcome.code == row.code);
        CHECK(contains(outcome.text, row.said));
        CHECK(std::filesystem::exists(wall.scratch / "out" / "ao_raw.npy") == (row.code == 0));
        if (row.code != 0) CHECK(std::count(outcome.text.begin(), outcome.text.end(), '\n') == 1);
    }
}

TEST_CASE("given buffers: a long normal is the same as the unit one") {
    Wall unit, doubled;
    doubled.normal = Image3({8, 6}, glm::vec3(0, 0, -2));
    REQUIRE(unit.run().code == 0);
    REQUIRE(doubled.run().code == 0);
    CHECK(bytes_of(unit.scratch / "out" / "ao_raw.npy") == bytes_of(doubled.scratch / "out" / "ao_raw.npy"));
}

TEST_CASE("given buffers: words that do not go together, and files of another kind") {
    const Wall wall;
    CHECK(contains(wall.run("--fov-y 60 --near 6 --far 9").text,
                   "d.npy: depths beyond the planes (5 .. 5, --near 6"));
    const std::pair<const char*, const char*> wrong[] = {
        {"", "give --fov-y DEG"},
        {"columns --fov-y 60", "SCENE: says nothing of buffers"},
        {"--fov-y 60 --frames 0-3", "--frames: says nothing of buffers"},
        {"--fov-y 60 --eye 0,0,0", "--eye: says nothing of buffers"},
        {"--fov-y 60 --only lit", "--only: buffers are not lit"},
        {"--fov-y 60 --ao ray_cast", "--ao: casts rays through a scene"},
        {"--fov-y 60 --ao none", "--ao: computes nothing"},
        {"--fov-y 60 --param history=4", "--param history: there is no frame before"},
        {"--fov-y 60 --near 9 --far 2", "--far"},
    };
    for (const auto& row : wrong) {
        CAPTURE(row.first);
        const Outcome outcome = wall.run(row.first);
        CAPTURE(outcome.text);
        CHECK(outcome.code == 2);
        CHECK(contains(outcome.text, row.second));
    }
    const std::string depth =
        " --fov-y 60 --out " + quoted(wall.scratch / "out") + " --depth " + quoted(wall.scratch / "d.npy");
    const std::string normals = " --normals " + quoted(wall.scratch / "n.npy");
    CHECK(contains(crevice_says("render" + depth).text, "xjun reads normals as well; give --normals FILE"));
    CHECK(crevice_says("render --ao msvo" + depth).code == 0);
    CHECK(contains(crevice_says("render --fov-y 60" + normals).text, "--normals: the depths are missing"));
    // Each in the other's place.
    const Outcome swapped = crevice_says("render --fov-y 60 --normals " + quoted(wall.scratch / "d.npy") +
                                         " --depth " + quoted(wall.scratch / "n.npy"));
    CHECK(swapped.code == 3);
    CHECK(contains(swapped.text,
                   "n.npy: 3 components a pixel where view_depth has 1; give a file of shape (H, W)"));
    // Bytes, and a picture.
    std::ofstream(wall.scratch / "bytes.npy", std::ios::binary)
        << std::string("\x93NUMPY\1\0\x3a\0", 10)
        << "{'descr': '|u1', 'fortran_order': False, 'shape': (1, 2)}\n"
        << "ab";
    for (const auto& [file, said] : {std::pair("bytes.npy", "whole numbers of one or two bytes"),
                                     std::pair("picture.png", "no file of floats by its ending (.png)"),
                                     std::pair("none.npy", "none.npy")}) {
        const Outcome outcome =
            crevice_says("render --fov-y 60 --depth " + quoted(wall.scratch / file) + normals);
        CAPTURE(outcome.text);
        CHECK(outcome.code == 3);
        CHECK(contains(outcome.text, said));
    }
}
