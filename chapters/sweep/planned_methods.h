// The methods of a plan, and the values that their parameters take.
#pragma once

#include <string>
#include <vector>

#include "chapters/frame/frame_settings.h"
#include "chapters/sweep/sweep_results.h"
#include "chapters/terminal/json_file.h"

namespace crevice {

// The values that one parameter takes, as words.
struct PlannedValues {
    std::string parameter;
    std::vector<std::string> words;
    JsonPlace place;
};

struct PlannedMethod {
    const Method* method = nullptr;
    std::vector<PlannedValues> values;  // in the order of sweep_parameters()
    JsonPlace place;
};

// What can be varied: the parameters of the method and its denoiser without the seed, and how the buffers before them are
// stored. All others concern passes that a sweep does not run.
std::vector<Parameter<FrameSettings>> sweep_parameters(const Method& method);

// "methods" of a plan with the "parameters" of all of them. Refuses what the table of methods does not have.
std::vector<PlannedMethod> planned_methods(const JsonFile& plan);

// Every combination of the method's values; the last parameter changes first.
std::vector<SweepSetting> settings_of(const PlannedMethod& method);

}  // namespace crevice
