// Error against run time: many settings of one method, ray casting and vertex bakes on one view, each with its
// error against the three references and its time.
// Errors: debiased (reference_error.h), over the pixels that show a surface; mean, lowest and highest of the
//         seeds' roots
// Times:  wall time of the AO pass and its blur (inputs included); of ray casting the rays alone; of a bake its
//         rays. G-buffer, trees and references are apart. Settings take turns, so that all share the machine's
//         moods; the first round is thrown away.
#pragma once

#include <functional>

#include "chapters/study/error_settings.h"
#include "chapters/study/references.h"
#include "chapters/terminal/stopwatch.h"
#include "ssao/judge/error_parts.h"
#include "ssao/judge/reference_error.h"

namespace crevice {

// Of the images that differ in nothing but their seed.
struct ErrorSpread {
    double rmse = 0, lowest = 0, highest = 0;
    double bias = 0;
    double error = 0;  // standard error of `rmse`, of pixels and reference; seeds are in lowest and highest
};

struct StudyPoint {
    std::string method;                 // of the table of methods, "ray_cast" or "vertex_bake"
    std::string setting;                // in words
    std::optional<ErrorSetting> of;     // of a method: the setting itself
    ErrorSpread truth, screen;          // against T soft and S
    std::optional<ErrorSpread> limit;   // against C, the method's own
    std::optional<double> fitted_rmse;  // against T after the exponent that was fitted on other scenes
    PassTime time;
};

struct ErrorStudy {
    const Method* method = nullptr;
    Camera camera;
    ErrorPlan plan;
    RayAoSettings cast;  // of ray casting and bakes: the method's radius and fade
    References references;
    std::vector<StudyPoint> points;      // the method's settings, ray casting, bakes
    double fitted_exponent = 1;          // brings the method's limit nearest to truth on fitted_on
    std::vector<std::string> fitted_on;  // scenes other than this one
    ErrorSetting parts_setting;          // the method's defaults with float16, whose error is taken apart
    ErrorParts parts;
};

// Reported after every image and every timing.
using StudyProgress = std::function<void(const char* stage, long long done, long long total)>;

// `timed` false: times stay 0, and everything else is the same on every machine. Throws as make_references().
ErrorStudy error_study(const Scene& scene, const Camera& camera, const Method& method, const ErrorPlan& plan,
                       const std::optional<std::filesystem::path>& cache, bool timed, const Run& run,
                       const StudyProgress& progress = {});

}  // namespace crevice
