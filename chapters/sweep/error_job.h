// Error jobs: how far a setting's AO image is from ray-cast truth, and which step makes it so. Deterministic: the same bytes on
// every machine and number of threads.
#pragma once

#include <filesystem>
#include <map>
#include <optional>

#include "chapters/study/method_view.h"
#include "chapters/study/references.h"
#include "chapters/sweep/sweep_jobs.h"
#include "ssao/judge/error_parts.h"
#include "ssao/judge/reference_error.h"

namespace crevice {

// Seeds of the limit that the steps of an error are told by.
inline constexpr int kPartsSeeds = 64;

// What a sweep keeps of an image against a reference, over the pixels that show a surface. Pixels with a value that is not
// finite are left out, and FLIP, which needs them all, is 0 then.
SweepError sweep_error(const ReferenceError& error);

std::vector<SweepErrorPart> sweep_parts(const ErrorParts& parts);

// Every k-th pixel of every k-th row, so that at most 320 columns are left.
Image<float> small_picture(const Image<float>& image);

// Does error jobs. What a job has drawn and traced is kept for the next, so that jobs of one view and question should come
// one after the other.
class ErrorJudge {
 public:
    // `cache`: of the references; none: they are made anew.
    ErrorJudge(std::optional<std::filesystem::path> cache, const Run& run)
        : cache_(std::move(cache)), run_(run) {}

    struct JudgedImage {
        SweepErrorResult result;  // without the picture's name
        Image<float> picture;     // small_picture()
    };
    // Throws UsageError for a view without any surface.
    JudgedImage judge(const SweepJob& job);

 private:
    void look_at(const SweepJob& job, const Method& method, const FrameSettings& settings);
    void take_apart(const MethodView& view, const FrameSettings& settings, SweepErrorResult& result);

    std::optional<std::filesystem::path> cache_;
    Run run_;
    // What the following belong to.
    std::string seen_, asked_, limited_;
    std::optional<MethodView> view_;
    References references_;
    ReferenceRequest request_;
    Image<SurfaceKind> kinds_;
};

}  // namespace crevice
