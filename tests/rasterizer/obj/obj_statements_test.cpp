// OBJ statements beyond positions and faces: smoothing groups, colours, weights, and where the scene lies.
#include <doctest/doctest.h>

#include "rasterizer/lanes/approx_math.h"
#include "tests/tools/loaded_obj.h"

using namespace crevice;
using namespace std::string_literals;

namespace {

// A roof of three squares in a row: to the right of x = 1 and of x = 2 it falls, before it is level.
const std::string kRoof = "v 0 1 0\nv 0 1 1\nv 1 1 0\nv 1 1 1\nv 2 0 0\nv 2 0 1\nv 2 -1 0\nv 2 -1 1\n";
constexpr const char* kLevel = "f 1 2 4 3\n";
constexpr const char* kSlope = "f 3 4 6 5\n";
constexpr const char* kWall = "f 5 6 8 7\n";

// The normals at x = 1, where level and slope meet, in the order of first use.
std::vector<glm::vec3> normals_at_ridge(const LoadedObj& loaded, float x) {
    std::vector<glm::vec3> normals;
    const Mesh& mesh = mesh_of(loaded);
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        if (mesh.positions[i].x == x && mesh.positions[i].z == 0) normals.push_back(mesh.normals[i]);
    }
    return normals;
}

}  // namespace

TEST_CASE("smoothing groups: faces of one group share normals, those of two and of `s off` do not") {
    const auto half = static_cast<float>(std::sqrt(0.5));
    const glm::vec3 up(0, 1, 0), right(1, 0, 0), slant(half, half, 0);
    struct Row {
        const char* what;
        std::string faces;
        std::vector<glm::vec3> ridge, foot;
    };
    const glm::vec3 soft_ridge = glm::normalize(up + slant), soft_foot = glm::normalize(slant + right);
    const std::vector<Row> rows = {
        {"no groups: all smooth", kLevel + ""s + kSlope + kWall, {soft_ridge}, {soft_foot}},
        {"one group", "s 1\n"s + kLevel + kSlope + kWall, {soft_ridge}, {soft_foot}},
        {"off", "s off\n"s + kLevel + kSlope + kWall, {up, slant}, {slant, right}},
        {"0", "s 0\n"s + kLevel + kSlope + kWall, {up, slant}, {slant, right}},
        {"two groups", "s 1\n"s + kLevel + "s 7\n" + kSlope + kWall, {up, slant}, {soft_foot}},
        {"off in the middle", "s 1\n"s + kLevel + kSlope + "s off\n" + kWall, {soft_ridge}, {slant, right}},
        {"capitals", "S OFF\n"s + kLevel + kSlope + kWall, {up, slant}, {slant, right}},
    };
    for (const Row& row : rows) {
        CAPTURE(row.what);
        const LoadedObj loaded = load_text(kRoof + row.faces);
        check_whole(loaded);
        CHECK(loaded.report.warnings == std::vector<std::string>{});
        for (const bool ridge : {true, false}) {
            const std::vector<glm::vec3> found = normals_at_ridge(loaded, ridge ? 1.0f : 2.0f);
            const std::vector<glm::vec3>& wanted = ridge ? row.ridge : row.foot;
            // The wall's lower end lies at x = 2, too.
            REQUIRE(found.size() >= wanted.size());
            for (std::size_t i = 0; i < wanted.size(); ++i) CHECK(glm::length(found[i] - wanted[i]) < 1e-6f);
        }
    }
    CHECK(has_warning(load_text(kRoof + "s 1.5\n" + kLevel).report, "a.obj:9: `s` is not drawn here"));
}

