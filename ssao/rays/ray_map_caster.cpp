#include "ssao/rays/ray_map_caster.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>

#include "rasterizer/lanes/arc_cosine.h"
#include "ssao/inputs/pixel_fetch.h"
#include "ssao/methods/each_texel.h"

namespace crevice {

namespace {

constexpr float kHalfStep = 0x1p-10f;  // of 16-bit floats, relative

// Which part of the pattern a texel has: neighbours have parts that are far from each other.
int part_of(int x, int y) {
    int part = 0;
    for (int bit = 0; bit < 3; ++bit) {
        const int column = (x >> bit) & 1, row = (y >> bit) & 1;
        part = part * 4 + 2 * (column ^ row) + row;
    }
    return part;
}

}  // namespace

RayMapCaster::RayMapCaster(const RayScene& ray_scene, const Camera& camera, const GBuffer& g,
                           const AoInputs& ao_inputs, const RayMapSettings& ray_map)
    : scene(ray_scene),
      gbuffer(g),
      inputs(ao_inputs),
      settings(ray_map),
      columns(inputs.size().width, inputs.picture.width),
      rows(inputs.size().height, inputs.picture.height),
      relative_from_view(camera_matrices(camera, ao_inputs.picture).relative_from_view) {
    if (settings.pattern == RayPattern::interleaved)
        pattern = directions(settings.samples * kPatternSide * kPatternSide, 0);
    for (int i = 0; i < kTexelTile * kTexelTile; ++i) order.push_back(i);
    std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return heading(a) < heading(b); });
}

// Where the first ray of a texel of a tile points, about its normal, in radians; 0 without a pattern.
float RayMapCaster::heading(int texel) const {
    if (pattern.empty()) return 0;
    const auto part = static_cast<std::size_t>(part_of(texel % kTexelTile, texel / kTexelTile));
    const glm::vec3& d = pattern[part * static_cast<std::size_t>(settings.samples)];
    const float angle = arc_cosine(d.x / std::max(std::sqrt(d.x * d.x + d.y * d.y), 1e-6f));
    return d.y < 0 ? -angle : angle;
}

std::vector<glm::vec3> RayMapCaster::directions(int count, std::uint32_t stream) const {
    const auto padded = static_cast<std::size_t>(round_up(count, kPointGroup));
    std::vector<float> u(padded), v(padded);
    SquarePoints(count, RaySequence::sobol).fill(settings.seed, stream, u.data(), v.data());
    std::vector<glm::vec3> result;
    for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
        const Vec3<float> d = hemisphere_direction(settings.weight, u[i], v[i]);
        result.push_back({d.x, d.y, d.z});
    }
    return result;
}

// The pixel nearest to the eye of those around a texel's centre, the first of equals: at half size the point between
// four pixels of a curved surface would lie inside it.
RayMapCaster::Pixel RayMapCaster::pixel_of(int x, int y) const {
    const auto column = static_cast<std::size_t>(x), row = static_cast<std::size_t>(y);
    const int left = columns.first[column], top = rows.first[row];
    const int right = columns.weight_of_second[column] > 0 ? columns.second[column] : left,
              bottom = rows.weight_of_second[row] > 0 ? rows.second[row] : top;
    Pixel nearest{left, top};
    for (const Pixel other : {Pixel{right, top}, Pixel{left, bottom}, Pixel{right, bottom}}) {
        if (gbuffer.view_depth.at(other.x, other.y) < gbuffer.view_depth.at(nearest.x, nearest.y))
            nearest = other;
    }
    return nearest;
}

// What the position of a pixel may be off: roundings, those of a 16-bit format among them, and the snapping of corners.
float RayMapCaster::lift_at(const glm::vec3& p, float z) const {
    const float rounded = kRayLift * std::max({std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)});
    const float stored = gbuffer.format == BufferFormat::float32 ? 0 : kHalfStep * z;
    const float pixel = (inputs.rays.perspective ? z : 1) / pixels_per_unit(inputs);
    return rounded + stored + pixel / kSubpixelSteps;
}

RayStart RayMapCaster::start_at(int x, int y) const {
    if (!(inputs.view_depth.at(x, y) < std::numeric_limits<float>::infinity())) return {};
    const Pixel pixel = pixel_of(x, y);
    const float z = gbuffer.view_depth.at(pixel.x, pixel.y);
    if (!(z < std::numeric_limits<float>::infinity())) return {};
    const float u = (static_cast<float>(pixel.x) + 0.5f) / static_cast<float>(inputs.picture.width),
                v = (static_cast<float>(pixel.y) + 0.5f) / static_cast<float>(inputs.picture.height);
    const Vec3<float> at = inputs.rays.p_view(u, v, z);
    const glm::vec3 p = relative_from_view * glm::vec3(at.x, at.y, at.z),
                    n = relative_from_view * gbuffer.normal.at(pixel.x, pixel.y);
    const float length = glm::length(n);
    if (!(length > 0)) return {};
    const glm::vec3 normal = n / length;
    const float lift = lift_at(p, z);
    return {true, p + lift * normal, normal, lift};
}

void RayMapCaster::add_rays(const RayStart& from, int x, int y, std::vector<Ray>& rays) const {
    const TangentFrame frame = tangent_frame(from.normal);
    const auto add = [&](const glm::vec3& d) {
        const Vec3<float> turned = in_frame<float>(frame, {d.x, d.y, d.z});
        rays.push_back({from.origin, {turned.x, turned.y, turned.z}});
    };
    const auto count = static_cast<std::size_t>(settings.samples);
    if (settings.pattern == RayPattern::interleaved) {
        const std::size_t first = static_cast<std::size_t>(part_of(x, y)) * count;
        for (std::size_t i = 0; i < count; ++i) add(pattern[first + i]);
    } else {
        const auto texel = static_cast<std::uint32_t>(y * inputs.size().width + x);
        for (const glm::vec3& d : directions(settings.samples, texel)) add(d);
    }
}

float accessibility_of(const RayMapSettings& settings, float met) {
    const float count = static_cast<float>(settings.samples);
    return saturate(power((count - met) / count, settings.exponent));
}

}  // namespace crevice
