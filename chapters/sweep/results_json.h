// The results of a sweep, and of single jobs, as JSON: schemas/sweep_results.schema.json.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "chapters/sweep/sweep_results.h"

namespace crevice {

// results_from_json() gives back the same to the last bit. No number is NaN.
std::string results_json(const SweepResults& results);

// Throws InputError "NAME:LINE: what is wrong (value); what to do".
SweepResults results_from_json(const std::string& text, const std::string& name);

// What a job has done, as its file holds it.
struct FinishedJob {
    std::string id;
    std::string version;                    // of the program, with its commit
    std::optional<SweepErrorResult> error;  // of an error job
    std::optional<SweepMachine> machine;    // of a time job
    std::vector<SweepTimeResult> times;     // of a time job, in the plan's order
};
std::string job_json(const FinishedJob& job);
// Throws as results_from_json().
FinishedJob job_from_json(const std::string& text, const std::string& name);

// Lines that tell apart what is alike: for ids, and as keys.
std::string json_line(const SweepView& view);
std::string json_line(const SweepSetting& setting);

}  // namespace crevice
