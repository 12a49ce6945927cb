// The skies of arithmetic: smooth, finite, and with their parts where they belong.
#include "scenes/procedural_sky.h"

#include <cmath>
#include <string>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include "tests/tools/noise.h"

using namespace crevice;

namespace {

struct NamedLook {
    std::string name;
    SkyLook look;
};
const NamedLook kLooks[] = {{"desert", desert_look()}, {"sunset", sunset_look()}};

glm::vec3 direction(int i) {
    const glm::vec3 d(noise(1, i, 0) - 0.5f, noise(2, i, 0) - 0.5f, noise(3, i, 0) - 0.5f);
    return glm::normalize(d);
}

float brightness(glm::vec3 colour) { return colour.x + colour.y + colour.z; }

}  // namespace

TEST_CASE("procedural sky: finite, not negative, bounded by its colours") {
    for (const NamedLook& named : kLooks) {
        const SkyLook& look = named.look;
        CAPTURE(named.name);
        for (int i = 0; i < 5000; ++i) {
            const glm::vec3 c = sky_colour(look, direction(i));
            CAPTURE(i);
            for (int k = 0; k < 3; ++k) CHECK((c[k] >= 0 && c[k] <= look.sun[k] + look.glow[k]));
        }
    }
}

TEST_CASE("procedural sky: no jumps but at the sun's rim") {
    for (const NamedLook& named : kLooks) {
        const SkyLook& look = named.look;
        CAPTURE(named.name);
        for (int i = 0; i < 5000; ++i) {
            const glm::vec3 d = direction(i), next = glm::normalize(d + 1e-4f * direction(i + 90000));
            if (glm::dot(d, look.to_sun) > 0.99f) continue;
            const glm::vec3 step = sky_colour(look, next) - sky_colour(look, d);
            CAPTURE(i);
            // The steepest there is are clouds low over the horizon.
            CHECK(glm::length(step) < 0.03f);
        }
    }
}

TEST_CASE("procedural sky: the sun is brightest, haze pales the horizon, the ground lies below") {
    for (const NamedLook& named : kLooks) {
        SkyLook look = named.look;
        CAPTURE(named.name);
        CHECK(std::fabs(glm::length(look.to_sun) - 1) < 1e-6f);
        look.cloud_cover = 0;
        CHECK(glm::length(sky_colour(look, look.to_sun) - look.sun) < 1e-5f);
        const glm::vec3 away = glm::normalize(glm::vec3(-look.to_sun.x, 0.02f, -look.to_sun.z));
        CHECK(brightness(sky_colour(look, away)) > brightness(sky_colour(look, {0, 1, 0})));
        CHECK(sky_colour(look, {0, -1, 0}) == look.ground);
        CHECK(sky_colour(look, glm::normalize(glm::vec3(1, -0.5f, 0.3f))) !=
              sky_colour(look, glm::normalize(glm::vec3(1, 0.5f, 0.3f))));
    }
    // What tells the two apart: blue over pale sand, dark over an orange horizon.
    const glm::vec3 desert = sky_colour(desert_look(), {0, 0.7071f, 0.7071f}),
                    dusk = sky_colour(sunset_look(), glm::normalize(glm::vec3(0.3f, 0.01f, 1)));
    CHECK(desert.z > desert.x);
    CHECK(dusk.x > 1.5f * dusk.z);
}

TEST_CASE("procedural sky: more cover, more cloud; another seed, other clouds") {
    SkyLook look = desert_look();
    const auto clouded = [&](float cover, std::uint32_t seed) {
        SkyLook clear = look, cloudy = look;
        clear.cloud_cover = 0;
        cloudy.cloud_cover = cover;
        cloudy.seed = seed;
        int count = 0;
        for (int i = 0; i < 4000; ++i) {
            glm::vec3 d = direction(i);
            d.y = std::fabs(d.y);
            count += sky_colour(cloudy, d) != sky_colour(clear, d) ? 1 : 0;
        }
        return count;
    };
    const int few = clouded(0.3f, look.seed), more = clouded(0.6f, look.seed), most = clouded(1, look.seed);
    CHECK(few > 100);
    CHECK(more > few + 400);
    CHECK(most > more + 400);
    CHECK(clouded(0.3f, look.seed + 1000) != few);
}

TEST_CASE("procedural sky: the cube map holds it, the same from one thread and many") {
    const SkyLook look = sunset_look();
    const CubeMap cube = procedural_sky(look, 16);
    CHECK(procedural_sky(look, 16, {.threads = 1}).rgba == cube.rgba);
    const glm::vec3 d(glm::normalize(cube_direction(1, 3.0 / 16, -5.0 / 16)));
    CHECK(cube.texel(0, 1, 9, 5) == sky_colour(look, d));
}
