// The jobs that a plan comes to, each with an id that is the hash of all that its result follows from.
//   error job:  one setting and seed on one view; the same bytes on every machine and number of threads
//   time job:   one view and number of threads with all settings, which take turns
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "chapters/sweep/sweep_plan.h"

namespace crevice {

// A planned scene, loaded.
struct SweepScene {
    SceneArgument argument;
    Camera camera;
    std::string name, camera_words;  // SCENE, and its camera flags as words
    std::string key;                 // scene_key()
};

struct SweepJob {
    std::string id;  // 16 hex digits
    bool timed = false;
    std::shared_ptr<const SweepScene> scene;
    SweepView view;
    std::vector<SweepSetting> settings;  // of an error job one
    std::uint32_t seed = 0;
    bool parts = false;           // of an error job: its error is taken apart
    std::string asks;             // jobs of one view that ask the same question share its truth
    int threads = 1, rounds = 0;  // of a time job
    bool instructions = false;    // of a time job: they are counted, too
    int reference_rays = 0;
    // Estimates of what it costs, in samples of a pixel: the job itself, and the truth that it shares with others.
    double work = 0, truth_work = 0;
};

// All of them, in the plan's order: error jobs, then time jobs. Loads the scenes. `instructions`: time jobs count them.
// Throws UsageError "PLAN:LINE: ..." for cameras and settings that are out of range and for over 100,000 error jobs;
// else as load_scene().
std::vector<SweepJob> sweep_jobs(const SweepPlan& plan, bool instructions, const Run& run);

}  // namespace crevice
