// The line for a terminal that draws the same bits.
#include <doctest/doctest.h>

#include "chapters/lab/render_words.h"

using namespace crevice;

TEST_CASE("render_words: the line holds camera and parameters, and a parameter stands there once") {
    LabWords words;
    words.scene = "columns";
    words.ao = "luna";
    words.size = "640x360";
    words.camera.eye = "-1,2,3";
    words.camera.fov_y = "50";
    set_param(words, "radius", "1");
    set_param(words, "samples", "8");
    set_param(words, "radius", "2");
    CHECK(render_command(words) ==
          "crevice render columns --size 640x360 --ao luna --eye=-1,2,3 --fov-y=50 --param samples=8 --param "
          "radius=2");
    words.params.clear();
    words.crease = "30";
    CHECK(render_command(words) ==
          "crevice render columns --size 640x360 --ao luna --eye=-1,2,3 --fov-y=50 --crease 30");
}
