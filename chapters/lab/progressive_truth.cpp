#include "chapters/lab/progressive_truth.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "rasterizer/base/hash.h"

namespace crevice {

ProgressiveTruth::ProgressiveTruth(const Scene& scene, const Camera& camera, Size size,
                                   const RayAoSettings& question, const Run& run)
    : run_(run), rays_(question) {
    rays_.rays = kRaysAPass;
    validate(rays_);
    // As for the references of a study: the most precise depths decide what is seen.
    Camera precise = camera;
    precise.reversed_z = true;
    const GBuffer gbuffer = normal_depth(scene, precise, size, run_);
    kinds_ = surface_kinds(gbuffer, precise);
    points_ = surface_points(scene, precise, gbuffer, run_);
    scene_ = ray_scene(scene, camera.eye, run_);
    pass_.resize(points_.points.size());
    for (std::vector<double>& sum : sums_) sum.assign(pass_.size(), 0);
    squares_.assign(pass_.size(), 0);
}

bool ProgressiveTruth::cast_from(std::size_t points) {
    const std::size_t count = std::min(points, pass_.size() - cast_);
    // Rays are scrambled by a point's place in what is cast at once: another seed for each pass and each part of it
    // keeps all of them independent.
    rays_.seed = hash_of(1, static_cast<std::uint32_t>(passes_), static_cast<std::uint32_t>(cast_));
    const std::vector<float> open =
        ray_cast_ao(scene_, std::span(points_.points).subspan(cast_, count), rays_, run_);
    std::copy(open.begin(), open.end(), pass_.begin() + static_cast<std::ptrdiff_t>(cast_));
    cast_ += count;
    if (cast_ < pass_.size()) return false;
    add_pass();
    return true;
}

void ProgressiveTruth::add_pass() {
    std::vector<double>& sum = sums_[static_cast<std::size_t>(passes_ % 2)];
    for (std::size_t i = 0; i < pass_.size(); ++i) {
        sum[i] += pass_[i];
        squares_[i] += double(pass_[i]) * pass_[i];
    }
    ++passes_;
    cast_ = 0;
}

ReferenceImage ProgressiveTruth::reference() const {
    const double even = (passes_ + 1) / 2, odd = passes_ / 2;
    std::vector<float> values(pass_.size());
    const auto picture = [&](auto value_at, float background) {
        for (std::size_t i = 0; i < values.size(); ++i) values[i] = static_cast<float>(value_at(i));
        return picture_of(points_, values, background);
    };
    const auto mean_at = [&](std::size_t i) { return (sums_[0][i] + sums_[1][i]) / passes_; };
    const auto error_at = [&](std::size_t i) {
        const double variance = squares_[i] / passes_ - mean_at(i) * mean_at(i);
        return variance > 0 ? std::sqrt(variance / (passes_ - 1)) : 0;
    };
    return {picture(mean_at, 1),
            picture(error_at, 0),
            {picture([&](std::size_t i) { return sums_[0][i] / even; }, 1),
             picture([&](std::size_t i) { return sums_[1][i] / odd; }, 1)}};
}

}  // namespace crevice
