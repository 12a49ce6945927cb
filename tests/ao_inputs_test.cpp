#include "ssao/ao_inputs.h"

#include <algorithm>
#include <cmath>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include "rasterizer/error.h"
#include "rasterizer/image_summary.h"
#include "tests/test_scenes.h"

using namespace crevice;

namespace {

const AoFetch kXjunFetch = {DepthSource::view_depth, false, 0.5f, false};
const AoFetch kLunaFetch = {DepthSource::ndc_depth, true, 0.5f, false};

Camera near_camera() {
    Camera camera = still_life().camera;
    camera.near_plane = 0.5;
    camera.far_plane = 100;
    return camera;
}

// Unlike values in every pixel, all of them multiples of 1/64, so that the sum of four is exact; `sky_share` of them sky.
GBuffer made_up(Size size, float sky_share) {
    const Camera camera = near_camera();
    const CameraMatrices m = camera_matrices(camera, size);
    GBuffer g{Image3(size, glm::vec3(0)), Image<float>(size, kInfinity), cleared_depth(size, DepthFormat::d32f, false)};
    const auto dyadic = [](float a) { return std::floor(a * 64) / 64; };
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
            if (noise(1, x, y) < sky_share) continue;
            const float z = 2 + dyadic(8 * noise(2, x, y));
            g.view_depth.at(x, y) = z;
            g.depth.codes.at(x, y) = depth_code(DepthFormat::d32f, m.depth_a + m.depth_b / z, 0.0);
            g.normal.set(x, y, {dyadic(noise(3, x, y)), dyadic(noise(4, x, y)) - 0.5f, -dyadic(noise(5, x, y)) - 0.25f});
        }
    }
    return g;
}

AoFetch published(AoFetch fetch) {
    fetch.as_published = true;
    return fetch;
}

struct Pixel {
    double weight, z, stored;  // view depth, or infinity; what the depth map holds
    glm::dvec3 p, n;
};
struct Texel {
    glm::dvec3 normal = glm::dvec3(0);
    double stored = 0, z = kInfinity;  // without a surface z stays infinite
    double magnified = 0;              // |terms| / |slope| of a carried depth: what its roundings are relative to
};

// The definitions of ao_inputs.h in double: the four pixels around a texel's centre, their mean, and the nearest surface.
class TexelReference {
   public:
    TexelReference(const GBuffer& g, const AoFetch& fetch, Size map, int column, int row)
        : size_(g.depth.size()), ndc_(fetch.depth == DepthSource::ndc_depth) {
        const double x = (column + 0.5) * size_.width / map.width, y = (row + 0.5) * size_.height / map.height;
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
        return {first.n, 0, usable ? carried : first.z, usable ? magnified : 0};
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
    const AoInputs inputs = ao_inputs(g, near_camera(), fetch);
    return pixels_against(inputs.size(), [&](int x, int y) {
        const TexelReference reference(g, fetch, inputs.size(), x, y);
        const Texel t = fetch.as_published ? reference.mean() : reference.nearest_or_mean();
        const double z = inputs.view_depth.at(x, y);
        if (std::isinf(t.z)) return z == t.z && inputs.normal.at(x, y) == glm::vec3(0);
        // Six roundings of an ndc depth near 1, magnified by dz/d(ndc) = z^2 (f - n) / (n f).
        const double from_ndc = fetch.depth == DepthSource::ndc_depth ? t.z * t.z * 2 * 6 / 16777216 : 0;
        const double bound = 1e-6 * (t.z + t.magnified) + from_ndc;
        const bool normal_holds = fetch.point_normals || glm::length(glm::dvec3(inputs.normal.at(x, y)) - t.normal) < 1e-6;
        return std::fabs(z - t.z) <= bound && normal_holds;
    });
}

}  // namespace

