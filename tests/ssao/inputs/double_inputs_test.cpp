// AO inputs in double: kernels that are given the same numbers make the same map, and half-size texels are no pixels.
#include "ssao/inputs/double_inputs.h"

#include <doctest/doctest.h>

#include "rasterizer/base/error.h"
#include "ssao/judge/double_judge.h"
#include "tests/tools/image_checks.h"
#include "tests/tools/method_maps.h"
#include "tests/tools/still_life.h"

using namespace crevice;

namespace {

Image<double> widened(const Image<float>& image) {
    Image<double> result(image.size);
    for (std::size_t i = 0; i < image.pixels.size(); ++i) result.pixels[i] = image.pixels[i];
    return result;
}

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

TEST_CASE("in double: the judge's numbers are read, a little off and far off, and only at full size") {
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
        const MethodSettings half = with_value(*method, defaults_of(*method), "ao_scale", 0.5);
        CHECK_THROWS_WITH_AS(method->ao_in_double(view, half.ao, {}), doctest::Contains("ao_scale: "),
                             UsageError);
    }
}
