// The directory of a sweep:
//   plan.json     the plan as it was given
//   jobs.json     the jobs that it came to
//   jobs/ID.json  what a job has done, and ID.png, the AO image of an error job
// All files are written whole or not at all.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "chapters/sweep/results_json.h"
#include "chapters/sweep/sweep_jobs.h"

namespace crevice {

// jobs.json
struct ListedJob {
    std::string id, words;
    std::string kind;  // "error" or "time"
};
struct SweepListing {
    std::string plan;             // its name
    std::vector<ListedJob> jobs;  // in the plan's order
};

const char* kind_of(const SweepJob& job);

// Bytes; a file that is longer is none of a sweep's.
inline constexpr std::uintmax_t kLargestSweepFile = 1 << 28;

class SweepDirectory {
 public:
    explicit SweepDirectory(std::filesystem::path path) : path_(std::move(path)) {}

    const std::filesystem::path& path() const { return path_; }
    std::filesystem::path file_of(const std::string& id) const { return path_ / "jobs" / (id + ".json"); }

    // Makes it, with the first two files. Shards may do this at the same time. Throws OutputError.
    void begin(const SweepPlan& plan, const std::vector<SweepJob>& jobs) const;
    // Throw InputError.
    std::string plan_text() const;
    SweepListing listing() const;

    // What the job has done, if this version of the program did it and its file is whole.
    std::optional<FinishedJob> finished(const std::string& id, const std::string& version) const;

    // `picture` of an error job: the file of the picture comes first, so that what is finished has one. Throws OutputError.
    void store(const FinishedJob& job, const Image<float>* picture = nullptr) const;

    // Relative to the directory.
    static std::string picture_name(const std::string& id) { return "jobs/" + id + ".png"; }

 private:
    std::filesystem::path path_;
};

}  // namespace crevice
