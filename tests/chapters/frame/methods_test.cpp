#include "chapters/frame/methods.h"

#include <functional>
#include <set>
#include <sstream>

#include <doctest/doctest.h>

#include "chapters/terminal/parse.h"
#include "rasterizer/base/error.h"

using namespace crevice;

namespace {

const Method& xjun() { return find_method("xjun"); }

MethodSettings xjun_with(const std::string& assignment) { return settings_of(xjun(), {assignment}); }

}  // namespace

TEST_CASE("methods: the tutorials' two and none, found by name") {
    std::set<std::string> names;
    for (const Method& method : ao_methods()) {
        names.insert(method.name);
        CHECK(&find_method(method.name) == &method);
        CHECK(method.computes_ao == (method.fetch != nullptr));
        CHECK(std::string(method.title) != "");
        CHECK(std::string(method.source) != "");
    }
    CHECK(names.size() == ao_methods().size());
    for (const char* name : {"xjun", "luna", "none"}) CHECK(names.contains(name));
    for (const char* wrong : {"", "XJUN", "xjun ", "ssao"}) {
        CAPTURE(std::string(wrong));
        CHECK_THROWS_WITH_AS(find_method(wrong), doctest::Contains("xjun, luna, none"), UsageError);
    }
}

TEST_CASE("parameters: the tutorials' defaults") {
    const MethodSettings x = settings_of(xjun(), {}), l = settings_of(find_method("luna"), {});
    CHECK(x.ao.samples == 14);
    CHECK(x.ao.radius == 0.5f);
    CHECK(x.ao.fade_start == 0.2f);
    CHECK(x.ao.fade_end == 2.0f);
    CHECK(x.ao.epsilon == 0.05f);
    CHECK(x.ao.exponent == 4);
    CHECK(x.blur.iterations == 4);
    CHECK(x.blur.weights == kXjunBlurWeights);
    CHECK(l.ao.radius == 0.5f);
    CHECK(l.ao.fade_end == 1.0f);
    CHECK(l.ao.exponent == 6);
    CHECK(l.blur.iterations == 3);
    CHECK(l.blur.weights == kLunaBlurWeights);
    CHECK(l.blur.normal_threshold == 0.8f);
    CHECK(l.blur.depth_threshold == 0.2f);
}

TEST_CASE(
    "parameters: each has a unique name, range and effect, and its default, read back, changes nothing") {
    for (const Method& method : ao_methods()) {
        std::set<std::string> names;
        for (const Parameter& parameter : parameters_of(method)) {
            CAPTURE(std::string(method.name));
            CAPTURE(std::string(parameter.name));
            CHECK(names.insert(parameter.name).second);
            CHECK(std::string(parameter.range) != "");
            CHECK(std::string(parameter.unit) != "");
            CHECK(std::string(parameter.effect) != "");
            const std::string word = parameter.get(method.defaults);
            const MethodSettings again = settings_of(method, {parameter.name + ("=" + word)});
            for (const Parameter& other : parameters_of(method))
                CHECK(other.get(again) == other.get(method.defaults));
        }
        for (const char* common : {"samples", "radius", "fade_start", "fade_end", "epsilon", "exponent",
                                   "seed", "blur_iterations", "as_published"}) {
            CAPTURE(std::string(common));
            CHECK(names.contains(common) == method.computes_ao);
        }
        for (const char* buffers : {"depth_format", "buffer_format"}) CHECK(names.contains(buffers));
    }
}

TEST_CASE("parameters: a value arrives where it belongs, the last one wins") {
    CHECK(xjun_with("samples=3").ao.samples == 3);
    CHECK(xjun_with("radius=.75").ao.radius == 0.75f);
    CHECK(xjun_with("fade_start=0").ao.fade_start == 0);
    CHECK(xjun_with("fade_end=1e2").ao.fade_end == 100);
    CHECK(xjun_with("epsilon=0.01").ao.epsilon == 0.01f);
    CHECK(xjun_with("exponent=0").ao.exponent == 0);
    CHECK(xjun_with("seed=4294967295").ao.seed == 0xffffffffu);
    CHECK(xjun_with("as_published=true").ao.as_published);
    CHECK(xjun_with("as_published=1").ao.as_published);
    CHECK(!xjun_with("as_published=0").ao.as_published);
    CHECK(xjun_with("ao_format=float16").ao.format == BufferFormat::float16_toward_zero);
    CHECK(xjun_with("buffer_format=float16_nearest").buffers.buffer_format ==
          BufferFormat::float16_nearest_even);
    CHECK(xjun_with("blur_iterations=0").blur.iterations == 0);
    CHECK(xjun_with("blur_weights=luna").blur.weights == kLunaBlurWeights);
    CHECK(xjun_with("blur_normal=-1").blur.normal_threshold == -1);
    CHECK(xjun_with("blur_depth=3").blur.depth_threshold == 3);
    CHECK(xjun_with("depth_format=d16").buffers.depth_format == DepthFormat::d16);
    CHECK(!xjun_with("depth_format=d32f").reversed_z);
    CHECK(xjun_with("depth_format=d32f_reversed").reversed_z);
    CHECK(settings_of(xjun(), {"samples=3", "radius=1", "samples=5"}).ao.samples == 5);
    CHECK(settings_of(xjun(), {"fade_start=5", "fade_end=6"}).ao.fade_start == 5);
}

TEST_CASE("parameters: each artifact has a switch, at its cure by default") {
    const auto ao = [](const std::string& assignment) { return xjun_with(assignment).ao; };
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
    CHECK(xjun_with("blur_edges=slope").blur.edges == BlurEdges::slope);
    CHECK(xjun_with("blur_edges=none").blur.edges == BlurEdges::none);
    for (const Method* method : {&xjun(), &find_method("luna")}) {
        CAPTURE(std::string(method->name));
        const MethodSettings s = settings_of(*method, {});
        CHECK(s.ao.random_vectors == RandomVectors::unit);
        CHECK(s.ao.sign_of_zero == SignOfZero::plus);
        CHECK(s.ao.self_occlusion_test);
        CHECK(s.ao.border == MapBorder::far);
        CHECK(s.ao.texel_centre == TexelCentre::exact);
        CHECK(s.ao.edge_texels == EdgeTexels::nearest);
        CHECK(s.ao.sky_depth == SkyDepth::finite);
        CHECK(s.blur.edges == BlurEdges::fixed);
        const DepthSource own = method == &xjun() ? DepthSource::view_depth : DepthSource::ndc_depth;
        CHECK(method->fetch(s.ao).depth == own);
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
                         doctest::Contains("none has no such parameter"), UsageError);
}

TEST_CASE("parameters: default lengths follow the scene's unit, given ones do not") {
    const MethodSettings s = settings_of(xjun(), {"epsilon=0.5"}, 8);
    CHECK(s.ao.radius == 4);
    CHECK(s.ao.fade_start == 8 * 0.2f);
    CHECK(s.ao.fade_end == 16);
    CHECK(s.ao.epsilon == 0.5f);
    CHECK(s.blur.depth_threshold == 8 * 0.2f);
    CHECK(s.blur.normal_threshold == 0.8f);
    CHECK(s.ao.exponent == 4);
}

TEST_CASE("the lists for reading name every method and parameter") {
    std::ostringstream methods, parameters;
    print_methods(methods);
    for (const Method& method : ao_methods()) CHECK(methods.str().find(method.name) != std::string::npos);
    print_parameters(parameters, xjun());
    for (const Parameter& parameter : parameters_of(xjun())) {
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
}
