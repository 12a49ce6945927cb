#include "chapters/study/supersampled.h"

#include <cmath>

#include <doctest/doctest.h>

#include "tests/tools/image_checks.h"
#include "tests/tools/small_scenes.h"
#include "tests/tools/still_life.h"

using namespace crevice;

TEST_CASE("supersampling a bare wall changes nothing and finds no edge") {
    Scene scene = scene_of({facing_quad({0, 0, 5}, 20)});
    scene.camera.near_plane = 0.5;
    const Supersampled s = supersample(scene, scene.camera, {48, 27});
    CHECK(s.edge_share == 0);
    CHECK(s.off_at_edges == 0);
    CHECK(s.off_elsewhere == 0);
    CHECK(further_apart_than(0.01, s.plain.y, s.four.y) == "");  // the highlight bends within a pixel
    CHECK(further_apart_than(0, s.four.y, s.four_with_one.y) == "");
}

TEST_CASE(
    "supersampling: a step in depth alone is an edge, and the AO of one sample is the pixel's everywhere") {
    Scene scene = scene_of({facing_quad({0, 0, 5}, 20), facing_quad({0.137f, 0.119f, 4.6f}, 0.531f)});
    scene.camera.near_plane = 0.5;
    const Size size{96, 54};
    const Supersampled s = supersample(scene, scene.camera, size);
    CHECK(s.edge_share > 0);
    CHECK(s.edge_share < 0.03);
    // On either wall a pixel's four samples are lit alike.
    CHECK(pixels_against(size, [&](int x, int y) {
              return s.edge.at(x, y) > 0 ||
                     std::fabs(s.four_with_one.y.at(x, y) - s.plain.y.at(x, y)) < 2e-3f;
          }) == "");
}

TEST_CASE("supersampling: outlines are edges, and there four samples with one AO go wrong most") {
    const Scene scene = still_life();
    const Size size{96, 54};
    const Supersampled s = supersample(scene, scene.camera, size);
    CHECK(s.edge_share > 0.01);
    CHECK(s.edge_share < 0.3);
    CHECK(s.off_at_edges > 2 * s.off_elsewhere);
    CHECK(values_against(s.edge, [](float a) { return a == 0 || a == 1; }) == "");
    double at_edges = 0, edges = 0;
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
            CAPTURE(x);
            CAPTURE(y);
            CHECK(s.off.at(x, y) == s.four_with_one.y.at(x, y) - s.four.y.at(x, y));
            if (s.edge.at(x, y) > 0) at_edges += std::fabs(double(s.off.at(x, y))), edges += 1;
        }
    }
    CHECK(s.edge_share == doctest::Approx(edges / (size.width * size.height)));
    CHECK(s.off_at_edges == doctest::Approx(at_edges / edges));
}
