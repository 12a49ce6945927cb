#include "ssao/rays/ray_cast_map.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include <glm/geometric.hpp>

#include "rasterizer/base/error.h"
#include "rasterizer/base/parallel.h"
#include "rasterizer/lanes/arc_cosine.h"
#include "ssao/inputs/linear_taps.h"
#include "ssao/inputs/pixel_fetch.h"
#include "ssao/methods/each_texel.h"
#include "ssao/methods/settings_range.h"
#include "ssao/rays/open_region.h"
#include "ssao/rays/ray_cast.h"

namespace crevice {

namespace {

constexpr int kMostSamples = 256;
constexpr float kHalfStep = 0x1p-10f;  // of 16-bit floats, relative

// Where the rays of a texel start, relative space.
struct RayStart {
    bool surface = false;
    glm::vec3 origin{0}, normal{0};
    float lift = 0;
};

struct Pixel {
    int x, y;
};

struct RayMapCaster {
    const RayScene& scene;
    const GBuffer& gbuffer;
    const AoInputs& inputs;
    const RayMapSettings& settings;
    const LinearTaps columns, rows;  // where the texels fall among the pixels
    const glm::mat3 relative_from_view;
    std::vector<glm::vec3>
        pattern;             // of RayPattern::interleaved: directions about +z, those of a texel side by side
    std::vector<int> order;  // of a tile's texels: those whose rays point alike together

    RayMapCaster(const RayScene& ray_scene, const Camera& camera, const GBuffer& g, const AoInputs& ao_inputs,
                 const RayMapSettings& ray_map)
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
    float heading(int texel) const {
        if (pattern.empty()) return 0;
        const auto part = static_cast<std::size_t>(part_of(texel % kTexelTile, texel / kTexelTile));
        const glm::vec3& d = pattern[part * static_cast<std::size_t>(settings.samples)];
        const float angle = arc_cosine(d.x / std::max(std::sqrt(d.x * d.x + d.y * d.y), 1e-6f));
        return d.y < 0 ? -angle : angle;
    }

