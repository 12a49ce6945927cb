// What a probe says of a pixel is what the frame's buffers hold, to the last bit, for every method.
#include "chapters/probe/pixel_probe.h"

#include <bit>

#include <doctest/doctest.h>

#include "rasterizer/base/error.h"
#include "scenes/builtin_scenes.h"
#include "ssao/rays/ray_cast.h"
#include "tests/tools/probed_frame.h"
#include "tests/tools/still_life.h"

using namespace crevice;

namespace {

constexpr Size kSmall{53, 31};

// A method or a scene, and parameters.
struct NamedWords {
    std::string name;
    std::vector<std::string> words;
};

// The terms added up as the formula says.
glm::vec3 added_up(const LitExplanation& lit) {
    glm::vec3 ambient(0), diffuse(0), specular(0), all(0);
    bool first = true;
    for (const ExplainedTerm& term : lit.terms) {
        all = first ? term.colour : all + term.colour;
        first = false;
        if (term.kind == LitTerm::ambient) ambient = ambient + term.colour;
        if (term.kind == LitTerm::diffuse) diffuse = diffuse + term.colour;
        if (term.kind == LitTerm::specular) specular = specular + term.colour;
    }
    if (std::string(lit.formula) == kSumOfTerms) return all;
    CHECK(std::string(lit.formula) == kPhongSum);
    return lit.texture * (lit.ambient_access * ambient + diffuse) + specular;
}

// Empty where all that the probe says is what the frame holds; else what is not.
std::string lie_of(const ProbedFrame& f, int x, int y) {
    const PixelProbe probe = f.at(x, y);
    const Frame& frame = f.worked.frame;
    const auto same = [](float a, float b) {
        return std::bit_cast<std::uint32_t>(a) == std::bit_cast<std::uint32_t>(b);
    };
    if (probe.raster.code != frame.gbuffer.depth.codes.at(x, y)) return "depth code";
    if (probe.raster.shown != frame.gbuffer.triangle.at(x, y)) return "triangle";
    if (probe.normal_depth.surface && !same(probe.normal_depth.view_depth, frame.gbuffer.view_depth.at(x, y)))
        return "view depth";
    const AoProbe& ao = probe.ao;
    if (ao.left_out.empty() && !same(ao.value, f.worked.raw.ao.at(ao.x, ao.y))) return "ao";
    float sum = 0;
    for (const ExplainedSample& sample : ao.explanation.samples) sum = sum + sample.contribution;
    if (ao.left_out.empty() && !same(ao.explanation.value_of_sum(sum), ao.value)) return "sum of samples";
    if (!frame.ao_blurred.empty() && !same(probe.blur.value, frame.ao_blurred.at(ao.x, ao.y))) return "blur";
    for (const ExplainedPass& pass : probe.blur.passes) {
        const bool kept = pass.value == 1 && pass.taps.empty();
        const float mean = pass.sum() / pass.total();
        const bool alone = std::string(pass.last_step).starts_with("the texel keeps its value");
        if (alone && !same(pass.value, pass.taps.front().value)) return "lone texel, " + pass.name;
        if (!alone && !kept && !same(pass.value, mean < 1 ? mean : 1)) return "taps, " + pass.name;
    }
    const LitExplanation& lit = probe.lit.explanation;
    const glm::vec3 shown = frame.lit.at(x, y), sum_of_terms = added_up(lit);
    for (int c = 0; c < 3; ++c) {
        if (!same(lit.colour[c], shown[c])) return "lit";
        if (!same(sum_of_terms[c], shown[c])) return "terms";
    }
    return "";
}

// The first pixel of a spread of them that is a lie, corners among them.
std::string first_lie(const ProbedFrame& frame) {
    const Size size = frame.request.size;
    for (const int y : {0, size.height / 3, size.height / 2, 3 * size.height / 4, size.height - 1}) {
        for (const int x :
             {0, size.width / 5, size.width / 3, size.width / 2, 2 * size.width / 3, size.width - 1}) {
            const std::string lie = lie_of(frame, x, y);
            if (!lie.empty()) return lie + " at (" + std::to_string(x) + ", " + std::to_string(y) + ")";
        }
    }
    return "";
}

}  // namespace

