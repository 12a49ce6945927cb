#include "chapters/sweep/sweep_directory.h"

#include "chapters/notebook/picture.h"
#include "chapters/sweep/json_fields.h"
#include "chapters/sweep/sweep_words.h"
#include "chapters/terminal/json_text.h"
#include "rasterizer/base/file_bytes.h"
#include "rasterizer/base/write_file.h"

namespace crevice {

template <class Archive>
void fields(Archive& archive, ListedJob& job) {
    archive("id", job.id);
    archive("kind", job.kind);
    archive("words", job.words);
}

template <class Archive>
void fields(Archive& archive, SweepListing& listing) {
    archive("plan", listing.plan);
    archive("jobs", listing.jobs);
}

namespace {

constexpr const char *kPlanFile = "plan.json", *kListingFile = "jobs.json";

bool holds(const std::filesystem::path& path, const std::string& bytes) {
    try {
        return read_file(path, kLargestSweepFile) == bytes;
    } catch (const InputError&) {
        return false;
    }
}

// Another shard may write the same at the same time.
void write_shared(const std::filesystem::path& path, const std::string& bytes) {
    if (holds(path, bytes)) return;
    try {
        write_file_atomically(path, bytes);
    } catch (const OutputError&) {
        if (!holds(path, bytes)) throw;
    }
}

}  // namespace

const char* kind_of(const SweepJob& job) { return job.timed ? "time" : "error"; }

void SweepDirectory::begin(const SweepPlan& plan, const std::vector<SweepJob>& jobs) const {
    std::error_code error;
    std::filesystem::create_directories(path_ / "jobs", error);
    if (error)
        throw OutputError(path_.string() + ": cannot make this directory (" + error.message() +
                          "); choose another --out");
    SweepListing listing{plan.name, {}};
    for (const SweepJob& job : jobs) listing.jobs.push_back({job.id, words_of(job), kind_of(job)});
    write_shared(path_ / kPlanFile, plan.text);
    write_shared(path_ / kListingFile, json_text(JsonWriter::written(listing)));
}

std::string SweepDirectory::plan_text() const { return read_file(path_ / kPlanFile, kLargestSweepFile); }

SweepListing SweepDirectory::listing() const {
    const std::filesystem::path path = path_ / kListingFile;
    const JsonFile file(read_file(path, kLargestSweepFile), path.string(), ExitCode::input);
    SweepListing listing;
    JsonReader reader(file, file.root(), {});
    fields(reader, listing);
    return listing;
}

std::optional<FinishedJob> SweepDirectory::finished(const std::string& id, const std::string& version) const {
    std::error_code ignored;
    if (!std::filesystem::exists(file_of(id), ignored)) return std::nullopt;
    try {
        FinishedJob job = job_from_json(read_file(file_of(id), kLargestSweepFile), file_of(id).string());
        if (job.id == id && job.version == version) return job;
    } catch (const InputError&) {
        // It is done again.
    }
    return std::nullopt;
}

void SweepDirectory::store(const FinishedJob& job, const Image<float>* picture) const {
    if (picture != nullptr) write_picture(path_ / picture_name(job.id), ao_picture(*picture));
    write_file_atomically(file_of(job.id), job_json(job));
}

}  // namespace crevice
