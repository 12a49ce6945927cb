// What a texel of the AO map shows of the four pixels around its centre, against the definitions in double.
#include "ssao/inputs/ao_inputs.h"

#include <algorithm>
#include <cmath>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include "tests/tools/ao_cases.h"
#include "tests/tools/image_checks.h"
#include "tests/tools/special_floats.h"
#include "tests/tools/still_life.h"
#include "tests/tools/tutorial_fetches.h"

using namespace crevice;

namespace {

struct Pixel {
    double weight, z, stored;  // view depth, or infinity; what the depth map holds
    glm::dvec3 p, n;
};
struct Texel {
    glm::dvec3 normal = glm::dvec3(0);
    double stored = 0, z = kInfinity;  // without a surface z stays infinite
    double magnified = 0;  // |terms| / |slope| of a carried depth: what its roundings are relative to
};

// The definitions of ao_inputs.h in double: the four pixels around a texel's centre, their mean, and the
// nearest surface.
class TexelReference {
 public:
    TexelReference(const GBuffer& g, const AoFetch& fetch, Size map, int column, int row)
        : size_(g.depth.size()), ndc_(fetch.depth == DepthSource::ndc_depth) {
        const double x = (column + 0.5) * size_.width / map.width,
                     y = (row + 0.5) * size_.height / map.height;
        ray_ = ray(x, y);
        for (int i = 0; i < 4; ++i) {
            const double x_tap = std::floor(x - 0.5) + i % 2, y_tap = std::floor(y - 0.5) + i / 2;
            const double weight = (1 - std::fabs(x - 0.5 - x_tap)) * (1 - std::fabs(y - 0.5 - y_tap));
            const int px = static_cast<int>(std::fmin(std::fmax(x_tap, 0), size_.width - 1));
            const int py = static_cast<int>(std::fmin(std::fmax(y_tap, 0), size_.height - 1));
            const double z = g.view_depth.at(px, py), code = float_from_bits(g.depth.codes.at(px, py));
            const bool sky = std::isinf(z);
            const glm::dvec3 cleared(0, 0, ndc_ ? 1 : -1);
            pixels_[i] = {weight, z, ndc_ ? code : (sky ? 1e4 : z), (sky ? 0 : z) * ray(px + 0.5, py + 0.5),
                          sky ? cleared : glm::dvec3(g.normal.at(px, py))};
        }
    }

    Texel mean() const {
        Texel texel;
        for (const Pixel& pixel : pixels_) {
            texel.normal += pixel.weight * pixel.n;
            texel.stored += pixel.weight * pixel.stored;
        }
        // near .5, far 100: ndc = (1 - near / z) far / (far - near)
        texel.z = ndc_ ? 50 / (100 - 99.5 * texel.stored) : texel.stored;
        return texel;
    }

    Texel nearest_or_mean() const {
        const Pixel& first = *std::min_element(pixels_, pixels_ + 4, [](const Pixel& a, const Pixel& b) {
            return (a.weight > 0 ? a.z : kInfinity) < (b.weight > 0 ? b.z : kInfinity);
        });
        if (std::isinf(first.z)) return {};
        const double pixel_width = 2 * kTangent / size_.height * first.z;
        bool one_surface = true;
        for (const Pixel& pixel : pixels_) {
            if (pixel.weight == 0) continue;
            one_surface = one_surface && !std::isinf(pixel.z) && glm::dot(first.n, pixel.n) >= 0.8 &&
                          std::fabs(glm::dot(first.n, pixel.p - first.p)) <= 2 * pixel_width;
        }
        if (one_surface) return mean();
        const double slope = glm::dot(first.n, ray_), carried = glm::dot(first.n, first.p) / slope;
        const bool usable = std::fabs(slope) > 0.05 && carried > 0;
        const double shift = glm::length(ray_) * std::fabs(carried - first.z);
        const double magnified = glm::length(first.n) * (glm::length(first.p) + shift) / std::fabs(slope);
        // Not behind what the depth map shows there.
        return {first.n, 0, std::fmin(usable ? carried : first.z, mean().z), usable ? magnified : 0};
    }

