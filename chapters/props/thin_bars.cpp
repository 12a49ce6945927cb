#include "chapters/props/thin_bars.h"

#include <utility>

#include "scenes/builtin_scenes.h"
#include "scenes/composing.h"
#include "scenes/shapes.h"

namespace crevice {
namespace {

constexpr std::pair<const char*, double> kThicknesses[] = {
    {"0.06", 0.06}, {"0.125", 0.125}, {"0.25", 0.25}, {"0.5", 0.5}, {"1", 1.0}, {"2", 2.0}, {"4", 4.0}};

}  // namespace

Scene bars_before_a_wall() {
    constexpr int kBars = 5;  // to each side of the middle one
    Scene scene = empty_scene();
    scene.instances = {placed(add_mesh(scene, box_mesh({16, 12, 0.2})), {0, 0, 6.1})};
    const int bar = add_mesh(scene, box_mesh({0.06, 12, 0.06}));
    for (int i = -kBars; i <= kBars; ++i) scene.instances.push_back(placed(bar, {0.8 * i, 0, 5}));
    scene.camera.eye = {-1.2, 0.5, 0};
    scene.camera.target = {0, 0, 6};
    return scene;
}

ThicknessError over_thickness(const std::string& name, const JudgedView& view, const Truth& truth,
                              const Words& words) {
    ThicknessError result{{name, {}, {}}};
    double least = 1;
    for (const auto& [word, value] : kThicknesses) {
        Words all = words;
        all.push_back(std::string("thickness=") + word);
        const double error = view.error(view.limit("vbao", all), truth).rmse;
        result.curve.x.push_back(value);
        result.curve.y.push_back(error);
        if (error < least) {
            least = error;
            result.best = value;
        }
    }
    return result;
}

}  // namespace crevice
