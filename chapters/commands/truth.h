// `crevice truth SCENE`: the references of one view as files, each with its standard error, and passes.json.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "chapters/frame/scene_argument.h"
#include "chapters/study/references.h"

namespace crevice {

struct TruthOptions {
    std::string scene;
    bool outside_files = false;              // WantedOfScene::outside_files
    std::optional<double> crease_angle_rad;  // the same
    CameraFlags camera;
    std::vector<std::string> params;  // "name=value", of the method
    std::optional<float> radius;      // scene units; none: the method's
    ReferenceRequest request;         // its `ao` and radius follow from the above and the scene
    std::filesystem::path out = "out";
};

// Writes OUT/truth_hard, truth_soft, truth_screen and truth_limit, each .npy and .png and with ..._error, and
// OUT/passes.json, and prints one line for each. Throws InputError, UsageError, OutputError.
void write_truth(const TruthOptions& options);

}  // namespace crevice
