#include "chapters/probe/probe_text.h"

#include <algorithm>
#include <string_view>

#include "chapters/probe/probe_sentences.h"
#include "chapters/probe/probe_words.h"
#include "chapters/probe/text_columns.h"
#include "chapters/terminal/number_text.h"
#include "rasterizer/base/float_text.h"

namespace crevice {

namespace {

std::string text_of(const glm::vec2& v) { return "(" + shortest_text(v.x) + ", " + shortest_text(v.y) + ")"; }
std::string text_of(const glm::vec3& v) {
    return "(" + shortest_text(v.x) + ", " + shortest_text(v.y) + ", " + shortest_text(v.z) + ")";
}
std::string text_of(const NamedNumber& number) {
    if (const float* const real = std::get_if<float>(&number.value)) return shortest_text(*real);
    const std::int64_t whole = std::get<std::int64_t>(number.value);
    if (!std::string_view(number.name).ends_with("_bits")) return std::to_string(whole);
    constexpr int kBits = 32;
    std::string bits;
    for (int bit = kBits - 1; bit >= 0; --bit) bits += ((whole >> bit) & 1) != 0 ? '1' : '0';
    return bits;
}
std::string place(int x, int y) { return "(" + std::to_string(x) + ", " + std::to_string(y) + ")"; }

// The names that occur in the lists of numbers, in their order.
template <class Numbered>
std::vector<std::string> names_in(const std::vector<Numbered>& all) {
    std::vector<std::string> names;
    for (const Numbered& one : all) {
        for (const NamedNumber& number : one.numbers) {
            if (std::find(names.begin(), names.end(), number.name) == names.end())
                names.emplace_back(number.name);
        }
    }
    return names;
}
// The numbers of one list under these names; "-" where it has none.
std::vector<std::string> numbers_under(const std::vector<std::string>& names,
                                       const std::vector<NamedNumber>& numbers) {
    std::vector<std::string> words(names.size(), "-");
    for (const NamedNumber& number : numbers) {
        const auto at = std::find(names.begin(), names.end(), number.name);
        words[static_cast<std::size_t>(at - names.begin())] = text_of(number);
    }
    return words;
}

std::string raster_text(const PixelProbe& probe) {
    const PixelFragments& raster = probe.raster;
    if (raster.fragments.empty()) return "No triangle reaches into the pixel's square.\n";
    const std::size_t count = raster.fragments.size();
    std::string text = std::to_string(count) + (count == 1 ? " triangle reaches" : " triangles reach") +
                       " into the pixel's square, in the order in which they were drawn; " +
                       word_of(probe.depth_format) + " depth, cleared to code " +
                       std::to_string(raster.cleared) + ":\n";
    TextColumns table({"number", "instance", "triangle", "material", "E0", "E1", "E2", "ndc depth", "code",
                       "stored", "verdict"});
    for (const PixelFragment& f : raster.fragments) {
        const auto edge = [&](std::size_t i) {
            // An edge that owns the centres on it is marked, as the fill rule asks for it at 0 alone.
            return std::to_string(f.edge[i]) + (f.edge[i] == 0 && f.top_or_left[i] ? " (top or left)" : "");
        };
        const bool covered = f.outside_edge < 0;
        table.row({f.number == kNoTriangle ? "-" : std::to_string(f.number),
                   std::to_string(f.triangle.instance), std::to_string(f.mesh_triangle),
                   probe.materials[static_cast<std::size_t>(f.triangle.material)], edge(0), edge(1), edge(2),
                   covered ? shortest_text(f.z_ndc) : "-", covered ? std::to_string(f.code) : "-",
                   covered ? std::to_string(f.stored) : "-", why(f)});
    }
    return text + table.text() +
           "E0, E1 and E2 are the edge functions at the pixel's centre, in 1/256 x 1/256 pixel: inside where "
           "positive, and at 0 where the edge is a top or a left one.\n";
}

std::string normal_depth_text(const NormalDepthProbe& probe) {
    if (!probe.surface)
        return "Nothing is seen here: the background, infinitely far away, without a normal.\n";
    std::string text = "view depth  " + shortest_text(probe.view_depth) + "\nnormal      " +
                       text_of(probe.n_view) + "\nposition    " + text_of(probe.p_by_ray) +
                       " by the ray times view depth\n            " + text_of(probe.p_by_unprojection) +
                       " by the inverse of the projection; they differ by " +
                       text_of(probe.p_by_unprojection - probe.p_by_ray) + "\n\n";
    TextColumns table({"format", "ndc depth", "code", "step in view depth", "view depth of the code", ""});
    for (const DepthInFormat& f : probe.formats) {
        table.row({std::string(word_of(f.format)) + (f.reversed ? " reversed" : ""), shortest_text(f.ndc),
                   std::to_string(f.code), significant_text(f.step, 4), shortest_text(f.view_depth),
                   f.drawn ? "what was drawn" : ""});
    }
    return text + table.text();
}

std::string samples_text(const Explanation& explanation) {
    const std::vector<ExplainedSample>& samples = explanation.samples;
    const std::vector<std::string> names = names_in(samples);
    TextColumns verdicts({"sample", "on the screen", "dz", "dp", "weight", "contribution", "sum", "verdict"});
    std::vector<std::string> headings = {"sample", "offset", "q", "r"};
    headings.insert(headings.end(), names.begin(), names.end());
    TextColumns places(headings);
    float sum = 0;
    for (std::size_t i = 0; i < samples.size(); ++i) {
        const ExplainedSample& s = samples[i];
        sum = sum + s.contribution;
        verdicts.row({std::to_string(i), text_of(s.q_screen), shortest_text(s.dz), shortest_text(s.dp),
                      shortest_text(s.weight), shortest_text(s.contribution), shortest_text(sum), s.verdict});
        std::vector<std::string> words = {std::to_string(i), text_of(s.offset), text_of(s.q_view),
                                          text_of(s.r_view)};
        for (const std::string& word : numbers_under(names, s.numbers)) words.push_back(word);
        places.row(words);
    }
    return verdicts.text() + "\n" + places.text();
}

std::string ao_text(const PixelProbe& probe) {
    const AoProbe& ao = probe.ao;
    std::string text =
        "texel       " + place(ao.x, ao.y) + " of a map of " + size_text(ao.map_size) + ", over";
    for (const TexelPixel& p : ao.pixels) {
        text += (ao.pixels.size() == 1 ? " pixel " : " ") + place(p.x, p.y);
        if (ao.pixels.size() > 1) text += " x " + shortest_text(p.weight);
        text += " at depth " + shortest_text(p.view_depth) + (&p == &ao.pixels.back() ? "\n" : ",");
    }
    if (!ao.left_out.empty())
        return text + "value       " + shortest_text(ao.value) + ": " + ao.left_out + "\n";
    if (!ao.explanation.surface)
        return text + "value       " + shortest_text(ao.value) + ": the background is open\n";
    text += "p           " + text_of(ao.explanation.p_view) + "\nn           " +
            text_of(ao.explanation.n_view) + "\n";
    for (const NamedNumber& number : ao.explanation.numbers)
        text += padded(number.name, 12) + text_of(number) + "\n";
    return text + "\n" + samples_text(ao.explanation) + "\nsum         " + shortest_text(ao.sum) +
           "\nvalue       " + shortest_text(ao.value) + " = " + ao.explanation.formula + "\n";
}

std::string pass_text(const ExplainedPass& pass) {
    const std::vector<std::string> names = names_in(pass.taps);
    std::vector<std::string> headings = {"tap", "value", "weight"};
    headings.insert(headings.end(), names.begin(), names.end());
    headings.push_back("verdict");
    TextColumns table(headings);
    for (const ExplainedTap& tap : pass.taps) {
        std::vector<std::string> words = {place(tap.x, tap.y), shortest_text(tap.value),
                                          shortest_text(tap.weight)};
        for (const std::string& word : numbers_under(names, tap.numbers)) words.push_back(word);
        words.push_back(tap.verdict);
        table.row(words);
    }
    std::string text = pass.name + "\n" + (pass.taps.empty() ? "" : table.text());
    if (!pass.taps.empty())
        text += "sum " + shortest_text(pass.sum()) + ", total " + shortest_text(pass.total()) + "; ";
    return text + "value " + shortest_text(pass.value) + " = " + pass.last_step + "\n";
}

std::string blur_text(const PixelProbe& probe) {
    if (!probe.blur.left_out.empty())
        return "value       " + shortest_text(probe.blur.value) + ": nothing is blurred, for " +
               probe.blur.left_out + "\n";
    std::string text;
    for (const ExplainedPass& pass : probe.blur.passes) text += pass_text(pass) + "\n";
    return text + "value       " + shortest_text(probe.blur.value) + "\n";
}

std::string lit_text(const PixelProbe& probe) {
    const LitExplanation& lit = probe.lit.explanation;
    std::string text;
    if (lit.surface) {
        text += "material    " + probe.materials[static_cast<std::size_t>(lit.material)] + "\nnormal      " +
                text_of(lit.n_view) + "\ntexture     " + text_of(lit.texture) + "\nAO          " +
                shortest_text(lit.accessibility) + ", read from";
        for (const ReadTexel& t : probe.lit.texels)
            text += " " + place(t.x, t.y) + " x " + shortest_text(t.weight) + " = " + shortest_text(t.value);
        if (probe.lit.texels.empty()) text += " no texels of the map itself";
        text += "; ambient terms times " + text_of(lit.ambient_access) + "\n";
        for (const ExplainedLight& light : lit.lights) {
            text += padded(light.number < 0 ? "point light" : "light " + std::to_string(light.number), 12) +
                    "cosine " + shortest_text(light.facing) + ", arriving " + shortest_text(light.arriving) +
                    "\n";
        }
        text += "\n";
    }
    TextColumns table({"term", "light", "colour"});
    for (const ExplainedTerm& term : lit.terms)
        table.row(
            {word_of(term.kind), term.light < 0 ? "-" : std::to_string(term.light), text_of(term.colour)});
    return text + table.text() + "\nvalue       " + text_of(lit.colour) + " = " + lit.formula + "\n";
}

}  // namespace

std::string probe_text(const PixelProbe& probe, const std::string& pass) {
    std::string text = probe.scene + ", " + size_text(probe.size) + ", pixel " + place(probe.x, probe.y) +
                       ", method " + probe.method + "\n\n" + answer(probe) + "\n";
    const auto section = [&](const char* name, const std::string& body) {
        if (pass.empty() || pass == name) text += "\n---- " + std::string(name) + "\n\n" + body;
    };
    section("normal_depth", raster_text(probe) + "\n" + normal_depth_text(probe.normal_depth));
    section("ao", ao_text(probe));
    section("blur", blur_text(probe));
    section("lit", lit_text(probe));
    return text;
}

}  // namespace crevice
