#include "chapters/study/methods_study.h"

#include <algorithm>
#include <map>

#include <doctest/doctest.h>

#include "scenes/builtin_scenes.h"

using namespace crevice;

TEST_CASE("methods study: every method has its points, held to the same rays; rays come nearest") {
    MethodsPlan plan = quick_methods_plan();
    plan.size = {240, 135};
    plan.reference_rays = 64;
    const Scene scene = cornell_scene();
    const MethodsStudy study = methods_study(scene, scene.camera, plan, std::nullopt, false, {});
    CHECK(study.radius == 0.5f * scene.length_unit);
    CHECK(study.truth.rays == 64);
    std::map<std::string, double> least;
    std::map<std::string, int> points;
    for (const StudyPoint& point : study.points) {
        CAPTURE(point.method);
        CAPTURE(point.setting);
        CHECK(point.truth.rmse > 0);
        CHECK(point.truth.rmse < 0.5);
        CHECK(point.time.wall_ms == 0);
        const auto [at, first] = least.try_emplace(point.method, point.truth.rmse);
        if (!first) at->second = std::min(at->second, point.truth.rmse);
        ++points[point.method];
    }
    for (const Method& method : ao_methods()) {
        CAPTURE(std::string(method.name));
        const int expected = static_cast<int>(2 * std::min<std::size_t>(3, method.samples_to_try.size()));
        CHECK(points[method.name] == (method.computes_ao() ? expected : 0));
        if (method.computes_ao() && !method.casts_rays) CHECK(least["crevice"] < least[method.name]);
    }
}

TEST_CASE("methods study: the full plan tries every sample count, the quick one three") {
    const auto points_of = [](MethodsPlan plan) {
        plan.size = {16, 9};
        plan.reference_rays = 8;
        const Scene scene = cornell_scene();
        return methods_study(scene, scene.camera, plan, std::nullopt, false, {}).points.size();
    };
    std::size_t all = 0;
    for (const Method& method : ao_methods()) all += 2 * method.samples_to_try.size();
    CHECK(points_of(full_methods_plan()) == all);
    CHECK(points_of(quick_methods_plan()) < all);
}
