#include "chapters/frame/precision_account.h"

#include <algorithm>
#include <cmath>

#include "chapters/frame/frame_settings.h"
#include "chapters/terminal/number_text.h"
#include "rasterizer/draw/cutouts.h"
#include "rasterizer/draw/depth_precision.h"
#include "rasterizer/draw/precision_counts.h"
#include "rasterizer/scene/far_vertices.h"
#include "ssao/rays/ray_cast.h"

namespace crevice {

namespace {

// Of the radius: a method without a tolerance of its own sees nothing wrong in less.
constexpr double kHarmlessShare = 1.0 / 64;

// Of the view depth: surfaces nearer to each other are not told apart by eye, where no method asks for more.
constexpr double kSeenApart = 0x1p-9;
// Of the tolerance: steps of the depth buffer that a method reads must be this much finer, since a sample's depth is off by one
// step and the depth that it is compared with by another.
constexpr double kFinerSteps = 0.5;

// Kernels square lengths, and shares of a millionth of them. Within these bounds no square leaves the range of a float
// (every_method_test: all lengths times 2^-40 to 2^40 give the same bits).
constexpr double kShortestSquared = 0x1p-42, kLongestSquared = 0x1p42;

// What a distance may be off before the method takes it for an occluder, scene units.
struct Tolerance {
    std::string name;
    double length = 0;   // 0: there is none
    std::string larger;  // what makes it larger
};
Tolerance tolerance_of(const Method& method, const MethodSettings& settings) {
    for (const auto& p : method.parameters) {
        const bool named = p.name == "epsilon" || p.name == "bias";
        if (named && p.unit == kSceneUnit && p.get(settings.ao) > 0)
            return {p.name, p.get(settings.ao), "--param " + p.name};
    }
    const double radius = value_of(method, settings, "radius").value_or(0);
    return {"radius / 64", radius * kHarmlessShare, "--param radius"};
}

std::string in_brackets(const Tolerance& tolerance) {
    return tolerance.name + " (" + significant_text(tolerance.length, 3) + ")";
}

// Pixels that a surface covers, whose depth the format cannot tell from the cleared buffer. `farthest` is the farthest code of
// any triangle.
std::size_t lost_to_clear_code(const DrawnForAccount& drawn, std::int32_t farthest, const Run& run) {
    const DepthFormat format = drawn.gbuffer.depth.format;
    if (farthest != depth_code(format, drawn.camera.reversed_z ? 0.0f : 1.0f, 0.0)) return 0;
    const Image<std::int32_t> there = drawn_again(drawn.geometry, drawn.gbuffer.depth, DepthFunction::equal,
                                                  alpha_holes(drawn.scene, drawn.geometry, run), run);
    return pixels_seen_only_in(there, drawn.gbuffer.triangle, run);
}

// How far apart surfaces at a depth must be, so that it matters which of them is shown.
double seen_apart(double tolerated, double depth) { return tolerated > 0 ? tolerated : depth * kSeenApart; }

// Whether steps are fine as far as anything is, from the farthest code of any triangle. A view depth comes from 1 / w and may
// be a few steps beyond that code: where these are a small share of it, it is nearer than twice as far.
bool fine_as_far_as_triangles(const DrawnForAccount& drawn, std::int32_t farthest, double tolerated,
                              const FrameSettings& settings) {
    constexpr double kFewSteps = 1.0 / 32;
    if (settings.buffers.depth_bias != DepthBias()) return false;
    const DepthFormat format = drawn.gbuffer.depth.format;
    const auto ndc = static_cast<double>(depth_from_code<float>(format, farthest));
    const double depth = std::min(2 * view_depth_of(drawn.camera, ndc), drawn.camera.far_plane);
    return depth_step(drawn.camera, format, depth) <=
           std::min(seen_apart(tolerated, depth), depth * kFewSteps);
}

// Pixels that show a surface which lies more than a length behind another one: the steps of the depth buffer were too
// coarse to tell. Drawn once more with the finest depths there are, where they may have been.
std::size_t pixels_in_wrong_order(const DrawnForAccount& drawn, std::int32_t farthest_code, double tolerated,
                                  const FrameSettings& settings, const Run& run) {
    const Camera& camera = drawn.camera;
    const GBuffer& gbuffer = drawn.gbuffer;
    const Size size = gbuffer.view_depth.size;
    const DepthFormat format = gbuffer.depth.format;
    if (camera.projection == Projection::orthographic || (camera.reversed_z && format == DepthFormat::d32f))
        return 0;
    if (fine_as_far_as_triangles(drawn, farthest_code, tolerated, settings)) return 0;
    const auto farthest = static_cast<double>(farthest_depth(gbuffer.view_depth, run));
    if (farthest == 0 ||
        depth_step(camera, format, std::min(farthest, camera.far_plane)) <= seen_apart(tolerated, farthest))
        return 0;
    Camera finest = camera;
    finest.reversed_z = true;
    const ScreenGeometry again =
        screen_geometry(drawn.scene, finest, size, geometry_settings(settings.buffers), run);
    const Image<float> ndc = ndc_depth(
        visibility(again, DepthFormat::d32f, true, alpha_holes(drawn.scene, again, run), run).depth, run);
    const CameraMatrices m = camera_matrices(finest, size);
    std::size_t count = 0;
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
            const auto shown = static_cast<double>(gbuffer.view_depth.at(x, y));
            if (gbuffer.triangle.at(x, y) < 0 || !(ndc.at(x, y) > 0)) continue;
            const double nearest = static_cast<double>(m.depth_b) /
                                   (static_cast<double>(ndc.at(x, y)) - static_cast<double>(m.depth_a));
            count += shown - nearest > seen_apart(tolerated, shown) ? 1 : 0;
        }
    }
    return count;
}

