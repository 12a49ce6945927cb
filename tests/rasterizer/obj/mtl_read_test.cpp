#include "rasterizer/obj/mtl_read.h"

#include <algorithm>
#include <string>

#include <doctest/doctest.h>

#include "tests/tools/error_message.h"

using namespace crevice;
using namespace std::string_literals;

namespace {

MtlMaterial only(const std::string& text) {
    const MtlFile file = read_mtl(text, "a.mtl");
    REQUIRE(file.materials.size() == 1);
    CHECK(file.warnings == std::vector<std::string>{});
    return file.materials[0];
}

bool said(const std::vector<std::string>& warnings, const std::string& fragment) {
    return std::any_of(warnings.begin(), warnings.end(),
                       [&](const std::string& w) { return w.find(fragment) != std::string::npos; });
}

std::string utf16(const std::string& ascii, bool big) {
    std::string bytes;
    for (const char c : ascii) bytes += big ? std::string{'\0', c} : std::string{c, '\0'};
    return bytes;
}

}  // namespace

TEST_CASE("read_mtl: one material however it is written") {
    struct Row {
        std::string what, text;
    };
    const std::vector<Row> rows = {
        {"plain", "newmtl paint\nKd 1 .5 .25\n"},
        {"CRLF and no final newline", "newmtl paint\r\nKd 1 .5 .25"},
        {"CR", "newmtl paint\rKd 1 .5 .25\r"},
        {"small letters", "newmtl paint\nkd 1 .5 .25\n"},
        {"capitals", "NEWMTL paint\nKD 1 .5 .25\n"},
        {"blanks and tabs", "  newmtl \t paint \t\n\tKd\t1  .5 .25 \n"},
        {"comments", "# made by hand\nnewmtl paint # the red one\nKd 1 .5 .25 # pure\n"},
        {"continued lines", "newmtl paint\nKd 1 \\\n .5 .25\n"},
        {"a comment that ends in a backslash", "newmtl paint\n# a\\\nKd 1 .5 .25\n"},
        {"a path behind a number", "newmtl paint # in C:\\art\\\nKd 1 .5 .25 # in C:\\art\\\n"},
        {"a comment behind a continuation", "newmtl paint\nKd 1 \\\n .5 .25 # C:\\\nNs 1\n"},
        {"a byte order mark", "\xEF\xBB\xBFnewmtl paint\nKd 1 .5 .25\n"},
        {"UTF-16, little end first", "\xFF\xFE"s + utf16("newmtl paint\nKd 1 .5 .25\n", false)},
        {"UTF-16, big end first", "\xFE\xFF"s + utf16("newmtl paint\nKd 1 .5 .25\n", true)},
        {"UTF-16 without a mark", utf16("newmtl paint\nKd 1 .5 .25\n", false)},
        {"the last statement counts", "newmtl paint\nKd 0 0 0\nKd 1 .5 .25\n"},
    };
    for (const Row& row : rows) {
        CAPTURE(row.what);
        const MtlMaterial m = only(row.text);
        CHECK(m.name == "paint");
        CHECK(m.diffuse == glm::vec3(1, 0.5f, 0.25f));
        CHECK(m.warnings == std::vector<std::string>{});
    }
}

TEST_CASE("read_mtl: a material has only what is its own") {
    const MtlFile file =
        read_mtl("newmtl a\nKd 1 0 0\nKs 1 1 1\nNs 90\nd .5\nmap_Kd a.png\nnewmtl b\n", "a.mtl");
    REQUIRE(file.materials.size() == 2);
    const MtlMaterial& b = file.materials[1];
    CHECK(b.line == 7);
    CHECK_FALSE((b.diffuse || b.ambient || b.specular || b.shininess || b.opacity || b.transparency));
    CHECK(b.diffuse_map.file.empty());
}

TEST_CASE("read_mtl: what stands behind the numbers of a statement is said, and the numbers are used") {
    for (const std::string rest : {"junk", "1", "0,5", "{"}) {
        CAPTURE(rest);
        const MtlMaterial m = only("newmtl a\nKd 1 .5 .25 " + rest + "\nks 1 1 0 " + rest + "\nNs 9 " + rest +
                                   "\nd .5 " + rest + "\n");
        CHECK(m.diffuse == glm::vec3(1, 0.5f, 0.25f));
        CHECK(m.specular == glm::vec3(1, 1, 0));
        CHECK(m.shininess == 9.0f);
        CHECK(m.opacity == 0.5f);
        REQUIRE(m.warnings.size() == 4);
        CHECK(contains(m.warnings[0], ":2: `Kd` goes on behind its numbers (" + rest + ")"));
        CHECK(contains(m.warnings[3], ":5: `d` goes on behind its numbers (" + rest + ")"));
    }
}

