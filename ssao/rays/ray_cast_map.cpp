#include "ssao/rays/ray_cast_map.h"

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "rasterizer/base/error.h"
#include "rasterizer/base/parallel.h"
#include "ssao/inputs/pixel_fetch.h"
#include "ssao/methods/each_texel.h"
#include "ssao/methods/settings_range.h"
#include "ssao/rays/open_region.h"
#include "ssao/rays/ray_map_caster.h"

namespace crevice {

namespace {

constexpr int kMostSamples = 256;

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
        run_narrow_kernel(run, [&]<class F>(Lanes<F>) {
            for_occluded_rays<F>(caster.scene, rays, caster.settings.radius, [&](std::size_t ray) {
                ++met[ray / static_cast<std::size_t>(caster.settings.samples)];
            });
        });
        for (std::size_t i = 0; i < count; ++i)
            ao.at(left + texel[i] % kTexelTile, top + texel[i] / kTexelTile) =
                accessibility_of(caster.settings, static_cast<float>(met[i]));
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
    result.value_of_sum = [settings](float sum) { return accessibility_of(settings, sum); };
    return result;
}

}  // namespace crevice
