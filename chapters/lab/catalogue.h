// What the lab offers: scenes, presets, methods and their parameters, as the tables have them.
#pragma once

#include <nlohmann/json.hpp>

namespace crevice {

// {"scenes": [{"name", "purpose", "unit"}], "presets": [{"name", "title", "scene", "method", "params"}],
//  "buffer_names": [name], "methods": [{"name", "title", "source", "computes_ao", "bent_normals",
//   "parameters": [{"name", "kind", "range", "unit", "effect", "default", "part"}]}]}
// "kind" is number, whole, yes_no or choice; "part" says whose parameter it is: method, denoiser, buffers or light;
// "default" is a word for scenes whose length_unit is 1.
nlohmann::ordered_json lab_catalogue();

}  // namespace crevice
