#include "chapters/probe/probe_json.h"

#include <nlohmann/json.hpp>

#include "chapters/frame/frame_json.h"
#include "chapters/probe/probe_sentences.h"
#include "chapters/probe/probe_words.h"
#include "chapters/terminal/json_number.h"
#include "chapters/terminal/json_text.h"

namespace crevice {

namespace {

using Json = nlohmann::ordered_json;

Json json_of(float value) { return json_number(value); }
Json json_of(double value) { return json_number(value); }
Json json_of(const glm::vec2& v) { return Json::array({json_of(v.x), json_of(v.y)}); }
Json json_of(const glm::vec3& v) { return json_numbers(v); }
Json json_of(Size size) { return Json::array({size.width, size.height}); }

// Of a triangle, a material or a light; null for none.
Json number_of(int number) { return number < 0 ? Json(nullptr) : Json(number); }

Json json_of(const DepthInFormat& f) {
    return {{"format", word_of(f.format)},        {"reversed", f.reversed}, {"drawn", f.drawn},
            {"ndc_depth", json_of(f.ndc)},        {"code", f.code},         {"step", json_of(f.step)},
            {"view_depth", json_of(f.view_depth)}};
}

Json json_of(const NormalDepthProbe& probe) {
    if (!probe.surface) return {{"surface", false}, {"view_depth", nullptr}, {"normal", {0, 0, 0}}};
    Json formats = Json::array();
    for (const DepthInFormat& f : probe.formats) formats.push_back(json_of(f));
    return {{"surface", true},
            {"view_depth", json_of(probe.view_depth)},
            {"normal", json_of(probe.n_view)},
            {"formats", formats},
            {"position",
             {{"by_ray", json_of(probe.p_by_ray)},
              {"by_unprojection", json_of(probe.p_by_unprojection)},
              {"difference", json_of(probe.p_by_unprojection - probe.p_by_ray)}}}};
}

Json json_of(const std::vector<NamedNumber>& numbers) {
    Json json = Json::object();
    for (const NamedNumber& number : numbers) {
        if (const float* real = std::get_if<float>(&number.value)) {
            json[number.name] = json_of(*real);
        } else {
            json[number.name] = std::get<std::int64_t>(number.value);
        }
    }
    return json;
}

Json json_of(const ExplainedSample& s, std::size_t number, float sum) {
    return {{"number", number},
            {"offset", json_of(s.offset)},
            {"q_view", json_of(s.q_view)},
            {"q_screen", json_of(s.q_screen)},
            {"r_view", json_of(s.r_view)},
            {"dz", json_of(s.dz)},
            {"dp", json_of(s.dp)},
            {"weight", json_of(s.weight)},
            {"contribution", json_of(s.contribution)},
            {"sum", json_of(sum)},
            {"verdict", s.verdict},
            {"numbers", json_of(s.numbers)}};
}

Json json_of(const PixelFragment& f, const std::vector<std::string>& materials) {
    const ScreenTriangle& t = f.triangle;
    Json corners = Json::array(), edges = Json::array();
    for (std::size_t i = 0; i < 3; ++i) {
        corners.push_back({t.x[i] / double{kSubpixelSteps}, t.y[i] / double{kSubpixelSteps}});
        edges.push_back({{"value", f.edge[i]}, {"top_or_left", f.top_or_left[i]}});
    }
    Json json = {{"number", number_of(f.number)},
                 {"instance", t.instance},
                 {"mesh_triangle", f.mesh_triangle},
                 {"material", materials[static_cast<std::size_t>(t.material)]},
                 {"corners", corners},
                 {"edges", edges},
                 {"verdict", word_of(f.verdict)},
                 {"why", why(f)}};
    if (f.outside_edge >= 0) {
        json["outside_edge"] = f.outside_edge;
    } else {
        json["ndc_depth"] = json_of(f.z_ndc);
        json["code"] = f.code;
        json["stored"] = f.stored;
    }
    return json;
}

Json raster_json(const PixelProbe& probe) {
    Json triangles = Json::array();
    for (const PixelFragment& f : probe.raster.fragments) triangles.push_back(json_of(f, probe.materials));
    return {{"format", word_of(probe.depth_format)},
            {"cleared", probe.raster.cleared},
            {"triangles", triangles},
            {"code", probe.raster.code},
            {"shown", number_of(probe.raster.shown)}};
}

Json json_of(const AoProbe& probe) {
    Json samples = Json::array(), pixels = Json::array();
    float sum = 0;
    for (const ExplainedSample& sample : probe.explanation.samples) {
        sum = sum + sample.contribution;
        samples.push_back(json_of(sample, samples.size(), sum));
    }
    for (const TexelPixel& p : probe.pixels) {
        pixels.push_back(
            {{"pixel", {p.x, p.y}}, {"weight", json_of(p.weight)}, {"view_depth", json_of(p.view_depth)}});
    }
    Json json = {{"texel", {probe.x, probe.y}},
                 {"map_size", json_of(probe.map_size)},
                 {"pixels", pixels},
                 {"surface", probe.explanation.surface}};
    if (!probe.left_out.empty()) json["left_out"] = probe.left_out;
    json["p_view"] = json_of(probe.explanation.p_view);
    json["n_view"] = json_of(probe.explanation.n_view);
    json["numbers"] = json_of(probe.explanation.numbers);
    json["samples"] = samples;
    json["sum"] = json_of(probe.sum);
    json["formula"] = probe.explanation.formula;
    json["value"] = json_of(probe.value);
    return json;
}

Json json_of(const ExplainedPass& pass) {
    Json taps = Json::array();
    for (const ExplainedTap& tap : pass.taps) {
        taps.push_back({{"texel", {tap.x, tap.y}},
                        {"value", json_of(tap.value)},
                        {"weight", json_of(tap.weight)},
                        {"verdict", tap.verdict},
                        {"numbers", json_of(tap.numbers)}});
    }
    return {{"name", pass.name},           {"taps", taps},
            {"sum", json_of(pass.sum())},  {"total", json_of(pass.total())},
            {"last_step", pass.last_step}, {"value", json_of(pass.value)}};
}

// The last pass is told twice: its taps are what the blurred texel is made of.
Json blur_json(const PixelProbe& probe) {
    Json passes = Json::array();
    for (const ExplainedPass& pass : probe.blur.passes) passes.push_back(json_of(pass));
    Json json = {{"texel", {probe.ao.x, probe.ao.y}}};
    if (!probe.blur.left_out.empty()) json["left_out"] = probe.blur.left_out;
    json["taps"] = passes.empty() ? Json::array() : passes.back()["taps"];
    json["passes"] = passes;
    json["value"] = json_of(probe.blur.value);
    return json;
}

Json lit_json(const PixelProbe& probe) {
    const LitExplanation& lit = probe.lit.explanation;
    Json texels = Json::array(), lights = Json::array(), terms = Json::array();
    for (const ReadTexel& t : probe.lit.texels) {
        texels.push_back({{"texel", {t.x, t.y}}, {"weight", json_of(t.weight)}, {"value", json_of(t.value)}});
    }
    for (const ExplainedLight& light : lit.lights) {
        lights.push_back({{"light", number_of(light.number)},
                          {"facing", json_of(light.facing)},
                          {"arriving", json_of(light.arriving)}});
    }
    for (const ExplainedTerm& term : lit.terms) {
        terms.push_back({{"term", word_of(term.kind)},
                         {"light", number_of(term.light)},
                         {"colour", json_of(term.colour)}});
    }
    Json json = {{"surface", lit.surface}};
    if (lit.surface) {
        json["triangle"] = number_of(lit.triangle);
        json["material"] = probe.materials[static_cast<std::size_t>(lit.material)];
        json["normal"] = json_of(lit.n_view);
        json["texture"] = json_of(lit.texture);
        json["accessibility"] = json_of(lit.accessibility);
        json["ambient_access"] = json_of(lit.ambient_access);
        json["ao_texels"] = texels;
        json["lights"] = lights;
    }
    json["terms"] = terms;
    json["formula"] = lit.formula;
    json["value"] = json_of(lit.colour);
    return json;
}

}  // namespace

std::string probe_json(const PixelProbe& probe, const std::string& pass) {
    Json passes = Json::object();
    const auto wanted = [&](const char* name) { return pass.empty() || pass == name; };
    if (wanted("normal_depth")) {
        passes["raster"] = raster_json(probe);
        passes["normal_depth"] = json_of(probe.normal_depth);
    }
    if (wanted("ao")) passes["ao"] = json_of(probe.ao);
    if (wanted("blur")) passes["blur"] = blur_json(probe);
    if (wanted("lit")) passes["lit"] = lit_json(probe);
    return json_text(Json{{"scene", probe.scene},
                          {"size", json_of(probe.size)},
                          {"pixel", {probe.x, probe.y}},
                          {"method", probe.method},
                          {"parameters", parameters_json(find_method(probe.method), probe.settings)},
                          {"answer", answer(probe)},
                          {"passes", passes}});
}

}  // namespace crevice
