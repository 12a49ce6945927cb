#include "chapters/frame/frame_settings.h"

#include <cstdint>
#include <functional>
#include <set>
#include <sstream>

#include <doctest/doctest.h>

#include "chapters/frame/parameter_words.h"
#include "chapters/terminal/parse.h"
#include "rasterizer/base/error.h"
#include "rasterizer/base/memory.h"
#include "tests/tools/tutorial_settings.h"

using namespace crevice;

namespace {

const Method& xjun() { return find_method("xjun"); }

FrameSettings xjun_with(const std::string& assignment) { return settings_of(xjun(), {assignment}); }

}  // namespace

TEST_CASE("parameters: the tutorials' defaults") {
    const FrameSettings x = settings_of(xjun(), {}), l = settings_of(find_method("luna"), {});
    CHECK(ao_of(x).samples == 14);
    CHECK(ao_of(x).radius == 0.5f);
    CHECK(ao_of(x).fade_start == 0.2f);
    CHECK(ao_of(x).fade_end == 2.0f);
    CHECK(ao_of(x).epsilon == 0.05f);
    CHECK(ao_of(x).exponent == 4);
    CHECK(blur_of(x).iterations == 4);
    CHECK(blur_of(x).weights == kXjunBlurWeights);
    CHECK(ao_of(l).radius == 0.5f);
    CHECK(ao_of(l).fade_end == 1.0f);
    CHECK(ao_of(l).exponent == 6);
    CHECK(blur_of(l).iterations == 3);
    CHECK(blur_of(l).weights == kLunaBlurWeights);
    CHECK(blur_of(l).normal_threshold == 0.8f);
    CHECK(blur_of(l).depth_threshold == 0.2f);
}

TEST_CASE(
    "parameters: each has a unique name, range and effect, and its default, read back, changes nothing") {
    for (const Method& method : ao_methods()) {
        std::set<std::string> names;
        for (const Parameter<FrameSettings>& parameter : frame_parameters(method)) {
            CAPTURE(std::string(method.name));
            CAPTURE(std::string(parameter.name));
            CHECK(names.insert(parameter.name).second);
            CHECK(std::string(parameter.range) != "");
            CHECK(std::string(parameter.unit) != "");
            CHECK(std::string(parameter.effect) != "");
            const FrameSettings defaults = settings_of(method);
            const std::string word = word_of(parameter, defaults);
            const FrameSettings again = settings_of(method, {parameter.name + ("=" + word)});
            for (const Parameter<FrameSettings>& other : frame_parameters(method))
                CHECK(other.get(again) == other.get(defaults));
        }
        for (const char* common : {"samples", "radius", "exponent", "seed"}) {
            CAPTURE(std::string(common));
            CHECK(names.contains(common) == method.computes_ao());
        }
        CHECK(names.contains("blur_iterations") == (method.denoiser.denoised != nullptr));
        for (const char* buffers : {"depth_format", "buffer_format"}) CHECK(names.contains(buffers));
    }
}

TEST_CASE("parameters: a value arrives where it belongs, the last one wins") {
    CHECK(ao_of(xjun_with("samples=3")).samples == 3);
    CHECK(ao_of(xjun_with("radius=.75")).radius == 0.75f);
    CHECK(ao_of(xjun_with("fade_start=0")).fade_start == 0);
    CHECK(ao_of(xjun_with("fade_end=1e2")).fade_end == 100);
    CHECK(ao_of(xjun_with("epsilon=0.01")).epsilon == 0.01f);
    CHECK(ao_of(xjun_with("exponent=0")).exponent == 0);
    CHECK(ao_of(xjun_with("seed=4294967295")).seed == 0xffffffffu);
    CHECK(ao_of(xjun_with("as_published=true")).as_published);
    CHECK(ao_of(xjun_with("as_published=1")).as_published);
    CHECK(!ao_of(xjun_with("as_published=0")).as_published);
    CHECK(ao_of(xjun_with("ao_format=float16")).format == BufferFormat::float16_toward_zero);
    CHECK(xjun_with("buffer_format=float16_nearest").buffers.buffer_format ==
          BufferFormat::float16_nearest_even);
    CHECK(blur_of(xjun_with("blur_iterations=0")).iterations == 0);
    CHECK(blur_of(xjun_with("blur_weights=luna")).weights == kLunaBlurWeights);
    CHECK(blur_of(xjun_with("blur_normal=-1")).normal_threshold == -1);
    CHECK(blur_of(xjun_with("blur_depth=3")).depth_threshold == 3);
    CHECK(xjun_with("depth_format=d16").buffers.depth_format == DepthFormat::d16);
    CHECK(!xjun_with("depth_format=d32f").reversed_z);
    CHECK(xjun_with("depth_format=d32f_reversed").reversed_z);
    CHECK(ao_of(settings_of(xjun(), {"samples=3", "radius=1", "samples=5"})).samples == 5);
    CHECK(ao_of(settings_of(xjun(), {"fade_start=5", "fade_end=6"})).fade_start == 5);
}

