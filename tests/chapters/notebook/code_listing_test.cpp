#include "chapters/notebook/code_listing.h"

#include <doctest/doctest.h>

#include "chapters/notebook/embedded_files.h"
#include "rasterizer/base/error.h"

using namespace crevice;

namespace {

constexpr const char* kSource =
    "float half(float x);\n"
    "\n"
    "// Calls half(1) and says \"half {\".\n"
    "struct User {\n"
    "    float y = half(1);\n"
    "    // The half of it:\n"
    "    // no more.\n"
    "    template <class F>\n"
    "    F half(F x) const {\n"
    "        const char* text = \"}\";\n"
    "        return x / 2;\n"
    "    }\n"
    "    User(float x) : y(x) {}\n"
    "};\n"
    "enum class Kind { one, two };\n";

}  // namespace

TEST_CASE("listing: the definition with its comment, not a call, a declaration or a word in a string") {
    const CodeListing listing = code_listing(kSource, "a.h", "half");
    CHECK(listing.first_line == 6);
    CHECK(listing.code ==
          "// The half of it:\n// no more.\ntemplate <class F>\nF half(F x) const {\n    const char* text = "
          "\"}\";\n"
          "    return x / 2;\n}\n");
    CHECK(code_listing(kSource, "a.h", "User").code.starts_with("// Calls half(1)"));
    CHECK(code_listing(kSource, "a.h", "User").code.ends_with("};\n") == true);
    CHECK(code_listing(kSource, "a.h", "Kind").first_line == 15);
    CHECK_THROWS_WITH_AS(code_listing(kSource, "a.h", "third"),
                         "a.h: nothing of this name is defined there (third); name one that is", UsageError);
}

TEST_CASE("listing: a part of it keeps its line numbers") {
    const CodeListing part = part_of(code_listing(kSource, "a.h", "half"), "const char", "return");
    CHECK(part.first_line == 10);
    CHECK(part.code == "const char* text = \"}\";\nreturn x / 2;\n");
    CHECK_THROWS_AS(part_of(code_listing(kSource, "a.h", "half"), "nowhere", "return"), UsageError);
}

TEST_CASE("listing: the repository's own files are part of the program") {
    const auto file = embedded_file("ssao/methods/luna_occlusion.h");
    REQUIRE(file);
    CHECK(code_listing(*file, "ssao/methods/luna_occlusion.h", "sample").code.find("return contribution(") !=
          std::string::npos);
    CHECK(!embedded_file("ssao/methods/nowhere.h"));
}
