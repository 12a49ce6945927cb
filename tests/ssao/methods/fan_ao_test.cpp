// A flat fan of slivers, narrower than the grid that their corners are snapped to, is as open as a square.
#include <doctest/doctest.h>

#include "ssao/ao_methods.h"
#include "tests/tools/fan_scene.h"
#include "tests/tools/image_checks.h"
#include "tests/tools/method_maps.h"

using namespace crevice;

TEST_CASE("fan: every method finds a disc of slivers open") {
    const Scene scene = fan_scene(false);
    for (const Method* method : computing_methods()) {
        CAPTURE(std::string(method->name));
        CHECK(values_against(maps_of(*method, scene).raw.ao, [](float open) { return open > 0.99f; }) == "");
    }
}