TEST_CASE(
    "smoothing: a box without `vn` and `s` is said to be smoothed, and is not where a crease angle is "
    "given") {
    const std::string corners =
        "v -1 -1 -1\nv 1 -1 -1\nv 1 1 -1\nv -1 1 -1\nv -1 -1 1\nv 1 -1 1\nv 1 1 1\nv -1 1 1\n";
    const std::string faces = "f 1 4 3 2\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";
    const auto flat_faces = [](const LoadedObj& loaded) {
        const Mesh& mesh = mesh_of(loaded);
        return std::all_of(mesh.normals.begin(), mesh.normals.end(),
                           [](glm::vec3 n) { return std::abs(n.x) + std::abs(n.y) + std::abs(n.z) == 1; });
    };
    const LoadedObj smooth = load_text(corners + faces);
    CHECK_FALSE(flat_faces(smooth));
    CHECK(smooth.report.warnings.size() == 1);
    CHECK(has_warning(
        smooth.report,
        "a.obj:9: without `vn` and `s` normals are smoothed, here across sharp edges (6 faces, the first "
        "here); --crease 30 keeps those sharp, 0 makes every face flat"));
    // A few sharp edges among many are those of a scan, not of a box.
    std::string ground = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
    for (int i = 0; i < 594; ++i) ground += "f -3 -2 -1\n";
    CHECK(load_text(corners + faces + ground).report.warnings.size() == 1);
    CHECK(load_text(corners + faces + ground + "f -3 -2 -1\n").report.warnings.empty());
    CHECK(load_text(corners + faces + ground + "f -3 -2 -1\n").report.smoothed_faces.count == 6);
    // Nothing is said where the file or the caller wants it so.
    const LoadedObj wanted = load_text(corners + "s 1\n" + faces),
                    off = load_text(corners + "s off\n" + faces);
    CHECK((!flat_faces(wanted) && wanted.report.warnings.empty()));
    CHECK((flat_faces(off) && off.report.warnings.empty()));
    for (const double crease_rad : {0.0, radians(30), radians(89)}) {
        const LoadedObj sharp = load_text(corners + faces, {.crease_angle_rad = crease_rad});
        CHECK((flat_faces(sharp) && sharp.report.warnings.empty()));
        // Within one smoothing group, too, and between `s off` and the rest.
        CHECK(flat_faces(load_text(corners + "s 1\n" + faces, {.crease_angle_rad = crease_rad})));
    }
    CHECK_FALSE(flat_faces(load_text(corners + faces, {.crease_angle_rad = radians(91)})));
}

TEST_CASE("smoothing: what may well be a ball is smoothed without a word") {
    // An octahedron's faces turn by 70.5 degrees at each edge, those of an icosahedron by 41.8.
    const std::string icosahedron =
        "v 0 1 1.618034\nv 0 -1 1.618034\nv 0 1 -1.618034\nv 0 -1 -1.618034\nv 1 1.618034 0\nv -1 1.618034 "
        "0\n"
        "v 1 -1.618034 0\nv -1 -1.618034 0\nv 1.618034 0 1\nv -1.618034 0 1\nv 1.618034 0 -1\nv -1.618034 0 "
        "-1\n"
        "f 1 2 9\nf 2 1 10\nf 1 9 5\nf 1 5 6\nf 1 6 10\nf 2 10 8\nf 2 8 7\nf 2 7 9\nf 3 4 12\nf 4 3 11\nf 3 "
        "5 11\n"
        "f 3 6 5\nf 3 12 6\nf 4 11 7\nf 4 7 8\nf 4 8 12\nf 5 9 11\nf 7 11 9\nf 6 12 10\nf 8 10 12\n";
    CHECK(load_text(icosahedron).report.warnings.empty());
}

TEST_CASE("smoothing: a crease angle of 0 makes every face flat, a bent polygon as a whole") {
    const LoadedObj loaded =
        load_text("v 0 0 0\nv 1 0 0\nv 1 1 .5\nv 0 1 0\nf 1 2 3 4\n", {.crease_angle_rad = 0});
    REQUIRE(mesh_of(loaded).normals.size() == 4);
    for (const glm::vec3& n : mesh_of(loaded).normals) CHECK(n == mesh_of(loaded).normals[0]);
}

TEST_CASE("smoothing off: a bent polygon has one normal, whatever the cut") {
    const LoadedObj loaded = load_text("s off\nv 0 0 0\nv 1 0 0\nv 1 1 .5\nv 0 1 0\nf 1 2 3 4\n");
    check_whole(loaded);
    REQUIRE(mesh_of(loaded).normals.size() == 4);
    for (const glm::vec3& n : mesh_of(loaded).normals) CHECK(n == mesh_of(loaded).normals[0]);
}

