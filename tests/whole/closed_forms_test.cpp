// Ray-cast ambient occlusion where the answer is known (closed_form_scenes.h), with 65,536 rays a point.
#include <cmath>
#include <set>
#include <string>

#include <doctest/doctest.h>

#include "tests/tools/closed_form_scenes.h"
#include "tests/tools/closed_form_shapes.h"
#include "tests/tools/special_floats.h"

using namespace crevice;

namespace {

constexpr int kRays = 65536;
constexpr double kLargestError = 1e-3;

const std::vector<ClosedForm>& all_forms() {
    static const std::vector<ClosedForm> forms = closed_forms();
    return forms;
}

std::string name_of(RayWeight weight) { return weight == RayWeight::cosine ? "cosine" : "uniform"; }

std::vector<SurfacePoint> points_of(const ClosedForm& form) {
    std::vector<SurfacePoint> points;
    for (const ClosedFormPoint& p : form.points) points.push_back(p.point);
    return points;
}

RayAoSettings settings_for(const ClosedForm& form, RayWeight weight, RaySequence sequence) {
    RayAoSettings settings;
    settings.rays = kRays;
    settings.radius = form.radius;
    settings.weight = weight;
    settings.sequence = sequence;
    return settings;
}

// Calls check(point index, answer) for all points of a form that have an answer.
template <class Check>
void for_answers(const ClosedForm& form, RayWeight weight, const Check& check) {
    for (std::size_t i = 0; i < form.points.size(); ++i) {
        const auto answer = weight == RayWeight::cosine ? form.points[i].cosine : form.points[i].uniform;
        if (!answer) continue;
        INFO(form.name << ", " << form.points[i].where << ", " << name_of(weight) << ", answer " << *answer);
        check(i, *answer);
    }
}

double standard_error(double answer) { return std::sqrt(answer * (1 - answer) / kRays); }

struct ErrorSum {
    double squares = 0, signed_sum = 0;
    int count = 0;
    void add(double error) {
        squares += error * error;
        signed_sum += error;
        ++count;
    }
};

}  // namespace

TEST_CASE("every closed form is met: 0 and 1 exactly, the rest far inside four standard errors") {
    ErrorSum sum;
    for (const ClosedForm& form : all_forms()) {
        CHECK_MESSAGE(form.scene_error < kLargestError / 3, form.name);
        for (const RayWeight weight : {RayWeight::cosine, RayWeight::uniform}) {
            const std::vector<float> open =
                ray_cast_ao(*form.scene, points_of(form), settings_for(form, weight, RaySequence::sobol));
            for_answers(form, weight, [&](std::size_t i, double answer) {
                const double error = static_cast<double>(open[i]) - answer;
                CAPTURE(error);
                if (answer == 0 || answer == 1) {
                    CHECK(error == 0);
                    return;
                }
                CHECK(std::abs(error) <= 4 * standard_error(answer));
                CHECK(std::abs(error) < kLargestError);
                sum.add(error);
            });
        }
    }
    REQUIRE(sum.count > 100);
    // Random rays are off by 0.0016 here; a low-discrepancy sequence is what makes 65,536 rays a truth.
    const double rms = std::sqrt(sum.squares / sum.count), bias = sum.signed_sum / sum.count;
    CAPTURE(rms);
    CAPTURE(bias);
    CHECK(rms < 1.5e-4);
    CHECK(std::abs(bias) < 3e-5);
}

TEST_CASE("random rays are as far off as the binomial law says, and no further") {
    const std::set<std::string> rows = {"wall of height 1", "trench", "pit of radius 1 and depth 1.5",
                                        "parallel rectangle 1 x 2", "tilted normal over ground"};
    double squares = 0;
    int count = 0;
    std::uint32_t seed = 0;
    for (const ClosedForm& form : all_forms()) {
        if (rows.count(form.name) == 0) continue;
        for (const RayWeight weight : {RayWeight::cosine, RayWeight::uniform}) {
            RayAoSettings settings = settings_for(form, weight, RaySequence::independent);
            settings.seed = ++seed;  // the same rays in every row would err alike
            const std::vector<float> open = ray_cast_ao(*form.scene, points_of(form), settings);
            for_answers(form, weight, [&](std::size_t i, double answer) {
                if (answer == 0 || answer == 1) return;
                const double errors = (static_cast<double>(open[i]) - answer) / standard_error(answer);
                CAPTURE(errors);
                CHECK(std::abs(errors) <= 4);
                squares += errors * errors;
                ++count;
            });
        }
    }
    REQUIRE(seed == 2 * rows.size());
    REQUIRE(count > 30);
    // Chi-square over its degrees of freedom, +- four standard deviations.
    const double spread = squares / count, allowed = 4 * std::sqrt(2.0 / count);
    CAPTURE(count);
    CHECK(spread > 1 - allowed);
    CHECK(spread < 1 + allowed);
}

TEST_CASE("a reference is off by no more than its own standard error tells") {
    for (const ClosedForm& form : all_forms()) {
        const RayAoReference reference = ray_cast_reference(
            *form.scene, points_of(form), settings_for(form, RayWeight::cosine, RaySequence::sobol), nullptr);
        CHECK(reference.rays == static_cast<long long>(form.points.size()) * kRays);
        for_answers(form, RayWeight::cosine, [&](std::size_t i, double answer) {
            const AoEstimate& estimate = reference.hard[i];
            const double error = static_cast<double>(estimate.mean) - answer;
            CAPTURE(error);
            CAPTURE(estimate.error);
            CHECK(std::abs(error) < kLargestError);
            CHECK(estimate.error < kLargestError / 2);
            if (answer == 0 || answer == 1) {
                CHECK(error == 0);
                CHECK(estimate.error == 0);
            } else {
                // Student's t of seven degrees of freedom exceeds 6 once in 1,850 times. Replicates may
                // agree to the ray, of which each has kRays / kReplicates.
                const double one_ray = static_cast<double>(kReplicates) / kRays;
                CHECK(std::abs(error) <=
                      6 * static_cast<double>(estimate.error) + form.scene_error + one_ray);
            }
        });
    }
}

TEST_CASE("a larger occluder never leaves more open, ray by ray") {
    const SurfacePoint point = {placed({1, 0, 0.5}), {0, 1, 0}, {0, 1, 0}};
    RayAoSettings settings;
    settings.radius = kInfinity;
    settings.rays = 4096;
    for (const RayWeight weight : {RayWeight::cosine, RayWeight::uniform}) {
        settings.weight = weight;
        float before = 1;
        for (int step = 0; step <= 40; ++step) {
            const double height = std::exp2(step / 4.0 - 4);
            INFO(name_of(weight) << ", height " << height);
            const auto wall = scene_of_shapes({rectangle({0, -1, -64}, {0, 1 + height, 0}, {0, 0, 128})});
            const float open = ray_cast_ao(*wall, std::vector{point}, settings)[0];
            CHECK(open <= before);
            CHECK(open > 0.5f);
            before = open;
        }
        CHECK(before < 0.52f);
        before = 0;
        for (const float radius : {64.0f, 16.0f, 4.0f, 2.0f, 1.25f, 1.0f, 0.5f}) {
            INFO(name_of(weight) << ", radius " << radius);
            settings.radius = radius;
            const auto wall = scene_of_shapes({rectangle({0, -1, -64}, {0, 64, 0}, {0, 0, 128})});
            const float open = ray_cast_ao(*wall, std::vector{point}, settings)[0];
            CHECK(open >= before);
            before = open;
        }
        CHECK(before == 1);
        settings.radius = kInfinity;
    }
}
