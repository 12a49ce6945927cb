// The filter kernel against a filter that is as plain as can be, bit for bit: at every filter, address
// mode and size, one lane, eight lanes and two textures at once, for every instruction set of this
// machine.
#include "rasterizer/textures/sample_texture.h"

#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <vector>

#include <doctest/doctest.h>
#include <glm/vec2.hpp>

#include "tests/tools/every_run.h"
#include "tests/tools/plain_texture_filter.h"
#include "tests/tools/special_floats.h"

using namespace crevice;

namespace {

constexpr AddressMode kModes[] = {AddressMode::wrap, AddressMode::clamp, AddressMode::border};
constexpr TextureFilter kFilters[] = {TextureFilter::point, TextureFilter::bilinear, TextureFilter::trilinear,
                                      TextureFilter::anisotropic};
constexpr int kLaneCount = kMostLanes;

// Small numbers from a sequence that is the same on every machine.
struct Numbers {
    std::uint32_t state = 1;
    std::uint32_t bits() {
        state = state * 1664525u + 1013904223u;
        return state >> 8;
    }
    float unit() { return static_cast<float>(bits()) / 16777216.0f; }
    float between(float low, float high) { return low + unit() * (high - low); }
};

Texture random_texture(Size size, bool with_alpha, std::uint32_t seed) {
    Numbers random{seed};
    Image3 base(size, glm::vec3(0));
    Image<float> alpha(size, 0.0f);
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
            base.set(x, y, {random.unit(), random.unit(), random.unit()});
            alpha.at(x, y) = random.unit();
        }
    }
    return build_texture(base, with_alpha ? alpha : Image<float>());
}

using Pixels = SampledPixels;

// Of kLaneCount pixels, as many at a time as the run has lanes.
struct Answers {
    float channel[4][kLaneCount];

    glm::vec4 of(int lane) const {
        return {channel[0][lane], channel[1][lane], channel[2][lane], channel[3][lane]};
    }
    void put(int first, int count, const SampledColours& colours) {
        for (int i = 0; i < count; ++i) {
            channel[0][first + i] = colours.r[i];
            channel[1][first + i] = colours.g[i];
            channel[2][first + i] = colours.b[i];
            channel[3][first + i] = colours.a[i];
        }
    }
};

Pixels from_lane(const Pixels& p, int first) {
    Pixels moved{};
    for (int i = 0; first + i < kLaneCount; ++i) {
        const auto from = static_cast<std::size_t>(first + i), to = static_cast<std::size_t>(i);
        moved.u[to] = p.u[from], moved.v[to] = p.v[from];
        moved.du_dx[to] = p.du_dx[from], moved.dv_dx[to] = p.dv_dx[from];
        moved.du_dy[to] = p.du_dy[from], moved.dv_dy[to] = p.dv_dy[from];
        moved.wanted[to] = p.wanted[from];
    }
    return moved;
}

// Two textures, each alone and both at once.
struct SampledBoth {
    Answers alone[2], together[2];
};

SampledBoth sample(const Texture& a, const Texture& b, const Sampler& sampler, const Pixels& pixels,
                   const Run& run) {
    SampledBoth result{};
    const int lanes = lane_count(run);
    for (int first = 0; first < kLaneCount; first += lanes) {
        const Pixels group = from_lane(pixels, first);
        const Texture* const both[2] = {&a, &b};
        SampledColours colours[2];
        for (std::size_t k = 0; k < 2; ++k) {
            sample_textures(std::span(both + k, 1), sampler, group, colours, run);
            result.alone[k].put(first, lanes, colours[0]);
        }
        sample_textures(both, sampler, group, colours, run);
        for (std::size_t k = 0; k < 2; ++k) result.together[k].put(first, lanes, colours[k]);
    }
    return result;
}

void check_pixels(const Texture& a, const Texture& b, const Sampler& sampler, const Pixels& pixels) {
    for (const Run& run : every_run()) {
        const SampledBoth sampled = sample(a, b, sampler, pixels, run);
        for (int lane = 0; lane < kLaneCount; ++lane) {
            const glm::vec2 uv(pixels.u[lane], pixels.v[lane]), dx(pixels.du_dx[lane], pixels.dv_dx[lane]),
                dy(pixels.du_dy[lane], pixels.dv_dy[lane]);
            for (int k = 0; k < 2; ++k) {
                const Texture& texture = k == 0 ? a : b;
                const glm::vec4 expected = pixels.wanted[lane] != 0
                                               ? plain_filter(TexelsInUnits{texture}, sampler, uv, dx, dy)
                                               : glm::vec4(0);
                const auto n = static_cast<std::size_t>(k);
                if (sampled.alone[n].of(lane) == expected && sampled.together[n].of(lane) == expected)
                    continue;
                INFO(run_text(run), ", lane ", lane, ", texture ", k, " of ", texture.size().width, " x ",
                     texture.size().height, ", filter ", static_cast<int>(sampler.filter), ", address ",
                     static_cast<int>(sampler.address_u), " ", static_cast<int>(sampler.address_v), ", uv ",
                     uv.x, " ", uv.y, ", steps ", dx.x, " ", dx.y, " ", dy.x, " ", dy.y);
                for (int c = 0; c < 4; ++c) {
                    CHECK(sampled.alone[n].of(lane)[c] == expected[c]);
                    CHECK(sampled.together[n].of(lane)[c] == expected[c]);
                }
            }
        }
    }
}

