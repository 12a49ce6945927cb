// Bent normals against rays: the mean of those that meet nothing within the radius.
#include <cmath>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include "scenes/builtin_scenes.h"
#include "ssao/inputs/pixel_fetch.h"
#include "ssao/methods/gtao_bent_normals.h"
#include "ssao/rays/hemisphere_directions.h"
#include "ssao/rays/ray_cast.h"
#include "ssao/rays/surface_points.h"
#include "tests/tools/still_life.h"

using namespace crevice;

namespace {

constexpr int kRays = 128;

// The mean open direction over a point, world axes, and the share of directions that is open.
struct OpenDirections {
    glm::vec3 mean;
    double share;
};
OpenDirections open_directions(const RayScene& scene, const SurfacePoint& point, float radius,
                               std::uint32_t stream) {
    const SquarePoints square(kRays, RaySequence::sobol);
    std::vector<float> u(kRays), v(kRays);
    square.fill(1, stream, u.data(), v.data());
    const TangentFrame frame = tangent_frame(point.normal);
    glm::vec3 sum(0);
    int open = 0;
    for (std::size_t i = 0; i < kRays; ++i) {
        const Vec3<float> d = in_frame(frame, hemisphere_direction(RayWeight::cosine, u[i], v[i]));
        const glm::vec3 direction(d.x, d.y, d.z);
        const glm::vec3 origin = offset_origin(point.position, point.geometric_normal, direction).origin;
        if (occluded(scene, {origin, direction}, radius)) continue;
        sum += direction;
        ++open;
    }
    return {sum, 1.0 * open / kRays};
}

double angle_between(glm::vec3 a, glm::vec3 b) {
    return std::acos(std::fmin(double{glm::dot(glm::normalize(a), glm::normalize(b))}, 1));
}

}  // namespace

TEST_CASE("bent normals: where much is hidden, less than three fifths as far from the rays' as the normals are") {
    constexpr Size size{64, 48};
    for (const Scene& scene : {cornell_scene(), still_life()}) {
        const GBuffer g = normal_depth(scene, scene.camera, size);
        const GtaoSettings settings{
            .samples = 54, .radius = 1.5f, .radius_multiplier = 1, .falloff = 0, .ao_scale = 1};
        const AoInputs inputs = ao_inputs(g, scene.camera, pixel_fetch(settings));
        const Image3 bent = gtao_bent_normals(inputs, settings);
        const RayScene rays = ray_scene(scene, scene.camera.eye);
        const SurfacePoints seen = surface_points(scene, scene.camera, g);
        const glm::mat3 view_from_world(camera_matrices(scene.camera, size).view_from_relative);
        double of_bent = 0, of_normals = 0;
        int count = 0;
        for (std::size_t i = 0; i < seen.points.size(); i += 3) {
            const int x = seen.pixel[i] % size.width, y = seen.pixel[i] / size.width;
            const OpenDirections open =
                open_directions(rays, seen.points[i], settings.radius, static_cast<std::uint32_t>(i));
            if (open.share < 0.2 || open.share > 0.8) continue;
            const glm::vec3 truth = view_from_world * open.mean;
            of_bent += angle_between(bent.at(x, y), truth);
            of_normals += angle_between(inputs.normal.at(x, y), truth);
            ++count;
        }
        CAPTURE(scene.name);
        CAPTURE(of_bent / count);
        CAPTURE(of_normals / count);
        CHECK(count > 50);
        CHECK(of_bent < 0.6 * of_normals);
    }
}