TEST_CASE("ao map size: half rounded up, or full; anything else is refused by name") {
    CHECK(ao_map_size({801, 601}, 0.5f) == Size{401, 301});
    CHECK(ao_map_size({1280, 720}, 0.5f) == Size{640, 360});
    CHECK(ao_map_size({1, 1}, 0.5f) == Size{1, 1});
    CHECK(ao_map_size({32768, 1}, 0.5f) == Size{16384, 1});
    CHECK(ao_map_size({801, 601}, 1) == Size{801, 601});
    for (const float scale : {0.0f, 0.25f, 2.0f, -0.5f, kNan, kInfinity}) {
        CAPTURE(scale);
        CHECK_THROWS_WITH_AS(ao_map_size({8, 8}, scale), doctest::Contains("--ao-scale"), UsageError);
    }
}

TEST_CASE("an even size gives exactly the mean of 2 x 2 pixels: as published always, else where they show one surface") {
    const auto is_mean = [](const GBuffer& g, const AoInputs& inputs) {
        return pixels_against(inputs.size(), [&](int x, int y) {
            const auto mean = [&](const Image<float>& a) {
                return (a.at(2 * x, 2 * y) + a.at(2 * x + 1, 2 * y) + a.at(2 * x, 2 * y + 1) + a.at(2 * x + 1, 2 * y + 1)) / 4;
            };
            return inputs.view_depth.at(x, y) == mean(g.view_depth) &&
                   inputs.normal.at(x, y) == glm::vec3(mean(g.normal.x), mean(g.normal.y), mean(g.normal.z));
        });
    };
    GBuffer g = made_up({26, 14}, 0);
    CHECK(is_mean(g, ao_inputs(g, near_camera(), published(kXjunFetch))) == "");
    // One bumpy surface: depths and normals differ by a few of their steps.
    for (float& z : g.view_depth.pixels) z = 4 + std::floor(8 * (z - 2)) / 512;
    for (Image<float>* axis : {&g.normal.x, &g.normal.y}) {
        for (float& n : axis->pixels) n /= 8;
    }
    for (float& n : g.normal.z.pixels) n = -1;
    CHECK(is_mean(g, ao_inputs(g, near_camera(), kXjunFetch)) == "");
}

TEST_CASE("any size, with and without sky, against the definition in double") {
    for (const Size size : {Size{1, 1}, {1, 9}, {3, 5}, {37, 23}, {161, 7}, {26, 14}}) {
        for (const float sky : {0.0f, 0.3f}) {
            CAPTURE(size.width);
            CAPTURE(size.height);
            CAPTURE(sky);
            const GBuffer g = made_up(size, sky);
            CHECK(against_reference(g, kXjunFetch) == "");
            CHECK(against_reference(g, kLunaFetch) == "");
            CHECK(against_reference(g, published(kXjunFetch)) == "");
            CHECK(against_reference(g, published(kLunaFetch)) == "");
        }
    }
}

