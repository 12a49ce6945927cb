#include "rasterizer/obj/file_tree.h"

#include <doctest/doctest.h>

#include "tests/tools/loaded_obj.h"

using namespace crevice;
namespace fs = std::filesystem;

TEST_CASE("FileTree: where files are found, and which may be read") {
    const ScratchDirectory scratch;
    fs::create_directories(scratch / "models/mtl/maps");
    for (const char* name :
         {"outside.png", "models/beside.png", "models/mtl/maps/Wood.PNG", "models/mtl/near.png"})
        write_text(scratch / name, "x");
    const fs::path models = scratch / "models";
    struct Row {
        std::string name, path;  // path: below models; "": nothing
        bool outside, elsewhere;
    };
    const std::vector<Row> rows = {
        {"near.png", "mtl/near.png", false, false},
        {"maps/Wood.PNG", "mtl/maps/Wood.PNG", false, false},
        {"maps\\wood.png", "mtl/maps/Wood.PNG", false, false},
        {"MAPS/wood.png", "mtl/maps/Wood.PNG", false, false},
        {"../beside.png", "beside.png", false, false},
        {"beside.png", "beside.png", false, false},
        {"C:\\Users\\me\\near.png", "mtl/near.png", false, true},
        {"/home/me/beside.png", "beside.png", false, true},
        {"../../outside.png", "", true, false},
        {"../../../../../../etc/passwd", "", true, false},
        {"/etc/passwd", "", true, false},
        {"none.png", "", false, false},
        {"", "", false, false},
        {"maps/", "", false, false},
    };
    const FileTree tree(models / "a.obj", false), open(models / "a.obj", true);
    for (const Row& row : rows) {
        CAPTURE(row.name);
        const FoundFile found = tree.find(row.name, models / "mtl");
        CHECK(found.path == (row.path.empty() ? fs::path() : models / row.path));
        CHECK(found.outside == row.outside);
        CHECK(found.elsewhere == row.elsewhere);
    }
    CHECK(open.find("../../outside.png", models / "mtl").path == fs::canonical(scratch / "outside.png"));
    // Listed once: what comes later is found by its own name alone.
    write_text(models / "Late.png", "x");
    CHECK(tree.find("late.png", models).path.empty());
    CHECK(tree.find("Late.png", models).path == models / "Late.png");
    fs::create_symlink(scratch / "outside.png", models / "link.png");
    CHECK(tree.find("link.png", models).path.empty());
    CHECK(tree.find("link.png", models).outside);
}

TEST_CASE("FileTree: of names that differ in capitals alone the first in the alphabet is taken") {
    const ScratchDirectory scratch;
    for (const char* name : {"wOOD.png", "WOOD.png", "Wood.png"}) write_text(scratch / name, "x");
    const FileTree tree(scratch / "a.obj", false);
    for (const char* name : {"wood.png", "woOd.PNG"})
        CHECK(tree.find(name, scratch.path()).path == scratch / "WOOD.png");
    CHECK(tree.find("Wood.png", scratch.path()).path == scratch / "Wood.png");
}
