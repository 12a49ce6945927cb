// A file with one fault a thousand times is told of it in a few lines, and of its other faults all the same.
#include "rasterizer/obj/alike_warnings.h"

#include <doctest/doctest.h>

#include "tests/tools/loaded_obj.h"

using namespace crevice;

namespace {

std::string faces_of_materials(int count) {
    std::string text = "mtllib a.mtl\n";
    text += kCorners;
    for (int i = 0; i < count; ++i) text += "usemtl m" + std::to_string(i) + "\nf 1 2 3\n";
    return text;
}

}  // namespace

TEST_CASE("few_of_each_kind: the first are kept, the others counted where they begin") {
    std::vector<std::string> warnings = {"a.obj: the coordinates lie too far"};
    for (int i = 1; i <= 20; ++i) {
        const std::string n = std::to_string(i);
        warnings.push_back("a.mtl:" + n + ": material `m" + n + "` has a Kd outside [0, 1] (" + n +
                           " 2 2); as 1");
        warnings.push_back("a.mtl:" + n + ": `Kd` has a number that is none (" + n + "); passed over");
    }
    const std::vector<std::string> few = few_of_each_kind(warnings);
    REQUIRE(few.size() == 1 + 2 * (kMostAlike + 1));
    CHECK(few[0] == warnings[0]);
    for (std::size_t i = 1; i <= 2 * kMostAlike; ++i) CHECK(few[i] == warnings[i]);
    CHECK(few[2 * kMostAlike + 1] ==
          "a.mtl:9: and 12 more of this kind, the first of them here: material `m9` has a Kd outside [0, 1] "
          "(9 2 2); "
          "as 1");
    CHECK(few[2 * kMostAlike + 2] ==
          "a.mtl:9: and 12 more of this kind, the first of them here: `Kd` has a number that is none (9); "
          "passed over");
}

TEST_CASE("few_of_each_kind: what fits is said in full, keywords are kinds of their own") {
    std::vector<std::string> warnings;
    for (std::size_t i = 0; i <= kMostAlike; ++i) warnings.push_back("a.mtl:1: no such texture (t.png)");
    CHECK(few_of_each_kind(warnings) == warnings);
    warnings.clear();
    for (char c = 'a'; c <= 'z'; ++c)
        warnings.push_back("a.mtl:1: `" + std::string(1, c) + "` is not drawn here");
    CHECK(few_of_each_kind(warnings) == warnings);
    CHECK(few_of_each_kind({}).empty());
}

TEST_CASE("load_obj: a flood of one fault is a few lines") {
    constexpr int kCount = 500;
    struct Row {
        std::string what, of_each_material, fragment;
    };
    const std::vector<Row> rows = {
        {"unknown materials", "",
         "and 492 more of this kind, the first of them here: no library has the material (m8)"},
        {"missing textures", "Kd 1 1 1\nmap_Kd t#.png\n", "and 492 more"},
        {"decimal commas", "Kd 0,8 0,8 0,8\n", "and 492 more"},
        {"reflectances above 1", "Kd 2 2 2\n", "and 492 more"},
        {"the same name again", "Kd 1 1 1\nnewmtl m0\n", "and 492 more"},
    };
    for (const Row& row : rows) {
        CAPTURE(row.what);
        std::string mtl;
        for (int i = 0; i < kCount && !row.of_each_material.empty(); ++i) {
            std::string text = row.of_each_material;
            if (const std::size_t at = text.find('#'); at != std::string::npos)
                text.replace(at, 1, std::to_string(i));
            mtl += "newmtl m" + std::to_string(i) + "\n" + text;
        }
        const ScratchDirectory scratch;
        write_text(scratch / "a.mtl", mtl);
        write_text(scratch / "a.obj", faces_of_materials(kCount));
        const LoadedObj loaded = load_obj(scratch / "a.obj");
        CHECK(loaded.report.warnings.size() <= kMostAlike + 3);
        CHECK(has_warning(loaded.report, row.fragment));
    }
    // Statements that nobody knows, each of its own name.
    std::string junk;
    for (int i = 0; i < kCount; ++i) {
        const std::string n = std::to_string(i);
        junk += "newmtl m" + n + "\nKd 1 1 1\nword" + n + " 1\n";
    }
    const ScratchDirectory scratch;
    write_text(scratch / "a.mtl", junk);
    write_text(scratch / "a.obj", faces_of_materials(kCount));
    const LoadedObj of_another_kind = load_obj(scratch / "a.obj");
    CHECK(of_another_kind.report.warnings.size() == 33);
    CHECK(
        has_warning(of_another_kind.report,
                    "a.mtl:99: more statements are not drawn here (468 lines, the first here); passed over"));
    std::string libraries;
    for (int i = 0; i < kCount; ++i) libraries += "mtllib m" + std::to_string(i) + ".mtl\n";
    const LoadedObj loaded = load_text(libraries + kCorners + "usemtl m\nf 1 2 3\n");
    CHECK(loaded.report.warnings.size() == kMostAlike + 2);
    CHECK(has_warning(loaded.report, "a.obj:9: and 492 more of this kind"));
}
