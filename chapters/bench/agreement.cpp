#include "chapters/bench/agreement.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "chapters/bench/peer_scene.h"
#include "ssao/light/scene_shadow.h"
#include "ssao/light/shade.h"
#include "ssao/light/sky.h"

namespace crevice {

namespace {

// What two rasterizers may differ in at one pixel: four steps of a float just below 1; a ten-thousandth of
// the distance; and for normals what snapping corners to 1/256 pixel turns them by.
constexpr double kNdcTolerance = 2.4e-7, kViewTolerance = 1e-4;
constexpr double kNormalTolerance_rad = 0.1 * 3.14159265358979 / 180;

// Above the largest values seen of equal work (tests/peers/README.md). On `columns` other work lies above the
// limit of the blurred AO: a radius 10 % larger gives 0.0012, another seed 0.0034, a blur iteration less
// 0.0010. What is timed is made in other ways on both sides (texels at edges, anisotropic filters, 8 bits), so its
// limits only notice what is badly wrong. Ndc depth is told and not judged: the two programs round the planes of a
// triangle that reaches far beyond the picture differently, by more than 2.4e-7 at once for all its pixels.
constexpr double kCoverageLimit_percent = 0.05, kViewDepthLimit_percent = 0.05, kNormalLimit_percent = 3;
constexpr double kLitLimit = 0.0008, kLitRmsLimit = 0.003;
constexpr double kAoAsTimedLimit = 0.02, kLitAsTimedLimit = 0.02;  // mean, RMSE
// Of the shadow map: a share of near to far, and of its texels.
constexpr double kShadowTolerance = 1e-4, kShadowLimit_percent = 0.02;

// Of AO, whose means and roots of mean squares are limited.
struct AoLimits {
    double raw, raw_rms, blurred, blurred_rms;
};
// The tutorials compare filtered depths with `epsilon`. The other methods read one pixel a sample, sao from a level that
// rounding may choose, and leave no room for filters.
AoLimits ao_limits(const Method& method) {
    const std::string name = method.name;
    if (name == "xjun" || name == "luna") return {0.003, 0.02, 0.0008, 0.01};
    if (name == "sao") return {0.0005, 0.015, 0.0004, 0.004};
    return {0.0001, 0.003, 0.0001, 0.002};
}

struct PixelCounts {
    double all = 0, one_sided = 0, covered = 0, ndc_off = 0, view_off = 0, normal_off = 0;
};

PixelCounts count_pixels(const Frame& ours, const Image<float>& our_depth, const PeerBuffers& theirs) {
    PixelCounts counts;
    const Size size = our_depth.size;
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
            const bool here = ours.gbuffer.view_depth.at(x, y) < std::numeric_limits<float>::infinity(),
                       there = theirs.ndc_depth.at(x, y) < 1;
            ++counts.all;
            counts.one_sided += here != there ? 1 : 0;
            if (!here || !there) continue;
            ++counts.covered;
            const double ndc_off = std::fabs(double{our_depth.at(x, y)} - double{theirs.ndc_depth.at(x, y)});
            counts.ndc_off += ndc_off <= kNdcTolerance ? 0 : 1;
            const double z = ours.gbuffer.view_depth.at(x, y),
                         view_off = std::fabs(z - theirs.view_depth.at(x, y));
            counts.view_off += view_off <= kViewTolerance * z ? 0 : 1;
            const glm::dvec3 a = ours.gbuffer.normal.at(x, y), b = theirs.normal.at(x, y);
            const double angle = std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
            counts.normal_off += angle <= kNormalTolerance_rad ? 0 : 1;
        }
    }
    return counts;
}

// How far two maps lie apart.
struct Apart {
    double mean = 0, rms = 0;  // of absolute differences; root of the mean square
};

Apart apart(const Image<float>& a, const Image<float>& b) {
    double sum = 0, squares = 0;
    for (int y = 0; y < a.size.height; ++y) {
        for (int x = 0; x < a.size.width; ++x) {
            const double off = double{a.at(x, y)} - double{b.at(x, y)};
            sum += std::fabs(off);
            squares += off * off;
        }
    }
    const double count = double{1} * a.size.width * a.size.height;
    return {sum / count, std::sqrt(squares / count)};
}

