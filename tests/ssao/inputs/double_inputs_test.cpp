// AO inputs in double: kernels that are given the same numbers make the same map, and texels of half size are fetched
// by the same text.
#include "ssao/inputs/double_inputs.h"

#include <cmath>
#include <limits>

#include <doctest/doctest.h>

#include "ssao/judge/double_judge.h"
#include "tests/tools/image_checks.h"
#include "tests/tools/method_maps.h"
#include "tests/tools/still_life.h"

using namespace crevice;

namespace {

// The numbers of a float G-buffer.
DoubleGBuffer widened(const GBuffer& g, const CameraMatrices& m) {
    return {widened(g.view_depth),
            widened(ndc_depth(g.depth)),
            {widened(g.normal.x), widened(g.normal.y), widened(g.normal.z)},
            m.depth_a,
            m.depth_b};
}

struct Drawn {
    Scene scene = still_life();
    ScreenGeometry geometry = screen_geometry(scene, scene.camera, kMethodMaps);
    GBuffer g = normal_depth(scene, geometry, false, {});
};

}  // namespace

TEST_CASE(
    "in double: given what the buffers hold, every method makes the map that it makes from the buffers") {
    const Drawn drawn;
    const DoubleGBuffer same = widened(drawn.g, camera_matrices(drawn.scene.camera, kMethodMaps));
    int in_double = 0;
    for (const Method* method : computing_methods()) {
        CAPTURE(std::string(method->name));
        if (!method->ao_in_double) {
            CHECK(method->casts_rays);
            continue;
        }
        ++in_double;
        const MethodSettings settings = full_size(*method);
        AoView view{drawn.scene, drawn.scene.camera, drawn.g};
        const Image<float> from_buffers = method->ao_in_double(view, settings.ao, {});
        view.in_double = &same;
        // Normals that are means or are normalised once more differ in their last bit.
        CHECK(further_apart_than(2e-6, method->ao_in_double(view, settings.ao, {}), from_buffers) == "");
        CHECK(other_than(from_buffers, 1) != "");
    }
    CHECK(in_double >= 11);
}

TEST_CASE(
    "in double: a texel of half size on one plane is the mean of its pixels, to the last bits of a double") {
    const Drawn drawn;
    const DoubleGBuffer right =
        double_gbuffer(DoubleJudge(drawn.scene, drawn.scene.camera, drawn.geometry), drawn.g);
    const AoInputs inputs = in_double(ao_inputs(drawn.g, drawn.scene.camera, {}), &right);
    int on_one_plane = 0;
    // The sides are odd: the last texels lie half beyond the picture.
    for (int y = 0; y < kMethodMaps.height / 2; ++y) {
        for (int x = 0; x < kMethodMaps.width / 2; ++x) {
            double sum = 0;
            bool level = true;
            for (int i = 0; i < 4; ++i) {
                const int column = 2 * x + i % 2, row = 2 * y + i / 2;
                sum += right.view_depth.at(column, row);
                for (const Image<double>& n : right.normal)
                    level = level && n.at(column, row) == n.at(2 * x, 2 * y);
                // Of two parallel planes one lies much further away.
                level = level &&
                        std::fabs(right.view_depth.at(column, row) / right.view_depth.at(2 * x, 2 * y) - 1) <
                            0.02;
            }
            if (!level || !(sum < std::numeric_limits<double>::infinity())) continue;
            CAPTURE(x);
            CAPTURE(y);
            CHECK(inputs.in_double->view_depth.at(x, y) == doctest::Approx(sum / 4).epsilon(1e-15));
            ++on_one_plane;
        }
    }
    CHECK(on_one_plane > 30);
}

TEST_CASE("in double: a texel of half size is fetched as in float, at edges too") {
    const Drawn drawn;
    const DoubleGBuffer same = widened(drawn.g, camera_matrices(drawn.scene.camera, kMethodMaps));
    for (const EdgeTexels edges : {EdgeTexels::nearest, EdgeTexels::mixed}) {
        for (const TexelCentre centre : {TexelCentre::exact, TexelCentre::off}) {
            for (const bool point_normals : {false, true}) {
                const AoFetch fetch{
                    .point_normals = point_normals, .edge_texels = edges, .texel_centre = centre};
                const AoInputs inputs = in_double(ao_inputs(drawn.g, drawn.scene.camera, fetch), &same);
                for (int y = 0; y < inputs.size().height; ++y) {
                    for (int x = 0; x < inputs.size().width; ++x) {
                        CAPTURE(x);
                        CAPTURE(y);
                        const double z = inputs.in_double->view_depth.at(x, y);
                        const auto in_float = static_cast<double>(inputs.view_depth.at(x, y));
                        CHECK((z == in_float || std::fabs(z - in_float) < 1e-5 * z));
                        for (std::size_t i = 0; i < 3; ++i)
                            CHECK(std::fabs(inputs.in_double->normal[i].at(x, y) -
                                            static_cast<double>(
                                                inputs.normal.at(x, y)[static_cast<int>(i)])) < 1e-6);
                    }
                }
            }
        }
    }
}

TEST_CASE("in double: the judge's numbers are read and not the buffers'") {
    const Drawn drawn;
    const DoubleJudge judge(drawn.scene, drawn.scene.camera, drawn.geometry);
    const DoubleGBuffer right = double_gbuffer(judge, drawn.g);
    DoubleGBuffer level = right;  // every surface at one depth, facing the eye: nothing occludes
    for (int y = 0; y < kMethodMaps.height; ++y) {
        for (int x = 0; x < kMethodMaps.width; ++x) {
            level.view_depth.at(x, y) = 4;
            level.ndc_depth.at(x, y) = judge.ndc_depth(4);
            level.normal[0].at(x, y) = level.normal[1].at(x, y) = 0;
            level.normal[2].at(x, y) = -1;
        }
    }
    for (const Method* method : computing_methods()) {
        if (!method->ao_in_double) continue;
        CAPTURE(std::string(method->name));
        AoView view{drawn.scene, drawn.scene.camera, drawn.g};
        view.in_double = &level;
        CHECK(values_against(method->ao_in_double(view, full_size(*method).ao, {}),
                             [](float a) { return a > 0.999f; }) == "");
        CHECK(values_against(method->ao_in_double(view, defaults_of(*method).ao, {}),
                             [](float a) { return a > 0.999f; }) == "");
    }
}
