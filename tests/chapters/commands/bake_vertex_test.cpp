#include "chapters/commands/bake.h"

#include <sstream>

#include <doctest/doctest.h>

#include "rasterizer/base/error.h"
#include "tests/tools/bytes_in.h"
#include "tests/tools/loaded_obj.h"

using namespace crevice;

namespace {

BakeOptions options_for(const std::string& scene, const std::filesystem::path& out) {
    BakeOptions options;
    options.scene = scene;
    options.rays.rays = 8;
    options.rays.radius = std::numeric_limits<float>::infinity();
    options.out = out;
    return options;
}

}  // namespace

TEST_CASE("bake_vertex: writes the scene with grey vertex colours, the same bytes at every thread count") {
    const ScratchDirectory scratch;
    // A floor in the open and a lid close above its middle: four vertices are open, four are not.
    write_text(scratch / "lid.obj",
               "v -1 0 -1\nv 1 0 -1\nv 1 0 1\nv -1 0 1\nv -9 .25 -9\nv 9 .25 -9\nv 9 .25 9\nv -9 .25 9\n"
               "f 4 3 2 1\nf 1 2 3 4\nf 5 6 7 8\n");
    std::string first;
    for (const int threads : {1, 3}) {
        BakeOptions options = options_for((scratch / "lid.obj").string(), scratch / "out");
        options.run.threads = threads;
        std::ostringstream said;
        bake_vertex(options, said);
        const std::filesystem::path written = scratch / "out" / "lid_vertex_ao.obj";
        CHECK(said.str().find("6 triangles") != std::string::npos);
        CHECK(said.str().find(written.string()) != std::string::npos);
        const std::string bytes = bytes_in(written);
        CHECK(bytes.find("# Accessibility of lid ") == 0);
        if (threads == 1) first = bytes;
        CHECK(bytes == first);
        CHECK(load_obj(written).scene.meshes[0].triangles.size() == 6);
    }
    std::istringstream lines(first);
    int vertices = 0, open = 0;
    for (std::string line; std::getline(lines, line);) {
        if (line.rfind("v ", 0) != 0) continue;
        ++vertices;
        std::istringstream words(line.substr(2));
        float x = 0, y = 0, z = 0, red = -1, green = -1, blue = -1;
        words >> x >> y >> z >> red >> green >> blue;
        CAPTURE(line);
        CHECK(red == green);
        CHECK(red == blue);
        CHECK(red >= 0);
        CHECK(red <= 1);
        open += red == 1;
    }
    CHECK(vertices == 12);  // the floor's front and back have vertices of their own
    CHECK(open >= 4);
    CHECK(open <= 8);
}

TEST_CASE("bake_vertex: a scene without triangles is named, and so is a place that cannot be written to") {
    const ScratchDirectory scratch;
    std::ostringstream said;
    try {
        bake_vertex(options_for("empty", scratch.path()), said);
        FAIL_CHECK("an empty scene was baked");
    } catch (const InputError& error) {
        CHECK(std::string(error.what()).find("empty: there is no triangle to bake") == 0);
    }
    write_text(scratch / "file", "");
    CHECK_THROWS_AS(bake_vertex(options_for("trench", scratch / "file"), said), OutputError);
    BakeOptions bad = options_for("trench", scratch.path());
    bad.rays.radius = 0;
    CHECK_THROWS_AS(bake_vertex(bad, said), UsageError);
    CHECK(said.str().empty());
}
