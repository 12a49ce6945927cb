#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>

#include "chapters/stability/rounding.h"
#include "rasterizer/draw/depth_precision.h"
#include "ssao/inputs/double_inputs.h"
#include "ssao/judge/double_judge.h"
#include "ssao/judge/percentile.h"

namespace crevice {

namespace {

// The step from a float of this size to the next.
double ulp_of(double value) {
    int exponent = 0;
    std::frexp(value, &exponent);
    return std::ldexp(1.0, exponent - std::numeric_limits<float>::digits);
}

double apart(double a, double b) { return std::fabs(a - b); }

// Of the vertices on the screen: positions before they are snapped, and w, which is their view depth.
void add_vertices(const RoundingView& view, std::vector<PassRounding>& rows) {
    const Scene& scene = view.view.scene;
    const DoubleJudge judge(scene, view.camera, view.geometry);
    const TransformedVertices& drawn = view.geometry.vertices;
    std::vector<double> off_px, off_ulps;
    for (std::size_t i = 0; i < scene.instances.size(); ++i) {
        if (!drawn.in_view[i].any()) continue;
        const Instance& instance = scene.instances[i];
        const std::size_t count = scene.meshes[static_cast<std::size_t>(instance.mesh)].positions.size();
        for (std::size_t number = 0; number < count; ++number) {
            const std::size_t at = drawn.first_vertex[i] + number;
            const ProjectedVertex p = drawn.projected[at];
            if ((p.outside & (kNeedsClipping | kNotANumber | kNotTransformed)) != 0) continue;
            const JudgedVertex right = judge.vertex(instance, number);
            const auto position = [](std::int32_t snapped, float rest) {
                return (static_cast<double>(snapped) + static_cast<double>(rest)) / kSubpixelSteps;
            };
            off_px.push_back(std::max(apart(position(p.x, p.x_rest), right.x_px),
                                      apart(position(p.y, p.y_rest), right.y_px)));
            off_ulps.push_back(apart(static_cast<double>(drawn.p_clip[at].w), right.w) / ulp_of(right.w));
        }
    }
    rows.push_back({"vertex transform: screen position", "px", rounding_figures(off_px)});
    rows.push_back({"vertex transform: view depth", "ulps", rounding_figures(off_ulps)});
}

// The depth buffer's step at a depth: a code of an integer format, a float's step of the other.
double depth_step(DepthFormat format, double ndc) {
    switch (format) {
        case DepthFormat::d16: return 1 / kD16Steps;
        case DepthFormat::d24: return 1 / kD24Steps;
        case DepthFormat::d32f: break;
    }
    return ulp_of(ndc);
}

void add_pixels(const RoundingView& view, std::vector<PassRounding>& rows) {
    const GBuffer& g = view.gbuffer;
    const Image<float> ndc = ndc_depth(g.depth);
    std::vector<double> off_depth, off_view_depth, off_normal;
    for (int y = 0; y < g.view_depth.size.height; ++y) {
        for (int x = 0; x < g.view_depth.size.width; ++x) {
            const double z = view.judged.view_depth.at(x, y);
            if (!(z < std::numeric_limits<double>::infinity())) continue;
            const double right_ndc = view.judged.ndc_depth.at(x, y);
            off_depth.push_back(apart(static_cast<double>(ndc.at(x, y)), right_ndc) /
                                depth_step(g.depth.format, right_ndc));
            off_view_depth.push_back(apart(static_cast<double>(g.view_depth.at(x, y)), z) / ulp_of(z));
            const glm::dvec3 right(view.judged.normal[0].at(x, y), view.judged.normal[1].at(x, y),
                                   view.judged.normal[2].at(x, y));
            off_normal.push_back(glm::length(glm::dvec3(g.normal.at(x, y)) - right) / kAoUlp);
        }
    }
    rows.push_back({"depth buffer", "steps of its format", rounding_figures(off_depth)});
    rows.push_back({"view depth", "ulps", rounding_figures(off_view_depth)});
    rows.push_back({"normal", "ulps of 1", rounding_figures(off_normal)});
}

// What a texel of half size takes from its four pixels.
void add_texels(const RoundingView& view, std::vector<PassRounding>& rows) {
    const AoInputs inputs = in_double(ao_inputs(view.gbuffer, view.camera, AoFetch{}), &view.judged);
    const DoubleInputs& judged = *inputs.in_double;
    std::vector<double> off_view_depth, off_normal;
    for (int y = 0; y < inputs.size().height; ++y) {
        for (int x = 0; x < inputs.size().width; ++x) {
            const double z = judged.view_depth.at(x, y);
            if (!(z < std::numeric_limits<double>::infinity())) continue;
            off_view_depth.push_back(apart(static_cast<double>(inputs.view_depth.at(x, y)), z) / ulp_of(z));
            const glm::dvec3 right(judged.normal[0].at(x, y), judged.normal[1].at(x, y),
                                   judged.normal[2].at(x, y));
            off_normal.push_back(glm::length(glm::dvec3(inputs.normal.at(x, y)) - right) / kAoUlp);
        }
    }
    rows.push_back({"half-size texel: view depth", "ulps", rounding_figures(off_view_depth)});
    rows.push_back({"half-size texel: normal", "ulps of 1", rounding_figures(off_normal)});
}

}  // namespace

RoundingFigures rounding_figures(std::vector<double> off) {
    if (off.empty()) return {};
    RoundingFigures figures;
    for (const double value : off) figures.mean += value / static_cast<double>(off.size());
    figures.max = *std::ranges::max_element(off);
    figures.p99 = percentile(std::move(off), 99);
    return figures;
}

RoundingView rounding_view(StiffView view, const Run& run) {
    const FrameSettings settings = settings_of(view, find_method("none"));
    RoundingView result{std::move(view), {}, {}, {}, {}};
    const Scene& scene = result.view.scene;
    result.camera = result.view.camera;
    result.camera.reversed_z = settings.reversed_z;
    GeometrySettings with_clip_positions = geometry_settings(settings.buffers);
    with_clip_positions.with_clip_positions = true;
    result.geometry = screen_geometry(scene, result.camera, result.view.size, with_clip_positions, run);
    result.gbuffer = normal_depth(scene, result.geometry, settings.reversed_z, settings.buffers, run);
    result.judged = double_gbuffer(DoubleJudge(scene, result.camera, result.geometry), result.gbuffer);
    return result;
}

std::vector<PassRounding> pass_rounding(const RoundingView& view) {
    std::vector<PassRounding> rows;
    add_vertices(view, rows);
    add_pixels(view, rows);
    add_texels(view, rows);
    return rows;
}

}  // namespace crevice