// Texels whose steps of the depth buffer are too coarse. `farthest` is the farthest depth of a texel.
std::size_t texels_of_coarse_depth(const DrawnForAccount& drawn, double farthest, double tolerated,
                                   const Run& run) {
    const AoInputs& inputs = drawn.inputs;
    const DepthFormat format = drawn.gbuffer.depth.format;
    const double step = kFinerSteps * tolerated;
    if (inputs.fetch.depth != DepthSource::ndc_depth ||
        largest_step_up_to(drawn.camera, format, farthest) <= step)
        return 0;
    return pixels_beyond(inputs.view_depth, depth_of_step(drawn.camera, format, step), run);
}

// What is wrong with one, and with several.
struct WhatIsWrong {
    std::string one, many;
};

std::string warning_of(std::size_t count, const WhatIsWrong& what, const std::string& cure) {
    return count == 0 ? "" : counted(static_cast<long long>(count), what.one, what.many) + ": " + cure;
}

}  // namespace

FarVertices far_vertices(const Scene& scene, const Method& method, const MethodSettings& settings,
                         const FarVertices& known, const Run& run) {
    const double length = tolerance_of(method, settings).length;
    if (!(length > 0) || known.length == length) return known;
    return {length, vertices_far_from_origin(scene, length, run)};
}

std::vector<PrecisionLoss> precision_account(const DrawnForAccount& drawn, const Method& method,
                                             const FrameSettings& settings, const Run& run) {
    const Camera& camera = drawn.camera;
    const ScreenGeometry& geometry = drawn.geometry;
    const GBuffer& gbuffer = drawn.gbuffer;
    const AoInputs& inputs = drawn.inputs;
    std::vector<PrecisionLoss> account;
    const std::string finer_depth = settings.reversed_z || camera.projection == Projection::orthographic
                                        ? "give a larger --near or a smaller --far"
                                        : "give a larger --near or --param depth_format=d32f_reversed";
    const auto add = [&](const char* name, std::size_t count, const WhatIsWrong& what,
                         const std::string& cure) {
        account.push_back({name, count, warning_of(count, what, cure)});
    };
    const std::int32_t farthest = farthest_code(geometry, gbuffer.depth.format, camera.reversed_z);
    add("pixels_lost_to_clear_depth", lost_to_clear_code(drawn, farthest, run),
        {"pixel of a surface became sky, its depth is that of the cleared buffer",
         "pixels of surfaces became sky, their depth is that of the cleared buffer"},
        finer_depth);
    const Tolerance tolerance = method.computes_ao() ? tolerance_of(method, settings.method) : Tolerance{};
    const std::string behind =
        " a surface that lies behind another one, the depth buffer's steps are larger than the distance "
        "between "
        "them";
    add("pixels_in_wrong_order", pixels_in_wrong_order(drawn, farthest, tolerance.length, settings, run),
        {"pixel shows" + behind, "pixels show" + behind}, finer_depth);
    const std::size_t unseen = shows_a_triangle(geometry, gbuffer) ? 0 : geometry.submitted_triangles;
    add("triangles_of_an_empty_picture", unseen,
        {"triangle, and it is not seen", "triangles, and none is seen"},
        "give another --eye and --target, or --near and --far");
    add("vertices_not_finite", vertices_not_finite(geometry, run),
        {"vertex is no finite number on its way to the screen, and its triangles are left out",
         "vertices are no finite numbers on their way to the screen, and their triangles are left out"},
        "mend the file, or bring scene and camera to a smaller scale");
    account.push_back({"triangles_through_eye_plane", triangles_through_eye_plane(geometry), ""});
    add("triangles_out_of_reach_of_rays", drawn.rays == nullptr ? 0 : drawn.rays->not_finite,
        {"triangle lies further than rays reach, 2^36 units, and blocks none",
         "triangles lie further than rays reach, 2^36 units, and block none"},
        "scale the scene");
    if (!method.computes_ao() || inputs.view_depth.empty()) return account;

    const double radius = value_of(method, settings.method, "radius").value_or(1);
    const bool squares = radius == 0 || (radius >= kShortestSquared && radius <= kLongestSquared);
    account.push_back(
        {"radius_out_of_range", squares ? 0u : 1u,
         squares ? ""
                 : "the radius (" + significant_text(radius, 3) +
                       " scene units) is out of the range whose squares floats hold, 2e-13 to 4e12, "
                       "and occlusion may be lost: scale the scene"});
    if (!(tolerance.length > 0)) return account;
    const auto farthest_texel = static_cast<double>(farthest_depth(inputs.view_depth, run));
    const std::string steps = " steps of the depth buffer larger than half of " + in_brackets(tolerance);
    add("texels_of_coarse_depth", texels_of_coarse_depth(drawn, farthest_texel, tolerance.length, run),
        {"AO texel sees" + steps, "AO texels see" + steps}, finer_depth);
    const double rounds_to_tolerance = tolerance.length / static_cast<double>(kViewDepthRounding);
    add("texels_of_coarse_positions",
        farthest_texel > rounds_to_tolerance ? pixels_beyond(inputs.view_depth, rounds_to_tolerance, run) : 0,
        {"AO texel sees rounding larger than " + in_brackets(tolerance),
         "AO texels see rounding larger than " + in_brackets(tolerance)},
        "bring the camera nearer, or give a larger " + tolerance.larger);
    const std::string coarse = " coordinates whose steps are larger than " + in_brackets(tolerance) +
                               ", or than 1/" + significant_text(1 / kHarmlessStep, 3);
    add("vertices_far_from_origin", drawn.far_vertices,
        {"vertex has" + coarse + " of its triangles", "vertices have" + coarse + " of their triangles"},
        "move the scene nearer to its origin before it is written");
    return account;
}

}  // namespace crevice