    std::vector<glm::vec3> directions(int count, std::uint32_t stream) const {
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
    Pixel pixel_of(int x, int y) const {
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
    float lift_at(const glm::vec3& p, float z) const {
        const float rounded = kRayLift * std::max({std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)});
        const float stored = gbuffer.format == BufferFormat::float32 ? 0 : kHalfStep * z;
        const float pixel = (inputs.rays.perspective ? z : 1) / pixels_per_unit(inputs);
        return rounded + stored + pixel / kSubpixelSteps;
    }

    RayStart start_at(int x, int y) const {
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

    // Which part of the pattern a texel has: neighbours have parts that are far from each other.
    static int part_of(int x, int y) {
        int part = 0;
        for (int bit = 0; bit < 3; ++bit) {
            const int column = (x >> bit) & 1, row = (y >> bit) & 1;
            part = part * 4 + 2 * (column ^ row) + row;
        }
        return part;
    }

    void add_rays(const RayStart& from, int x, int y, std::vector<Ray>& rays) const {
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

    float value(int met) const {
        const float share = static_cast<float>(settings.samples - met) / static_cast<float>(settings.samples);
        return saturate(power(share, settings.exponent));
    }
};

// The tile whose upper left texel is (left, top).
struct TileCaster {
    const RayMapCaster& caster;
    const int left, top, width, height;
    std::array<RayStart, kTexelTile * kTexelTile> starts;  // row by row, kTexelTile a row

    TileCaster(const RayMapCaster& ray_map, int first_column, int first_row)
        : caster(ray_map),
          left(first_column),
          top(first_row),
          width(std::min(kTexelTile, ray_map.inputs.size().width - first_column)),
          height(std::min(kTexelTile, ray_map.inputs.size().height - first_row)) {
        for (int y = 0; y < height; ++y) {
            for (int x = 0; x < width; ++x) start(x, y) = caster.start_at(left + x, top + y);
        }
    }
    RayStart& start(int x, int y) { return starts[static_cast<std::size_t>(y * kTexelTile + x)]; }

    // Nothing can be met from a flat piece of surface.
    bool is_open() const {
        RayRegion region;
        bool any = false;
        for (const RayStart& from : starts) {
            if (!from.surface) continue;
            if (any && from.normal != region.normal) return false;
            region.normal = from.normal;
            region.include(from.origin, from.lift);
            any = true;
        }
        return any && region_is_open(caster.scene.bvh, region, caster.settings.radius);
    }

    void cast(Image<float>& ao, const Run& run) const {
        std::vector<Ray> rays;
        std::array<int, kTexelTile * kTexelTile> texel, met{};
        std::size_t count = 0;
        for (const int i : caster.order) {
            const RayStart& from = starts[static_cast<std::size_t>(i)];
            if (!from.surface) continue;
            caster.add_rays(from, left + i % kTexelTile, top + i / kTexelTile, rays);
            texel[count++] = i;
        }
        run_kernel(run, [&]<class F>(Lanes<F>) {
            for_occluded_rays<F>(caster.scene, rays, caster.settings.radius, [&](std::size_t ray) {
                ++met[ray / static_cast<std::size_t>(caster.settings.samples)];
            });
        });
        for (std::size_t i = 0; i < count; ++i)
            ao.at(left + texel[i] % kTexelTile, top + texel[i] / kTexelTile) = caster.value(met[i]);
    }
};

}  // namespace

void validate(const RayMapSettings& s) {
    require_within("samples", s.samples, 1, kMostSamples);
    require_common(s);
}

AoMap ray_cast_map(const RayScene& scene, const Camera& camera, const GBuffer& gbuffer,
                   const AoInputs& inputs, const RayMapSettings& settings, const Run& run) {
    validate(settings);
    AoMap map{Image<float>(inputs.size(), 1.0f), surface_tiles(inputs, run)};
    const RayMapCaster caster(scene, camera, gbuffer, inputs, settings);
    Image<TileWork>& tiles = map.tiles.tiles;
    parallel_for(tiles.size.width * tiles.size.height, run, [&](int tile) {
        const int column = tile % tiles.size.width, row = tile / tiles.size.width;
        TileWork& work = tiles.at(column, row);
        if (work != TileWork::done) return;
        const TileCaster casting(caster, column * kTexelTile, row * kTexelTile);
        if (run.leaves_out(Skip::open_tiles) && casting.is_open()) {
            work = TileWork::open;
        } else {
            casting.cast(map.ao, run);
        }
    });
    return map;
}

Explanation explain_ray_cast_map(const RayScene& scene, const Camera& camera, const GBuffer& gbuffer,
                                 const AoInputs& inputs, const RayMapSettings& settings, int x, int y) {
    validate(settings);
    const RayMapCaster caster(scene, camera, gbuffer, inputs, settings);
    const RayStart from = caster.start_at(x, y);
    Explanation result;
    result.surface = inputs.view_depth.at(x, y) < std::numeric_limits<float>::infinity();
    if (!from.surface) return result;
    const glm::mat3 view_from_relative = glm::transpose(caster.relative_from_view);
    result.p_view = view_from_relative * (from.origin - from.lift * from.normal);
    result.n_view = view_from_relative * from.normal;
    std::vector<Ray> rays;
    caster.add_rays(from, x, y, rays);
    for (const Ray& ray : rays) {
        const RayHit hit = nearest_solid_hit<float>(scene, ray, settings.radius);
        ExplainedSample sample;
        const float distance = hit.triangle < 0 ? settings.radius : static_cast<float>(hit.distance);
        sample.offset = view_from_relative * (distance * ray.direction);
        sample.q_view = result.p_view + sample.offset;
        sample.r_view = sample.q_view;
        const Screen2<float> on_screen = inputs.rays.p_screen<float>(
            {sample.q_view.x, sample.q_view.y, sample.q_view.z}, 1 / sample.q_view.z);
        sample.q_screen = {on_screen.x, on_screen.y};
        sample.dz = -sample.offset.z;
        sample.dp = glm::dot(from.normal, ray.direction);
        sample.weight = 1;
        sample.contribution = hit.triangle < 0 ? 0.0f : 1.0f;
        sample.verdict = hit.triangle < 0 ? "meets nothing" : "occludes";
        const glm::vec3 towards = view_from_relative * ray.direction;
        sample.numbers = {{"direction_x", towards.x}, {"direction_y", towards.y}, {"direction_z", towards.z}};
        if (hit.triangle >= 0) {
            sample.numbers.push_back({"distance", distance});
            sample.numbers.push_back({"triangle", std::int64_t{hit.triangle}});
        }
        result.samples.push_back(sample);
    }
    result.formula = contrast_formula(
        "(" + std::to_string(settings.samples) + " - sum) / " + std::to_string(settings.samples),
        settings.exponent);
    result.value_of_sum = [settings](float sum) {
        const float share =
            (static_cast<float>(settings.samples) - sum) / static_cast<float>(settings.samples);
        return saturate(power(share, settings.exponent));
    };
    return result;
}

}  // namespace crevice
