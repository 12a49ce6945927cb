// What float and double claim of a ray and a triangle is never unlike what exact_hit() finds.
#include "ssao/rays/ray_triangle.h"

#include <cmath>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include "ssao/rays/ray_cast.h"
#include "tests/tools/ray_checks.h"
#include "tests/tools/special_floats.h"

using namespace crevice;

namespace {

BvhBlock block_of(const Corners& corners) {
    BvhBlock block{};
    for (std::size_t corner = 0; corner < 3; ++corner) {
        for (int axis = 0; axis < 3; ++axis) {
            for (float& lane : block.corner[corner][axis]) lane = corners[corner][axis];
        }
    }
    return block;
}

// How far an origin is from a triangle that it lies above.
enum class Lift { none, less, as_rays, far };

// As rays of ambient occlusion are lifted that start on the triangle, or less, or far more.
glm::vec3 above(const Corners& t, Lift lift, RandomNumbers& random) {
    const float u = random.between(0, 1), v = random.between(0, 1 - u);
    const glm::vec3 p = (1 - u - v) * t[0] + u * t[1] + v * t[2],
                    across = glm::cross(t[1] - t[0], t[2] - t[0]);
    const glm::vec3 normal = glm::normalize(across), lifted = offset_origin(p, normal, normal).origin;
    switch (lift) {
        case Lift::none: return p;
        case Lift::less: return glm::mix(p, lifted, 0.2f);
        case Lift::as_rays: return lifted;
        case Lift::far: break;
    }
    return p + random.between(0, 1) * glm::length(t[1] - t[0]) * normal;
}

struct Claims {
    int made = 0, left_open = 0;
};

// Whether `seen` claims nothing false about a ray; counts whether it claims anything.
bool is_right(const SeenTriangles<float>& seen, const Ray& ray, float max_distance, const BvhBlock& block,
              Claims& claims) {
    const Verdict<float> found = verdict(seen, ray_aim(ray.direction, max_distance));
    ++(found.perhaps && !found.sure ? claims.left_open : claims.made);
    const bool met = exact_hit(ray, max_distance, block, 0).met;
    return met ? found.perhaps : !found.sure;
}

}  // namespace

TEST_CASE("ray triangle: neither float's nor double's volumes claim what exact_hit() does not find") {
    RandomNumbers random(31);
    Claims in_float, in_double;
    int wrong = 0;
    for (int i = 0; i < 4000; ++i) {
        const float away = std::exp2(random.between(-10, 10)), size = away * std::exp2(random.between(-8, 3));
        const glm::vec3 middle = away * random.direction();
        const Corners t{middle + size * random.direction(), middle + size * random.direction(),
                        middle + size * random.direction()};
        const glm::vec3 origin = above(t, static_cast<Lift>(i % 4), random);
        const BvhBlock block = block_of(t);
        const SeenTriangles<float> seen = seen_triangles<float>(origin, block, 0),
                                   better = with_volumes_in_double(seen, origin, block, 0, 1);
        for (int k = 0; k < 16; ++k) {
            const Ray ray{origin, random.direction()};
            const float max_distance = k % 2 == 0 ? kInfinity : size * random.between(0, 1);
            wrong += is_right(seen, ray, max_distance, block, in_float) ? 0 : 1;
            wrong += is_right(better, ray, max_distance, block, in_double) ? 0 : 1;
        }
    }
    CHECK(wrong == 0);
    CHECK(in_double.left_open < in_float.left_open / 2);
}

TEST_CASE("ray triangle: a volume in double is off by no more than its error") {
    RandomNumbers random(32);
    for (int i = 0; i < 4000; ++i) {
        const float away = std::exp2(random.between(-20, 20));
        const auto whole = [&] { return std::floor(random.between(-1000, 1000)); };
        const auto corner = [&] { return glm::vec3(whole(), whole(), whole()); };
        const Corners t{corner(), corner(), corner()};
        const glm::vec3 origin = corner();
        // Products of whole numbers, all exact in double, by a power of two.
        const float scale = std::exp2(std::floor(std::log2(away)));
        const glm::dvec3 a = glm::dvec3(t[0]) - glm::dvec3(origin), ab = glm::dvec3(t[1]) - glm::dvec3(t[0]),
                         ca = glm::dvec3(t[0]) - glm::dvec3(t[2]);
        const double volume = 2 * glm::dot(a, glm::cross(ab, ca)) * std::pow(double{scale}, 3);
        const BvhBlock block = block_of({scale * t[0], scale * t[1], scale * t[2]});
        const SeenVolume found = volume_in_double(scale * origin, block, 0);
        CHECK(std::abs(double{found.volume} - volume) <= double{found.error});
    }
}
