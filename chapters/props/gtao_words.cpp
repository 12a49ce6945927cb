#include "chapters/props/gtao_words.h"

#include <cmath>
#include <numbers>

#include "chapters/props/number_words.h"
#include "chapters/terminal/number_text.h"
#include "ssao/ao_methods.h"
#include "ssao/methods/slices.h"

namespace crevice {
namespace {

const Method& gtao_row() { return find_method("gtao"); }

std::string listed(const std::string& list, const std::string& next) {
    return list.empty() ? next : list + ", " + next;
}

float kept_when_open(const SliceHorizons& slice) {
    return slice.length * (std::cos(slice.gamma) + slice.gamma * std::sin(slice.gamma));
}

}  // namespace

std::string degrees_text(float radians) {
    const long whole = std::lround(static_cast<double>(radians) * 180 / std::numbers::pi);
    return (whole < 0 ? "−" : "") + std::to_string(std::abs(whole)) + "°";
}

std::vector<SliceHorizons> slices_of_texel(const AoInputs& inputs, const GtaoSettings& settings, Texel at) {
    std::vector<SliceHorizons> slices;
    const int count = slice_plan(settings.samples).slices;
    for (int i = 0; i < count; ++i) slices.push_back(slice_horizons(inputs, settings, at.x, at.y, i));
    return slices;
}

std::vector<std::vector<std::string>> slice_rows(const std::vector<SliceHorizons>& slices) {
    std::vector<std::vector<std::string>> rows;
    for (const SliceHorizons& slice : slices) {
        rows.push_back({std::to_string(rows.size() + 1), text(slice.length), degrees_text(slice.gamma),
                        degrees_text(slice.before), degrees_text(slice.behind), text(kept_when_open(slice)),
                        text(slice.lost)});
    }
    return rows;
}

std::string kept_when_open_text(const std::vector<SliceHorizons>& slices) {
    std::string list;
    for (const SliceHorizons& slice : slices) list = listed(list, text(kept_when_open(slice)));
    return list;
}

float mean_kept_when_open(const std::vector<SliceHorizons>& slices) {
    float sum = 0;
    for (const SliceHorizons& slice : slices) sum += kept_when_open(slice);
    return sum / static_cast<float>(slices.size());
}

std::vector<std::vector<std::string>> gtao_parameter_rows() {
    struct ParameterRow {
        const char *name, *symbol, *meaning;
    };
    constexpr ParameterRow kParameters[] = {
        {"samples", "2NK", "slices times steps, to two sides"},
        {"radius", "R", "scene units; what is further away does not occlude"},
        {"radius_multiplier", "m", "samples are looked for up to m R"},
        {"falloff", "f", "over this outer part of m R they count less and less; 0: a cut"},
        {"step_power", "", "above 1 the steps lie denser near the texel"},
        {"thickness", "", "above 0 thin things occlude less"},
        {"exponent", "", "contrast"},
        {"ao_scale", "", "size of the map over that of the picture"},
        {"blur_iterations", "", "passes of the filter"}};
    std::vector<std::vector<std::string>> rows;
    for (const auto& [name, symbol, meaning] : kParameters) {
        const double value = value_of(gtao_row(), defaults_of(gtao_row()), name).value();
        rows.push_back({name, symbol, significant_text(value, 4), meaning});
    }
    return rows;
}

std::string sample_presets_text() {
    std::string list;
    for (const int samples : gtao_row().samples_to_try) list = listed(list, std::to_string(samples));
    return list;
}

std::string slice_plans_text() {
    std::string list;
    for (const int samples : gtao_row().samples_to_try) {
        const SlicePlan plan = slice_plan(samples);
        list = listed(list, std::to_string(plan.slices) + " × " + std::to_string(plan.steps));
    }
    return list;
}

}  // namespace crevice