// Of colours as a screen shows them, which ends at 1; channels count alike.
Apart shown_apart(const Image3& a, const Image3& b) {
    double sum = 0, squares = 0;
    for (int y = 0; y < a.size().height; ++y) {
        for (int x = 0; x < a.size().width; ++x) {
            const auto shown = [&](const Image3& image) {
                return glm::clamp(glm::dvec3(image.at(x, y)), 0.0, 1.0);
            };
            const glm::dvec3 off = glm::abs(shown(a) - shown(b));
            sum += (off.x + off.y + off.z) / 3;
            squares += glm::dot(off, off) / 3;
        }
    }
    const double count = double{1} * a.size().width * a.size().height;
    return {sum / count, std::sqrt(squares / count)};
}

// Texels of the shadow map whose depths are further apart than the share of near to far.
double shadow_off_percent(const Image<float>& ours, const Image<float>& theirs) {
    double off = 0;
    for (int y = 0; y < ours.size.height; ++y) {
        for (int x = 0; x < ours.size.width; ++x) {
            const double apart = std::fabs(double{ours.at(x, y)} - double{theirs.at(x, y)});
            off += apart <= kShadowTolerance ? 0 : 1;
        }
    }
    return 100 * off / (double{1} * ours.size.width * ours.size.height);
}

// With trilinear filters, where the two sides' are alike.
Image3 lit_trilinear(Scene scene, const FrameRequest& request, const Frame& ours, const Image<float>& ao,
                     const std::optional<ShadowMap>& shadow) {
    for (Material& material : scene.materials) material.sampler.filter = TextureFilter::trilinear;
    Image3 lit = shade(scene, ours.camera, ours.gbuffer.depth, ao, ShadeSettings{}, request.run,
                       shadow ? &*shadow : nullptr);
    if (scene.sky_cube == nullptr) return lit;
    return with_sky(std::move(lit), ours.gbuffer.depth, ours.camera, *scene.sky_cube, request.run);
}

}  // namespace

std::vector<Agreement> agreement(const Scene& scene, const FrameRequest& request, const Frame& ours,
                                 const PeerBuffers& theirs) {
    const PixelCounts counts = count_pixels(ours, ndc_depth(ours.gbuffer.depth), theirs);
    const double to_percent = 100 / std::max(1.0, counts.covered);
    const RawAo raw =
        ao_as_peer({scene, ours.camera, ours.gbuffer}, *request.method, request.settings.method, request.run);
    const Image<float> blurred = denoised(*request.method, raw, request.settings.method, request.run).ao;
    const Apart of_raw = apart(raw.ao, theirs.ao_raw), of_blurred = apart(blurred, theirs.ao_blurred);
    const char *const mean = "mean absolute difference", *const rms = "RMSE";
    const AoLimits limits = ao_limits(*request.method);
    std::vector<Agreement> all = {
        {"coverage", "pixels covered on one side only, %", 100 * counts.one_sided / counts.all,
         kCoverageLimit_percent},
        {"ndc_depth", "pixels off by more than 2.4e-7, %", to_percent * counts.ndc_off, std::nullopt},
        {"view_depth", "pixels off by more than 0.01 %, %", to_percent * counts.view_off,
         kViewDepthLimit_percent},
        {"normal", "pixels off by more than 0.1 degree, %", to_percent * counts.normal_off,
         kNormalLimit_percent},
        {"ao_raw", mean, of_raw.mean, limits.raw},
        {"ao_raw", rms, of_raw.rms, limits.raw_rms},
        {"ao_blurred", mean, of_blurred.mean, limits.blurred},
        {"ao_blurred", rms, of_blurred.rms, limits.blurred_rms},
        {"ao_blurred as timed", mean, apart(ours.ao_blurred, theirs.ao_blurred).mean, kAoAsTimedLimit},
    };
    if (theirs.lit.empty()) return all;
    std::optional<ShadowMap> shadow;
    if (throws_shadow(scene)) {
        shadow = scene_shadow(scene, request.run);
        all.push_back({"shadow", "texels off by more than 0.0001 of near to far, %",
                       shadow_off_percent(ndc_depth(shadow->depth), theirs.shadow), kShadowLimit_percent});
    }
    const Apart of_lit =
        shown_apart(lit_trilinear(scene, request, ours, blurred, shadow), theirs.lit_trilinear);
    all.push_back({"lit", mean, of_lit.mean, kLitLimit});
    all.push_back({"lit", rms, of_lit.rms, kLitRmsLimit});
    all.push_back({"lit as timed", mean, shown_apart(ours.lit, theirs.lit).mean, std::nullopt});
    all.push_back({"lit as timed", rms, shown_apart(ours.lit, theirs.lit).rms, kLitAsTimedLimit});
    return all;
}

}  // namespace crevice
