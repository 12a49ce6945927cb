// Parameters as words: what stands behind `--param name=`, in lists and in passes.json.
#pragma once

#include <string>

#include "chapters/frame/frame_settings.h"

namespace crevice {

// Sets what the word says. Throws UsageError naming the parameter for a word that is no value of its kind.
void set_from_word(const Parameter<FrameSettings>& parameter, FrameSettings& settings,
                   const std::string& word);

// The word for the present value; "custom" for a choice that has none.
std::string word_of(const Parameter<FrameSettings>& parameter, const FrameSettings& settings);

}  // namespace crevice
