#include "rasterizer/obj/obj_prescan.h"

#include <doctest/doctest.h>
#include <sys/stat.h>

#include "rasterizer/base/memory.h"
#include "tests/tools/loaded_obj.h"

using namespace crevice;
using namespace std::string_literals;
namespace fs = std::filesystem;

TEST_CASE("load_obj: text that is not what it should be is an InputError with its line, value and advice") {
    struct Row {
        std::string what, lines;  // after the four corners, from line 5
        int line;
        std::string fragment;
    };
    const std::vector<Row> rows = {
        {"index wraps 32 bits", "f 1 2 4294967297\n", 5, "too large (4294967297)"},
        {"index far too long", "f 1 2 9999999999999999999999\n", 5, "too large (9999999999999999999999)"},
        {"negative index too long", "f 1 2 -9999999999\n", 5, "too large (-9999999999)"},
        {"texture index too long", "f 1 2 3/4294967297\n", 5, "too large (3/4294967297)"},
        {"fraction as an index", "\nf 1.5 2 3\n", 6, "not a whole index (1.5)"},
        {"letters as indices", "f a b c\n", 5, "not a whole index (a)"},
        {"index zero", "f 1 2 3\nf 0 2 3\n", 6, "zero (0); OBJ counts from 1"},
        {"texture index zero", "f 1/0 2 3\n", 5, "zero (1/0)"},
        {"normal index zero", "f 1//0 2 3\n", 5, "zero (1//0)"},
        {"four indices", "f 1/1/1/1 2 3\n", 5, "more than three indices (1/1/1/1)"},
        {"corner without vertex", "f /1 2 3\n", 5, "not a whole index (/1)"},
        {"hexadecimal", "v 0x10 0 0\n", 5, "not a number (0x10)"},
        {"half an exponent", "v 1e 0 0\n", 5, "not a number (1e)"},
        {"decimal comma", "v 1,5 0 0\n", 5, "not a number (1,5); write it with a decimal point"},
        {"trailing letters", "v 12x 0 0\n", 5, "not a number (12x)"},
        {"two signs", "v +-1 0 0\n", 5, "not a number (+-1)"},
        {"missing z", "v 1 2\n", 5, "wrong count of numbers (2); give 3 to 7"},
        {"too many numbers", "v 1 2 3 4 5 6 7 8\n", 5, "wrong count of numbers (8)"},
        {"half a normal", "vn 0 1\n", 5, "`vn` has the wrong count of numbers (2); give 3"},
        {"empty texture coordinate", "vt\n", 5, "`vt` has the wrong count of numbers (0)"},
        {"comma in a normal", "vn 0 0 1,0\n", 5, "not a number (1,0)"},
        {"text behind a NUL", "v 0 0 0\0junk\n"s, 5, "not a number (junk)"},
        {"line number across a continuation", "f 1 2 \\\n 3\nf 1 2 x\n", 7, "not a whole index (x)"},
    };
    const ScratchDirectory scratch;
    for (const Row& row : rows) {
        CAPTURE(row.what);
        write_text(scratch / "a.obj", kCorners + row.lines);
        const std::string error = error_of(scratch / "a.obj");
        CAPTURE(error);
        CHECK(error.find("a.obj:" + std::to_string(row.line) + ": ") != std::string::npos);
        CHECK(error.find(row.fragment) != std::string::npos);
        CHECK(error.find("; ") != std::string::npos);
    }
}

TEST_CASE("load_obj: what is no OBJ file is an InputError") {
    const ScratchDirectory scratch;
    SUBCASE("missing") {
        CHECK(error_of(scratch / "a.obj").find("a.obj: there is no such file") != std::string::npos);
    }
    SUBCASE("directory") { CHECK(error_of(scratch.path()).find("is a directory") != std::string::npos); }
    SUBCASE("pipe") {
        REQUIRE(mkfifo((scratch / "a.obj").c_str(), 0600) == 0);
        CHECK(error_of(scratch / "a.obj").find("not a regular file") != std::string::npos);
    }
    SUBCASE("empty") {
        write_text(scratch / "a.obj", "");
        CHECK(error_of(scratch / "a.obj").find("the file is empty") != std::string::npos);
    }
    SUBCASE("a byte order mark and nothing else") {
        write_text(scratch / "a.obj", "\xEF\xBB\xBF");
        CHECK(error_of(scratch / "a.obj").find("not an OBJ") != std::string::npos);
    }
    SUBCASE("another kind of text") {
        write_text(scratch / "a.obj", "ply\nformat ascii 1.0\nelement vertex 8\nend_header\n0 0 0\n");
        CHECK(error_of(scratch / "a.obj").find("not an OBJ (no `v` and no `f` line in 5 lines)") !=
              std::string::npos);
    }
    SUBCASE("a binary") {
        std::string bytes;
        for (int i = 0; i < 4096; ++i) bytes.push_back(static_cast<char>(i * i >> 3));
        write_text(scratch / "a.obj", bytes);
        CHECK(error_of(scratch / "a.obj").find("a.obj") != std::string::npos);
        CHECK(error_of(scratch / "a.obj").find("; ") != std::string::npos);
    }
    SUBCASE("faces and no vertices") {
        write_text(scratch / "a.obj", "f 1 2 3\nf 1 2 3\n");
        CHECK(error_of(scratch / "a.obj").find("faces and no vertices") != std::string::npos);
    }
    SUBCASE("too large for 32-bit indices") {
        write_text(scratch / "a.obj", "v 0 0 0\n");
        fs::resize_file(scratch / "a.obj", kMaxObjBytes + 1);  // sparse: takes no room
        CHECK(error_of(scratch / "a.obj").find("too large (4294967297 bytes") != std::string::npos);
    }
    SUBCASE("too large for the memory, which is seen before it is read") {
        const std::uintmax_t bytes = memory_bytes() / 8 + 1;
        if (bytes > kMaxObjBytes) return;
        write_text(scratch / "a.obj", "v 0 0 0\n");
        fs::resize_file(scratch / "a.obj", bytes);
        CHECK(error_of(scratch / "a.obj").find("too large for this machine's memory") != std::string::npos);
    }
}

