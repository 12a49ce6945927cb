// Depth in every format and the two positions of a probed pixel; and which texel it lies in.
#include "chapters/probe/normal_depth_probe.h"

#include <cmath>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include "tests/tools/probed_frame.h"
#include "tests/tools/still_life.h"

using namespace crevice;

namespace {

constexpr Size kSmall{53, 31};

}  // namespace

TEST_CASE(
    "probed depth: four formats, the frame's own as it was drawn, and every code within a step of the "
    "depth") {
    for (const char* own : {"d16", "d24", "d32f", "d32f_reversed"}) {
        CAPTURE(std::string(own));
        const ProbedFrame frame(still_life(), find_method("none"), kSmall,
                                {"depth_format=" + std::string(own)});
        const NormalDepthProbe probe = frame.at(26, 22).normal_depth;
        REQUIRE(probe.surface);
        REQUIRE(probe.formats.size() == 4);
        int drawn = 0;
        for (const DepthInFormat& f : probe.formats) {
            CHECK(std::fabs(f.view_depth - double(probe.view_depth)) <= f.step + 1e-5);
            CHECK(f.ndc == depth_from_code<float>(f.format, f.code));
            if (!f.drawn) continue;
            ++drawn;
            CHECK(f.code == frame.worked.frame.gbuffer.depth.codes.at(26, 22));
            CHECK(f.reversed == (own == std::string("d32f_reversed")));
        }
        CHECK(drawn == 1);
    }
}

TEST_CASE("probed position: both ways agree to what a float holds, for either camera") {
    Scene scene = still_life();
    for (const Projection projection : {Projection::perspective, Projection::orthographic}) {
        scene.camera.projection = projection;
        scene.camera.ortho_height = 4;
        const ProbedFrame frame(scene, find_method("none"), kSmall);
        int surfaces = 0;
        for (int y = 0; y < kSmall.height; y += 3) {
            for (int x = 0; x < kSmall.width; x += 4) {
                const NormalDepthProbe probe = frame.at(x, y).normal_depth;
                if (!probe.surface) continue;
                ++surfaces;
                CAPTURE(x);
                CAPTURE(y);
                CHECK(probe.p_by_ray.z == probe.view_depth);
                CHECK(glm::length(probe.p_by_unprojection - probe.p_by_ray) < 1e-4f * probe.view_depth);
            }
        }
        CHECK(surfaces > 40);
    }
}

TEST_CASE(
    "probed texel: it holds the pixel's centre, and its pixels' weights add up to one, at odd sizes, too") {
    for (const Size size : {Size{53, 31}, Size{8, 6}, Size{1, 1}, Size{3, 1}}) {
        for (const char* scale : {"0.5", "1"}) {
            const ProbedFrame frame(still_life(), find_method("none"), size,
                                    {"ao_scale=" + std::string(scale)});
            for (int y = 0; y < size.height; ++y) {
                for (int x = 0; x < size.width; ++x) {
                    const AoProbe ao = frame.at(x, y).ao;
                    CAPTURE(x);
                    CAPTURE(y);
                    const double texels_a_pixel = double(ao.map_size.width) / size.width,
                                 at = (x + 0.5) * texels_a_pixel;
                    CHECK(ao.x <= at);
                    CHECK(at <= ao.x + 1);
                    float total = 0;
                    bool holds_pixel = false;
                    for (const TexelPixel& p : ao.pixels) {
                        total += p.weight;
                        holds_pixel = holds_pixel || (p.x == x && p.y == y);
                    }
                    CHECK(total == doctest::Approx(1));
                    // At even sizes a texel is made of the four pixels that lie in it.
                    if (size.width % 2 == 0) CHECK(holds_pixel);
                    if (std::string(scale) == "1") CHECK(ao.pixels.size() == 1);
                }
            }
        }
    }
}
