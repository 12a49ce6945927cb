// A view whose pixels can be asked about, on the way from an artifact in its picture to the one sample that makes it: what the
// terminal and the debugger say of that pixel, in their own words.
#pragma once

#include <string>

#include "chapters/frame/worked_frame.h"
#include "chapters/probe/pixel_probe.h"
#include "chapters/props/switched_ao.h"

namespace crevice {

class ProbedView {
 public:
    // The frame of these parameters, with what its passes worked on. The method is X_Jun's or Luna's.
    ProbedView(const SwitchedView& view, const Words& words);

    const Image<float>& ao() const { return worked_.raw.ao; }  // raw, AO map size
    const AoInputs& inputs() const { return worked_.raw.inputs; }
    float exponent() const { return request_.settings.method.ao.as<LunaSettings>().exponent; }
    // The numbers behind one texel.
    Explanation explanation(const Texel& texel) const;
    // And behind the pixel that shows the texel's centre.
    PixelProbe probe(const Texel& texel) const;

    // The samples of a probed pixel, in the picture and, of one of them, in a cut through the depth buffer.
    Picture overlay(const PixelProbe& probe) const;
    std::string section(const PixelProbe& probe, std::size_t sample, const std::string& title) const;

    // What draws the raw map of this view.
    std::string render_command() const { return view_.render_command(words_); }
    // What probes a texel of it.
    std::string probe_command(const Texel& texel) const { return view_.probe_command(words_, texel); }
    // What that prints, as far as it is about this sample.
    std::string terminal_transcript(const PixelProbe& probe, std::size_t sample) const;
    // The five commands that lead GDB from the pixel to the sample, with what it answers to the last ones.
    std::string debugger_transcript(const PixelProbe& probe, std::size_t sample) const;

 private:
    SwitchedView view_;
    Words words_;
    FrameRequest request_;
    WorkedFrame worked_;
};

}  // namespace crevice
