// `crevice bake SCENE --lightmap`: the three files and what they hold; errors leave nothing behind.
#include <doctest/doctest.h>

#include <fstream>
#include <limits>
#include <sstream>

#include "chapters/commands/bake.h"
#include "rasterizer/base/error.h"
#include "rasterizer/base/image_io.h"
#include "rasterizer/obj/obj_load.h"
#include "rasterizer/textures/texture.h"
#include "tests/tools/bytes_in.h"
#include "tests/tools/scratch_directory.h"

using namespace crevice;

namespace {

BakeOptions options_for(const std::string& scene, const std::filesystem::path& out) {
    BakeOptions options;
    options.scene = scene;
    options.rays = {.rays = 8, .radius = std::numeric_limits<float>::infinity()};
    options.texels = 64;
    options.out = out;
    return options;
}

}  // namespace

TEST_CASE("bake --lightmap: the map as floats and as a picture, the mesh that leads into it") {
    const ScratchDirectory scratch;
    std::ostringstream said;
    bake_lightmap(options_for("cornell", scratch.path() / "new"), said);
    const std::filesystem::path out = scratch.path() / "new";
    const Planes map = read_npy(out / "lightmap.npy");
    REQUIRE(map.size() == 1);
    CHECK(map[0].size == Size{64, 64});
    const BufferStatistics values = buffer_statistics(map[0]);
    CHECK(values.min < 0.1f);
    CHECK(values.max == 1);
    CHECK(values.nan == 0);
    CHECK(read_png(out / "lightmap.png").colour.size() == Size{64, 64});

    const std::string obj = bytes_in(out / "cornell_lightmap.obj");
    CHECK(obj.find("# An OBJ file has one set of texture coordinates") != std::string::npos);
    ObjOptions load;
    load.want_unused_texcoords = true;
    const LoadedObj loaded = load_obj(out / "cornell_lightmap.obj", load);
    CHECK(triangle_count(loaded.scene) == 38);
    for (const Mesh& mesh : loaded.scene.meshes) {
        REQUIRE(mesh.texcoords.size() == mesh.positions.size());
        for (const glm::vec2& at : mesh.texcoords) {
            CHECK(at.x > 0);
            CHECK(at.x < 1);
            CHECK(at.y > 0);
            CHECK(at.y < 1);
        }
    }
    for (const char* word : {"15 charts for 38 triangles", "texels a scene unit", "% of the texels are used",
                             "rays", "ms", "cornell_lightmap.obj"}) {
        CAPTURE(word);
        CAPTURE(said.str());
        CHECK(said.str().find(word) != std::string::npos);
    }
}

TEST_CASE("bake --lightmap: two runs write the same bytes, an OBJ file is named after itself") {
    const ScratchDirectory scratch;
    std::ofstream(scratch / "step.obj") << "v 0 0 0\nv 1 0 0\nv 1 0 -1\nv 0 0 -1\nv 0 1 -1\nv 1 1 -1\n"
                                           "f 1 2 3 4\nf 4 3 6 5\n";
    std::ostringstream said;
    for (const int threads : {1, 7}) {
        BakeOptions options =
            options_for((scratch / "step.obj").string(), scratch.path() / std::to_string(threads));
        options.run.threads = threads;
        bake_lightmap(options, said);
    }
    for (const char* name : {"lightmap.npy", "lightmap.png", "step_lightmap.obj"}) {
        CAPTURE(name);
        const std::string once = bytes_in(scratch.path() / "1" / name);
        const bool same = once == bytes_in(scratch.path() / "7" / name);
        CHECK(!once.empty());
        CHECK(same);
    }
}

TEST_CASE(
    "bake --lightmap --mesh-texcoords: the file's own coordinates lead into the map; without any, charts "
    "do") {
    const ScratchDirectory scratch;
    const std::string corners = "v 0 0 0\nv 1 0 0\nv 1 0 -1\nv 0 0 -1\n";
    std::ofstream(scratch / "own.obj") << corners << "vt .25 .25\nvt .75 .25\nvt .75 .75\nvt .25 .75\n"
                                       << "f 1/1 2/2 3/3 4/4\n";
    std::ofstream(scratch / "none.obj") << corners << "f 1 2 3 4\n";
    const auto mean_of = [](const Mesh& mesh) {
        glm::vec2 sum(0);
        for (const glm::vec2& at : mesh.texcoords) sum += at;
        return sum / static_cast<float>(mesh.texcoords.size());
    };
    for (const char* name : {"own", "none"}) {
        CAPTURE(name);
        const std::filesystem::path out = scratch.path() / name;
        std::ostringstream said;
        BakeOptions options = options_for((scratch / (std::string(name) + ".obj")).string(), out);
        options.mesh_texcoords = true;
        bake_lightmap(options, said);
        const LoadedObj loaded = load_obj(out / (std::string(name) + "_lightmap.obj"));
        const Mesh& mesh = loaded.scene.meshes.at(0);
        REQUIRE(mesh.texcoords.size() == 4);
        const bool own = mean_of(mesh) == glm::vec2(0.5f) && mesh.texcoords[0].x == 0.25f;
        CHECK(own == (name == std::string("own")));
    }
}

TEST_CASE("bake --lightmap: what cannot be baked is an error, and nothing is written") {
    const ScratchDirectory scratch;
    std::ofstream(scratch / "flat.obj") << "v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n";
    std::ostringstream said;
    BakeOptions empty = options_for("empty", scratch.path() / "out"), flat = empty, none = empty,
                small = empty, crowded = empty, rays = empty;
    flat.scene = (scratch / "flat.obj").string();
    none.scene = (scratch / "missing.obj").string();
    small.scene = crowded.scene = rays.scene = "columns";
    small.texels = 8;
    crowded.texels = 16;
    rays.rays.rays = 0;
    CHECK_THROWS_AS(bake_lightmap(empty, said), InputError);
    CHECK_THROWS_AS(bake_lightmap(flat, said), InputError);
    CHECK_THROWS_AS(bake_lightmap(none, said), InputError);
    CHECK_THROWS_AS(bake_lightmap(small, said), UsageError);
    CHECK_THROWS_AS(bake_lightmap(crowded, said), UsageError);
    CHECK_THROWS_AS(bake_lightmap(rays, said), UsageError);
    const bool nothing =
        !std::filesystem::exists(scratch.path() / "out") || std::filesystem::is_empty(scratch.path() / "out");
    CHECK(nothing);
    CHECK(said.str().empty());
    BakeOptions unwritable = options_for("cornell", scratch.path() / "flat.obj" / "out");
    CHECK_THROWS_AS(bake_lightmap(unwritable, said), OutputError);
}