TEST_CASE("vertex colours: read as linear, bytes brought to 1, absent ones white") {
    const auto colours = [](const std::string& text) {
        return mesh_of(load_text(text + "f 1 2 3\n")).colours;
    };
    using Colours = std::vector<glm::vec3>;
    CHECK(colours("v 0 0 0 1 0 0\nv 1 0 0 0 .5 0\nv 0 1 0 0 0 .25\n") ==
          Colours{{1, 0, 0}, {0, .5f, 0}, {0, 0, .25f}});
    CHECK(colours("v 0 0 0 1 0 0 1\nv 1 0 0\nv 0 1 0 1\n") == Colours{{1, 0, 0}, glm::vec3(1), glm::vec3(1)});
    CHECK(colours("v 0 0 0\nv 1 0 0\nv 0 1 0\n").empty());
    const Material shown = load_text("v 0 0 0 1 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n").scene.materials.back();
    CHECK((shown.diffuse == glm::vec3(1) && shown.specular == glm::vec3(0)));
    const LoadedObj bytes = load_text("v 0 0 0 255 0 0\nv 1 0 0 0 51 0\nv 0 1 0\nf 1 2 3\n");
    CHECK(mesh_of(bytes).colours == Colours{{1, 0, 0}, {0, 0.2f, 0}, glm::vec3(1)});
    CHECK(has_warning(bytes.report,
                      "a.obj:1: vertex colours are above 1 (the highest is 255); taken as 0 to 255"));
    const LoadedObj rounded = load_text("v 0 0 0 1.000001 0 0\nv 1 0 0 0 .5 0\nv 0 1 0\nf 1 2 3\n");
    CHECK(mesh_of(rounded).colours == Colours{{1, 0, 0}, {0, .5f, 0}, glm::vec3(1)});
    CHECK(has_warning(rounded.report, "cut at 1"));
    const LoadedObj wild = load_text("v 0 0 0 nan 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    CHECK(mesh_of(wild).colours.empty());
    CHECK(has_warning(wild.report, "a.obj:1: a vertex colour of the file is out of range"));
}

TEST_CASE("polypaint of ZBrush: sRGB colours for the vertices in their order") {
    const std::string corners = "v 0 0 0\nv 1 0 0\nv 0 1 0\n", face = "f 1 2 3\n";
    using Colours = std::vector<glm::vec3>;
    const Colours wanted = {{1, 0, 0}, glm::vec3(linear_from_srgb(128.0f / 255)), {0, 0, 1}};
    for (const std::string& text : {corners + "#MRGB ffff0000ff808080000000FF\n" + face,
                                    "#MRGB ffff0000ff808080000000ff\n" + corners + face,
                                    corners + "#MRGB ffff0000ff808080\r\n#MRGB 000000ff\r\n" + face}) {
        CAPTURE(text);
        const LoadedObj loaded = load_text(text);
        CHECK(loaded.report.warnings == std::vector<std::string>{});
        REQUIRE(mesh_of(loaded).colours.size() == 3);
        for (std::size_t i = 0; i < 3; ++i)
            CHECK(glm::length(mesh_of(loaded).colours[i] - wanted[i]) < 1e-6f);
        CHECK(loaded.scene.materials.back().diffuse == glm::vec3(1));
    }
    struct Row {
        std::string lines, warning;
    };
    for (const Row& row :
         {Row{"#MRGB ffff0000\n",
              "a.obj:4: the colours of `#MRGB` (polypaint) are not as many as the "
              "vertices (1 for 3); drawn without"},
          Row{"#MRGB ffff00\n", "a.obj:4: `#MRGB` (polypaint) is not eight hexadecimal digits"},
          Row{"#MRGB ffff000g\n", "a.obj:4: `#MRGB` (polypaint) is not eight hexadecimal digits"}}) {
        CAPTURE(row.lines);
        const LoadedObj loaded = load_text(corners + row.lines + face);
        CHECK(mesh_of(loaded).colours.empty());
        CHECK(has_warning(loaded.report, row.warning));
    }
    // Colours of the vertices themselves go before; other comments stay comments.
    const LoadedObj both = load_text("v 0 0 0 0 1 0\nv 1 0 0\nv 0 1 0\n#MRGB ffff0000\n" + face);
    CHECK(mesh_of(both).colours[0] == glm::vec3(0, 1, 0));
    CHECK(load_text(corners + "#MRGBs are colours\n" + face).report.warnings.empty());
}

TEST_CASE("homogeneous vertices are divided by w") {
    const Mesh mesh = mesh_of(load_text("v 0 0 2 2\nv 3 0 0 3\nv 0 .5 0 .5\nf 1 2 3\n"));
    CHECK(mesh.positions == std::vector<glm::vec3>{{0, 0, -1}, {1, 0, 0}, {0, 1, 0}});
    CHECK(load_text("v 0 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n").report.not_finite.count == 1);
    const ScratchDirectory scratch;
    write_text(scratch / "a.obj", "v 1 2 3 4 5\n");
    CHECK(error_of(scratch / "a.obj").find("a.obj:1: `v` has the wrong count of numbers (5)") !=
          std::string::npos);
}

TEST_CASE("far from the origin: the shape keeps its digits, and the origin says where it lies") {
    // 2 mm apart at UTM coordinates, where floats are 25 cm apart.
    const LoadedObj loaded = load_text(
        "v 388095.350 3948995.700 40.200\nv 388095.352 3948995.700 40.200\nv 388095.350 3948995.702 "
        "40.200\nf 1 2 3\n");
    check_whole(loaded);
    const Mesh& mesh = mesh_of(loaded);
    REQUIRE(mesh.triangles.size() == 1);
    const glm::dvec3 origin = loaded.scene.origin;
    const auto in_file = [&](std::size_t i) {
        const glm::dvec3 p = origin + glm::dvec3(mesh.positions[i]);
        return glm::dvec3(p.x, p.y, -p.z);
    };
    CHECK(glm::length(in_file(0) - glm::dvec3(388095.350, 3948995.700, 40.200)) < 1e-8);
    CHECK(glm::length(in_file(1) - glm::dvec3(388095.352, 3948995.700, 40.200)) < 1e-8);
    CHECK(has_warning(loaded.report,
                      "too far from their origin for the precision of float; the scene is moved by (-388"));
    // A vertex that no face uses has no say.
    const LoadedObj unused = load_text(
        "v 0 0 0\nv 388095.350 3948995.700 0\nv 388095.352 3948995.700 0\nv 388095.350 3948995.702 0\nf 2 3 "
        "4\n");
    CHECK(unused.scene.origin != glm::dvec3(0));
    // What is not so far away stays where it is, and a shift by a power of two changes nothing at all.
    CHECK(load_text("v 100 0 0\nv 101 0 0\nv 100 1 0\nf 1 2 3\n").scene.origin == glm::dvec3(0));
    const std::string near = "v 0 0 0\nv 1.5 0 0\nv 0 1.25 0\nf 1 2 3\n";
    const LoadedObj far =
        load_text("v 1048576 -2097152 0\nv 1048577.5 -2097152 0\nv 1048576 -2097150.75 0\nf 1 2 3\n");
    CHECK(far.scene.origin != glm::dvec3(0));
    const glm::vec3 moved = mesh_of(far).positions[0];
    for (std::size_t i = 0; i < 3; ++i)
        CHECK(mesh_of(far).positions[i] - moved == mesh_of(load_text(near)).positions[i]);
}

TEST_CASE("text of every encoding and habit gives the same triangle") {
    const std::string plain = "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
    std::string utf16 = "\xFF\xFE";
    for (const char c : plain) utf16 += std::string{c, '\0'};
    const std::vector<glm::vec3> wanted = mesh_of(load_text(plain)).positions;
    CHECK(mesh_of(load_text(utf16)).positions == wanted);
    CHECK(mesh_of(load_text("V 0 0 0\nV 1 0 0\nV 0 1 0\nF 1 2 3\n")).positions == wanted);
    const ScratchDirectory scratch;
    write_text(scratch / "a.obj", "v 0, 0, 0\nv 1, 0, 0\nv 0, 1, 0\nf 1 2 3\n");
    CHECK(error_of(scratch / "a.obj").find("a.obj:1: this is not a number (0,); write blanks between") !=
          std::string::npos);
}
