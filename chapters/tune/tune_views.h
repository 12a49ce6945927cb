// What settings are judged on: views with their ray-cast truth, those that the search sees and those that it does not.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "chapters/study/method_view.h"
#include "chapters/study/references.h"
#include "ssao/judge/surface_masks.h"

namespace crevice {

// What counts as an occluder: whatever lies within the radius, or by the share that the method's fade gives it.
enum class TuneTruth { hard, soft };

struct TuneView {
    std::string name;  // "columns", "columns, turned by 20 degrees"
    std::shared_ptr<const Scene> scene;
    MethodView view;
    Reference truth;
    Image<SurfaceKind> kinds;
};

struct TuneViews {
    std::vector<TuneView> searched, held_out;
};

struct TuneViewsRequest {
    // Names or paths; the last of several is held out, of one its second view.
    std::vector<std::string> scenes;
    const Method* method = nullptr;
    Size size;
    TuneTruth truth = TuneTruth::hard;
    int rays = 256;  // of the truth
    std::optional<std::filesystem::path> cache;
    std::optional<double> crease_angle_rad;  // WantedOfScene::crease_angle_rad
    Run run;
};

// Throws as load_scene() and make_references(), and InputError for a scene without triangles.
TuneViews tune_views(const TuneViewsRequest& request);

}  // namespace crevice
