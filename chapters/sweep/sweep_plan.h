// What a sweep is to try: scenes, sizes, methods and their parameters, seeds; and how often it is to be timed.
// Form:   schemas/sweep_plan.schema.json; plans/quick.json is an example
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "chapters/frame/scene_argument.h"
#include "chapters/sweep/planned_methods.h"

namespace crevice {

struct PlannedScene {
    std::string name;    // SCENE on the command line
    CameraFlags camera;  // as they would be typed
    std::optional<std::string> crease;
    JsonPlace place;
};

struct SweepPlan {
    JsonFile file;
    std::string name, text;
    std::vector<PlannedScene> scenes;
    std::vector<Size> sizes;
    std::vector<PlannedMethod> methods;
    std::vector<std::uint32_t> seeds;
    std::vector<int> threads;  // of the timings
    int repetitions = 0;       // rounds of the timings; 0: nothing is timed
    int reference_rays = 256;  // a pixel
    bool parts = false;        // whether each setting's error is taken apart
};

// Throws UsageError "FILE:LINE: what is wrong (value); what to do". Whether lengths are in range is known only once the
// scenes are there, with their units (sweep_jobs.h).
SweepPlan plan_from_text(const std::string& text, const std::string& file);

// A plan that is part of the program, or a file. Throws UsageError for a word that is neither, InputError for a file that
// cannot be read; else as plan_from_text().
SweepPlan find_plan(const std::string& name_or_path);

}  // namespace crevice
