#include "scenes/procedural_sky.h"

#include <glm/geometric.hpp>

#include "scenes/composing.h"

namespace crevice {

namespace {

constexpr int kOctaves = 6;

// Of two lattice coordinates: the finalizer of MurmurHash3 after each.
std::uint32_t mixed(std::uint32_t h) {
    h = (h ^ (h >> 16)) * 0x85ebca6bu;
    h = (h ^ (h >> 13)) * 0xc2b2ae35u;
    return h ^ (h >> 16);
}
float lattice_value(std::uint32_t seed, int x, int y) {
    const std::uint32_t h =
        mixed(mixed(seed + static_cast<std::uint32_t>(x)) + static_cast<std::uint32_t>(y) * 0x9e3779b9u);
    return static_cast<float>(h >> 8) * (1.0f / 16777216);
}

float smooth(float t) { return t * t * (3 - 2 * t); }
float smooth_step(float low, float high, float a) { return smooth(saturate((a - low) / (high - low))); }
glm::vec3 blend(glm::vec3 a, glm::vec3 b, float t) { return a + t * (b - a); }

// In [0,1], continuous with its slope.
float value_noise(std::uint32_t seed, float x, float y) {
    const int x0 = floor_to_int(x), y0 = floor_to_int(y);
    const float fx = smooth(x - static_cast<float>(x0)), fy = smooth(y - static_cast<float>(y0));
    return mix(mix(lattice_value(seed, x0, y0), lattice_value(seed, x0 + 1, y0), fx),
               mix(lattice_value(seed, x0, y0 + 1), lattice_value(seed, x0 + 1, y0 + 1), fx), fy);
}

// Octaves of it, each twice as fine and half as strong, turned by 3:4:5 so that their lattices do not line
// up. [0,1]; where it is below `least`, it may be 0 instead.
float cloud_noise(std::uint32_t seed, float x, float y, float least) {
    constexpr float total = 1 - 1.0f / (1 << kOctaves);
    float sum = 0, weight = 0.5f;
    for (int octave = 0; octave < kOctaves; ++octave) {
        sum += weight * value_noise(seed + static_cast<std::uint32_t>(octave), x, y);
        weight *= 0.5f;
        // All the octaves to come weigh less than 2 * weight: a clear sky is soon known.
        if (sum + 2 * weight < least * total) return 0;
        const float turned_x = 1.2f * x - 1.6f * y + 17.3f, turned_y = 1.6f * x + 1.2f * y - 5.7f;
        x = turned_x;
        y = turned_y;
    }
    return sum / total;
}

glm::vec3 clear_sky(const SkyLook& look, float up) {
    const float low = 1 - saturate(up), low2 = low * low, low4 = low2 * low2;
    return blend(blend(look.zenith, look.middle, low2), look.horizon, low4 * low4);
}

glm::vec3 with_sun(const SkyLook& look, glm::vec3 colour, float to_sun_cosine) {
    float near_sun = 0.5f * (1 + max_of(to_sun_cosine, -1.0f));
    for (int i = 0; i < 3; ++i) near_sun *= near_sun;  // ^8: a wide glow
    const float wide = near_sun;
    for (int i = 0; i < 5; ++i) near_sun *= near_sun;  // ^256: a narrow one
    const float rim = 0.15f * (1 - look.sun_cosine);
    const float disc = smooth_step(look.sun_cosine - rim, look.sun_cosine + rim, to_sun_cosine);
    return blend(colour + (0.25f * wide + 0.75f * near_sun) * look.glow, look.sun, disc);
}

// A layer one unit above the eye, bent down towards the horizon so that it ends somewhere.
glm::vec3 with_clouds(const SkyLook& look, glm::vec3 colour, glm::vec3 d) {
    const float reach = look.cloud_scale / (d.y + 0.12f);
    const float x = d.x * reach, y = d.z * reach;
    const float threshold = 0.75f - 0.55f * look.cloud_cover;
    const float density = cloud_noise(look.seed, x, y, threshold);
    const float opacity = smooth_step(threshold, threshold + 0.22f, density) * smooth_step(0.0f, 0.16f, d.y);
    if (!(opacity > 0)) return colour;
    // Lit where the layer is thinner towards the sun.
    const float towards_sun = cloud_noise(look.seed, x + 0.3f * look.to_sun.x, y + 0.3f * look.to_sun.z, 0);
    const float bright = saturate(0.6f + 3 * (density - towards_sun) - 0.9f * (density - threshold));
    return blend(colour, blend(look.cloud_dark, look.cloud_bright, bright), 0.9f * opacity);
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
    const float cosine = glm::dot(direction, look.to_sun);
    // Half a degree of blur hides where sky and ground meet.
    const float above = smooth_step(-0.008f, 0.008f, direction.y);
    glm::vec3 ground = look.ground, sky = look.horizon;
    if (above < 1) {
        const float far = 1 - saturate(-direction.y), far2 = far * far, far4 = far2 * far2;
        ground = blend(look.ground, look.ground_far, far4 * far4);
    }
    if (above > 0) {
        sky = with_sun(look, clear_sky(look, direction.y), cosine);
        if (direction.y > 0) sky = with_clouds(look, sky, direction);
    }
    return blend(ground, sky, above);
}

CubeMap procedural_sky(const SkyLook& look, int side, const Run& run) {
    return build_cube_map(
        side, [&](glm::vec3 direction) { return sky_colour(look, direction); }, run);
}

}  // namespace crevice
