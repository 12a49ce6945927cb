#include "chapters/probe/probe_sentences.h"

#include <algorithm>
#include <cmath>

#include "chapters/terminal/number_text.h"
#include "rasterizer/base/float_text.h"

namespace crevice {

namespace {

constexpr int kDigits = 3;

std::string place(const glm::vec2& p_screen) {
    return "(" + decimal_text(static_cast<double>(p_screen.x), 1) + ", " +
           decimal_text(static_cast<double>(p_screen.y), 1) + ")";
}

// Where it is that a sample takes so much, seen from the point.
std::string whereabouts(const ExplainedSample& sample) {
    if (sample.offset == glm::vec3(0)) return ", which stands for the texel as a whole";
    const std::string at = " at " + place(sample.q_screen) + ", whose r ";
    if (sample.dz == 0) return at + "is as far as p";
    return at + "lies " + significant_text(std::fabs(static_cast<double>(sample.dz)), kDigits) +
           (sample.dz > 0 ? " in front of p" : " behind p");
}

// What becomes of the texel on its way to the pixel.
std::string afterwards(const PixelProbe& probe) {
    if (probe.blur.passes.empty() || !probe.lit.explanation.surface) return ".";
    return ". Denoised it is " + shortest_text(probe.blur.value) + "; the lit pixel reads " +
           shortest_text(probe.lit.explanation.accessibility) + ".";
}

}  // namespace

std::string answer(const PixelProbe& probe) {
    const AoProbe& ao = probe.ao;
    const std::string value = "AO " + shortest_text(ao.value) + ": ";
    if (!ao.left_out.empty()) return value + ao.left_out + ".";
    if (!ao.explanation.surface) return value + "the texel shows the background, which is open.";
    const std::vector<ExplainedSample>& samples = ao.explanation.samples;
    const auto occluding = std::count_if(samples.begin(), samples.end(),
                                         [](const ExplainedSample& s) { return s.contribution > 0; });
    if (occluding == 0)
        return value + "none of " + counted(static_cast<long long>(samples.size()), "sample") + " occludes" +
               afterwards(probe);
    const auto darkest = std::max_element(
        samples.begin(), samples.end(),
        [](const ExplainedSample& a, const ExplainedSample& b) { return a.contribution < b.contribution; });
    return value + std::to_string(occluding) + " of " +
           counted(static_cast<long long>(samples.size()), "sample") +
           (occluding == 1 ? " occludes" : " occlude") + "; the darkest is sample " +
           std::to_string(darkest - samples.begin()) + whereabouts(*darkest) + afterwards(probe);
}

std::string why(const PixelFragment& f) {
    switch (f.verdict) {
        case FragmentVerdict::kept: return "kept: it is what the pixel shows";
        case FragmentVerdict::drawn_over:
            return "drawn over: it was nearer than what was there, a later one nearer still";
        case FragmentVerdict::behind: return "behind: what was there is nearer";
        case FragmentVerdict::equal: return "equal: of equal depths the first one stays";
        case FragmentVerdict::facing_away: return "facing away: back faces are culled";
        case FragmentVerdict::cut_out: return "cut out: its texture has a hole here";
        case FragmentVerdict::hidden: return "hidden: left out as a whole, for all around there is nearer";
        case FragmentVerdict::outside: break;
    }
    const std::string edge = "edge " + std::to_string(f.outside_edge);
    if (f.edge[static_cast<std::size_t>(f.outside_edge)] < 0)
        return "outside: the pixel's centre lies beyond " + edge;
    return "outside: the pixel's centre lies on " + edge + ", which is neither a top nor a left edge";
}

}  // namespace crevice