TEST_CASE("parameters: each artifact has a switch, at its cure by default") {
    const auto ao = [](const std::string& assignment) { return ao_of(xjun_with(assignment)); };
    CHECK(ao("random_vectors=raw").random_vectors == RandomVectors::raw);
    CHECK(ao("random_vectors=none").random_vectors == RandomVectors::none);
    CHECK(ao("sign_of_zero=zero").sign_of_zero == SignOfZero::zero);
    CHECK(!ao("self_occlusion_test=false").self_occlusion_test);
    CHECK(ao("depth_source=ndc_depth").depth_source == DepthSource::ndc_depth);
    CHECK(ao("border=edge").border == MapBorder::edge);
    CHECK(ao("border=wrap").border == MapBorder::wrap);
    CHECK(ao("texel_centre=off").texel_centre == TexelCentre::off);
    CHECK(ao("edge_texels=mixed").edge_texels == EdgeTexels::mixed);
    CHECK(ao("sky_depth=as_stored").sky_depth == SkyDepth::as_stored);
    CHECK(blur_of(xjun_with("blur_edges=slope")).edges == BlurEdges::slope);
    CHECK(blur_of(xjun_with("blur_edges=none")).edges == BlurEdges::none);
    for (const Method* method : {&xjun(), &find_method("luna")}) {
        CAPTURE(std::string(method->name));
        const FrameSettings s = settings_of(*method, {});
        CHECK(ao_of(s).random_vectors == RandomVectors::unit);
        CHECK(ao_of(s).sign_of_zero == SignOfZero::plus);
        CHECK(ao_of(s).self_occlusion_test);
        CHECK(ao_of(s).border == MapBorder::far);
        CHECK(ao_of(s).texel_centre == TexelCentre::exact);
        CHECK(ao_of(s).edge_texels == EdgeTexels::nearest);
        CHECK(ao_of(s).sky_depth == SkyDepth::finite);
        CHECK(blur_of(s).edges == BlurEdges::fixed);
        const DepthSource own = method == &xjun() ? DepthSource::view_depth : DepthSource::ndc_depth;
        CHECK(ao_of(s).depth_source == own);
    }
    for (const char* name : {"random_vectors", "sign_of_zero", "self_occlusion_test", "depth_source",
                             "border", "texel_centre", "edge_texels", "sky_depth", "blur_edges"}) {
        for (const char* word : {"", "2", "Raw", "yes", "unit "}) {
            const std::string assignment = std::string(name) + "=" + word;
            CAPTURE(assignment);
            CHECK_THROWS_WITH_AS(xjun_with(assignment), doctest::Contains(name), UsageError);
        }
    }
}

TEST_CASE("parameters: a wrong name or value is refused, and the message names it") {
    const auto refused = [](const std::string& assignment, const std::string& named) {
        CAPTURE(assignment);
        CHECK_THROWS_WITH_AS(xjun_with(assignment), doctest::Contains(named.c_str()), UsageError);
    };
    refused("radius", "radius");
    refused("", "name=value");
    refused("=1", "no such parameter");
    refused("Radius=1", "radius, fade_start");  // lists what there is
    for (const char* samples : {"0", "-1", "15", "1.5", "", "nan", "1e1", "14x", "99999999999999999999"}) {
        refused(std::string("samples=") + samples, "samples");
    }
    for (const char* name :
         {"radius", "fade_start", "fade_end", "epsilon", "exponent", "blur_normal", "blur_depth"}) {
        for (const char* value :
             {"", "nan", "inf", "-inf", "1e999", "12x", "0x10", " 1", "1 ", "+1", "1,5", "-2"}) {
            refused(std::string(name) + "=" + value, name);
        }
    }
    refused("fade_end=0.1", "fade_end");  // before the start of the fade
    refused("fade_start=3", "fade_end");
    refused("exponent=65", "exponent");
    refused("radius=1e39", "radius");  // finite, but not as a float
    for (const char* seed : {"-1", "4294967296", "1.0"}) refused(std::string("seed=") + seed, "seed");
    for (const char* word : {"yes", "TRUE", "2", ""})
        refused(std::string("as_published=") + word, "as_published");
    for (const char* name : {"ao_format", "buffer_format", "depth_format", "blur_weights"})
        refused(std::string(name) + "=float8", name);
    for (const char* iterations : {"-1", "65"})
        refused(std::string("blur_iterations=") + iterations, "blur_iterations");
    CHECK_THROWS_WITH_AS(settings_of(find_method("none"), {"radius=1"}),
                         doctest::Contains("there is no such parameter of none"), UsageError);
}

