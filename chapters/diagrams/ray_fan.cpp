#include "chapters/diagrams/ray_fan.h"

#include <cstddef>

#include "rasterizer/lanes/approx_math.h"

namespace crevice {

RayFan ray_fan(const RayScene& rays, SectionPoint p, const std::vector<double>& angles_rad, double length,
               const std::vector<SectionPoint>& outline, const std::string& title) {
    constexpr float kLift = 1e-4f;  // off the floor
    RayFan fan;
    SectionDrawing drawing({p.z - 1.15 * length, -0.32 * length}, {p.z + 1.15 * length, 1.15 * length});
    for (std::size_t i = 0; i + 1 < outline.size(); ++i) drawing.segment(outline[i], outline[i + 1], kSvgInk);
    for (const double angle_rad : angles_rad) {
        const SineCosine at = sine_cosine(angle_rad);
        const Ray ray{{0, kLift, static_cast<float>(p.z)},
                      {0, static_cast<float>(at.sine), static_cast<float>(at.cosine)}};
        const RayHit hit = closest_hit(rays, ray, static_cast<float>(length));
        const bool blocked = hit.triangle >= 0;
        fan.blocked += blocked ? 1 : 0;
        const double reach = blocked ? static_cast<double>(hit.distance) : length;
        drawing.arrow(p, {p.z + reach * at.cosine, p.across + reach * at.sine},
                      blocked ? kSvgOccluded : kSvgOpen);
    }
    drawing.point(p, "", kSvgPoint);
    drawing.label(p, -4, 22, "p", kSvgPoint);
    fan.svg = drawing.svg(title);
    return fan;
}

}  // namespace crevice
