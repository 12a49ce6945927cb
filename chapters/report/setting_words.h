// Settings, views and lists in words, as tables and sentences of a sweep's report name them.
#pragma once

#include <string>
#include <vector>

#include "chapters/sweep/sweep_results.h"

namespace crevice {

// "8 samples, half size, no blur, radius 0.5"; "defaults" where nothing differs from them.
std::string setting_words(const SweepSetting& setting);

// The method and its setting inside a sentence: "gtao with 8 samples at half size with no blur", "gtao with its defaults".
std::string setting_phrase(const SweepSetting& setting);

// The setting without one of its parameters.
SweepSetting without(SweepSetting setting, const std::string& parameter);

// "columns, 640x360"; with the camera's words where it is not the scene's own.
std::string view_words(const SweepView& view);

// "0.0020", or "unknown" where it is infinite.
std::string margin_words(double margin);

// "a", "a and b", "a, b and c".
std::string listed(const std::vector<std::string>& words);

// Between back ticks, as Markdown writes what is typed; back ticks inside become quotes.
std::string as_code(const std::string& text);

// Plain text for Markdown: nothing in it means more than itself.
std::string escaped_markdown(const std::string& text);

}  // namespace crevice
