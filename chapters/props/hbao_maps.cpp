#include "chapters/props/hbao_maps.h"

#include "chapters/props/surface_mean.h"
#include "scenes/builtin_scenes.h"
#include "scenes/composing.h"
#include "scenes/shapes.h"
#include "ssao/inputs/pixel_fetch.h"

namespace crevice {

std::size_t darkest_direction(const Explanation& texel, int steps) {
    const std::size_t length = static_cast<std::size_t>(steps);
    std::size_t best = 0;
    float most = -1;
    for (std::size_t first = 0; first < texel.samples.size(); first += length) {
        float taken = 0;
        for (std::size_t i = first; i < first + length; ++i) taken += texel.samples[i].contribution;
        if (taken > most) {
            most = taken;
            best = first;
        }
    }
    return best;
}

HbaoStrip hbao_over_steps(const JudgedView& view, const JudgedView& judged, const Truth& truth) {
    HbaoStrip strip;
    for (const std::string count : {"1", "2", "4", "12"}) {
        const Words words = {"steps=" + count, "bias=0"};
        const MethodLimit limit = judged.limit("hbao", words);
        const MapError error = judged.error(limit, truth);
        strip.errors.push_back(error.rmse);
        strip.noise.push_back(limit.noise);
        strip.rows.push_back(error_row("hbao, steps = " + count, error, limit));
        strip.pictures.push_back(
            {"steps_" + count, ao_picture(around_foot(view.map("hbao", words).raw.ao)), "steps = " + count});
    }
    return strip;
}

HbaoStrip hbao_over_radii(const JudgedView& view) {
    HbaoStrip strip;
    for (const std::string radius : {"0.25", "0.5", "1", "2"}) {
        const MethodMap map = view.map("hbao", {"radius=" + radius});
        strip.means.push_back(mean_over_surfaces(map.raw));
        strip.pictures.push_back({"radius_" + std::to_string(strip.pictures.size()),
                                  ao_picture(around_foot(map.raw.ao)), "radius " + radius});
    }
    return strip;
}

Scene faceted_ball() {
    Scene scene = empty_scene();
    scene.instances = {placed(add_mesh(scene, grid_mesh(40, 40, 2, 2)), {0, 0, 0}),
                       placed(add_mesh(scene, sphere_mesh(1, 12, 8)), {0, 1, 0})};
    scene.camera.eye = {0, 1.6, -3.4};
    scene.camera.target = {0, 0.8, 0};
    return scene;
}

Image<float> without_noise(const Scene& scene, Size size, HbaoSettings settings) {
    settings.samples = 96;
    settings.ao_scale = 1;
    settings.steps = 8;
    const GBuffer gbuffer = normal_depth(scene, scene.camera, size);
    return hbao(ao_inputs(gbuffer, scene.camera, pixel_fetch(settings)), settings).ao;
}

}  // namespace crevice
