#include "rasterizer/obj/obj_materials.h"

#include <cstdint>

#include <doctest/doctest.h>

#include "rasterizer/base/image_io.h"
#include "tests/tools/loaded_obj.h"

using namespace crevice;
namespace fs = std::filesystem;

namespace {

// A directory with an OBJ's directory in it, and files that lie inside and outside of that.
struct Models {
    ScratchDirectory scratch;

    Models() {
        fs::create_directories(scratch / "models/maps");
        const std::vector<std::uint8_t> white(3, 255);
        const std::string png = png_bytes({1, 1}, 3, white);
        write_text(scratch / "models/maps/white.png", png);
        write_text(scratch / "outside.png", png);
        write_text(scratch / "outside.mtl", "newmtl red\nKd 1 0 0\n");
        write_text(scratch / "models/cut.png", png.substr(0, png.size() / 2));
    }

    // One triangle of material `red`; `head` comes before it, `mtl` is the text of `a b.mtl`.
    LoadedObj load(const std::string& head, const std::string& mtl, const ObjOptions& options = {}) const {
        write_text(scratch / "models/a b.mtl", mtl);
        write_text(scratch / "models/a.obj", head + kCorners + "vt 0 0\nusemtl red\nf 1/1 2/1 3/1\n");
        LoadedObj loaded = load_obj(scratch / "models/a.obj", options);
        check_whole(loaded);
        return loaded;
    }
};

}  // namespace

TEST_CASE("load_obj: material values as they stand; names with blanks and with Windows slashes") {
    const Models models;
    const LoadedObj loaded =
        models.load("mtllib a b.mtl\n",
                    "\xEF\xBB\xBFnewmtl red\r\nKd 0.5 0.25 0\r\nKa 0.1 0.2 0.3\r\nKs 0.04 0.04 0.05\r\n"
                    "Ns 90\r\nmap_Kd maps\\white.png\r\n");
    CHECK(loaded.report.warnings == std::vector<std::string>{});
    const Material& red = loaded.scene.materials[0];
    CHECK(red.name == "red");
    CHECK(red.diffuse == glm::vec3(0.5f, 0.25f, 0));
    CHECK(red.ambient == glm::vec3(0.1f, 0.2f, 0.3f));
    CHECK(red.specular == glm::vec3(0.04f, 0.04f, 0.05f));
    CHECK(red.shininess == 90);
    REQUIRE(red.texture);
    CHECK(red.texture->colour(0).at(0, 0) == glm::vec3(1));
}

TEST_CASE("load_obj: no texture is read that nobody wants") {
    const Models models;
    const LoadedObj loaded = models.load("mtllib a b.mtl\n", "newmtl red\nKd .8 .8 .8\nmap_Kd cut.png\n",
                                         {.want_textures = false});
    CHECK_FALSE(loaded.report.any());
    CHECK_FALSE(loaded.scene.materials[0].texture);
}

TEST_CASE("load_obj: a material that is missing, damaged or outside is a warning and the default") {
    const Models models;
    struct Row {
        std::string what, head, mtl, warning;
    };
    const std::string lib = "mtllib a b.mtl\n";
    const std::string absolute = (models.scratch / "outside.png").string();
    const std::vector<Row> rows = {
        {"no mtllib", "", "", "a.obj:6: no library has the material (red)"},
        {"mtllib missing", "mtllib none.mtl\n", "", "a.obj:1: the material library cannot be read"},
        {"mtllib outside", "mtllib ../outside.mtl\n", "", "a.obj:1: the material library is outside"},
        {"material missing", lib, "newmtl green\nKd 0 1 0\n", "a.obj:7: no library has the material (red)"},
        {"empty library", lib, "", "no library has the material (red)"},
        {"texture missing", lib, "newmtl red\nKd .8 .8 .8\nmap_Kd none.png\n", "there is no such file"},
        {"texture damaged", lib, "newmtl red\nKd .8 .8 .8\nmap_Kd cut.png\n",
         "cut.png: the picture is damaged"},
        {"texture outside", lib, "newmtl red\nKd .8 .8 .8\nmap_Kd ../outside.png\n",
         "is outside the OBJ's directory"},
        {"texture by absolute path", lib, "newmtl red\nKd .8 .8 .8\nmap_Kd " + absolute + "\n", "is outside"},
        {"texture by detour", lib, "newmtl red\nKd .8 .8 .8\nmap_Kd maps/../../outside.png\n", "is outside"},
        {"texture is a directory", lib, "newmtl red\nKd .8 .8 .8\nmap_Kd maps\n", "is a directory"},
        {"negative reflectance", lib, "newmtl red\nKd -1 0 0\n",
         "has a Kd outside [0, 1] (-1 0 0); drawn with the default"},
        {"reflectance that is none", lib, "newmtl red\nKd inf 0 0\n", "has a Kd outside [0, 1] (inf 0 0)"},
    };
    for (const Row& row : rows) {
        CAPTURE(row.what);
        const LoadedObj loaded = models.load(row.head, row.mtl);
        CHECK(has_warning(loaded.report, row.warning));
        CHECK(triangle_count(loaded.scene) == 1);
        CHECK(loaded.scene.materials[0].diffuse == Material{}.diffuse);
        CHECK_FALSE(loaded.scene.materials[0].texture);
    }
}

