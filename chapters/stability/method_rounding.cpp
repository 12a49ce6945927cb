#include <algorithm>
#include <cmath>
#include <limits>

#include "chapters/stability/rounding.h"
#include "chapters/stability/stiff_scenes.h"
#include "scenes/builtin_scenes.h"
#include "ssao/rays/ray_cast.h"

namespace crevice {

namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();

AoRounding ao_rounding(const Image<float>& a, const Image<float>& b, const Image<float>& view_depth) {
    std::vector<double> off;
    for (int y = 0; y < a.size.height; ++y) {
        for (int x = 0; x < a.size.width; ++x) {
            if (!(view_depth.at(x, y) < kInfinity)) continue;
            off.push_back(std::fabs(static_cast<double>(a.at(x, y)) - static_cast<double>(b.at(x, y))));
        }
    }
    AoRounding rounding;
    const auto otherwise = std::ranges::count_if(off, [](double value) { return value > kDecidedOtherwise; });
    rounding.decided_otherwise =
        off.empty() ? 0 : static_cast<double>(otherwise) / static_cast<double>(off.size());
    rounding.off = rounding_figures(std::move(off));
    return rounding;
}

// The judge's numbers rounded to float once.
GBuffer rounded_once(GBuffer g, const DoubleGBuffer& judged) {
    for (int y = 0; y < g.view_depth.size.height; ++y) {
        for (int x = 0; x < g.view_depth.size.width; ++x) {
            const double z = judged.view_depth.at(x, y);
            if (!(z < std::numeric_limits<double>::infinity())) continue;
            g.view_depth.at(x, y) = static_cast<float>(z);
            g.depth.codes.at(x, y) =
                depth_code(g.depth.format, static_cast<float>(judged.ndc_depth.at(x, y)), 0.0);
            g.normal.set(
                x, y,
                glm::vec3(judged.normal[0].at(x, y), judged.normal[1].at(x, y), judged.normal[2].at(x, y)));
        }
    }
    return g;
}

// The maps of one method on one view.
struct MapMaker {
    const RoundingView& judged;
    const Method& method;
    const FrameSettings settings;
    const Run& run;
    RayScene rays = {};

    MapMaker(const RoundingView& view, const Method& of, const Run& with)
        : judged(view), method(of), settings(settings_of(at_full_size(view.view), of)), run(with) {
        if (method.casts_rays) rays = ray_scene(view.view.scene, view.camera.eye, run);
    }

    static StiffView at_full_size(StiffView view) {
        view.params.push_back("ao_scale=1");
        return view;
    }

    AoView ao_view(const GBuffer& gbuffer, const DoubleGBuffer* in_double = nullptr) const {
        return {judged.view.scene, judged.camera, gbuffer, &rays, nullptr, in_double};
    }
    RawAo in_float(const GBuffer& gbuffer) const {
        return method.ao(ao_view(gbuffer), settings.method.ao, run);
    }
    Image<float> in_double(const DoubleGBuffer* seen) const {
        return method.ao_in_double(ao_view(judged.gbuffer, seen), settings.method.ao, run);
    }
    // Of the map `ao` of the same texels.
    Image<float> blurred(RawAo raw, Image<float> ao) const {
        raw.ao = std::move(ao);
        return denoised(method, raw, settings.method, run).ao;
    }
};

}  // namespace

const char* word_of(RoundingCause cause) {
    static constexpr const char* kWords[] = {"kernel", "depth", "normal", "all", "blurred"};
    return kWords[static_cast<std::size_t>(cause)];
}

std::string why_not_in_double(const Method& method) {
    if (method.ao_in_double) return "";
    if (method.bake) return "its rays start at the scene's vertices, which no pass before it has rounded";
    return "whether a ray meets a triangle is decided in double wherever float is in doubt";
}

MethodRounding method_rounding(const RoundingView& view, const Method& method, const Run& run) {
    const MapMaker maps(view, method, run);
    const RawAo raw = maps.in_float(view.gbuffer);
    const Image<float>& depth = view.gbuffer.view_depth;
    MethodRounding result{&method, {}};
    const auto set = [&](RoundingCause cause, const Image<float>& a, const Image<float>& b) {
        result.by_cause[static_cast<std::size_t>(cause)] = ao_rounding(a, b, depth);
    };
    if (!method.ao_in_double) {
        const RawAo once = maps.in_float(rounded_once(view.gbuffer, view.judged));
        set(RoundingCause::all, raw.ao, once.ao);
        set(RoundingCause::blurred, maps.blurred(raw, raw.ao), maps.blurred(once, once.ao));
        return result;
    }
    DoubleGBuffer float_depths = view.judged, float_normals = view.judged;
    float_depths.view_depth = widened(view.gbuffer.view_depth);
    float_depths.ndc_depth = widened(ndc_depth(view.gbuffer.depth, run));
    const Image3& n = view.gbuffer.normal;
    float_normals.normal = {widened(n.x), widened(n.y), widened(n.z)};
    const Image<float> exact = maps.in_double(&view.judged);
    set(RoundingCause::kernel, raw.ao, maps.in_double(nullptr));
    set(RoundingCause::depth, maps.in_double(&float_depths), exact);
    set(RoundingCause::normal, maps.in_double(&float_normals), exact);
    set(RoundingCause::all, raw.ao, exact);
    set(RoundingCause::blurred, maps.blurred(raw, raw.ao), maps.blurred(raw, exact));
    return result;
}

CaseRounding case_rounding(const RoundingCase& of, const Method* only, const Run& run) {
    const RoundingView view = rounding_view(of.view(), run);
    CaseRounding result{of, pass_rounding(view), {}};
    for (const Method& method : ao_methods()) {
        if (method.computes_ao() && (only == nullptr || only == &method))
            result.methods.push_back(method_rounding(view, method, run));
    }
    return result;
}

std::vector<RoundingCase> rounding_cases(bool quick) {
    std::vector<RoundingCase> cases = {
        {"block", "a floor, a wall and a block some units away", block_view},
        {"columns", "the tutorials' columns and spheres: curved meshes of small triangles",
         [] {
             const Scene scene = columns_scene();
             return StiffView{scene, scene.camera};
         }},
        {"grazing_85", "a plane tilted by 85 degrees: depths change fast along it",
         [] { return tilted_plane_view(85); }}};
    if (quick) return cases;
    cases.push_back({"grazing_89.9", "a plane tilted by 89.9 degrees, all of it in one row of pixels",
                     [] { return tilted_plane_view(89.9); }});
    cases.push_back({"origin_4e6",
                     "the same block 4,000,000 units from the origin, where a float's step is half a unit: "
                     "its vertices are floats, its eye is none",
                     [] { return moved(block_view(), 4e6); }});
    cases.push_back({"far_plane_1e5", "a plane 100,000 units away, where a float's step is 1/128 unit",
                     [] { return far_plane_view(1e5); }});
    cases.push_back({"depth_1e-4_1e7", "the block with near 1e-4 and far 1e7 in 32-bit depths", [] {
                         StiffView view = block_view();
                         view.camera.near_plane = 1e-4;
                         view.camera.far_plane = 1e7;
                         return view;
                     }});
    cases.push_back({"slivers", "a plane cut into triangles a thousandth of a pixel wide",
                     [] { return sliver_plane_view(); }});
    return cases;
}

}  // namespace crevice
