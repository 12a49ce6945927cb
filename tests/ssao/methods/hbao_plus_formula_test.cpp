// HBAO+ against an independent text of its formula.
#include <cmath>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include "ssao/inputs/pixel_fetch.h"
#include "ssao/methods/each_texel.h"
#include "ssao/methods/hbao_plus.h"
#include "ssao/methods/screen_rays.h"
#include "tests/tools/ao_cases.h"
#include "tests/tools/depth_map_points.h"
#include "tests/tools/listed_errors.h"

using namespace crevice;

namespace {

// The listing in double, with its errors or without.
class Listing {
 public:
    Listing(const AoInputs& inputs, const HbaoPlusSettings& settings)
        : inputs_(inputs),
          s_(settings),
          directions_(settings.samples / settings.steps),
          noise_(settings.seed, settings.turns == TurnFormat::unorm8 ? 3 : directions_) {}

    double accessibility(int x, int y) const {
        const TexelPoint<float> texel = texel_point<float>(inputs_, x, y);
        const glm::dvec3 p(texel.p.x, texel.p.y, texel.p.z), n(texel.n.x, texel.n.y, texel.n.z);
        const double radius = s_.radius, pictures = inputs_.picture.width, rows = inputs_.picture.height;
        const double wide = s_.projected_by == ProjectedBy::width ? pictures / rows : 1;
        const double spacing =
            wide * static_cast<double>(length_px(inputs_, s_.radius, texel.p.z)) / (s_.steps + 1);
        const double cosine = stored(noise_.cosine.at<float>(x, y)),
                     sine = stored(noise_.sine.at<float>(x, y));
        double sum = 0;
        for (int i = 0; i < directions_; ++i) {
            const glm::dvec2 d = direction(i), turned(d.x * cosine - d.y * sine, d.x * sine + d.y * cosine);
            for (int step = 0; step < s_.steps; ++step) {
                const double along = (step + stored(noise_.shift.at<float>(x, y))) * spacing + 1;
                const glm::dvec3 v =
                    surface_at(inputs_, texel.at.x + along * turned.x, texel.at.y - along * turned.y) - p;
                double squared = glm::dot(v, v);
                if (s_.near_samples == NearSamples::clamped)
                    squared = std::fmax(squared, radius * radius / 64);
                const double facing = glm::dot(n, v) / std::sqrt(squared) - static_cast<double>(s_.bias);
                sum += std::fmax(facing, 0.0) * std::fmax(1 - squared / (radius * radius), 0.0);
            }
        }
        return 1 - 2 / (1 - static_cast<double>(s_.bias)) * sum / s_.samples;
    }

 private:
    double stored(float part) const {
        if (s_.turns == TurnFormat::float32) return part;
        return std::floor(255 * std::fmax(static_cast<double>(part), 0.0) + 0.5) / 255;
    }
    glm::dvec2 direction(int i) const {
        if (s_.table == RayTable::listed && i >= 3) return {0, 1};
        const double angle = 2 * kPi * i / (s_.table == RayTable::listed ? 3 : directions_);
        return {std::cos(angle), std::sin(angle)};
    }
    const AoInputs& inputs_;
    HbaoPlusSettings s_;
    int directions_;
    RayNoise noise_;
};

}  // namespace

TEST_CASE("hbao_plus: a texel's formula, evaluated in double, with each error and without") {
    const PreparedStillLife still(kTutorialMethods[0]);
    std::vector<NamedChange> changes(std::begin(kListedErrors), std::end(kListedErrors));
    changes.push_back({"none", [](HbaoPlusSettings&) {}});
    changes.push_back({"bias", [](HbaoPlusSettings& s) { s.bias = 0.2f; }});
    for (const NamedChange& change : changes) {
        CAPTURE(std::string(change.name));
        HbaoPlusSettings settings{.samples = 15, .steps = 3, .ao_scale = 1};
        change.change(settings);
        const AoInputs inputs = ao_inputs(still.g, still.scene.camera, pixel_fetch(settings));
        const Image<float> ao = hbao_plus(inputs, settings).ao;
        const Listing listing(inputs, settings);
        int texels = 0, exact = 0, dark = 0;
        for (int y = 1; y < inputs.size().height; y += 2) {
            for (int x = 1; x < inputs.size().width; x += 3) {
                if (inputs.view_depth.at(x, y) == kInfinity) continue;
                const double expected = std::fmin(std::fmax(listing.accessibility(x, y), 0.0), 1.0);
                ++texels;
                exact += std::fabs(static_cast<double>(ao.at(x, y)) - expected) < 1e-4 ? 1 : 0;
                dark += expected < 0.9 ? 1 : 0;
            }
        }
        CHECK(texels > 200);
        CHECK(dark > 10);
        CHECK(exact > 0.97 * texels);  // a sample may fall to either side of a border between two pixels
    }
}
