// The AO methods of the command line, and their parameters by name.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "rasterizer/draw/normal_depth.h"
#include "ssao/blur/bilateral_blur.h"
#include "ssao/light/ao_lookup.h"
#include "ssao/light/shade.h"
#include "ssao/methods/luna_occlusion.h"

namespace crevice {

// Everything `--param` can set.
struct MethodSettings {
    LunaSettings ao = {};
    BlurSettings blur = {};
    NormalDepthSettings buffers = {};
    ShadeSettings lit = {};  // of the second drawing
    AoLookup ao_lookup = AoLookup::exact;
    bool reversed_z = false;
};

struct Parameter {
    std::string name, range, unit, effect;
    std::function<void(MethodSettings&, const std::string& word)> set;  // throws UsageError
    std::function<std::string(const MethodSettings&)> get;
};

struct Method {
    const char* name;
    const char* title;
    const char* source;
    MethodSettings defaults;
    bool computes_ao = true;  // false: everything counts as open
    AoFetch (*fetch)(const LunaSettings&) = nullptr;
};

// In the order in which `crevice methods` lists them.
std::span<const Method> ao_methods();
// Throws UsageError listing the methods there are.
const Method& find_method(const std::string& name);

// The parameters of a method. Methods that compute no AO have only those of the buffers.
std::vector<Parameter> parameters_of(const Method& method);

// The method's defaults, their lengths times the scene's length_unit, with "name=value" words (in scene
// units) applied in order. Throws UsageError for an unknown name (listing what there is), a value that does
// not read, or settings that do not fit together.
MethodSettings settings_of(const Method& method, const std::vector<std::string>& assignments,
                           float length_unit = 1);

void print_methods(std::ostream& out);
void print_parameters(std::ostream& out, const Method& method);

}  // namespace crevice
