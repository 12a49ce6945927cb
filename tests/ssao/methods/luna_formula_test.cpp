// The estimator against an independent text of its formula.
#include <algorithm>
#include <cmath>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include "tests/tools/ao_cases.h"
#include "tests/tools/image_checks.h"
#include "tests/tools/special_floats.h"

using namespace crevice;

namespace {

constexpr Size kSize = PreparedStillLife::kSize;

struct Interval {
    double low, high;
};

// The formulas of the tutorials, scalar, in double, from the G-buffer: reflect, flip, project, compare.
class Reference {
 public:
    Reference(const Scene& scene, const GBuffer& g, const AoInputs& inputs, const LunaSettings& settings)
        : camera_(scene.camera),
          g_(g),
          inputs_(inputs),
          s_(settings),
          offsets_(cube_offsets(settings.seed)),
          map_(random_map(settings.seed)),
          ndc_(inputs.fetch.depth == DepthSource::ndc_depth) {}

    // Accessibility without exponent: all that the float kernel's rounding allows. A sample may fall on
    // either side of a decision, such as dz > epsilon, so every sample is taken with its screen position and
    // depth moved a little each way.
    Interval accessibility(int x, int y) const {
        const Size map = inputs_.size();
        const double u = (x + 0.5) / map.width, v = (y + 0.5) / map.height, z = inputs_.view_depth.at(x, y);
        const glm::dvec3 p = z * ray(u, v), n = inputs_.normal.at(x, y);
        const glm::dvec3 random = glm::normalize(random_at(4 * u * 256, 4 * v * 256));
        Interval sum = {0, 0};
        for (int i = 0; i < s_.samples; ++i) {
            const glm::dvec3 o = offsets_[static_cast<std::size_t>(i)],
                             d = o - 2 * glm::dot(o, random) * random;
            const double side = glm::dot(d, n);
            Interval all = {1, 0};
            for (const double sign : {-1.0, 1.0}) {
                if (std::fabs(side) > 1e-6 && sign * side < 0) continue;
                for (int move = 0; move < 27; ++move) {
                    const double a = sample(p, n, p + sign * static_cast<double>(s_.radius) * d, move % 3 - 1,
                                            move / 3 % 3 - 1, move / 9 - 1);
                    all = {std::fmin(all.low, a), std::fmax(all.high, a)};
                }
            }
            sum = {sum.low + all.low, sum.high + all.high};
        }
        return {1 - sum.high / s_.samples, 1 - sum.low / s_.samples};
    }

 private:
    static constexpr double kMove_px = 3e-5, kMoveDepth = 4.0 / 16777216;

    double tangent_y() const { return std::tan(camera_.fov_y_rad / 2); }
    glm::dvec3 ray(double u, double v) const {
        return {(2 * u - 1) * tangent_y() * kSize.width / kSize.height, (1 - 2 * v) * tangent_y(), 1};
    }

    glm::dvec3 random_at(double x, double y) const {
        glm::dvec3 sum(0);
        for (int i = 0; i < 4; ++i) {
            const double left = std::floor(x - 0.5) + i % 2, top = std::floor(y - 0.5) + i / 2;
            const auto at = static_cast<std::size_t>((static_cast<int>(top) & 255) * 256 +
                                                     (static_cast<int>(left) & 255));
            sum += (1 - std::fabs(x - 0.5 - left)) * (1 - std::fabs(y - 0.5 - top)) *
                   glm::dvec3(map_.x[at], map_.y[at], map_.z[at]);
        }
        return sum;
    }

    // What the published sampler sees: linear, border and sky at the far value.
    double depth_at(double x, double y, double move) const {
        const double n = camera_.near_plane, f = camera_.far_plane;
        double sum = 0;
        for (int i = 0; i < 4; ++i) {
            const double left = std::floor(x - 0.5) + i % 2, top = std::floor(y - 0.5) + i / 2;
            const double weight = (1 - std::fabs(x - 0.5 - left)) * (1 - std::fabs(y - 0.5 - top));
            const bool inside = left >= 0 && top >= 0 && left < kSize.width && top < kSize.height;
            double depth = ndc_ ? 1 : 100 * f;
            if (inside && !std::isinf(g_.view_depth.at(static_cast<int>(left), static_cast<int>(top)))) {
                const int px = static_cast<int>(left), py = static_cast<int>(top);
                depth = static_cast<double>(ndc_ ? float_from_bits(g_.depth.codes.at(px, py))
                                                 : g_.view_depth.at(px, py));
            }
            sum += weight * depth;
        }
        sum *= 1 + move * kMoveDepth;
        return ndc_ ? n * f / (f - sum * (f - n)) : sum;
    }

    double sample(glm::dvec3 p, glm::dvec3 n, glm::dvec3 q, double move_x, double move_y,
                  double move_depth) const {
        if (q.z <= camera_.near_plane) return 0;
        const double x = (q.x / q.z / ray(1, 0).x + 1) / 2 * kSize.width,
                     y = (1 - q.y / q.z / tangent_y()) / 2 * kSize.height;
        const double r_z = depth_at(x + move_x * kMove_px, y + move_y * kMove_px, move_depth);
        const double dz = p.z - r_z;
        if (dz <= static_cast<double>(s_.epsilon)) return 0;
        const double start = s_.fade_start, end = s_.fade_end;
        const double occlusion = std::clamp((end - dz) / (end - start), 0.0, 1.0);
        const double dp = glm::dot(n, glm::normalize(r_z / q.z * q - p));
        return dp > 0 ? dp * occlusion : 0;
    }

    Camera camera_;
    const GBuffer& g_;
    const AoInputs& inputs_;
    const LunaSettings& s_;
    std::array<glm::vec3, kCubeVectors> offsets_;
    RandomMap map_;
    bool ndc_;
};

}  // namespace

TEST_CASE("the whole pass agrees with the formula in double to 1e-5") {
    for (const TutorialMethod& method : kTutorialMethods) {
        CAPTURE(method.name);
        const PreparedStillLife scene(method);
        const Reference reference(scene.scene, scene.g, scene.inputs, scene.settings);
        const Image<float> ao = luna_occlusion(scene.inputs, scene.settings, {}).ao;
        int surfaces = 0, occluded = 0, ambiguous = 0;
        CHECK(pixels_against(ao.size, [&](int x, int y) {
                  if (scene.inputs.view_depth.at(x, y) == kInfinity) return ao.at(x, y) == 1;
                  const double actual = ao.at(x, y);
                  const Interval expected = reference.accessibility(x, y);
                  ++surfaces;
                  occluded += actual < 0.9;
                  ambiguous += expected.high - expected.low > 2e-5;
                  return actual >= expected.low - 1e-5 && actual <= expected.high + 1e-5;
              }) == "");
        // The reference must have had something to say: shade, and few texels where rounding may decide.
        CHECK(surfaces > 800);
        CHECK(occluded > 50);
        CHECK(ambiguous * 10 < surfaces);
    }
}
