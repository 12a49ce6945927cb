#include "chapters/bench/agreement.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "ssao/light/shade.h"
#include "ssao/methods/luna_settings.h"

namespace crevice {

namespace {

// What two rasterizers may differ in at one pixel: four steps of a float just below 1; a ten-thousandth of
// the distance; and for normals what snapping corners to 1/256 pixel turns them by.
constexpr double kNdcTolerance = 2.4e-7, kViewTolerance = 1e-4;
constexpr double kNormalTolerance_rad = 0.1 * 3.14159265358979 / 180;

// Above the largest values seen of equal work (tests/peers/README.md). On `columns` other work lies above the
// limit of the blurred AO: a radius 10 % larger gives 0.0012, another seed 0.0034, a blur iteration less
// 0.0010. The AO as timed is fetched in another way than the peer's, so its limit only notices what is badly
// wrong. Ndc depth is told and not judged: the two programs round the planes of a triangle that reaches far
// beyond the picture differently, by more than 2.4e-7 at once for all its pixels.
constexpr double kCoverageLimit_percent = 0.05, kViewDepthLimit_percent = 0.05, kNormalLimit_percent = 3;
constexpr double kAoLimit = 0.003, kBlurredLimit = 0.0008, kAsTimedLimit = 0.02, kLitLimit = 0.0015;

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

double mean_difference(const Image<float>& a, const Image<float>& b) {
    double sum = 0;
    for (int y = 0; y < a.size.height; ++y) {
        for (int x = 0; x < a.size.width; ++x) sum += std::fabs(double{a.at(x, y)} - double{b.at(x, y)});
    }
    return sum / (double{1} * a.size.width * a.size.height);
}

// Of colours as a screen shows them: the peer's picture has 8 bits a channel and ends at 1.
double mean_shown_difference(const Image3& a, const Image3& b) {
    double sum = 0;
    for (int y = 0; y < a.size().height; ++y) {
        for (int x = 0; x < a.size().width; ++x) {
            const glm::dvec3 off =
                glm::abs(glm::clamp(glm::dvec3(a.at(x, y)), 0.0, 1.0) - glm::dvec3(b.at(x, y)));
            sum += (off.x + off.y + off.z) / 3;
        }
    }
    return sum / (double{1} * a.size().width * a.size().height);
}

}  // namespace

std::vector<Agreement> agreement(const Scene& scene, const FrameRequest& request, const Frame& ours,
                                 const PeerBuffers& theirs) {
    const PixelCounts counts = count_pixels(ours, ndc_depth(ours.gbuffer.depth), theirs);
    const double to_percent = 100 / std::max(1.0, counts.covered);
    MethodSettings as_peer = request.settings.method;
    as_peer.ao.as<LunaSettings>().edge_texels = EdgeTexels::mixed;
    const RawAo raw = request.method->ao({scene, ours.camera, ours.gbuffer}, as_peer.ao, request.run);
    const Image<float>& ao_raw = raw.ao;
    const Image<float> ao_blurred = denoised(*request.method, raw, as_peer, request.run).ao;
    const Image3 lit = shade(scene, ours.camera, ours.gbuffer.depth, ao_blurred, request.run);
    const char* const mean = "mean absolute difference";
    return {
        {"coverage", "pixels covered on one side only, %", 100 * counts.one_sided / counts.all,
         kCoverageLimit_percent},
        {"ndc_depth", "pixels off by more than 2.4e-7, %", to_percent * counts.ndc_off, std::nullopt},
        {"view_depth", "pixels off by more than 0.01 %, %", to_percent * counts.view_off,
         kViewDepthLimit_percent},
        {"normal", "pixels off by more than 0.1 degree, %", to_percent * counts.normal_off,
         kNormalLimit_percent},
        {"ao_raw", mean, mean_difference(ao_raw, theirs.ao_raw), kAoLimit},
        {"ao_blurred", mean, mean_difference(ao_blurred, theirs.ao_blurred), kBlurredLimit},
        {"lit", mean, mean_shown_difference(lit, theirs.lit), kLitLimit},
        {"ao_blurred as timed", mean, mean_difference(ours.ao_blurred, theirs.ao_blurred), kAsTimedLimit},
    };
}

}  // namespace crevice
