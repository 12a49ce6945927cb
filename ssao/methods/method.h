// A row of the table of AO methods (ssao/ao_methods.h): everything that frames, studies, commands and the tests
// of all methods know of a method. A row is plain values and functions, so that a new method is its own files
// and its row.
// Order:  this header knows none of the folders that come after methods/. A row draws on them (its blur, its
//         limit), so the rows stand in ssao/rows/.
#pragma once

#include <any>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "rasterizer/base/run.h"
#include "rasterizer/draw/normal_depth.h"
#include "ssao/methods/ao_map.h"
#include "ssao/methods/explanation.h"
#include "ssao/methods/parameter.h"

namespace crevice {

struct RayScene;        // ssao/rays/ray_cast.h
struct ReferenceImage;  // ssao/judge/reference_image.h
struct VertexAo;        // ssao/bakes/vertex_ao.h

// What a method is given to look at. The screen-space methods see the G-buffer and the camera alone.
struct AoView {
    const Scene& scene;
    const Camera& camera;
    const GBuffer& gbuffer;          // drawn of both
    const RayScene* rays = nullptr;  // for methods that cast rays: the scene, its origin the eye
    // For methods that bake: what bake() made of it; null: they make it themselves.
    const VertexAo* baked = nullptr;
    // For ao_in_double(): what the pixels show; null: what the G-buffer's floats say.
    const DoubleGBuffer* in_double = nullptr;
};

// The settings of one method or one denoiser, by value. Which struct that is only its own functions know;
// everything else goes by its parameters.
class AnySettings {
 public:
    AnySettings() = default;
    template <class S>
    static AnySettings of(S settings) {
        AnySettings result;
        result.held_ = std::move(settings);
        return result;
    }

    // Throws std::bad_any_cast where it is another struct.
    template <class S>
    const S& as() const {
        return std::any_cast<const S&>(held_);
    }
    template <class S>
    S& as() {
        return std::any_cast<S&>(held_);
    }

 private:
    std::any held_;
};

struct MethodSettings {
    AnySettings ao;        // of the method: what its row's functions take
    AnySettings denoiser;  // of its denoiser
};

// What smooths the noise of a method's raw map.
struct Denoiser {
    AnySettings defaults;
    std::vector<Parameter<AnySettings>> parameters;
    std::function<void(const AnySettings&)>
        validate;  // throws UsageError naming the first member out of range
    std::function<AoMap(const RawAo&, const AnySettings&, const Run&)> denoised;  // empty: there is none
    // Texel (x, y) in each pass that denoised() makes of this map, in their order; empty where it keeps the map.
    std::function<std::vector<ExplainedPass>(const RawAo&, const AnySettings&, int x, int y)> explain;
    // The same of unit vectors, such as bent normals. Empty: they stay as they are.
    std::function<Image3(const Image3&, const AoInputs&, const AnySettings&, const Run&)> directions;
};

// What a method sets out to compute, in terms of rays: of those into the hemisphere over a point, the share that
// meets nothing, where an occluder counts fully up to fade_start, not at all from fade_end on, linear between.
struct AoQuestion {
    float radius = 0;                    // scene units; what is further away does not occlude
    float fade_start = 0, fade_end = 0;  // scene units
    bool cosine_weighted = true;         // false: every direction counts the same
};

// Where the samples of every texel lie before a texel turns or mirrors them.
struct SampleOffsets {
    const char* space = "";          // "view", or "tangent": x and y along the surface, z its normal
    std::vector<glm::vec3> vectors;  // from p, in radii, in the order of the samples
};

struct Method {
    const char* name = "";
    const char* title = "";
    const char* source = "";

    AnySettings defaults;                            // the source's, for scenes whose length_unit is 1
    std::vector<Parameter<AnySettings>> parameters;  // of these; those of the denoiser are its own
    std::function<void(const AnySettings&)>
        validate;                     // throws UsageError naming the first member out of range
    std::vector<int> samples_to_try;  // from the cheapest to the dearest, for error against time

    // Of the G-buffer, beside its depth; the first pass leaves out what nobody reads.
    bool reads_normals = true;
    // Pixels of the picture. A G-buffer pixel that is further than this from the centre of a texel, in x or in y,
    // changes nothing of it, where all that is shown around there is no nearer than view_depth.
    std::function<double(const AoInputs&, const AnySettings&, double view_depth)> reach_px;

    bool casts_rays = false;  // it needs AoView::rays: what lies beyond the screen counts as well

    // What is made once of a scene at rest, before any picture of it. Empty: nothing.
    std::function<std::shared_ptr<const VertexAo>(const Scene&, const RayScene&, const AnySettings&,
                                                  const Run&)>
        bake;

    // The raw map. Empty: the method computes none, and everything counts as open.
    std::function<RawAo(const AoView&, const AnySettings&, const Run&)> ao;
    Denoiser denoiser;
    // The mean direction that is open over each texel that ao() saw: view space, unit, 0 in the background; AO map
    // size. Empty: the method knows none.
    std::function<Image3(const AoInputs&, const AnySettings&, const Run&)> bent_normals;

    // Empty: what a sample looks at follows from its texel alone.
    std::function<SampleOffsets(const AnySettings&)> offsets;

    // The same kernel in double: the map without its rounding errors. With AoView::in_double without those of the
    // buffers, too. Empty: not known.
    std::function<Image<float>(const AoView&, const AnySettings&, const Run&)> ao_in_double;
    // What the raw map tends to with ever more samples; `on_progress` is called with numbers of seeds. Throws
    // UsageError for too few seeds.
    std::function<ReferenceImage(const AoView&, const AnySettings&, int seeds, const Run&,
                                 const std::function<void(long long)>& on_progress)>
        limit;
    std::function<AoQuestion(const AnySettings&)> question;
    // Texel (x, y) of a map that ao() made of this view with these settings; on one thread, so that a debugger that steps
    // through it meets no other.
    std::function<Explanation(const AoView&, const RawAo&, const AnySettings&, int x, int y)> explain;

    bool computes_ao() const { return ao != nullptr; }
};

// The method's defaults and its denoiser's, lengths times length_unit.
MethodSettings defaults_of(const Method& method, float length_unit = 1);

// The method's parameters and its denoiser's.
std::vector<Parameter<MethodSettings>> parameters_of(const Method& method);

// Throws UsageError naming the first member out of its range.
void validate(const Method& method, const MethodSettings& settings);

// The value of a parameter; none where the method has no parameter of that name.
std::optional<double> value_of(const Method& method, const MethodSettings& settings, const std::string& name);

// The settings with one parameter changed, as they are where the method has no parameter of that name. The
// result is not yet validated.
MethodSettings with_value(const Method& method, MethodSettings settings, const std::string& name,
                          double value);

// The bent normals of what ao() saw, denoised where the method's denoiser can; the method must know them.
Image3 bent_normals(const Method& method, const AoInputs& inputs, const MethodSettings& settings,
                    const Run& run = {});

// The denoised map, or the raw one as it is where the method has no denoiser.
AoMap denoised(const Method& method, const RawAo& raw, const MethodSettings& settings, const Run& run = {});

}  // namespace crevice
