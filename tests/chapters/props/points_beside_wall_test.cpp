#include "chapters/props/points_beside_wall.h"

#include <doctest/doctest.h>

using namespace crevice;

TEST_CASE("points beside a wall: half of them in the corner, none a radius away, fewer and fewer between") {
    for (const HemisphereLengths lengths :
         {HemisphereLengths{.shortest = 0.1f, .shortened = true}, {.shortest = 0.01f, .shortened = false}}) {
        CHECK(points_beside_wall(lengths, 0) == doctest::Approx(0.5));
        CHECK(points_beside_wall(lengths, 1) == 1);
        double last = 0;
        for (const double distance : {0.0, 0.1, 0.3, 0.6, 1.0}) {
            const double open = points_beside_wall(lengths, distance);
            CAPTURE(distance);
            CHECK(open > last);
            CHECK(open >= rays_beside_wall(distance) - 1e-6);
            last = open;
        }
    }
    CHECK(rays_beside_wall(0) == 0.5);
    CHECK(rays_beside_wall(1) == 1);
}