TEST_CASE("along every edge of a scene a texel shows one of its surfaces, not a mixture; as published it is mixed") {
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
                    const double v = (y + 0.5) / inputs.size().height, per_depth = (1 - 2 * v) * 0.57735026918962576;
                    const glm::vec3 n = inputs.normal.at(x, y);
                    const auto faces = [&](glm::vec3 way) { return glm::length(n - way) < 1e-6f; };
                    const bool floor = faces({0, 1, 0}) && std::fabs(static_cast<double>(z) * per_depth + 1) < 2e-2;
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

TEST_CASE("scale 1 gives the pixel itself") {
    GBuffer g = made_up({37, 23}, 0.2f);
    AoFetch fetch = kXjunFetch;
    fetch.scale = 1;
    const AoInputs inputs = ao_inputs(g, near_camera(), fetch);
    CHECK(content_hash(inputs.view_depth) == content_hash(g.view_depth));
    CHECK(content_hash(inputs.normal) == content_hash(g.normal));
}

TEST_CASE("point-sampled normals: the pixel whose cell holds the texel's centre, brought to length 1") {
    GBuffer g = made_up({26, 14}, 0);
    for (int y = 0; y < 14; ++y) {
        for (int x = 0; x < 26; ++x) g.normal.set(x, y, 1.1f * glm::normalize(g.normal.at(x, y)));
    }
    const AoInputs half = ao_inputs(g, near_camera(), published(kLunaFetch));
    CHECK(pixels_against(half.size(), [&](int x, int y) {
              const glm::vec3 expected = glm::normalize(g.normal.at(2 * x + 1, 2 * y + 1));
              return glm::length(half.normal.at(x, y) - expected) < 3e-7f;
          }) == "");
    AoFetch fetch = kLunaFetch;
    fetch.scale = 1;
    const AoInputs full = ao_inputs(g, near_camera(), fetch);
    CHECK(pixels_against(full.size(), [&](int x, int y) {
              return glm::length(full.normal.at(x, y) - glm::normalize(g.normal.at(x, y))) < 3e-7f;
          }) == "");
}

TEST_CASE("nothing but sky: no surface; as published the tutorials' clear values") {
    const GBuffer g = made_up({2, 2}, 2);
    for (const AoFetch& fetch : {kXjunFetch, kLunaFetch}) {
        const AoInputs inputs = ao_inputs(g, near_camera(), fetch);
        CHECK(inputs.view_depth.at(0, 0) == kInfinity);
        CHECK(inputs.normal.at(0, 0) == glm::vec3(0));
    }
    // Seed 000 clears to normal (0, 0, -1) and a depth beyond the far plane, seed 002 to normal (0, 0, 1) and the far plane.
    const AoInputs xjun = ao_inputs(g, near_camera(), published(kXjunFetch));
    CHECK(xjun.normal.at(0, 0) == glm::vec3(0, 0, -1));
    CHECK(xjun.view_depth.at(0, 0) == 100 * 100);
    const AoInputs luna = ao_inputs(g, near_camera(), published(kLunaFetch));
    CHECK(luna.normal.at(0, 0) == glm::vec3(0, 0, 1));
    CHECK(std::fabs(luna.view_depth.at(0, 0) - 100) < 0.1f);
}

TEST_CASE("depth map: the picture shifted by one, around it and in the sky the far value") {
    const Size size = {5, 3};
    GBuffer g = made_up(size, 0.3f);
    Camera camera = near_camera();
    for (const bool reversed : {false, true}) {
        camera.reversed_z = reversed;
        if (reversed) {
            for (std::int32_t& code : g.depth.codes.pixels) code = depth_code(DepthFormat::d32f, 1 - float_from_bits(code), 0.0);
        }
        for (const AoFetch& fetch : {kXjunFetch, kLunaFetch}) {
            CAPTURE(reversed);
            const bool ndc = fetch.depth == DepthSource::ndc_depth;
            CAPTURE(ndc);
            const Image<float> map = ao_inputs(g, camera, fetch).depth_map;
            REQUIRE(map.size == Size{8, 6});
            const float far = ndc ? (reversed ? 0.0f : 1.0f) : 100 * 100.0f;
            CHECK(pixels_against(map.size, [&](int x, int y) {
                      const bool inside = x >= 1 && x <= size.width && y >= 1 && y <= size.height;
                      if (!inside || std::isinf(g.view_depth.at(x - 1, y - 1))) return map.at(x, y) == far;
                      return map.at(x, y) == (ndc ? float_from_bits(g.depth.codes.at(x - 1, y - 1)) : g.view_depth.at(x - 1, y - 1));
                  }) == "");
        }
    }
}

TEST_CASE("every depth format and projection sees the depths that the rasterizer wrote") {
    const Size size = {64, 48};
    for (const bool ortho : {false, true}) {
        for (const DepthFormat format : {DepthFormat::d24, DepthFormat::d32f}) {
            for (const bool reversed : {false, true}) {
                CAPTURE(ortho);
                CAPTURE(static_cast<int>(format));
                CAPTURE(reversed);
                Scene scene = still_life();
                scene.camera.projection = ortho ? Projection::orthographic : Projection::perspective;
                scene.camera.ortho_height = 5;
                scene.camera.reversed_z = reversed;
                NormalDepthSettings settings;
                settings.depth_format = format;
                const GBuffer g = normal_depth(scene, scene.camera, size, settings);
                AoFetch fetch = kLunaFetch;
                fetch.scale = 1;
                // D24 near z = 8 has steps of 8^2 / 0.5 / 2^24; float32 rounds about as much a few times over.
                CHECK(further_apart_than(5e-5, ao_inputs(g, scene.camera, fetch).view_depth, g.view_depth) == "");
            }
        }
    }
}
