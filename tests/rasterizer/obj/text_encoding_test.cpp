#include "rasterizer/obj/text_encoding.h"

#include <doctest/doctest.h>

#include "rasterizer/base/error.h"

using namespace crevice;
using namespace std::string_literals;

TEST_CASE("utf8_text: each encoding comes out as UTF-8") {
    CHECK(utf8_text("v 1", "a.obj") == "v 1");
    CHECK(utf8_text("\xEF\xBB\xBFv 1", "a.obj") == "v 1");
    CHECK(utf8_text("caf\xe9", "a.obj") == "caf\xe9");  // Latin-1
    CHECK(utf8_text("\xFF\xFEv\0 \0"
                    "1\0"s,
                    "a.obj") == "v 1");
    CHECK(utf8_text("\xFE\xFF\0v\0 \0"
                    "1"s,
                    "a.obj") == "v 1");
    // U+00E9, U+6728, U+1F600 as a pair, and one half of a pair.
    CHECK(utf8_text("\xFF\xFE\xE9\0\x28\x67\x3D\xD8\x00\xDE\x3D\xD8x\0"s, "a.obj") ==
          "\xC3\xA9\xE6\x9C\xA8\xF0\x9F\x98\x80\xEF\xBF\xBDx");
    CHECK(utf8_text("v\0 \0"
                    "1\0 \0"
                    "2\0"s,
                    "a.obj") == "v 1 2");
    CHECK(utf8_text("\0v\0 \0"
                    "1\0 \0"
                    "2"s,
                    "a.obj") == "v 1 2");
    // A comment of letters outside Latin-1 before the first statement, in both byte orders.
    std::string little, big;
    for (const char16_t c : std::u16string(u"# \u0434\u043e\u043c \u6728 \u00fc\u0142\nv 1 2 3\nv 4 5 6\n")) {
        little += std::string{static_cast<char>(c & 255), static_cast<char>(c >> 8)};
        big += std::string{static_cast<char>(c >> 8), static_cast<char>(c & 255)};
    }
    const std::string house = "# \xD0\xB4\xD0\xBE\xD0\xBC \xE6\x9C\xA8 \xC3\xBC\xC5\x82\nv 1 2 3\nv 4 5 6\n";
    CHECK(utf8_text(little, "a.obj") == house);
    CHECK(utf8_text(big, "a.obj") == house);
    const std::string padded = "v 0 0 0" + std::string(25, '\0');
    CHECK(utf8_text(padded, "a.obj") == padded);
    CHECK(utf8_text("v 0 0 0\0\n"s, "a.obj") == "v 0 0 0\0\n"s);  // a NUL alone does not make it UTF-16
}

TEST_CASE("utf8_text: what cannot be read is named") {
    CHECK_THROWS_WITH_AS(utf8_text("\xFF\xFEv\0x"s, "a.obj"),
                         doctest::Contains("a.obj: the text is UTF-16 cut short"), InputError);
    CHECK_THROWS_WITH_AS(utf8_text("v\0 \0001\0 \0x"s, "a.obj"),
                         doctest::Contains("a.obj: the text is UTF-16 cut short"), InputError);
    CHECK_THROWS_WITH_AS(utf8_text("\xFF\xFE\0\0v\0\0\0"s, "a.obj"), doctest::Contains("UTF-32"), InputError);
}
