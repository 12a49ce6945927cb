#include "chapters/props/wrong_normals.h"

#include <doctest/doctest.h>

#include "rasterizer/base/image_summary.h"

using namespace crevice;

TEST_CASE("normal errors: the largest angle in degrees, and the share beyond one degree") {
    const Size size{4, 1};
    Image3 right(size, {0, 0, -1}), turned = right;
    CHECK(normal_error(turned, right).most_deg == 0);
    CHECK(normal_error(turned, right).share == 0);
    turned.set(0, 0, {0.01f, 0, -1});  // 0.57 degrees, and not unit
    CHECK(normal_error(turned, right).most_deg == doctest::Approx(0.5729).epsilon(1e-3));
    CHECK(normal_error(turned, right).share == 0);
    turned.set(1, 0, {0, 3, 0});
    CHECK(normal_error(turned, right).most_deg == doctest::Approx(90));
    CHECK(normal_error(turned, right).share == 0.25);
    turned.set(2, 0, {0, 0, 0});
    CHECK(normal_error(turned, right).most_deg == 180);
    right.set(3, 0, {0, 0, 0});  // background: does not count, whatever is there
    CHECK(normal_error(turned, right).share == doctest::Approx(2.0 / 3));
}

TEST_CASE("compared normals: what shade is lost and invented is the difference of the means") {
    const Scene scene = stretched_scene();
    for (const NormalMatrix matrix : {NormalMatrix::with_translation, NormalMatrix::world}) {
        CAPTURE(static_cast<int>(matrix));
        const ComparedNormals both = compare_normals(scene, matrix, {160, 90});
        CHECK(both.off.most_deg > 30);
        CHECK(both.shade_lost > 0);
        CHECK(both.shade_invented > 0);
        CHECK(both.shade_lost - both.shade_invented ==
              doctest::Approx(buffer_statistics(both.ao_wrong).mean - buffer_statistics(both.ao_right).mean)
                  .epsilon(1e-6));
    }
    const ComparedNormals same = compare_normals(scene, NormalMatrix::inverse_transpose, {160, 90});
    CHECK(same.off.most_deg == 0);
    CHECK(same.shade_lost + same.shade_invented == 0);
}

TEST_CASE("the tutorials' products: wrong by what both matrices move, right when either moves nothing") {
    Scene scene = stretched_scene();
    Camera still;
    still.eye = {0, 0, 0}, still.target = {0, 0, 1};
    for (const NormalProduct product : {NormalProduct::float4, NormalProduct::float3x3}) {
        CAPTURE(static_cast<int>(product));
        CHECK(tutorial_error_deg(scene, scene.camera, product, false) > 30);
        CHECK(tutorial_error_deg(scene, scene.camera, product, true) < 0.01);
        CHECK(tutorial_error_deg(scene, still, product, false) < 0.01);
    }
}
