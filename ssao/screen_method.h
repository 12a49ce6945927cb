// A row of the table of methods from the functions that each screen-space method has, whose settings S have members
// radius, exponent, seed and ao_scale.
#pragma once

#include <vector>

#include "ssao/inputs/double_inputs.h"
#include "ssao/inputs/pixel_fetch.h"
#include "ssao/judge/seed_limit.h"
#include "ssao/methods/method.h"

namespace crevice {

template <class S>
struct ScreenMethod {
    const char *name, *title, *source;
    S defaults;
    std::vector<Parameter<S>> parameters;
    std::vector<int> samples_to_try;
    AoFetch (*fetch)(const S&) =
        pixel_fetch;  // how it reads the G-buffer; or, where that is no fetch of ao_inputs():
    AoInputs (*inputs)(const AoView&, const S&, const Run&) = nullptr;
    AoMap (*ao)(const AoInputs&, const S&, const Run&);
    double (*reach_px)(const AoInputs&, const S&, double view_depth);
    Explanation (*explain)(const AoInputs&, const S&, int x, int y);
    AoQuestion (*question)(const S&);
    std::vector<glm::vec3> (*tangent_offsets)(const S&) = nullptr;  // SampleOffsets::vectors
    bool reads_normals = true;
    Image3 (*bent_normals)(const AoInputs&, const S&, const Run&) = nullptr;
};

// The parameters that every screen-space method has beside its own.
template <class S>
std::vector<Parameter<S>> common_parameters() {
    return {
        number("radius", "[0, 1e15]", kSceneUnit, "how far from the surface something may occlude",
               &S::radius),
        number("exponent", "[0, 64]", "-", "contrast: accessibility is raised to it", &S::exponent),
        whole("seed", 0, 0xffffffffLL, "of all that is random", &S::seed),
        number("ao_scale", "0.5|1", "-", "size of the AO map over that of the picture; as --ao-scale",
               &S::ao_scale),
    };
}

// How a screen-space method makes its inputs. Apart from ScreenMethod, because every function of a row has a copy.
template <class S>
struct InputsOf {
    AoFetch (*fetch)(const S&);
    AoInputs (*inputs)(const AoView&, const S&, const Run&);  // or null

    AoInputs operator()(const AoView& view, const S& settings, const Run& run) const {
        if (inputs != nullptr) return inputs(view, settings, run);
        return ao_inputs(view.gbuffer, view.camera, fetch(settings), run);
    }
};

// A row with its settings, their parameters and their check.
template <class S>
Method row_with(const S& defaults, const std::vector<Parameter<S>>& parameters) {
    Method row;
    row.defaults = AnySettings::of(defaults);
    row.parameters = within<AnySettings>(
        parameters, [](auto& settings) -> auto& { return settings.template as<S>(); });
    row.validate = [](const AnySettings& s) { validate(s.as<S>()); };
    return row;
}

// Method::limit of a method that makes its inputs by inputs_of(view, settings, run), and of these its map by
// map_of(view, inputs, settings, run): over seeds, with the contrast taken of their mean.
template <class S, class InputsOf, class MapOf>
auto limit_over_seeds(InputsOf inputs_of, MapOf map_of) {
    return [=](const AoView& view, const AnySettings& s, int seeds, const Run& run,
               const std::function<void(long long)>& on_progress) {
        const AoInputs inputs = inputs_of(view, s.as<S>(), run);
        S drawn = s.as<S>();
        drawn.exponent = 1;
        return seed_limit(inputs.view_depth, s.as<S>().exponent, seeds, run, on_progress,
                          [&](std::uint32_t seed) {
                              drawn.seed = seed;
                              return map_of(view, inputs, drawn, run).ao;
                          });
    };
}

template <class S>
Method row_of(const ScreenMethod<S>& m, Denoiser denoiser) {
    std::vector<Parameter<S>> parameters = m.parameters;
    for (Parameter<S>& common : common_parameters<S>()) parameters.push_back(std::move(common));
    Method row = row_with(m.defaults, parameters);
    row.name = m.name;
    row.title = m.title;
    row.source = m.source;
    row.reads_normals = m.reads_normals;
    row.samples_to_try = m.samples_to_try;
    row.reach_px = [reach_px = m.reach_px](const AoInputs& inputs, const AnySettings& s, double view_depth) {
        return reach_px(inputs, s.as<S>(), view_depth);
    };
    const InputsOf<S> inputs_of{m.fetch, m.inputs};
    row.ao = [inputs_of, ao = m.ao](const AoView& view, const AnySettings& s, const Run& run) {
        AoInputs inputs = inputs_of(view, s.as<S>(), run);
        AoMap map = ao(inputs, s.as<S>(), run);
        return RawAo{std::move(map.ao), std::move(map.tiles), std::move(inputs)};
    };
    row.ao_in_double = [inputs_of, ao = m.ao](const AoView& view, const AnySettings& s, const Run& run) {
        AoInputs inputs = inputs_of(view, s.as<S>(), run);
        return ao(in_double(std::move(inputs), view.in_double), s.as<S>(), run).ao;
    };
    if (m.tangent_offsets != nullptr)
        row.offsets = [offsets = m.tangent_offsets](const AnySettings& s) {
            return SampleOffsets{"tangent", offsets(s.as<S>())};
        };
    row.denoiser = std::move(denoiser);
    if (m.bent_normals != nullptr) {
        row.bent_normals = [bent_normals = m.bent_normals](const AoInputs& inputs, const AnySettings& s,
                                                           const Run& run) {
            return bent_normals(inputs, s.as<S>(), run);
        };
    }
    row.limit =
        limit_over_seeds<S>(inputs_of, [ao = m.ao](const AoView&, const AoInputs& inputs, const S& settings,
                                                   const Run& run) { return ao(inputs, settings, run); });
    row.question = [question = m.question](const AnySettings& s) { return question(s.as<S>()); };
    row.explain = [explain = m.explain](const AoView&, const RawAo& raw, const AnySettings& s, int x, int y) {
        return explain(raw.inputs, s.as<S>(), x, y);
    };
    return row;
}

}  // namespace crevice
