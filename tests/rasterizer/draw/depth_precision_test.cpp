// What is left of a view depth: inside the bound everywhere, and the closed forms of where a step is too
// long.
#include <cmath>
#include <utility>

#include <doctest/doctest.h>

#include "rasterizer/base/error.h"
#include "rasterizer/draw/depth_precision.h"

using namespace crevice;

namespace {

constexpr std::pair<double, double> kPlanes[] = {{1, 1e3}, {0.1, 1e3}, {1e-3, 1e3}, {1e-4, 1e7},
                                                 {1, 100}, {0.5, 5},   {0.01, 50},  {10, 1e6}};
constexpr DepthFormat kFormats[] = {DepthFormat::d16, DepthFormat::d24, DepthFormat::d32f};

Camera camera_with(std::pair<double, double> planes, bool reversed = false) {
    Camera camera;
    camera.near_plane = planes.first, camera.far_plane = planes.second, camera.reversed_z = reversed;
    return camera;
}

// Calls body(z) for 61 depths an octave, exact ones and odd ones.
template <class Body>
void each_depth(std::pair<double, double> planes, const Body& body) {
    for (double octave = planes.first; octave < planes.second; octave *= 2) {
        for (int i = 0; i < 61; ++i) {
            const double z = octave * (1 + i / 61.0);
            if (z <= planes.second) body(z);
        }
    }
    body(planes.second);
}

// Calls body(camera, format, planes) for all pairs of planes, formats, directions of depth and projections.
template <class Body>
void each_buffer(const Body& body) {
    for (const auto& planes : kPlanes) {
        for (const DepthFormat format : kFormats) {
            for (const bool reversed : {false, true}) {
                for (const Projection projection : {Projection::perspective, Projection::orthographic}) {
                    CAPTURE(planes.first);
                    CAPTURE(planes.second);
                    CAPTURE(static_cast<int>(format));
                    CAPTURE(reversed);
                    Camera camera = camera_with(planes, reversed);
                    camera.projection = projection;
                    body(camera, format, planes);
                }
            }
        }
    }
}

}  // namespace

TEST_CASE(
    "depth precision: no step up to a depth exceeds what is said of it, and in most formats the last one is "
    "as large") {
    each_buffer([](const Camera& camera, DepthFormat format, const auto& planes) {
        double largest = 0;
        each_depth(planes, [&](double z) {
            const double step = depth_step(camera, format, z);
            largest = std::fmax(largest, step);
            const double bound = largest_step_up_to(camera, format, z);
            REQUIRE(largest <= bound);
            if (!camera.reversed_z || format != DepthFormat::d32f) REQUIRE(step == bound);
        });
    });
}

TEST_CASE("depth precision: the error is inside the bound for eight pairs of planes, and comes close to it") {
    each_buffer([](const Camera& camera, DepthFormat format, const auto& planes) {
        double worst = 0;
        each_depth(planes, [&](double z) {
            const DepthError e = depth_error(camera, format, z);
            worst = std::fmax(worst, e.error / e.bound);
        });
        CHECK(worst <= 1);
        CHECK(worst > 0.15);  // a bound that no error comes near would prove nothing
    });
}

TEST_CASE("depth precision: reversed floats keep 2e-7 everywhere, standard ones do not") {
    for (const auto& planes : kPlanes) {
        CAPTURE(planes.first);
        CAPTURE(planes.second);
        double reversed = 0, standard = 0;
        each_depth(planes, [&](double z) {
            reversed =
                std::fmax(reversed, depth_error(camera_with(planes, true), DepthFormat::d32f, z).error / z);
            standard = std::fmax(standard, depth_error(camera_with(planes), DepthFormat::d32f, z).error / z);
        });
        CHECK(reversed < 2e-7);
        if (planes.second / planes.first > 50) CHECK(standard > 10 * reversed);
    }
}

