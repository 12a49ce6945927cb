#include "chapters/props/error_walk.h"

#include <set>

#include <doctest/doctest.h>

using namespace crevice;

namespace {

// The steps of a study's chain, each of the same RMSE.
ErrorParts parts_of(double rmse) {
    ErrorParts parts;
    for (const char* step : {"depth buffer", "definition", "half size", "sampling", "rounding", "float16",
                             "blur, bias", "blur, noise removed"}) {
        parts.parts.push_back({step, 0.25, rmse * rmse, rmse, 0.5, Image<float>({2, 1}, 0.1f)});
    }
    parts.total = {"", 2, 0, 0, 4, Image<float>({2, 1}, 0.8f)};
    return parts;
}

}  // namespace

TEST_CASE(
    "error walk: every step has a picture and a caption of its own; of what is not seen there is none") {
    const std::vector<Notebook::Named> pictures = part_pictures(parts_of(0.01));
    REQUIRE(pictures.size() == 8);
    std::set<std::string> names, captions;
    for (const Notebook::Named& named : pictures) {
        INFO(named.name);
        CHECK(named.name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789_") == named.name.npos);
        names.insert(named.name);
        captions.insert(named.caption);
    }
    CHECK(names.size() == pictures.size());
    CHECK(captions.size() == pictures.size());
    CHECK(part_pictures(parts_of(0.001)).empty());
}

TEST_CASE("error walk: a row a step and one of the whole; parts that do not add up are seen") {
    ErrorParts parts = parts_of(0.01);
    CHECK(parts_add_up(parts));
    const auto rows = part_rows(parts);
    REQUIRE(rows.size() == 9);
    CHECK(rows.front() == std::vector<std::string>{"depth buffer", "0.25000", "0.0100", "500000.0"});
    CHECK(rows.back() == std::vector<std::string>{"all of it", "2.00000", "0.0000", "4000000.0"});
    parts.total.share += 1e-6;
    CHECK_FALSE(parts_add_up(parts));
    CHECK(error_steps(parts, "the way").find(">the way</text>") != std::string::npos);
}