TEST_CASE("probe: every method's numbers add up to the frame's buffers, to the last bit") {
    for (const Method& method : ao_methods()) {
        for (const char* scale : {"0.5", "1"}) {
            CAPTURE(std::string(method.name));
            CAPTURE(std::string(scale));
            const ProbedFrame frame(still_life(), method, kSmall, {"ao_scale=" + std::string(scale)});
            CHECK(first_lie(frame) == "");
        }
    }
}

TEST_CASE("probe: so do those of every denoiser, and of every kind of edge and iteration") {
    const NamedWords switched[] = {
        {"xjun", {"blur_iterations=0"}},
        {"xjun", {"blur_iterations=9", "blur_edges=slope"}},
        {"luna", {"blur_edges=none", "blur_depth=0"}},
        {"hemisphere", {"blur_kind=bilateral", "blur_iterations=2"}},
        {"hemisphere", {"blur_shift=true", "blur_iterations=3"}},
        {"unity", {"blur_iterations=2", "blur_step=2"}},
        {"sao", {"blur_kind=bilateral", "blur_depth=0.2"}},
        {"sao", {"blur_quads=false", "blur_fine=false", "blur_iterations=2"}},
        {"gtao", {"blur_kind=bilateral"}},
        {"gtao", {"blur_iterations=3"}},
    };
    for (const NamedWords& method : switched) {
        CAPTURE(method.name);
        CAPTURE(method.words.front());
        CHECK(first_lie(ProbedFrame(still_life(), find_method(method.name), kSmall, method.words)) == "");
    }
}

TEST_CASE(
    "probe: and those of every way to light: phong, shadows, mirrors, a sky, a point light, holes, depth "
    "formats") {
    const NamedWords lights[] = {
        {"columns", {}},
        {"columns_2022", {"depth_format=d24"}},
        {"columns_luna", {"multi_bounce=paper", "specular_occlusion=lagarde"}},
        {"columns_luna", {"depth_format=d32f_reversed", "lit_position=view_first"}},
        {"room", {}},
        {"fence", {}},
        {"cornell", {"ao_lookup=joint", "depth_format=d16", "lit_depth_test=less_equal"}},
    };
    for (const NamedWords& shown : lights) {
        CAPTURE(shown.name);
        const BuiltinScene* const scene = find_builtin_scene(shown.name);
        REQUIRE(scene != nullptr);
        CHECK(first_lie(ProbedFrame(scene->make(SceneDetail::surfaces, {}), find_method("xjun"), {64, 36},
                                    shown.words)) == "");
    }
}

TEST_CASE("probe: an empty scene, one pixel, and the sky have their words and no samples") {
    const Scene nothing = scene_of({});
    const ProbedFrame empty(nothing, find_method("xjun"), {4, 3});
    const PixelProbe probe = empty.at(3, 2);
    CHECK(!probe.normal_depth.surface);
    CHECK(probe.raster.fragments.empty());
    CHECK(probe.ao.left_out == "the scene has no triangles: everything is open");
    CHECK(probe.ao.value == 1);
    CHECK(probe.blur.value == 1);
    for (const Method& method : ao_methods()) {
        CAPTURE(std::string(method.name));
        CHECK(first_lie(ProbedFrame(still_life(), method, {1, 1})) == "");
    }
}

TEST_CASE("probe: a pixel outside the picture and a history are refused in one line") {
    const ProbedFrame frame(still_life(), find_method("xjun"), kSmall);
    for (const auto& [x, y] : {std::pair{-1, 0}, {0, -1}, {53, 0}, {0, 31}}) {
        CHECK_THROWS_WITH_AS(frame.at(x, y), doctest::Contains("lies outside the picture of 53x31"),
                             UsageError);
    }
    FrameRequest request = frame.request;
    request.settings.history.longest = 4;
    CHECK_THROWS_WITH_AS(probe_pixel(frame.scene, frame.scene.camera, request, 0, 0),
                         doctest::Contains("history: there is no frame before this one (4)"), UsageError);
}
