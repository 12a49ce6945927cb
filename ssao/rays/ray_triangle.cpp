#include "ssao/rays/ray_triangle.h"

namespace crevice {

ExactHit exact_hit(const Ray& ray, float max_distance, const BvhBlock& block, int lane) {
    const RaySpace<double> space = ray_space<double>(ray, max_distance);
    const SeenTriangle<double> t = seen_triangle<double>(space, block, lane);
    // An edge function of 0 is inside on both sides of the edge: the ray cannot pass between them.
    const bool inside = (t.u >= 0 && t.v >= 0 && t.w >= 0) || (t.u <= 0 && t.v <= 0 && t.w <= 0);
    if (!inside || !(t.area > 0) || !(t.depth_by_area > t.depth_error)) return {};
    const double along = std::abs(static_cast<double>(ray.direction[space.z]));
    const auto distance = static_cast<float>((t.depth_by_area + t.depth_error) / (t.area * along));
    return {distance <= max_distance, distance, static_cast<float>(std::abs(t.v) / t.area),
            static_cast<float>(std::abs(t.w) / t.area)};
}

}  // namespace crevice
