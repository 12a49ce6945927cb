#include "scenes/procedural_sky.h"

#include "rasterizer/lanes/vec3.h"
#include "rasterizer/textures/paint_cube_map.h"
#include "scenes/composing.h"
#include "scenes/lattice_hash.h"

namespace crevice {

namespace {

constexpr int kOctaves = 6;

// [0,1], of a lattice point.
template <class F>
CREVICE_INLINE F lattice_value(std::uint32_t seed, Int<F> x, Int<F> y) {
    HashBits<Int<F>> column(x), row(y);
    column.v += seed;
    column = mixed(column);
    column.v += row.v * 0x9e3779b9u;
    return from_int<F>(mixed(column).upper(24)) * F(1.0f / 16777216);
}

template <class F>
CREVICE_INLINE F smooth(F t) {
    return t * t * (F(3) - F(2) * t);
}
template <class F>
CREVICE_INLINE F smooth_step(float low, float high, F a) {
    return smooth(saturate((a - F(low)) / F(high - low)));
}
template <class F>
CREVICE_INLINE Vec3<F> blend(Vec3<F> a, Vec3<F> b, F t) {
    return a + t * (b - a);
}
template <class F>
CREVICE_INLINE Vec3<F> blend(const glm::vec3& a, const glm::vec3& b, F t) {
    return blend(spread<F>(a), spread<F>(b), t);
}

// In [0,1], continuous with its slope.
template <class F>
CREVICE_INLINE F value_noise(std::uint32_t seed, F x, F y) {
    const Int<F> x0 = floor_to_int(x), y0 = floor_to_int(y), x1 = x0 + Int<F>(1), y1 = y0 + Int<F>(1);
    const F fx = smooth(x - from_int<F>(x0)), fy = smooth(y - from_int<F>(y0));
    return mix(mix(lattice_value<F>(seed, x0, y0), lattice_value<F>(seed, x1, y0), fx),
               mix(lattice_value<F>(seed, x0, y1), lattice_value<F>(seed, x1, y1), fx), fy);
}

// Octaves of it, each twice as fine and half as strong, turned by 3:4:5 so that their lattices do not line
// up. [0,1]; where it is below `least`, it may be 0 instead.
template <class F>
CREVICE_INLINE F cloud_noise(std::uint32_t seed, F x, F y, float least, Mask<F> wanted) {
    constexpr float total = 1 - 1.0f / (1 << kOctaves);
    F sum(0);
    float weight = 0.5f;
    Mask<F> left = wanted;
    for (int octave = 0; octave < kOctaves; ++octave) {
        sum = sum + F(weight) * value_noise(seed + static_cast<std::uint32_t>(octave), x, y);
        weight *= 0.5f;
        // All the octaves to come weigh less than 2 * weight: a clear sky is soon known.
        left = left & (sum + F(2 * weight) >= F(least * total));
        if (!any(left)) break;
        const F turned_x = F(1.2f) * x - F(1.6f) * y + F(17.3f);
        y = F(1.6f) * x + F(1.2f) * y - F(5.7f);
        x = turned_x;
    }
    return select(left, sum / F(total), F(0));
}

template <class F>
CREVICE_INLINE Vec3<F> clear_sky(const SkyLook& look, F up) {
    const F low = F(1) - saturate(up), low2 = low * low, low4 = low2 * low2;
    return blend(blend(look.zenith, look.middle, low2), spread<F>(look.horizon), low4 * low4);
}

template <class F>
CREVICE_INLINE Vec3<F> with_sun(const SkyLook& look, Vec3<F> colour, F to_sun_cosine) {
    F near_sun = F(0.5f) * (F(1) + max_of(to_sun_cosine, F(-1)));
    for (int i = 0; i < 3; ++i) near_sun = near_sun * near_sun;  // ^8: a wide glow
    const F wide = near_sun;
    for (int i = 0; i < 5; ++i) near_sun = near_sun * near_sun;  // ^256: a narrow one
    const float rim = 0.15f * (1 - look.sun_cosine);
    const F disc = smooth_step(look.sun_cosine - rim, look.sun_cosine + rim, to_sun_cosine);
    const F glow = F(0.25f) * wide + F(0.75f) * near_sun;
    return blend(colour + glow * spread<F>(look.glow), spread<F>(look.sun), disc);
}

// A layer one unit above the eye, bent down towards the horizon so that it ends somewhere.
template <class F>
CREVICE_INLINE Vec3<F> with_clouds(const SkyLook& look, Vec3<F> colour, Vec3<F> d) {
    const Mask<F> above = d.y > F(0);
    if (!any(above)) return colour;
    const F reach = F(look.cloud_scale) / (max_of(d.y, F(0)) + F(0.12f));
    const F x = d.x * reach, y = d.z * reach;
    const float threshold = 0.75f - 0.55f * look.cloud_cover;
    const F density = cloud_noise(look.seed, x, y, threshold, above);
    const F opacity = smooth_step(threshold, threshold + 0.22f, density) * smooth_step(0.0f, 0.16f, d.y);
    const Mask<F> cloudy = above & (opacity > F(0));
    if (!any(cloudy)) return colour;
    // Lit where the layer is thinner towards the sun.
    const F towards_sun =
        cloud_noise(look.seed, x + F(0.3f * look.to_sun.x), y + F(0.3f * look.to_sun.z), 0, cloudy);
    const F bright = saturate(F(0.6f) + F(3) * (density - towards_sun) - F(0.9f) * (density - F(threshold)));
    const Vec3<F> cloud = blend(look.cloud_dark, look.cloud_bright, bright);
    return select<F>(cloudy, blend(colour, cloud, F(0.9f) * opacity), colour);
}

template <class F>
CREVICE_INLINE Vec3<F> colour_towards(const SkyLook& look, Vec3<F> direction) {
    const F cosine = dot(direction, spread<F>(look.to_sun));
    // Half a degree of blur hides where sky and ground meet.
    const F above = smooth_step(-0.008f, 0.008f, direction.y);
    const F far = F(1) - saturate(F(0) - direction.y), far2 = far * far, far4 = far2 * far2;
    const Vec3<F> ground =
        select<F>(above < F(1), blend(look.ground, look.ground_far, far4 * far4), spread<F>(look.ground));
    const Vec3<F> clear = with_sun(look, clear_sky(look, direction.y), cosine);
    const Vec3<F> sky = select<F>(above > F(0), with_clouds(look, clear, direction), spread<F>(look.horizon));
    return blend(ground, sky, above);
}

}  // namespace

SkyLook desert_look() {
    return {.zenith = {0.10f, 0.24f, 0.58f},
            .middle = {0.28f, 0.46f, 0.76f},
            .horizon = {0.80f, 0.76f, 0.66f},
            .ground = {0.46f, 0.33f, 0.19f},
            .ground_far = {0.72f, 0.60f, 0.43f},
            .to_sun = unit({0.577, 0.577, -0.577}),
            .sun = {4.0f, 3.8f, 3.2f},
            .glow = {0.75f, 0.66f, 0.48f},
            .sun_cosine = 0.9995f,
            .cloud_bright = {0.96f, 0.95f, 0.92f},
            .cloud_dark = {0.62f, 0.62f, 0.64f},
            .cloud_cover = 0.30f,
            .cloud_scale = 0.9f,
            .seed = 11};
}

SkyLook sunset_look() {
    return {.zenith = {0.06f, 0.07f, 0.20f},
            .middle = {0.30f, 0.18f, 0.30f},
            .horizon = {0.95f, 0.42f, 0.16f},
            .ground = {0.05f, 0.04f, 0.05f},
            .ground_far = {0.34f, 0.17f, 0.12f},
            .to_sun = unit({-0.70, 0.12, -0.70}),
            .sun = {5.0f, 3.2f, 1.4f},
            .glow = {1.10f, 0.50f, 0.16f},
            .sun_cosine = 0.9985f,
            .cloud_bright = {0.98f, 0.52f, 0.30f},
            .cloud_dark = {0.22f, 0.14f, 0.20f},
            .cloud_cover = 0.40f,
            .cloud_scale = 1.1f,
            .seed = 29};
}

glm::vec3 sky_colour(const SkyLook& look, glm::vec3 direction) {
    const Vec3<float> colour = colour_towards<float>(look, spread<float>(direction));
    return {colour.x, colour.y, colour.z};
}

CubeMap procedural_sky(const SkyLook& look, int side, const Run& run) {
    return paint_cube_map(
        side,
        [&](const CubeRow& row) {
            run_kernel(run, [&]<class F>(Lanes<F>) {
                for (int x = 0; x < row.count; x += kLanes<F>) {
                    const Vec3<F> direction{load<F>(row.direction[0] + x), load<F>(row.direction[1] + x),
                                            load<F>(row.direction[2] + x)};
                    const Vec3<F> colour = colour_towards<F>(look, direction);
                    store(row.rgb[0] + x, colour.x);
                    store(row.rgb[1] + x, colour.y);
                    store(row.rgb[2] + x, colour.z);
                }
            });
        },
        run);
}

}  // namespace crevice