TEST_CASE("load_obj: a link does not lead out of the directory") {
    const Models models;
    fs::create_symlink(models.scratch / "outside.png", models.scratch / "models/link.png");
    const LoadedObj loaded = models.load("mtllib a b.mtl\n", "newmtl red\nKd 1 1 1\nmap_Kd link.png\n");
    CHECK(has_warning(loaded.report, "is outside the OBJ's directory (link.png)"));
}

TEST_CASE("load_obj: a material's colour is its own; without one it is grey, or its texture's, and says so") {
    const Models models;
    const std::string lib = "mtllib a b.mtl\n";
    const LoadedObj grey = models.load(lib, "newmtl other\nKd 1 0 0\nKs 1 1 1\nNs 90\nnewmtl red\nNs 10\n");
    const Material& plain = grey.scene.materials[0];
    CHECK(plain.diffuse == glm::vec3(0.8f));
    CHECK(plain.specular == glm::vec3(0));
    CHECK(plain.shininess == 10);
    CHECK(grey.report.warnings.size() == 1);
    CHECK(has_warning(grey.report,
                      "a b.mtl:5: a material has no Kd (colour) (1 line); drawn in the default grey"));
    const LoadedObj mapped = models.load(lib, "newmtl red\nmap_Kd maps/white.png\n");
    CHECK(mapped.scene.materials[0].diffuse == glm::vec3(1));
    CHECK(has_warning(mapped.report,
                      "a b.mtl:1: a material has no Kd (colour) (1 line); its texture is drawn as it is"));
    CHECK(models.load(lib, "newmtl red\nKd .5\n").scene.materials[0].diffuse == glm::vec3(0.5f));
}

TEST_CASE("load_obj: a reflectance above 1 keeps its hue") {
    const Models models;
    const LoadedObj loaded = models.load("mtllib a b.mtl\n", "newmtl red\nKd 2 1 0.5\nKa 4 4 4\nKs 1 1 2\n");
    const Material& red = loaded.scene.materials[0];
    CHECK(red.diffuse == glm::vec3(1, 0.5f, 0.25f));
    CHECK(red.ambient == glm::vec3(1));
    CHECK(red.specular == glm::vec3(0.5f, 0.5f, 1));
    CHECK(loaded.report.warnings.size() == 3);
    CHECK(has_warning(loaded.report,
                      "a b.mtl:1: material `red` has a Kd outside [0, 1] (2 1 0.5); drawn with 1 0.5 0.25"));
    CHECK_FALSE(models.load("mtllib a b.mtl\n", "newmtl red\nKd 1 0 1\n").report.any());
}

