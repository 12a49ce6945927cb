// What is searched of each method follows from its row: every value is one that the method takes.
#include "chapters/tune/tune_axes.h"

#include <algorithm>

#include <doctest/doctest.h>

#include "chapters/frame/frame_settings.h"
#include "tests/tools/method_maps.h"

using namespace crevice;

namespace {

constexpr double kRadius = 0.5;

const TuneAxis* axis_named(const std::vector<TuneAxis>& axes, const std::string& name) {
    const auto found = std::ranges::find(axes, name, &TuneAxis::name);
    return found == axes.end() ? nullptr : &*found;
}

std::vector<std::string> words_in(const std::string& text) {
    std::vector<std::string> words;
    std::size_t at = 0;
    while ((at = text.find("--param ", at)) != std::string::npos) {
        at += 8;
        words.push_back(text.substr(at, text.find(' ', at) - at));
    }
    return words;
}

}  // namespace

TEST_CASE(
    "tune axes: of every method, each value by itself is valid, and the default is where it should be") {
    for (const Method* method : computing_methods()) {
        CAPTURE(std::string(method->name));
        const std::vector<TuneAxis> axes = tune_axes(*method, kRadius);
        REQUIRE(axis_named(axes, "radius") != nullptr);
        CHECK(axis_named(axes, "seed") == nullptr);
        CHECK(axis_named(axes, "as_published") == nullptr);
        CHECK((axis_named(axes, "samples") != nullptr) == !method->samples_to_try.empty());
        for (std::size_t i = 0; i < axes.size(); ++i) {
            const TuneAxis& axis = axes[i];
            CAPTURE(axis.name);
            CHECK(axis.at(axis.share_of(axis.standard)) == doctest::Approx(axis.standard).epsilon(0.01));
            double before = axis.at(0);
            for (int step = 0; step <= 20; ++step) {
                TuneSetting setting = standard_setting(axes);
                setting[i] = axis.at(step / 20.0);
                CAPTURE(setting[i]);
                CHECK(setting[i] >= before);
                before = setting[i];
                // A fade that ends before it starts, and samples that steps do not divide, the search leaves aside.
                if (axis.name == "fade_start" || axis.name == "fade_end" || axis.name == "steps") continue;
                CHECK_NOTHROW(validate(*method, settings_with(*method, axes, setting, 1, 7)));
            }
        }
    }
}

TEST_CASE("tune axes: ladders, ranges, and the two sizes of the map") {
    const std::vector<TuneAxis> axes = tune_axes(find_method("xjun"), kRadius);
    CHECK(axis_named(axes, "samples")->values == std::vector<double>{1, 2, 4, 7, 10, 14});
    CHECK(axis_named(axes, "ao_scale")->values == std::vector<double>{0.5, 1});
    CHECK(axis_named(axes, "blur_iterations")->values == std::vector<double>{0, 1, 2, 4, 8, 16});
    CHECK(axis_named(axes, "radius")->low == 0.25);
    CHECK(axis_named(axes, "radius")->high == 1);
    CHECK(axis_named(axes, "exponent")->low == 0.5);
    CHECK(axis_named(axes, "exponent")->high == 32);
    CHECK(axis_named(tune_axes(find_method("gtao"), kRadius), "thickness")->high == 0.7);
    CHECK(tune_axes(find_method("none"), kRadius).size() <= 1);
}

TEST_CASE("tune axes: the words that are printed give the settings that were judged, in the scene's units") {
    const Method& xjun = find_method("xjun");
    const std::vector<TuneAxis> axes = tune_axes(xjun, kRadius);
    TuneSetting setting;
    for (std::size_t i = 0; i < axes.size(); ++i)
        setting.push_back(axes[i].at(0.37 + 0.01 * static_cast<double>(i)));
    for (const float length_unit : {1.0f, 4.0f, 0.01f}) {
        CAPTURE(length_unit);
        const MethodSettings judged = settings_with(xjun, axes, setting, length_unit, 1);
        const FrameSettings typed =
            settings_of(xjun, words_in(param_words(axes, setting, length_unit)), length_unit);
        for (const Parameter<MethodSettings>& p : parameters_of(xjun)) {
            CAPTURE(p.name);
            CHECK(p.get(judged) == p.get(typed.method));
        }
    }
    CHECK(param_words(axes, standard_setting(axes), 1) == "");
}
