#include "chapters/frame/precision_account.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "chapters/frame/far_vertices.h"
#include "chapters/frame/frame_settings.h"
#include "chapters/terminal/number_text.h"
#include "rasterizer/draw/cutouts.h"
#include "rasterizer/draw/depth_precision.h"
#include "rasterizer/draw/visibility.h"
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
    for (const Parameter<MethodSettings>& p : parameters_of(method)) {
        const bool named = p.name == "epsilon" || p.name == "bias";
        if (named && p.unit == kSceneUnit && p.get(settings) > 0)
            return {p.name, p.get(settings), "--param " + p.name};
    }
    const double radius = value_of(method, settings, "radius").value_or(0);
    return {"radius / 64", radius * kHarmlessShare, "--param radius"};
}

std::string in_brackets(const Tolerance& tolerance) {
    return tolerance.name + " (" + significant_text(tolerance.length, 3) + ")";
}

// Pixels that a surface covers, whose depth the format cannot tell from the cleared buffer.
std::size_t lost_to_clear_code(const Scene& scene, const ScreenGeometry& geometry, const GBuffer& gbuffer,
                               bool reversed_z, const Run& run) {
    const DepthFormat format = gbuffer.depth.format;
    const std::int32_t cleared = depth_code(format, reversed_z ? 0.0f : 1.0f, 0.0);
    bool reaches = false;
    for (const TriangleBlock& block : geometry.blocks) {
        for (const ScreenTriangle& t : block.triangles)
            reaches = reaches || depth_code(format, reversed_z ? t.z_low : t.z_high, t.depth_bias) == cleared;
    }
    if (!reaches) return 0;
    const Image<std::int32_t> there =
        drawn_again(geometry, gbuffer.depth, DepthFunction::equal, alpha_holes(scene, geometry, run), run);
    std::size_t count = 0;
    for (int y = 0; y < there.size.height; ++y) {
        for (int x = 0; x < there.size.width; ++x)
            count += gbuffer.triangle.at(x, y) < 0 && there.at(x, y) >= 0 ? 1 : 0;
    }
    return count;
}

// Texels with a surface further away than `depth`.
std::size_t texels_beyond(const AoInputs& inputs, double depth) {
    std::size_t count = 0;
    for (int y = 0; y < inputs.view_depth.size.height; ++y) {
        const float* const row = inputs.view_depth.row(y);
        for (int x = 0; x < inputs.view_depth.size.width; ++x)
            count += row[x] < std::numeric_limits<float>::infinity() && static_cast<double>(row[x]) > depth
                         ? 1
                         : 0;
    }
    return count;
}

// Pixels that show a surface which lies more than a length behind another one: the steps of the depth buffer were too
// coarse to tell. Drawn once more with the finest depths there are, where they may have been.
std::size_t pixels_in_wrong_order(const Scene& scene, const Camera& camera, const GBuffer& gbuffer,
                                  double tolerated, const FrameSettings& settings, const Run& run) {
    const Size size = gbuffer.view_depth.size;
    const DepthFormat format = gbuffer.depth.format;
    if (camera.projection == Projection::orthographic || (camera.reversed_z && format == DepthFormat::d32f))
        return 0;
    const auto seen_apart = [&](double depth) { return tolerated > 0 ? tolerated : depth * kSeenApart; };
    double farthest = 0;
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
            const auto depth = static_cast<double>(gbuffer.view_depth.at(x, y));
            if (depth < std::numeric_limits<double>::infinity()) farthest = std::max(farthest, depth);
        }
    }
    if (farthest == 0 ||
        depth_step(camera, format, std::min(farthest, camera.far_plane)) <= seen_apart(farthest))
        return 0;
    Camera finest = camera;
    finest.reversed_z = true;
    const ScreenGeometry again =
        screen_geometry(scene, finest, size, geometry_settings(settings.buffers), run);
    const Image<float> ndc =
        ndc_depth(visibility(again, DepthFormat::d32f, true, alpha_holes(scene, again, run), run).depth, run);
    const CameraMatrices m = camera_matrices(finest, size);
    std::size_t count = 0;
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
            const auto shown = static_cast<double>(gbuffer.view_depth.at(x, y));
            if (gbuffer.triangle.at(x, y) < 0 || !(ndc.at(x, y) > 0)) continue;
            const double nearest = static_cast<double>(m.depth_b) /
                                   (static_cast<double>(ndc.at(x, y)) - static_cast<double>(m.depth_a));
            count += shown - nearest > seen_apart(shown) ? 1 : 0;
        }
    }
    return count;
}

bool shows_something(const GBuffer& gbuffer) {
    const Size size = gbuffer.triangle.size;
    for (int y = 0; y < size.height; ++y) {
        const std::int32_t* const row = gbuffer.triangle.row(y);
        if (std::any_of(row, row + size.width, [](std::int32_t triangle) { return triangle >= 0; }))
            return true;
    }
    return false;
}