 private:
    static constexpr double kTangent = 0.57735026918962576;  // of half the field of view, 30 degrees

    glm::dvec3 ray(double x, double y) const {
        const double aspect = static_cast<double>(size_.width) / size_.height;
        return {(2 * x / size_.width - 1) * kTangent * aspect, (1 - 2 * y / size_.height) * kTangent, 1};
    }

    Size size_;
    bool ndc_;
    glm::dvec3 ray_;
    Pixel pixels_[4];
};

std::string against_reference(const GBuffer& g, const AoFetch& fetch) {
    const AoInputs inputs = ao_inputs(g, made_up_camera(), fetch);
    return pixels_against(inputs.size(), [&](int x, int y) {
        const TexelReference reference(g, fetch, inputs.size(), x, y);
        const Texel t =
            fetch.edge_texels == EdgeTexels::mixed ? reference.mean() : reference.nearest_or_mean();
        const double z = inputs.view_depth.at(x, y);
        if (std::isinf(t.z)) return z == t.z && inputs.normal.at(x, y) == glm::vec3(0);
        // Six roundings of an ndc depth near 1, magnified by dz/d(ndc) = z^2 (f - n) / (n f).
        const double from_ndc = fetch.depth == DepthSource::ndc_depth ? t.z * t.z * 2 * 6 / 16777216 : 0;
        const double bound = 1e-6 * (t.z + t.magnified) + from_ndc;
        const bool normal_holds =
            fetch.point_normals || glm::length(glm::dvec3(inputs.normal.at(x, y)) - t.normal) < 1e-6;
        return std::fabs(z - t.z) <= bound && normal_holds;
    });
}

}  // namespace

TEST_CASE("any size, with and without sky, against the definition in double") {
    for (const Size size : {Size{1, 1}, {1, 9}, {3, 5}, {37, 23}, {161, 7}, {26, 14}}) {
        for (const float sky : {0.0f, 0.3f}) {
            CAPTURE(size.width);
            CAPTURE(size.height);
            CAPTURE(sky);
            const GBuffer g = made_up_gbuffer(size, sky);
            CHECK(against_reference(g, kXjunFetch) == "");
            CHECK(against_reference(g, kLunaFetch) == "");
            CHECK(against_reference(g, published(kXjunFetch)) == "");
            CHECK(against_reference(g, published(kLunaFetch)) == "");
        }
    }
}

TEST_CASE("along every edge a texel shows one of the surfaces, not a mixture; as published it is mixed") {
    // Floor y = -1, wall z = 6, both axis-aligned, and sky.
    Scene scene = still_life();
    scene.instances.resize(2);
    const Size size = {63, 47};
    const GBuffer g = normal_depth(scene, scene.camera, size);
    for (const AoFetch& fetch : {kXjunFetch, kLunaFetch}) {
        const auto unlike_both = [&](const AoInputs& inputs) {
            int count = 0;
            for (int y = 0; y < inputs.size().height; ++y) {
                for (int x = 0; x < inputs.size().width; ++x) {
                    const float z = inputs.view_depth.at(x, y);
                    if (z == kInfinity) continue;
                    const double v = (y + 0.5) / inputs.size().height,
                                 per_depth = (1 - 2 * v) * 0.57735026918962576;
                    const glm::vec3 n = inputs.normal.at(x, y);
                    const auto faces = [&](glm::vec3 way) { return glm::length(n - way) < 1e-6f; };
                    const bool floor =
                        faces({0, 1, 0}) && std::fabs(static_cast<double>(z) * per_depth + 1) < 2e-2;
                    const bool wall = faces({0, 0, -1}) && std::fabs(z - 6) < 1e-4f;
                    count += !floor && !wall;
                }
            }
            return count;
        };
        CHECK(unlike_both(ao_inputs(g, scene.camera, fetch)) == 0);
        CHECK(unlike_both(ao_inputs(g, scene.camera, published(fetch))) > 20);
    }
}
