#include "chapters/props/method_candidates.h"

#include <algorithm>
#include <utility>

#include "chapters/terminal/number_text.h"

namespace crevice {
namespace {

// What a method asks, in words.
std::string question_text(const AoQuestion& q) {
    const std::string reach = decimal_text(static_cast<double>(q.radius), 1);
    const bool cut = q.fade_start >= q.radius;
    return std::string(q.cosine_weighted ? "cosine" : "even") + ", " + (cut ? "cut at " : "fading up to ") +
           reach;
}

struct Candidate {
    const char *label, *name, *reads, *fails;
    Words words = {};
};

// What each reads of the frame, and what is wrong with it wherever it is used.
const Candidate kCandidates[] = {
    {"X_Jun", "xjun", "normals, depth", "counts twice what two samples see; contrast by an exponent"},
    {"Luna", "luna", "normals, depth", "the same"},
    {"LearnOpenGL", "hemisphere", "normals, depth", "a volume, not light; blind very near"},
    {"Unity notes", "unity", "normals, depth", "the same, and a hard range"},
    {"Alchemy", "alchemy", "normals, depth", "noise near creases"},
    {"SAO", "sao", "normals, depth pyramid", "the same, and blocks far away"},
    {"MSVO", "msvo", "depth pyramid", "wide halos, no contact shade"},
    {"HBAO", "hbao", "normals, depth", "the bias loses creases"},
    {"HBAO, bias 0", "hbao", "normals, depth", "facets of coarse meshes", {"bias=0"}},
    {"HBAO+", "hbao_plus", "normals, depth", "counts walls more than once"},
    {"GTAO", "gtao", "normals, depth", "closed behind thin things; the fade is too bright here"},
    {"GTAO, cut",
     "gtao",
     "normals, depth",
     "closed behind thin things",
     {"falloff=0", "radius_multiplier=1"}},
    {"bitmask", "vbao", "normals, depth", "one thickness for all things"},
    {"crevice", "crevice", "normals, depth, triangles", "needs a tree of the triangles; noise"}};

Words with_radius_2(Words words) {
    words.push_back("radius=2");
    return words;
}

bool same_question(const AoQuestion& a, const AoQuestion& b) {
    return a.radius == b.radius && a.fade_start == b.fade_start && a.fade_end == b.fade_end &&
           a.cosine_weighted == b.cosine_weighted;
}

}  // namespace

CandidatesTable candidates_table(const JudgedView& view, const Truth& light, const JudgedView& bars,
                                 const Truth& bars_light) {
    std::vector<std::pair<AoQuestion, Truth>> truths = {{light.question, light}};
    std::vector<std::pair<double, std::string>> errors;
    CandidatesTable table;
    for (const Candidate& c : kCandidates) {
        const MethodLimit limit = view.limit(c.name, c.words);
        const auto asked = [&](const auto& known) { return same_question(known.first, limit.question); };
        if (std::ranges::none_of(truths, asked))
            truths.emplace_back(limit.question, view.truth(limit.question));
        const double own_question = view.error(limit, std::ranges::find_if(truths, asked)->second).rmse;
        const double of_light = view.error(limit, light).rmse;
        const double of_bars = bars.error(bars.limit(c.name, with_radius_2(c.words)), bars_light).rmse;
        table.rows.push_back({c.label, question_text(limit.question), c.reads, decimal_text(own_question, 3),
                              decimal_text(limit.noise, 3), decimal_text(of_light, 3),
                              decimal_text(of_bars, 3), c.fails});
        errors.emplace_back(of_light, c.label);
    }
    std::ranges::sort(errors);
    for (const auto& [error, label] : errors) table.ranking.push_back(label);
    return table;
}

}  // namespace crevice
