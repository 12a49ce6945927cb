#include "chapters/sweep/results_json.h"

#include "chapters/sweep/json_fields.h"
#include "chapters/terminal/json_text.h"

namespace crevice {

// The members of each struct, once for both directions (json_fields.h finds them by the struct's namespace).

template <class Archive>
void fields(Archive& archive, MedianInterval& interval) {
    archive("median", interval.median);
    archive("low", interval.low);
    archive("high", interval.high);
    archive("confidence", interval.confidence);
}

template <class Archive>
void fields(Archive& archive, SweepView& view) {
    archive("scene", view.scene);
    archive("camera", view.camera);
    archive("size", view.size);
    archive("triangles", view.triangles);
}

template <class Archive>
void fields(Archive& archive, SweepSetting& setting) {
    archive("method", setting.method);
    archive("parameters", setting.parameters);
}

template <class Archive>
void fields(Archive& archive, SweepError& error) {
    archive("rmse", error.rmse);
    archive("rmse_error", error.rmse_error);
    archive("bias", error.bias);
    archive("mae", error.mae);
    archive("p99", error.p99);
    archive("flip", error.flip);
    archive("ssim", error.ssim);
    archive("reference_error", error.reference_error);
    archive("mse", error.mse);
    archive("mse_error", error.mse_error);
}

template <class Archive>
void fields(Archive& archive, SweepErrorPart& part) {
    archive("step", part.step);
    archive("bias", part.bias);
    archive("rmse", part.rmse);
    archive("share", part.share);
}

template <class Archive>
void fields(Archive& archive, SweepErrorResult& result) {
    archive("id", result.id);
    archive("view", result.view);
    archive("setting", result.setting);
    archive("seed", result.seed);
    archive("nan_or_inf", result.nan_or_inf);
    archive("soft", result.soft);
    archive("hard", result.hard);
    archive("parts", result.parts);
    archive("limit_mse", result.limit_mse);
    archive("hash", result.hash);
    archive("picture", result.picture);
    archive("command", result.command);
}

template <class Archive>
void fields(Archive& archive, SweepPassTime& time) {
    archive("pass", time.pass);
    archive("wall_ms", time.wall);
    archive("cpu_ms", time.cpu);
    archive("wall_ms_mad", time.wall_mad);
    archive("instructions", time.instructions);
}

template <class Archive>
void fields(Archive& archive, SweepMachine& machine) {
    archive("cpu", machine.cpu);
    archive("isa", machine.isa);
    archive("compiler", machine.compiler);
    archive("version", machine.version);
    archive("cores", machine.cores);
    archive("lanes", machine.lanes);
}

template <class Archive>
void fields(Archive& archive, SweepTimeResult& result) {
    archive("id", result.id);
    archive("view", result.view);
    archive("setting", result.setting);
    archive("threads", result.threads);
    archive("rounds", result.rounds);
    archive("passes", result.passes);
    archive("same_again", result.same_again);
    archive("hash", result.hash);
    archive("command", result.command);
}

template <class Archive>
void fields(Archive& archive, SweepResults& results) {
    archive("plan", results.plan);
    archive("version", results.version);
    archive("machine", results.machine);
    archive("missing", results.missing);
    archive("errors", results.errors);
    archive("times", results.times);
    archive("plan_text", results.plan_text);
}

template <class Archive>
void fields(Archive& archive, FinishedJob& job) {
    archive("id", job.id);
    archive("version", job.version);
    archive("error", job.error);
    archive("machine", job.machine);
    archive("times", job.times);
}

namespace {

template <class T>
T read_as(const std::string& text, const std::string& name) {
    const JsonFile file(text, name, ExitCode::input);
    T value;
    JsonReader reader(file, file.root(), {});
    fields(reader, value);
    return value;
}

}  // namespace

std::string results_json(const SweepResults& results) { return json_text(JsonWriter::written(results)); }

SweepResults results_from_json(const std::string& text, const std::string& name) {
    return read_as<SweepResults>(text, name);
}

std::string job_json(const FinishedJob& job) { return json_text(JsonWriter::written(job)); }

FinishedJob job_from_json(const std::string& text, const std::string& name) {
    return read_as<FinishedJob>(text, name);
}

std::string json_line(const SweepView& view) {
    return json_line(JsonWriter::written(view));
}

std::string json_line(const SweepSetting& setting) {
    return json_line(JsonWriter::written(setting));
}

}  // namespace crevice
