// Names that are nearly right.
#include "rasterizer/base/no_such.h"

#include <doctest/doctest.h>

using namespace crevice;

TEST_CASE("the nearest name: one slip for every three letters") {
    const std::vector<std::string> known = {"columns", "columns_luna", "room", "gtao", "sao"};
    CHECK(nearest_name("colums", known) == "columns");    // one left out
    CHECK(nearest_name("collumns", known) == "columns");  // one added
    CHECK(nearest_name("colunms", known) == "columns");   // two exchanged
    CHECK(nearest_name("gtoa", known) == "gtao");
    CHECK(nearest_name("roof", known) == "room");
    CHECK(nearest_name("gto", known) == "gtao");
    CHECK(nearest_name("bunny", known) == "");
    CHECK(nearest_name("", known) == "");
    CHECK(nearest_name(std::string(1000, 'x'), known) == "");
    CHECK(nearest_name("room", {}) == "");
}

TEST_CASE("a name that is not known is refused with the nearest, or with all there are") {
    CHECK(std::string(no_such("--ao", "method", "gtoa", {"gtao", "sao"}).what()) ==
          "--ao: there is no such method (gtoa); did you mean gtao? There are gtao, sao");
    CHECK(std::string(no_such("--ao", "method", "path", {"gtao", "sao"}).what()) ==
          "--ao: there is no such method (path); give one of gtao, sao");
}
