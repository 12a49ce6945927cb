#include <doctest/doctest.h>

#include <string>

#include "ssao/bakes/shelf_packing.h"
#include "tests/tools/ray_checks.h"

using namespace crevice;

TEST_CASE("shelf packing: within the square, apart by the gap") {
    RandomNumbers random(3);
    for (const int gap : {0, 2, 5}) {
        std::vector<Size> sizes;
        for (int i = 0; i < 60; ++i)
            sizes.push_back(
                {static_cast<int>(random.between(1, 40)), static_cast<int>(random.between(1, 25))});
        const auto corners = pack_shelves(sizes, 256, gap);
        CAPTURE(gap);
        REQUIRE(corners.has_value());
        for (std::size_t i = 0; i < sizes.size(); ++i) {
            const glm::ivec2 a = (*corners)[i];
            CAPTURE(i);
            CHECK(a.x >= 0);
            CHECK(a.y >= 0);
            CHECK(a.x + sizes[i].width <= 256);
            CHECK(a.y + sizes[i].height <= 256);
            for (std::size_t k = 0; k < i; ++k) {
                const glm::ivec2 b = (*corners)[k];
                const bool apart = a.x >= b.x + sizes[k].width + gap || b.x >= a.x + sizes[i].width + gap ||
                                   a.y >= b.y + sizes[k].height + gap || b.y >= a.y + sizes[i].height + gap;
                CAPTURE(k);
                CHECK(apart);
            }
        }
    }
}

TEST_CASE("shelf packing: what just fits, and what does not") {
    const std::vector<Size> four(4, Size{4, 4});
    CHECK(pack_shelves(four, 8, 0).has_value());
    CHECK(!pack_shelves(four, 8, 1).has_value());
    CHECK(pack_shelves(four, 9, 1).has_value());
    const std::vector<Size> five(5, Size{4, 4}), wide = {{9, 1}}, tall = {{1, 9}}, whole = {{8, 8}};
    CHECK(!pack_shelves(five, 8, 0).has_value());
    CHECK(!pack_shelves(wide, 8, 0).has_value());
    CHECK(!pack_shelves(tall, 8, 0).has_value());
    CHECK(pack_shelves(whole, 8, 3).has_value());
    CHECK(pack_shelves({}, 8, 2)->empty());
}
