// All that can be set of a frame: its AO method's settings, and those of the passes around it.
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "rasterizer/draw/normal_depth.h"
#include "ssao/ao_methods.h"
#include "ssao/blur/temporal_accumulation.h"
#include "ssao/light/ao_lookup.h"
#include "ssao/light/deferred_point_light.h"
#include "ssao/light/shade.h"

namespace crevice {

struct FrameSettings {
    MethodSettings method;             // AO and its denoiser
    TemporalSettings history = {};     // of the raw map, between these two
    NormalDepthSettings buffers = {};  // of the first pass
    ShadeSettings lit = {};            // of the second drawing
    AmbientSettings ambient = {};      // what it makes of the AO map
    AoLookup ao_lookup = AoLookup::exact;
    LightSpace light_space = LightSpace::view;  // of a scene's point light
    bool reversed_z = false;
};

// Of the passes before and after AO, whatever the method.
std::vector<Parameter<FrameSettings>> buffer_parameters();
std::vector<Parameter<FrameSettings>> history_parameters();
std::vector<Parameter<FrameSettings>> lit_parameters();

// Everything `--param` can set: the parameters of the method, its denoiser and the passes around them.
std::vector<Parameter<FrameSettings>> frame_parameters(const Method& method);

// The method's defaults, their lengths times the scene's length_unit, with "name=value" words (in scene units)
// applied in order. Throws UsageError for an unknown name (listing what there is), a value that does not read,
// or settings that do not fit together.
FrameSettings settings_of(const Method& method, const std::vector<std::string>& assignments = {},
                          float length_unit = 1);

// The settings of a frame of a film with a history: as many seeds on as there were frames before, round and round where
// they end. As they are where the method has no seed.
MethodSettings reseeded(const Method& method, const MethodSettings& settings, int frame);

void print_methods(std::ostream& out);
void print_parameters(std::ostream& out, const Method& method);

}  // namespace crevice