TEST_CASE("load_obj: what would be invisible is drawn opaque, and said once for all") {
    const Models models;
    const LoadedObj solid = models.load("mtllib a b.mtl\n", "newmtl red\nKd 1 0 0\nd 0\n");
    REQUIRE(solid.report.warnings.size() == 1);
    CHECK(
        has_warning(solid.report,
                    "a b.mtl:1: a material would be wholly invisible (d 0 or Tr 1) (1 line); drawn opaque"));
    CHECK(has_warning(models.load("mtllib a b.mtl\n", "newmtl red\nKd 1 0 0\nTr 1\n").report,
                      "wholly invisible"));
    CHECK(has_warning(models.load("mtllib a b.mtl\n", "newmtl red\nKd 1 0 0\nd .5\n").report,
                      "a material is transparent (d below 1) (1 line)"));
    // Some exporters write both, the second one meaning the same as the first.
    CHECK_FALSE(models.load("mtllib a b.mtl\n", "newmtl red\nKd 1 0 0\nd 1\nTr 1\n").report.any());
}

TEST_CASE("load_obj: material names with comments, numbers and quotes around them") {
    const ScratchDirectory scratch;
    write_text(scratch / "a.mtl",
               "newmtl paint # red\nKd 1 0 0\nnewmtl Material #1\nKd 0 1 0\n"
               "newmtl Material #2\nKd 0 0 1\nnewmtl  two  words \nKd 1 1 0\n"
               "newmtl paint # red\nKd 0 0 0\n");
    write_text(scratch / "a.obj", "mtllib \"a.mtl\" # colours\n" + std::string(kCorners) +
                                      "usemtl paint # brush\nf 1 2 3\nusemtl Material #2\nf 1 2 3\n"
                                      "usemtl  two  words\nf 1 2 3\nusemtl Material #1\nf 1 2 3\n"
                                      "usemtl \"paint\"\nf 1 2 3\n");
    const LoadedObj loaded = load_obj(scratch / "a.obj");
    check_whole(loaded);
    const auto& parts = mesh_of(loaded).parts;
    REQUIRE(parts.size() == 5);
    const glm::vec3 wanted[] = {{1, 0, 0}, {0, 0, 1}, {1, 1, 0}, {0, 1, 0}, {1, 0, 0}};
    for (std::size_t i = 0; i < parts.size(); ++i) {
        CAPTURE(i);
        CHECK(loaded.scene.materials[static_cast<std::size_t>(parts[i].material)].diffuse == wanted[i]);
    }
    REQUIRE(loaded.report.warnings.size() == 1);
    CHECK(has_warning(loaded.report, "a.mtl:9: material `paint` is there already; the first one is drawn"));
}

TEST_CASE("load_obj: `usemtl` without a name means white, and no material without one") {
    const ScratchDirectory scratch;
    write_text(scratch / "a.mtl", "newmtl red\nKd 1 0 0\nnewmtl\nKd 0 1 0\n");
    for (const char* nameless : {"usemtl\n", "usemtl \t \n", "usemtl # none\n"}) {
        write_text(scratch / "a.obj", "mtllib a.mtl\n" + std::string(kCorners) + "usemtl red\nf 1 2 3\n" +
                                          nameless + "f 1 2 3\nusemtl red\nf 1 2 3\n");
        const LoadedObj loaded = load_obj(scratch / "a.obj");
        check_whole(loaded);
        const auto& parts = mesh_of(loaded).parts;
        REQUIRE(parts.size() >= 2);
        const auto material = [&](std::size_t i) {
            return loaded.scene.materials[static_cast<std::size_t>(parts[i].material)];
        };
        CHECK(material(0).diffuse == glm::vec3(1, 0, 0));
        CHECK(material(1).diffuse == glm::vec3(1));
        CHECK(material(1).ambient == glm::vec3(1));
        CHECK(material(1).specular == glm::vec3(0));
        REQUIRE(loaded.report.warnings.size() == 1);
        CHECK(has_warning(loaded.report, "a.mtl:3: `newmtl` without a name"));
    }
}

TEST_CASE("load_obj: files outside the directory are read where that is allowed") {
    const Models models;
    const LoadedObj loaded = models.load("mtllib ../outside.mtl\n", "", {.outside_files = true});
    CHECK_FALSE(loaded.report.any());
    CHECK(loaded.scene.materials[0].diffuse == glm::vec3(1, 0, 0));
}
