#include "rasterizer/draw/texture_colour.h"

#include <cstdint>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

using namespace crevice;

namespace {

constexpr int kPixels = 8;

Texture varied_texture() {
    Image3 base({16, 16}, glm::vec3(0));
    Image<float> alpha({16, 16}, 0.0f);
    for (int y = 0; y < 16; ++y) {
        for (int x = 0; x < 16; ++x) {
            base.set(x, y, glm::vec3(x * 5 % 16, y * 7 % 16, (x + y) % 16) / 15.0f);
            alpha.at(x, y) = static_cast<float>(x * y % 16) / 15;
        }
    }
    return build_texture(base, alpha);
}

// The pixels of a group from `first` on, every third of which is not the fragment's.
template <class F>
TextureCoordinates<F> coordinates(int first) {
    const F i = to_float(lane_index<F>() + Int<F>(first));
    std::int32_t wanted[kLanes<F>];
    for (int lane = 0; lane < kLanes<F>; ++lane) wanted[lane] = (first + lane) % 3 == 0 ? 0 : 1;
    return {{F(0.37f) * i, F(0.11f) * i},
            {F(0.013f) * i, F(0.02f)},
            {F(-0.1f), F(0.3f) * i},
            load<F>(wanted) == Int<F>(1)};
}

// A normal map that is everywhere the same.
Vec3<float> normal_from(glm::vec3 encoded) {
    TextureCoordinates<float> at = coordinates<float>(1);
    return mapped_normal<float>(build_texture(Image3({2, 2}, encoded)), Sampler{}, at).n_tangent;
}

}  // namespace

TEST_CASE("texture_colour: eight lanes are eight times one, and only the fragment's are sampled") {
    const Texture texture = varied_texture();
    for (const TextureFilter filter :
         {TextureFilter::point, TextureFilter::trilinear, TextureFilter::anisotropic}) {
        Sampler sampler;
        sampler.filter = filter;
        const TextureColour<Wide<8>> wide =
            texture_colour<Wide<8>>(texture, sampler, coordinates<Wide<8>>(0));
        for (int i = 0; i < kPixels; ++i) {
            CAPTURE(i);
            const TextureCoordinates<float> at = coordinates<float>(i);
            const TextureColour<float> one = texture_colour<float>(texture, sampler, at);
            const glm::vec4 sampled =
                i % 3 == 0 ? glm::vec4(0)
                           : sample_texture(texture, sampler, {at.uv.x, at.uv.y}, {at.duv_dx.x, at.duv_dx.y},
                                            {at.duv_dy.x, at.duv_dy.y});
            CHECK(glm::vec4(one.colour.x, one.colour.y, one.colour.z, one.alpha) == sampled);
            CHECK(glm::vec4(wide.colour.x[i], wide.colour.y[i], wide.colour.z[i], wide.alpha[i]) == sampled);
        }
    }
}

TEST_CASE("colour_and_normal: what colour and normal are alone, of one size and of two") {
    const Texture texture = varied_texture();
    const TextureCoordinates<float> at = coordinates<float>(4);
    for (const int side : {16, 8}) {
        CAPTURE(side);
        Image3 base({side, side}, glm::vec3(0.5f, 0.5f, 1));
        base.set(3, 2, {0.9f, 0.5f, 0.8f});
        const Texture map = build_texture(base, Image<float>({side, side}, 0.25f));
        const ColourAndNormal<float> both = colour_and_normal<float>(texture, map, Sampler{}, at);
        const TextureColour<float> colour = texture_colour<float>(texture, Sampler{}, at);
        const MappedNormal<float> normal = mapped_normal<float>(map, Sampler{}, at);
        CHECK(both.colour.colour.x == colour.colour.x);
        CHECK(both.colour.alpha == colour.alpha);
        CHECK(both.normal.n_tangent.x == normal.n_tangent.x);
        CHECK(both.normal.n_tangent.z == normal.n_tangent.z);
        CHECK(both.normal.shininess_factor == 0.25f);
    }
}

TEST_CASE("mapped_normal: red is along u, green along v, blue out; it is unit") {
    const auto is = [](Vec3<float> n, glm::vec3 wanted) {
        return glm::length(glm::vec3(n.x, n.y, n.z) - wanted) < 1e-6f;
    };
    CHECK(is(normal_from({0.5f, 0.5f, 1}), {0, 0, 1}));
    CHECK(is(normal_from({1, 0.5f, 0.5f}), {1, 0, 0}));
    CHECK(is(normal_from({0.5f, 1, 0.5f}), {0, 1, 0}));
    CHECK(is(normal_from({0.8f, 0.5f, 0.9f}), {0.6f, 0, 0.8f}));
    CHECK(is(normal_from({0.65f, 0.5f, 0.7f}), {0.6f, 0, 0.8f}));  // shortened by a filter
    CHECK(is(normal_from({0.5f, 0.5f, 0.5f}), {0, 0, 1}));         // averaged away
}

TEST_CASE("mapped_normal: alpha is the shininess factor, 1 where there is none") {
    const Image3 flat({2, 2}, glm::vec3(0.5f, 0.5f, 1));
    const TextureCoordinates<float> at = coordinates<float>(1);
    CHECK(mapped_normal<float>(build_texture(flat), Sampler{}, at).shininess_factor == 1);
    CHECK(mapped_normal<float>(build_texture(flat, Image<float>({2, 2}, 0.25f)), Sampler{}, at)
              .shininess_factor == 0.25f);
}