TEST_CASE("read_mtl: one number is grey; other counts and what is no number are said with their line") {
    CHECK(only("newmtl a\nKd .5\n").diffuse == glm::vec3(0.5f));
    struct Row {
        std::string line, warning;
    };
    const std::vector<Row> rows = {
        {"Kd 0,8 0,4 0,2", "`Kd` has a number that is none (0,8); write it with a decimal point"},
        {"Kd 0.8, 0.4, 0.2", "(0.8,); write blanks between numbers"},
        {"Kd 0x1 0 0", "(0x1); write it in decimal"},
        {"Kd 1 0", "`Kd` has the wrong count of numbers (2); give 3, or 1 for grey"},
        {"Kd", "wrong count of numbers (0)"},
        {"Kd xyz .4 .2 .1", "`Kd xyz` is not read here; give red, green and blue"},
        {"Kd spectral red.rfl 1", "`Kd spectral` is not read here"},
        {"Ns", "`Ns` has the wrong count of numbers (0); give 1"},
        {"d half", "`d` has a number that is none (half)"},
    };
    for (const Row& row : rows) {
        CAPTURE(row.line);
        const MtlMaterial m = only("newmtl a\n" + row.line + "\n");
        REQUIRE(m.warnings.size() == 1);
        CAPTURE(m.warnings[0]);
        CHECK(m.warnings[0].find("a.mtl:2: ") == 0);
        CHECK(said(m.warnings, row.warning));
        CHECK_FALSE((m.diffuse || m.shininess || m.opacity));
    }
}

TEST_CASE("read_mtl: opacity, in each of its ways") {
    CHECK(only("newmtl a\nd .5\n").opacity == 0.5f);
    CHECK(only("newmtl a\nd -halo .5\n").opacity == 0.5f);
    CHECK(only("newmtl a\nTr .25\n").transparency == 0.25f);
    CHECK(only("newmtl a\nd -halo .5\n").notes.at(0).what == "`-halo` is not drawn here");
}

TEST_CASE("read_mtl: what means something and is not drawn is noted, what changes nothing is not") {
    const MtlMaterial m = only(
        "newmtl a\nillum 2\nNi 1.5\nTf 1 1 1\nsharpness 60\nKe 0 0 0\nKe 1 0 0\nPr .5\nmap_Ns gloss.png\n"
        "refl -type sphere sky.png\n");
    REQUIRE(m.notes.size() == 4);
    CHECK(m.notes[0].what == "`Ke` is not drawn here");
    CHECK(m.notes[0].line == 7);
    CHECK(m.notes[1].what == "`Pr` is not drawn here");
    CHECK(m.notes[2].what == "`map_Ns` is not drawn here");
    CHECK(m.notes[3].what == "`refl` is not drawn here");
}

TEST_CASE("read_mtl: names") {
    const MtlMaterial numbered = only("newmtl Material #25\n");
    CHECK(numbered.name == "Material");
    CHECK(numbered.whole_name == "Material #25");
    CHECK(only("newmtl a#1\n").name == "a#1");
    CHECK(only("newmtl red paint  \n").name == "red paint");
    CHECK(only("newmtl \"red paint\" # oil\n").name == "red paint");
    CHECK(said(read_mtl("newmtl # none\n", "a.mtl").warnings, "a.mtl:1: `newmtl` without a name"));
    const MtlFile early = read_mtl("Kd 1 0 0\nKs 1 1 1\nnewmtl a\n", "a.mtl");
    REQUIRE(early.warnings.size() == 1);
    CHECK(said(early.warnings, "a.mtl:1: `Kd` stands before the first `newmtl`"));
    CHECK(read_mtl("", "a.mtl").materials.empty());
}

TEST_CASE("read_mtl: a file of another kind is not retold line by line") {
    std::string text = "newmtl a\n";
    for (int i = 0; i < 1000; ++i) text += "Kd x" + std::to_string(i) + "\nword" + std::to_string(i) + " 1\n";
    const MtlMaterial m = only(text);
    CHECK(m.warnings.size() == 8);
    CHECK(m.notes.back().what == "`others` is not drawn here");
    CHECK(m.notes.back().line == 2001);
}
