// Every method of the table on one view, held to one question: of the rays into the hemisphere over a point,
// cosine-weighted, the share that meets nothing within the radius. What a method asks by itself (Method::question) may
// differ, in its fade, its weight or its exponent; that difference is then a part of its error.
// Settings: each method's defaults, their sample counts, at half and at full size
// Errors, times: as in error_study.h
#pragma once

#include "chapters/study/error_study.h"

namespace crevice {

// The tutorials' radius, for scenes whose length_unit is 1: what all methods are asked.
inline constexpr float kAskedRadius = 0.5f;

struct MethodsPlan {
    Size size{1280, 720};
    bool all_samples = true;  // of Method::samples_to_try; else the fewest, the middle and the most
    std::vector<float> scales = {0.5f, 1};
    int seeds = 2;
    int rounds = 9, slow_rounds = 3;
    int reference_rays = 256;
};
MethodsPlan full_methods_plan();
MethodsPlan quick_methods_plan();

struct MethodsStudy {
    MethodsPlan plan;
    float radius = 0;  // scene units
    Reference truth;
    std::vector<StudyPoint> points;  // of all methods, in the order of the table
};

// The truth that all methods are held to, and of which kind each of its pixels is.
struct MethodsTruth {
    float radius = 0;  // scene units
    Reference reference;
    Image<SurfaceKind> kinds;
};
MethodsTruth methods_truth(const Scene& scene, const Camera& camera, Size size, int rays,
                           const std::optional<std::filesystem::path>& cache, const Run& run);

// The method's defaults, but that radius.
FrameSettings settings_for_study(const Method& method, float length_unit, float radius);

MethodsStudy methods_study(const Scene& scene, const Camera& camera, const MethodsPlan& plan,
                           const std::optional<std::filesystem::path>& cache, bool timed, const Run& run,
                           const StudyProgress& progress = {});

}  // namespace crevice
