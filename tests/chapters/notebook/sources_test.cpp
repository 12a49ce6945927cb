#include "chapters/notebook/sources.h"

#include <fstream>
#include <iterator>

#include <doctest/doctest.h>

#include "chapters/notebook/book_index.h"
#include "chapters/notebook/markdown.h"

using namespace crevice;

TEST_CASE("the table of sources stands in the README, and at the head of the book") {
    std::ifstream file(CREVICE_GOLDEN_DIR "/../../README.md");
    const std::string readme{std::istreambuf_iterator<char>(file), {}};
    CHECK(readme.find(sources_table()) != std::string::npos);

    const std::string page = book_index({{"01_first", {"First", "第一章"}, 0}}, BookLanguage::en);
    CHECK(page.find(html_from_markdown(sources_table())) != std::string::npos);
    CHECK(page.find("<h1>Crevice: ambient occlusion") != std::string::npos);
    CHECK(page.find("<span class=\"zh\" lang=\"zh\">第一章</span>") != std::string::npos);
    CHECK(page.find("data-set-lang=\"zh\"") != std::string::npos);
    CHECK(page.find("<a href=\"https://www.cnblogs.com/wickedpriest/p/13219981.html\">") !=
          std::string::npos);
}
