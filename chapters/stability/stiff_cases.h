// Cases that ask much of the numbers, each with the answer that mathematics gives, stated before anything is measured.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "chapters/frame/frame.h"

namespace crevice {

// What the AO map of a case must be.
enum class Answer {
    open,  // 1 where a surface is; a mean off by kStatedBias is within what a method states of tilted planes
    same,  // the map of another view of the same, to the last bit
    background,  // nothing is seen: 1 to the last bit
    in_range,    // no closed form: finite and within [0,1]
    refused,     // the parameters are beyond their limits: one line that names the first
};

// A mean accessibility of an open plane may be off by this much: depths are filtered, planes tilted.
inline constexpr double kStatedBias = 0.01;

struct StiffView {
    Scene scene;
    Camera camera;
    Size size{96, 64};
    std::vector<std::string> params = {};  // "name=value"; those that a method does not have are left out
};

// The method's settings for a view.
FrameSettings settings_of(const StiffView& view, const Method& method);

struct StiffCase {
    std::string name;      // unique; a word
    std::string question;  // half a sentence: what is stiff about it
    Answer answer;
    std::function<StiffView()> view;
    std::function<StiffView()> same_as = {};  // of Answer::same
    // The share of the picture that shows a surface; none: not asked. A row or a column of pixels may be missing.
    std::optional<double> covered = {};
};

// The answer that mathematics gives, in words.
std::string stated_answer(const StiffCase& stiff);

// `quick`: one or two of each kind.
std::vector<StiffCase> stiff_cases(bool quick);

}  // namespace crevice
