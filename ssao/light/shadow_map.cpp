#include "ssao/light/shadow_map.h"

#include <cmath>
#include <string>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "rasterizer/base/error.h"
#include "rasterizer/base/float_text.h"
#include "rasterizer/draw/cutouts.h"

namespace crevice {

namespace {

void require(bool holds, const char* what, double value, const char* cure) {
    if (!holds) {
        throw UsageError(std::string("shadow map: ") + what + " (" + shortest_text(value) + "); " + cure);
    }
}

bool finite(const glm::dvec3& p) { return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z); }

}  // namespace

ShadowFit sphere_shadow_fit(glm::dvec3 centre, double radius) {
    return {centre, 2 * radius, radius, radius, 3 * radius};
}

ShadowFit bounds_shadow_fit(const Bounds& bounds) {
    const double radius = 0.5 * glm::length(bounds.high - bounds.low);
    if (bounds.empty || !(radius > 0)) return sphere_shadow_fit(bounds.low, 1);
    return sphere_shadow_fit(0.5 * (bounds.low + bounds.high), radius);
}

ShadowFit xjun_shadow_fit(double length_unit) {
    return {glm::dvec3(0), 40 * length_unit, 20 * length_unit, 20 * length_unit, 60 * length_unit};
}

void validate(const ShadowSettings& settings) {
    require(settings.size_px >= 1 && settings.size_px <= kMaxShadowSide,
            "its side must lie in 1..16384 texels", settings.size_px, "give another size");
    require(std::isfinite(settings.bias.slope) && std::isfinite(settings.bias.clamp),
            "slope and clamp of the bias must be finite, the slope is",
            static_cast<double>(settings.bias.slope), "give another bias");
    require(std::isfinite(settings.shader_bias), "the bias in the shader must be finite",
            static_cast<double>(settings.shader_bias), "give another bias");
    require(settings.comparison == DepthFunction::less || settings.comparison == DepthFunction::less_equal,
            "the comparison must be LESS or LESS_EQUAL, its number is",
            static_cast<double>(settings.comparison), "give one of the two");
}

Camera light_camera(const ShadowFit& fit, glm::vec3 direction) {
    const glm::dvec3 along(direction);
    const double length = glm::length(along);
    require(std::isfinite(length) && length > 0, "the light must have a direction, its length is", length,
            "give another light");
    require(finite(fit.centre), "its centre must be finite, x is", fit.centre.x, "give another fit");
    require(std::isfinite(fit.distance) && fit.distance > 0, "the light's distance must be above 0",
            fit.distance, "give another fit");
    require(std::isfinite(fit.half_width) && fit.half_width > 0, "its half width must be above 0",
            fit.half_width, "give another fit");
    require(std::isfinite(fit.near_plane) && fit.near_plane > 0, "its near plane must be above 0",
            fit.near_plane, "give another fit");
    require(std::isfinite(fit.far_plane) && fit.far_plane > fit.near_plane,
            "its far plane must be beyond the near one", fit.far_plane, "give another fit");

    Camera camera;
    const double step = std::ldexp(1.0, std::ilogb(fit.distance) - 23);
    const glm::dvec3 offset = step * glm::floor(fit.distance / (step * length) * along + 0.5);
    camera.eye = fit.centre - offset;
    camera.target = fit.centre;
    // Less than a third of a degree off the vertical, up would be lost in rounding.
    const bool vertical = along.x * along.x + along.z * along.z < 2.5e-5 * length * length;
    camera.up = vertical ? glm::dvec3(0, 0, 1) : glm::dvec3(0, 1, 0);
    camera.projection = Projection::orthographic;
    camera.ortho_height = 2 * fit.half_width;
    camera.near_plane = fit.near_plane;
    camera.far_plane = fit.far_plane;
    validate(camera);
    return camera;
}

ScreenGeometry shadow_geometry(const Scene& scene, const Camera& light, const ShadowSettings& settings,
                               const Run& run) {
    return screen_geometry(scene, light, {settings.size_px, settings.size_px},
                           {.with_normals = false,
                            .depth_format = settings.format,
                            .depth_bias = settings.bias,
                            .keep_back_faces = !settings.cull_back_faces},
                           run);
}

ShadowMap shadow_map(const Scene& scene, glm::vec3 direction, const ShadowFit& fit,
                     const ShadowSettings& settings, const Run& run) {
    validate(settings);
    const Camera light = light_camera(fit, direction);
    const ScreenGeometry geometry = shadow_geometry(scene, light, settings, run);
    return {nearest_depth(geometry, settings.format, alpha_holes(scene, geometry, run), run), light,
            settings};
}

}  // namespace crevice