TEST_CASE("depth precision: exact values") {
    const Camera camera = camera_with({1, 1000});
    // Both planes are codes of every format.
    for (const DepthFormat format : kFormats) {
        CHECK(depth_error(camera, format, 1).error == 0);
        CHECK(depth_error(camera, format, 1000).error < 1e-4);
    }
    // Half way in ndc depth, code 32768 of 65535: z' = B / (32768 / 65535 - A) = 2 n f / (f + n) nearly.
    const double z = 2000.0 / 1001, expected = -(1000 / 999.0) / (32768 / 65535.0 - 1000 / 999.0);
    CHECK(std::fabs(depth_error(camera, DepthFormat::d16, z).error - std::fabs(expected - z)) < 1e-7);
    CHECK(depth_step(camera, DepthFormat::d16, 100) == doctest::Approx(1e4 * 0.999 / 65535));
    CHECK(depth_step(camera, DepthFormat::d24, 100) == doctest::Approx(1e4 * 0.999 / 16777215));
    CHECK(depth_step(camera, DepthFormat::d32f, 100) == doctest::Approx(1e4 * 0.999 * 0x1p-24));
    CHECK(depth_step(camera, DepthFormat::d32f, 1000) == doctest::Approx(1e6 * 0.999 * 0x1p-24));
    Camera ortho = camera;
    ortho.projection = Projection::orthographic;
    CHECK(depth_step(ortho, DepthFormat::d16, 3) == doctest::Approx(999 / 65535.0));
    CHECK(depth_step(ortho, DepthFormat::d16, 900) == doctest::Approx(999 / 65535.0));
    // A is 1 in float when far is so far: the far plane's depth divides by 0.
    CHECK(std::isinf(depth_error(camera_with({1e-4, 1e7}), DepthFormat::d24, 1e7).error_in_float));
}

TEST_CASE("depth precision: where one step exceeds a length") {
    const Camera camera = camera_with({1, 1000});
    CHECK(depth_of_step(camera, DepthFormat::d16, 0.05) ==
          doctest::Approx(std::sqrt(0.05 * 65535 / 0.999)).epsilon(1e-3));
    CHECK(depth_of_step(camera, DepthFormat::d24, 0.05) ==
          doctest::Approx(std::sqrt(0.05 * 16777215 / 0.999)).epsilon(1e-3));
    CHECK(std::isinf(depth_of_step(camera, DepthFormat::d24, 0.1)));
    CHECK(std::isinf(depth_of_step(camera_with({1, 1000}, true), DepthFormat::d32f, 0.05)));
    Camera wrong = camera;
    wrong.near_plane = 0;
    CHECK_THROWS_AS(depth_of_step(wrong, DepthFormat::d16, 0.05), UsageError);
    CHECK_THROWS_AS(depth_error(wrong, DepthFormat::d16, 5), UsageError);
}

TEST_CASE(
    "depth precision: what a buffer stores of a view depth is its code, and stands for a depth within the "
    "bound") {
    for (const Projection projection : {Projection::perspective, Projection::orthographic}) {
        for (const bool reversed : {false, true}) {
            Camera camera;
            camera.projection = projection;
            camera.reversed_z = reversed;
            for (const DepthFormat format : {DepthFormat::d16, DepthFormat::d24, DepthFormat::d32f}) {
                for (const double z : {1.0, 1.5, 20.0, 333.0, 1000.0}) {
                    CAPTURE(z);
                    const StoredDepth stored = stored_depth(camera, format, z);
                    CHECK(stored.code == depth_code(format, stored.ndc, 0.0));
                    CHECK(stored.stored == depth_from_code<float>(format, stored.code));
                    const double off = std::fabs(view_depth_of(camera, double(stored.stored)) - z);
                    CHECK(off <= depth_error(camera, format, z).bound);
                }
                CHECK(stored_depth(camera, format, 1.0).stored == (reversed ? 1.0f : 0.0f));
            }
        }
    }
}
