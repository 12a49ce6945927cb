#include "chapters/notebook/translation.h"

#include <doctest/doctest.h>

#include "chapters/notebook/svg.h"
#include "rasterizer/base/error.h"

using namespace crevice;

TEST_CASE("translation: cells with their hash, texts by their English") {
    const Translation chinese = translation_from(
        "<!-- cell why 0123abcd -->\n\n为什么\n\n第二段\n\n<!-- text A larger epsilon -->\n更大的 epsilon\n",
        "zh.md");
    REQUIRE(chinese.cells.contains("why"));
    CHECK(chinese.cells.at("why").hash == "0123abcd");
    CHECK(chinese.cells.at("why").chinese == "为什么\n\n第二段");
    CHECK(chinese.texts.at("A larger epsilon") == "更大的 epsilon");
    CHECK_THROWS_WITH_AS(translation_from("\ntext\n", "zh.md"),
                         "zh.md:2: text before the first heading; begin with <!-- cell NAME HASH -->",
                         UsageError);
    CHECK_THROWS_AS(translation_from("<!-- cell why -->\n", "zh.md"), UsageError);
    CHECK(chinese_lines_joined("一行\n二行，\n`code`\n三\n\n四\n- 五") ==
          "一行二行，\n`code`\n三\n\n四\n- 五");
    CHECK(text_hash("") == "811c9dc5");
    CHECK(text_hash("a") == "e40c292c");
}

TEST_CASE("svg: words are replaced, and a picture that stands alone has the light colours") {
    const std::string svg =
        "<svg><text fill=\"var(--ink, #111)\">a &lt; b</text><text>n<tspan>1</tspan></text></svg>";
    CHECK(standalone_svg(svg).find("fill=\"#111\"") != std::string::npos);
    const std::string changed =
        with_words(svg, [](const std::string& words) { return words == "a < b" ? "甲 < 乙" : words; });
    CHECK(changed.find(">甲 &lt; 乙</text>") != std::string::npos);
    CHECK(changed.find("n<tspan>1</tspan>") != std::string::npos);
}