// Neighbours on a surface: coordinates in an affine row, steps alike; some not wanted.
Pixels neighbours(Numbers& random, float longest_step) {
    Pixels p;
    const float u = random.between(-2, 3), v = random.between(-2, 3);
    const float du_dx = random.between(-longest_step, longest_step), dv_dy = random.between(0, longest_step);
    for (int lane = 0; lane < kLaneCount; ++lane) {
        const auto i = static_cast<float>(lane);
        p.u[lane] = u + i * du_dx;
        p.v[lane] = v + 0.1f * i * dv_dy;
        p.du_dx[lane] = du_dx * (1 + 0.2f * i * random.unit());
        p.dv_dx[lane] = 0.1f * dv_dy;
        p.du_dy[lane] = random.between(-0.01f, 0.01f);
        p.dv_dy[lane] = dv_dy;
        p.wanted[lane] = random.unit() < 0.85f ? 1 : 0;
    }
    return p;
}

// Anything in every lane.
Pixels strangers(Numbers& random) {
    static constexpr float odd[] = {0,          -0.0f,      1,        -1e-9f,      1 - 0x1p-24f, 0x1p23f + 1,
                                    -0x1p22f,   0.5f,       1e30f,    -3e38f,      kNan,         kInfinity,
                                    -kInfinity, 16777217.f, -0.3333f, 1 + 0x1p-23f};
    const auto any_number = [&] {
        return random.unit() < 0.3f ? odd[random.bits() % std::size(odd)] : random.between(-1.5f, 2.5f);
    };
    Pixels p;
    for (int lane = 0; lane < kLaneCount; ++lane) {
        for (float* value : {p.u, p.v, p.du_dx, p.dv_dx, p.du_dy, p.dv_dy}) value[lane] = any_number();
        p.wanted[lane] = random.unit() < 0.7f ? 1 : 0;
    }
    return p;
}

}  // namespace

TEST_CASE("texture probes: every filter, address mode and size gives the plain filter's bits") {
    Numbers random;
    const Size sizes[] = {{1, 1}, {1, 7}, {9, 1}, {2, 2}, {5, 3}, {16, 16}, {64, 8}, {33, 17}};
    for (const Size size : sizes) {
        const Texture colour = random_texture(size, false, 7), with_alpha = random_texture(size, true, 8),
                      of_other_size = random_texture({size.height, size.width + 1}, true, 9);
        for (const TextureFilter filter : kFilters) {
            for (const AddressMode u : kModes) {
                for (const AddressMode v : kModes) {
                    const Sampler sampler{
                        filter, 1 + static_cast<int>(random.bits() % 16), u, v, {0.25f, 0.5f, 0.125f, 0.75f}};
                    check_pixels(colour, with_alpha, sampler, neighbours(random, 0.02f));
                    check_pixels(with_alpha, of_other_size, sampler, neighbours(random, 0.5f));
                    check_pixels(colour, with_alpha, sampler, strangers(random));
                }
            }
        }
    }
}

TEST_CASE("texture probes: lanes of many levels and probe counts do not disturb each other") {
    Numbers random{3};
    const Texture colour = random_texture({64, 64}, false, 1), map = random_texture({64, 64}, true, 2);
    for (const TextureFilter filter : kFilters) {
        Sampler sampler;
        sampler.filter = filter;
        for (int i = 0; i < 30; ++i) {
            Pixels p = neighbours(random, 0.01f);
            for (int lane = 0; lane < kLaneCount; ++lane) {
                p.du_dx[lane] = std::ldexp(random.between(1, 2), static_cast<int>(random.bits() % 9) - 8);
            }
            check_pixels(colour, map, sampler, p);
        }
    }
}

TEST_CASE("texture probes: lanes that are not wanted are 0, whatever stands in them") {
    const Texture texture = random_texture({8, 8}, true, 5);
    for (const TextureFilter filter : kFilters) {
        Sampler sampler;
        sampler.filter = filter;
        for (const float odd : {kNan, kInfinity, -kInfinity, 3e38f, 0.25f}) {
            Pixels p{};
            for (int lane = 0; lane < kLaneCount; ++lane) {
                p.u[lane] = p.v[lane] = p.du_dx[lane] = p.dv_dy[lane] = lane == 5 ? 0.3f : odd;
                p.wanted[lane] = lane == 5 ? 1 : 0;
            }
            CAPTURE(odd);
            check_pixels(texture, texture, sampler, p);
            p.wanted[5] = 0;
            check_pixels(texture, texture, sampler, p);
        }
    }
}