std::size_t vertices_not_finite(const ScreenGeometry& geometry) {
    std::size_t count = 0;
    for (const std::int32_t outside : geometry.vertices.projected.outside)
        count += (outside & kNotANumber) != 0 ? 1 : 0;
    return count;
}

// Triangles that reach behind the eye and are cut at the near plane, with a piece that reaches into the picture: so their
// number does not depend on what is left out beyond its sides.
std::size_t through_the_eye_plane(const ScreenGeometry& geometry) {
    std::size_t count = 0;
    const PixelRect picture = {0, 0, geometry.size.width, geometry.size.height};
    const ScreenTriangle* counted = nullptr;
    for (const TriangleBlock& block : geometry.blocks) {
        for (const ScreenTriangle& t : block.triangles) {
            const bool piece_of_counted = counted != nullptr && counted->vertex == t.vertex;
            if (t.clipped < 0 || piece_of_counted || common_part(t.bounds, picture).empty()) continue;
            const auto behind = [&](std::uint32_t vertex) {
                return (geometry.vertices.projected.outside[vertex] & kOutsideEye) != 0;
            };
            if (std::none_of(t.vertex.begin(), t.vertex.end(), behind)) continue;
            counted = &t;
            ++count;
        }
    }
    return count;
}

// What is wrong with one, and with several.
struct WhatIsWrong {
    std::string one, many;
};

std::string warning_of(std::size_t count, const WhatIsWrong& what, const std::string& cure) {
    return count == 0 ? "" : counted(static_cast<long long>(count), what.one, what.many) + ": " + cure;
}

}  // namespace

std::vector<PrecisionLoss> precision_account(const Scene& scene, const Camera& camera,
                                             const ScreenGeometry& geometry, const GBuffer& gbuffer,
                                             const AoInputs& inputs, const RayScene* rays,
                                             const Method& method, const FrameSettings& settings,
                                             const Run& run) {
    std::vector<PrecisionLoss> account;
    const std::string finer_depth = settings.reversed_z || camera.projection == Projection::orthographic
                                        ? "give a larger --near or a smaller --far"
                                        : "give a larger --near or --param depth_format=d32f_reversed";
    const auto add = [&](const char* name, std::size_t count, const WhatIsWrong& what,
                         const std::string& cure) {
        account.push_back({name, count, warning_of(count, what, cure)});
    };
    add("pixels_lost_to_clear_depth", lost_to_clear_code(scene, geometry, gbuffer, camera.reversed_z, run),
        {"pixel of a surface became sky, its depth is that of the cleared buffer",
         "pixels of surfaces became sky, their depth is that of the cleared buffer"},
        finer_depth);
    const Tolerance tolerance = method.computes_ao() ? tolerance_of(method, settings.method) : Tolerance{};
    const std::string behind =
        " a surface that lies behind another one, the depth buffer's steps are larger than the distance "
        "between "
        "them";
    add("pixels_in_wrong_order",
        pixels_in_wrong_order(scene, camera, gbuffer, tolerance.length, settings, run),
        {"pixel shows" + behind, "pixels show" + behind}, finer_depth);
    const std::size_t unseen = shows_something(gbuffer) ? 0 : geometry.submitted_triangles;
    add("triangles_of_an_empty_picture", unseen,
        {"triangle, and it is not seen", "triangles, and none is seen"},
        "give another --eye and --target, or --near and --far");
    add("vertices_not_finite", vertices_not_finite(geometry),
        {"vertex is no finite number on its way to the screen, and its triangles are left out",
         "vertices are no finite numbers on their way to the screen, and their triangles are left out"},
        "mend the file, or bring scene and camera to a smaller scale");
    account.push_back({"triangles_through_eye_plane", through_the_eye_plane(geometry), ""});
    add("triangles_out_of_reach_of_rays", rays == nullptr ? 0 : rays->not_finite,
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
    const bool reads_depth_buffer = inputs.fetch.depth == DepthSource::ndc_depth;
    const std::string steps = " steps of the depth buffer larger than half of " + in_brackets(tolerance);
    add("texels_of_coarse_depth",
        reads_depth_buffer ? texels_beyond(inputs, depth_of_step(camera, gbuffer.depth.format,
                                                                 kFinerSteps * tolerance.length))
                           : 0,
        {"AO texel sees" + steps, "AO texels see" + steps}, finer_depth);
    add("texels_of_coarse_positions",
        texels_beyond(inputs, tolerance.length / static_cast<double>(kViewDepthRounding)),
        {"AO texel sees rounding larger than " + in_brackets(tolerance),
         "AO texels see rounding larger than " + in_brackets(tolerance)},
        "bring the camera nearer, or give a larger " + tolerance.larger);
    const std::string coarse = " coordinates whose steps are larger than " + in_brackets(tolerance) +
                               ", or than 1/" + significant_text(1 / kHarmlessStep, 3);
    add("vertices_far_from_origin", vertices_far_from_origin(scene, tolerance.length),
        {"vertex has" + coarse + " of its triangles", "vertices have" + coarse + " of their triangles"},
        "move the scene nearer to its origin before it is written");
    return account;
}

}  // namespace crevice
