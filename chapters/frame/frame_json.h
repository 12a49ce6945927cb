// What a frame tells of itself as JSON: parts of passes.json, and of what the lab in the browser is told.
#pragma once

#include <nlohmann/json.hpp>

#include "chapters/frame/frame.h"
#include "rasterizer/base/image_summary.h"

namespace crevice {

// [{"name", "wall_ms", "cpu_ms", "wall_ms_mad", "runs"}], last the frame.
nlohmann::ordered_json passes_json(const std::vector<PassTime>& passes);
// {"name": count}, each kind of loss once.
nlohmann::ordered_json precision_json(const std::vector<PrecisionLoss>& losses);
// {"name": value}, everything that `--param` can set: numbers, booleans, and words where there is a choice.
nlohmann::ordered_json parameters_json(const Method& method, const FrameSettings& settings);
// {"name": word}, the same as `--param` takes it.
nlohmann::ordered_json parameter_words_json(const FrameRequest& request);
// {"shape", "min", "max", "mean", "nan", "inf"} of a buffer; the shape is [height, width] or [height, width, components].
nlohmann::ordered_json statistics_json(Size size, int components, const BufferStatistics& statistics);

}  // namespace crevice
