#include "chapters/notebook/sources.h"

#include <fstream>
#include <iterator>

#include <doctest/doctest.h>

#include "chapters/notebook/html.h"
#include "chapters/notebook/markdown.h"
#include "chapters/notebook/notebook_page.h"

using namespace crevice;

TEST_CASE("the table of sources stands in the README, and at the head of the book") {
    std::ifstream file(CREVICE_GOLDEN_DIR "/../../README.md");
    const std::string readme{std::istreambuf_iterator<char>(file), {}};
    CHECK(readme.find(sources_table()) != std::string::npos);

    const std::string page = notebook_page({{"01_first", "First", "<h1>First</h1>", 0}});
    const std::size_t table = page.find(html_from_markdown(sources_table()));
    CHECK(table != std::string::npos);
    CHECK(table < page.find("<h1>First</h1>"));
    CHECK(page.find("<a href=\"https://www.cnblogs.com/wickedpriest/p/13219981.html\">") !=
          std::string::npos);
}