TEST_CASE("load_obj: odd but right text is read as it is meant") {
    struct Row {
        std::string what, text;
    };
    const std::vector<Row> rows = {
        {"plain", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"},
        {"byte order mark", "\xEF\xBB\xBFv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"},
        {"CRLF", "v 0 0 0\r\nv 1 0 0\r\nv 0 1 0\r\nf 1 2 3\r\n"},
        {"CR only", "v 0 0 0\rv 1 0 0\rv 0 1 0\rf 1 2 3\r"},
        {"no final newline", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3"},
        {"face before its vertices", "f 1 2 3\nv 0 0 0\nv 1 0 0\nv 0 1 0\n"},
        {"continued lines", "v 0 0 0\nv 1 \\\n0 \\\r\n 0\nv 0 1 0\nf 1 \\\n 2 3\n"},
        {"continued to the end of the file", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\\"},
        {"a comment that ends in a backslash", "# C:\\models\\\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"},
        {"a path behind a number", "v 0 0 0 # C:\\models\\\nv 1 0 0\nv 0 1 0\nf 1 2 3 # \\\n"},
        {"comments behind numbers", "v 0 0 0 # a\nv 1 0 0 #b\nv 0 1 0\nf 1 2 3 # c 4\n"},
        {"tabs, blanks, indents", " v\t0  0 0 \n\tv 1 0\t0\nv 0 1 0\n  f  1\t2 3 \n"},
        {"a NUL for a blank", "v 0 0 0\0\nv 1 0 0\nv\0 0 1 0\nf 1 2\0 3\n"s},
        {"negative indices", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -2 -1\nv 9 9 9\n"},
        {"plus signs", "v +0 0 0\nv +1 0 0\nv 0 1 0\nf +1 +2 3\n"},
        {"empty last fields", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1/ 2// 3//\n"},
        {"weights and colours", "v 0 0 0 1\nv 1 0 0 .5 .5 .5\nv 0 1 0 1 1 1 1\nf 1 2 3\n"},
        {"every way to write a number", "v 0e999 -0 0.\nv 1e0 .0 1e-999\nv 0 100E-2 -1e-400\nf 1 2 3\n"},
        {"names and groups", "o a b\ng x y\ns off\nmg 1 2\nv 0 0 0\nv 1 0 0\nv 0 1 0\ns 1\nf 1 2 3\n"},
    };
    for (const Row& row : rows) {
        CAPTURE(row.what);
        const LoadedObj loaded = load_text(row.text);
        check_whole(loaded);
        CHECK(loaded.report.warnings == std::vector<std::string>{});
        const Mesh& mesh = mesh_of(loaded);
        REQUIRE(mesh.triangles.size() == 1);
        CHECK(mesh.positions == std::vector<glm::vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
        CHECK(mesh.triangles[0] == std::array<std::uint32_t, 3>{0, 2, 1});
    }
}

TEST_CASE("load_obj: numbers are the nearest floats") {
    const Mesh mesh =
        mesh_of(load_text("v 0.1 0.3333333333333333 16777217\nv 1.00000017881393432617187499 1e-45 "
                          "3.4028235e38\nv 0 1 0\nf 1 2 3\n"));
    CHECK(mesh.positions[0] == glm::vec3(0.1f, 1.0f / 3, -16777216.0f));
    CHECK(mesh.positions[1] == glm::vec3(0x1.000002p0f, 0x1p-149f, -0x1.fffffep127f));
}