TEST_CASE("parameters: default lengths follow the scene's unit, given ones do not") {
    const FrameSettings s = settings_of(xjun(), {"epsilon=0.5"}, 8);
    CHECK(ao_of(s).radius == 4);
    CHECK(ao_of(s).fade_start == 8 * 0.2f);
    CHECK(ao_of(s).fade_end == 16);
    CHECK(ao_of(s).epsilon == 0.5f);
    CHECK(blur_of(s).depth_threshold == 8 * 0.2f);
    CHECK(blur_of(s).normal_threshold == 0.8f);
    CHECK(ao_of(s).exponent == 4);
}

TEST_CASE("the lists for reading name every method and parameter") {
    std::ostringstream methods, parameters;
    print_methods(methods);
    for (const Method& method : ao_methods()) CHECK(methods.str().find(method.name) != std::string::npos);
    print_parameters(parameters, xjun());
    for (const Parameter<FrameSettings>& parameter : frame_parameters(xjun())) {
        CAPTURE(std::string(parameter.name));
        CHECK(parameters.str().find(std::string("\n") + parameter.name + " ") != std::string::npos);
        CHECK(parameters.str().find(parameter.effect) != std::string::npos);
    }
}

TEST_CASE("parse: numbers are read whole or refused with the flag's name") {
    for (const auto& read :
         {std::pair{"0", 0.0}, {"-3", -3.0}, {".5", 0.5}, {"2.", 2.0}, {"1e-3", 1e-3}, {"1E3", 1e3}}) {
        CAPTURE(std::string(read.first));
        CHECK(parse_number("--near", read.first) == read.second);
    }
    for (const char* word : {"", " ", "1 ", " 1", "+1", "1e", "e5", "--1", "1.2.3", "nan", "inf", "-inf",
                             "infinity", "1e999", "0x10", "1,5", "1f"}) {
        CAPTURE(std::string(word));
        CHECK_THROWS_WITH_AS(parse_number("--near", word), doctest::Contains("--near"), UsageError);
    }
    CHECK(parse_whole("--threads", "0", 0, 8) == 0);
    CHECK(parse_whole("--threads", "8", 0, 8) == 8);
    for (const char* word : {"9", "-1", "1.0", "", "two", "1e1", "99999999999999999999"}) {
        CAPTURE(std::string(word));
        CHECK_THROWS_WITH_AS(parse_whole("--threads", word, 0, 8), doctest::Contains("--threads"),
                             UsageError);
    }
    CHECK(parse_yes_no("--keep", "true"));
    CHECK(!parse_yes_no("--keep", "0"));
    CHECK_THROWS_WITH_AS(parse_yes_no("--keep", "maybe"), doctest::Contains("--keep"), UsageError);
}

TEST_CASE("parse: points and sizes") {
    CHECK(parse_point("--eye", "1,-2.5,3e2") == glm::dvec3(1, -2.5, 300));
    for (const char* word :
         {"", "1", "1,2", "1,2,3,4", "1,2,", ",,", "1;2;3", "1, 2,3", "a,b,c", "1,2,nan"}) {
        CAPTURE(std::string(word));
        CHECK_THROWS_WITH_AS(parse_point("--eye", word), doctest::Contains("--eye"), UsageError);
    }
    CHECK(parse_size("--size", "1280x720") == Size{1280, 720});
    CHECK(parse_size("--size", "1x1") == Size{1, 1});
    CHECK(parse_size("--size", std::to_string(kLargestSide) + "x1") == Size{kLargestSide, 1});
    for (const char* word : {"", "x", "12", "12x", "x12", "0x10", "10x0", "-1x5", "12x34x", "12X34", "1.5x2",
                             "40000x1", "1x40000", "30000x30000"}) {
        CAPTURE(std::string(word));
        CHECK_THROWS_WITH_AS(parse_size("--size", word), doctest::Contains("--size"), UsageError);
    }
    // Whether the largest picture is allowed is a question of this machine's memory.
    if (memory_bytes() < std::uintmax_t{16} << 30)
        CHECK_THROWS_WITH_AS(parse_size("--size", "16384x16384"), doctest::Contains("memory"), UsageError);
    else
        CHECK_NOTHROW(parse_size("--size", "16384x16384"));
}
