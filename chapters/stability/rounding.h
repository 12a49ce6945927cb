// Rounding errors of every pass, against an independent judge in double (ssao/judge/double_judge.h).
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "chapters/notebook/table.h"
#include "chapters/stability/stiff_cases.h"
#include "ssao/inputs/double_buffers.h"

namespace crevice {

// How far numbers are off, over a picture.
struct RoundingFigures {
    double max = 0, p99 = 0, mean = 0;
};
RoundingFigures rounding_figures(std::vector<double> off);

// One quantity that a pass before AO makes.
struct PassRounding {
    std::string pass, unit;
    RoundingFigures off;
};

// Which roundings an AO map has, with which it is compared that has none.
enum class RoundingCause {
    kernel,   // those of its own arithmetic: in float and in double from the same float buffers
    depth,    // the depth buffer's: in double from float depths, and from the judge's
    normal,   // the normal buffer's, likewise
    all,      // in float from float buffers, and in double from the judge's
    blurred,  // the same two, denoised
};
inline constexpr RoundingCause kRoundingCauses[] = {RoundingCause::kernel, RoundingCause::depth,
                                                    RoundingCause::normal, RoundingCause::all,
                                                    RoundingCause::blurred};
const char* word_of(RoundingCause cause);

// A texel that is off by more than this was not rounded: a comparison came out otherwise, and a whole sample with it.
inline constexpr double kDecidedOtherwise = 1e-4;
// An ulp of accessibility: the step of a float just below 1.
inline constexpr double kAoUlp = 0x1p-24;

struct AoRounding {
    RoundingFigures off;           // accessibility
    double decided_otherwise = 0;  // share of the texels
};

struct MethodRounding {
    const Method* method = nullptr;
    std::array<std::optional<AoRounding>, std::size(kRoundingCauses)> by_cause;

    const std::optional<AoRounding>& of(RoundingCause cause) const {
        return by_cause[static_cast<std::size_t>(cause)];
    }
};
// Why there is no kernel in double; "" where there is one.
std::string why_not_in_double(const Method& method);

// What is drawn, in float and as the judge has it. AO maps are of the picture's size, so that a texel is a pixel.
struct RoundingView {
    StiffView view;
    Camera camera;  // with the depth direction that the view's parameters ask for
    ScreenGeometry geometry;
    GBuffer gbuffer;
    DoubleGBuffer judged;
};
RoundingView rounding_view(StiffView view, const Run& run);

// Of the vertex transform, the depth buffer, view depth and normals, and of what a texel of half size makes of these.
std::vector<PassRounding> pass_rounding(const RoundingView& view);
MethodRounding method_rounding(const RoundingView& view, const Method& method, const Run& run);

struct RoundingCase {
    std::string name;      // unique; a word
    std::string question;  // half a sentence: where its errors come from
    std::function<StiffView()> view;
};
std::vector<RoundingCase> rounding_cases(bool quick);

struct CaseRounding {
    RoundingCase of;
    std::vector<PassRounding> passes;
    std::vector<MethodRounding> methods;
};
// Of every method, or of `only`.
CaseRounding case_rounding(const RoundingCase& of, const Method* only, const Run& run);

// One row a case and pass; one row a case, method and cause.
Table pass_rounding_table(const std::vector<CaseRounding>& cases);
Table method_rounding_table(const std::vector<CaseRounding>& cases);
// What the page says of them.
std::string rounding_section(const std::vector<CaseRounding>& cases);

}  // namespace crevice
