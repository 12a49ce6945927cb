#include "chapters/props/probed_view.h"

#include <algorithm>
#include <cstdio>
#include <sstream>

#include "chapters/diagrams/depth_section.h"
#include "chapters/probe/probe_picture.h"
#include "chapters/probe/probe_text.h"
#include "rasterizer/base/float_text.h"

namespace crevice {

namespace {

// A command that is too long for a page, in lines that a shell takes for one; a flag and its word stay together.
std::string wrapped(const std::string& command) {
    constexpr std::size_t kWidth = 96;
    std::string text, line;
    for (std::size_t start = 0; start < command.size();) {
        const std::size_t end = std::min(command.find(" --", start + 1), command.size());
        const std::string part = command.substr(start, end - start);
        if (!line.empty() && line.size() + part.size() > kWidth) {
            text += line + " \\\n";
            line = "   ";
        }
        line += part;
        start = end;
    }
    return text + line;
}

// The first line of a text that begins so, with its end.
std::string first_line_with(const std::string& text, const std::string& begin) {
    const std::size_t at = text.find("\n" + begin);
    return at == text.npos ? "" : text.substr(at + 1, text.find('\n', at + 1) - at);
}

// As the debugger's printers have numbers.
std::string short_text(float value) {
    char digits[32];
    std::snprintf(digits, sizeof digits, "%.6g", static_cast<double>(value));
    return digits;
}
std::string short_text(const glm::vec3& v) {
    return "(" + short_text(v.x) + ", " + short_text(v.y) + ", " + short_text(v.z) + ")";
}

std::string place(int x, int y) { return "(" + std::to_string(x) + ", " + std::to_string(y) + ")"; }

}  // namespace

ProbedView::ProbedView(const SwitchedView& view, const Words& words)
    : view_(view),
      words_(words),
      request_(view.request(words)),
      worked_(worked_frame(view.scene(), view.camera(), request_)) {}

Explanation ProbedView::explanation(const Texel& texel) const {
    return request_.method->explain(
        {view_.scene(), worked_.frame.camera, worked_.frame.gbuffer, worked_.rays.get()}, worked_.raw,
        request_.settings.method.ao, texel.x, texel.y);
}

PixelProbe ProbedView::probe(const Texel& texel) const {
    const Texel pixel = pixel_of(texel, ao().size, request_.size);
    return probe_pixel(view_.scene(), request_, worked_, pixel.x, pixel.y);
}

Picture ProbedView::overlay(const PixelProbe& probe) const { return probe_overlay(probe, worked_); }

std::string ProbedView::section(const PixelProbe& probe, std::size_t sample, const std::string& title) const {
    const float radius = request_.settings.method.ao.as<LunaSettings>().radius;
    return sample_diagram(inputs(), probe.ao.x, probe.ao.y, probe.ao.explanation, sample,
                          static_cast<double>(radius), title);
}

std::string ProbedView::terminal_transcript(const PixelProbe& probe, std::size_t sample) const {
    const std::string said = probe_text(probe, "ao");
    const std::string number = std::to_string(sample);
    return "$ " + wrapped(probe_command({probe.ao.x, probe.ao.y})) + "\n...\n" +
           first_line_with(said, "AO ") + "...\n" + first_line_with(said, "sample ") + "...\n" +
           first_line_with(said, number + " ") + "...\n" + first_line_with(said, "value ");
}

std::string ProbedView::debugger_transcript(const PixelProbe& probe, std::size_t sample) const {
    const std::string pixel = std::to_string(probe.x) + "," + std::to_string(probe.y);
    const std::vector<ExplainedSample>& samples = probe.ao.explanation.samples;
    const auto taking =
        std::ranges::count_if(samples, [](const ExplainedSample& s) { return s.contribution > 0; });
    const auto most = std::ranges::max_element(samples, {}, &ExplainedSample::contribution) - samples.begin();
    const ExplainedSample& s = samples[sample];
    return "$ " +
           wrapped("gdb -x chapters/debugger/crevice_gdb.py --args build/debug/crevice render " +
                   view_.scene().name + " " + view_.flags(words_) + " --pixel " + pixel +
                   " --pass ao --break") +
           "\n(gdb) run\n...\nProgram received signal SIGTRAP, Trace/breakpoint trap.\n...\n(gdb) pixel " +
           std::to_string(probe.x) + " " + std::to_string(probe.y) + "\n...\nworked.raw.ao  " +
           place(probe.ao.x, probe.ao.y) + "  " + shortest_text(probe.ao.value) +
           "\n...\n(gdb) next\n...\n(gdb) print told\n$1 = texel " + std::to_string(probe.ao.x) + "," +
           std::to_string(probe.ao.y) + " is " + shortest_text(probe.ao.value) + ": " +
           std::to_string(taking) + " of " + std::to_string(samples.size()) +
           " samples take something, number " + std::to_string(most) + " most\n...\n[" +
           std::to_string(sample) + "]  takes " + short_text(s.contribution) + "  q " + short_text(s.q_view) +
           "  r " + short_text(s.r_view) + "  dz " + short_text(s.dz) + "  dp " + short_text(s.dp) +
           "  weight " + short_text(s.weight) + "  " + s.verdict + "\n";
}

}  // namespace crevice
