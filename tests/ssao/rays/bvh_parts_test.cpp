#include "ssao/rays/bvh_parts.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include <doctest/doctest.h>

#include "ssao/rays/ray_traverse.h"
#include "tests/tools/ray_checks.h"
#include "tests/tools/special_floats.h"

using namespace crevice;

namespace {

std::vector<BoxedTriangle> boxes_of(const std::vector<Corners>& triangles) {
    std::vector<BoxedTriangle> boxes;
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        const Corners& c = triangles[i];
        boxes.push_back({glm::min(c[0], glm::min(c[1], c[2])), static_cast<std::int32_t>(i),
                         glm::max(c[0], glm::max(c[1], c[2]))});
    }
    return boxes;
}
std::vector<BoxedTriangle> parts_of(const std::vector<Corners>& triangles) {
    std::vector<BoxedTriangle> boxes = boxes_of(triangles);
    return boxed_parts(triangles, boxes, range_of(boxes, {}).box);
}

// The boxes of how many triangles or parts a ray through the box of all enters.
double overlap_of(std::vector<BoxedTriangle> boxes) {
    double sum = 0;
    for (const BoxedTriangle& t : boxes) sum += Box{t.low, t.high}.half_area();
    return sum / range_of(boxes, {}).box.half_area();
}

bool holds(const BoxedTriangle& box, const glm::dvec3& p) {
    bool inside = true;
    for (int axis = 0; axis < 3; ++axis)
        inside = inside && double{box.low[axis]} <= p[axis] && p[axis] <= double{box.high[axis]};
    return inside;
}

// How many blocks of eight triangles a ray that meets nothing looks into.
int blocks_entered(const Bvh& bvh, const Ray& ray) {
    int blocks = 0;
    traverse<float>(bvh, box_ray(ray, kInfinity, bvh.reach), [&](const BvhBlock&) {
        ++blocks;
        return false;
    });
    return blocks;
}

}  // namespace

TEST_CASE("bvh parts: what overlaps little is left as it is") {
    for (const std::vector<Corners>& triangles :
         {random_triangles(2000, 0.05f, 1), thin_triangles(300, 2), fan_triangles(50, 0.5f),
          std::vector<Corners>(5000, Corners{glm::vec3(0), {1, 0, 0}, {0, 1, 0.5f}})}) {
        const std::vector<BoxedTriangle> boxes = boxes_of(triangles), parts = parts_of(triangles);
        CAPTURE(triangles.size());
        REQUIRE(parts.size() == boxes.size());
        CHECK(std::memcmp(parts.data(), boxes.data(), boxes.size() * sizeof(BoxedTriangle)) == 0);
    }
}

TEST_CASE("bvh parts: the parts of a sliver hold all of it and nothing outside its own box") {
    RandomNumbers random(5);
    for (const float tip : {0.0f, 0.5f}) {
        const std::vector<Corners> triangles = fan_triangles(3000, tip);
        const std::vector<BoxedTriangle> whole = boxes_of(triangles), parts = parts_of(triangles);
        CHECK(overlap_of(whole) > 4 * kOverlap);
        CHECK(overlap_of(parts) < 1.2 * kOverlap);  // each box is rounded out a little
        CHECK(parts.size() < 10 * triangles.size());
        std::vector<std::vector<BoxedTriangle>> of_triangle(triangles.size());
        for (const BoxedTriangle& part : parts) {
            const auto triangle = static_cast<std::size_t>(part.triangle);
            of_triangle[triangle].push_back(part);
            REQUIRE(holds(whole[triangle], part.low));
            REQUIRE(holds(whole[triangle], part.high));
        }
        for (std::size_t t = 0; t < triangles.size(); t += 7) {
            for (int i = 0; i < 40; ++i) {
                double u = random.between(0, 1), v = random.between(0, 1);
                if (u + v > 1) u = 1 - u, v = 1 - v;
                if (i < 3) u = i == 1, v = i == 2;  // the corners
                const Corners& c = triangles[t];
                const glm::dvec3 a = c[0], b = c[1], p = a + u * (b - a) + v * (glm::dvec3(c[2]) - a);
                CAPTURE(t);
                CAPTURE(u);
                CAPTURE(v);
                CHECK(std::any_of(of_triangle[t].begin(), of_triangle[t].end(),
                                  [&](const BoxedTriangle& part) { return holds(part, p); }));
            }
        }
    }
}

TEST_CASE("bvh parts: rays at a fan meet what testing every triangle finds") {
    RandomNumbers random(9);
    for (const float tip : {0.0f, 0.3f}) {
        const std::vector<Corners> triangles = fan_triangles(3000, tip);
        const Bvh bvh = build_bvh(triangles);
        for (int i = 0; i < 300; ++i) {
            const Corners& c = triangles[static_cast<std::size_t>(random.between(0, 2999))];
            // At the tip, at a corner of the rim, along an edge, inside.
            const float along = i % 4 == 0 ? 0 : random.between(0, 1),
                        aside = i % 4 < 3 ? 0 : random.between(0, 1);
            const glm::vec3 aim = c[0] + (i % 4 == 1 ? 1 : along) * (c[1] + aside * (c[2] - c[1]) - c[0]);
            const glm::vec3 origin = random.in_cube(2);
            const Ray ray{origin, aim - origin};
            CAPTURE(text_of(ray));
            CHECK(same(nearest_hit<float>(bvh, ray, kInfinity), nearest_of_all(triangles, ray, kInfinity)));
        }
    }
}

TEST_CASE("bvh parts: a ray that leaves a fan looks into a fraction of its triangles") {
    const std::vector<Corners> triangles = fan_triangles(20000, 0);
    const Bvh bvh = build_bvh(triangles);
    const glm::vec3 up = glm::normalize(glm::cross(triangles[0][1], triangles[1][2]));
    RandomNumbers random(3);
    double blocks = 0;
    for (int i = 0; i < 200; ++i) {
        const Corners& c = triangles[static_cast<std::size_t>(random.between(0, 19999))];
        const glm::vec3 p = 0.5f * c[1];
        const glm::vec3 aside = random.direction();
        blocks += blocks_entered(bvh, {p + 1e-5f * up, up + 0.5f * aside});
    }
    CHECK(blocks / 200 < 100);  // of 2500 blocks that hold the triangles once; uncut about 400
}
