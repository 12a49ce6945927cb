#include "chapters/diagrams/ray_fan.h"

#include <doctest/doctest.h>

#include "rasterizer/lanes/approx_math.h"
#include "scenes/builtin_scenes.h"
#include "tests/tools/well_formed.h"

using namespace crevice;

TEST_CASE("ray fan: before a wall one unit away, rays of length 2 are blocked below 60 degrees") {
    const RayScene wall = ray_scene(wall_corner_scene(), glm::dvec3(0));
    std::vector<double> angles_rad;
    for (int degrees = 5; degrees < 180; degrees += 10) angles_rad.push_back(radians(degrees));
    const RayFan fan = ray_fan(wall, {-1, 0}, angles_rad, 2, {{-4, 0}, {0, 0}, {0, 4}}, "A wall");
    CHECK(fan.blocked == 6);
    CHECK(xml_fault(fan.svg) == "");
    CHECK(ray_fan(wall, {-1, 0}, angles_rad, 0.5, {}, "Too short").blocked == 0);
}
