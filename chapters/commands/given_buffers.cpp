#include "chapters/commands/given_buffers.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <iostream>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "chapters/compare/compared_image.h"
#include "chapters/terminal/number_text.h"
#include "chapters/terminal/output_directory.h"
#include "chapters/terminal/stopwatch.h"
#include "rasterizer/base/error.h"
#include "rasterizer/base/npy.h"
#include "rasterizer/draw/own_buffers.h"

namespace crevice {

namespace {

constexpr float kNoSurfaceDepth = std::numeric_limits<float>::infinity();

// Doubles, numpy's own type, become the nearest floats.
Planes floats_of_npy(const std::filesystem::path& path) {
    NpyImage image = read_npy_image(path);
    if (image.codes)
        throw InputError(path.string() +
                         ": whole numbers of one or two bytes, which are too coarse for this; store "
                         "floats, such as numpy's float32");
    return std::move(image.planes);
}

// Of several layers the one of that name.
Planes layer_of(const std::filesystem::path& path, const std::string& layer) {
    std::vector<ComparedImage> images = compared_images(path, std::cerr);
    const auto named = [&](const ComparedImage& image) { return image.layer == layer; };
    const auto found =
        images.size() == 1 ? images.begin() : std::find_if(images.begin(), images.end(), named);
    if (found == images.end())
        throw InputError(path.string() + ": none of its layers is called " + layer + " (" +
                         counted(static_cast<long long>(images.size()), "layer") + "); give a file of one");
    return std::move(found->planes);
}

Planes planes_in(const std::filesystem::path& path, const std::string& layer, std::size_t components) {
    std::string ending = path.extension().string();
    for (char& c : ending) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    if (ending != ".npy" && ending != ".pfm" && ending != ".exr")
        throw InputError(
            path.string() + ": no file of floats by its ending (" + ending +
            "); give a .npy, a .pfm or an .exr, for the codes of a picture are too coarse for this");
    Planes planes = ending == ".npy" ? floats_of_npy(path) : layer_of(path, layer);
    if (planes.size() != components)
        throw InputError(path.string() + ": " + counted(static_cast<long long>(planes.size()), "component") +
                         " a pixel where " + layer + " has " + std::to_string(components) +
                         "; give a file of shape " + (components == 3 ? "(H, W, 3)" : "(H, W)"));
    return planes;
}

Image3 normals_in(const std::filesystem::path& path) {
    Planes planes = planes_in(path, "normal", 3);
    Image3 normal;
    normal.x = std::move(planes[0]), normal.y = std::move(planes[1]), normal.z = std::move(planes[2]);
    return normal;
}

std::string pixel_text(int x, int y) { return "(" + std::to_string(x) + ", " + std::to_string(y) + ")"; }

// Makes those of surfaces unit, and says where they were not, and where they cannot be what they should.
void make_unit(Image3& normal, const Image<float>& view_depth, const std::string& name) {
    constexpr double kUnitSlack = 0.004;  // more than halves and bytes round
    long long surfaces = 0, off = 0, away = 0;
    std::string first;
    for (int y = 0; y < view_depth.size.height; ++y) {
        for (int x = 0; x < view_depth.size.width; ++x) {
            if (view_depth.at(x, y) == kNoSurfaceDepth) continue;
            const glm::dvec3 n = normal.at(x, y);
            const double length = std::sqrt(n.x * n.x + n.y * n.y + n.z * n.z);
            ++surfaces;
            away += n.z > 0;
            if (std::isfinite(length) && std::fabs(length - 1) <= kUnitSlack) continue;
            if (!(length > 0) || !std::isfinite(length))
                throw InputError(name + ": no direction where view_depth has a surface (a normal of length " +
                                 significant_text(length, 3) + " at pixel " + pixel_text(x, y) +
                                 "); give unit normals, or +inf as the depth there");
            if (off++ == 0) first = significant_text(length, 3) + " long at pixel " + pixel_text(x, y);
            normal.set(x, y, glm::vec3(n / length));
        }
    }
    if (off > 0)
        warn_on_stderr(name + ": " + counted(off, "normal is not unit", "normals are not unit") + " (of " +
                       std::to_string(surfaces) + ", the first " + first +
                       "); made unit, if they are coded as n / 2 + 1/2 decode them before");
    if (2 * away > surfaces)
        warn_on_stderr(name + ": most normals face away from the eye (" + std::to_string(away) + " of " +
                       std::to_string(surfaces) + " have z > 0); view space is left-handed here, negate z");
}

// Of the surfaces; least is above largest where there are none.
struct SurfaceDepths {
    double least = HUGE_VAL, largest = 0;

    bool empty() const { return least > largest; }
};

SurfaceDepths depths_of_surfaces(const Image<float>& view_depth) {
    SurfaceDepths range;
    for (int y = 0; y < view_depth.size.height; ++y) {
        for (int x = 0; x < view_depth.size.width; ++x) {
            const double z = view_depth.at(x, y);
            if (!(z > 0) || !std::isfinite(z)) continue;
            range.least = std::min(range.least, z);
            range.largest = std::max(range.largest, z);
        }
    }
    return range;
}

// The near and far plane just around the depths, where the flags do not say them.
CameraFlags with_planes(CameraFlags flags, const SurfaceDepths& depths) {
    constexpr double kMargin = 1.0 / 1024;
    if (depths.empty()) return flags;
    if (!flags.near_plane && !flags.far_plane) {
        flags.near_plane = exact_text(static_cast<float>(depths.least * (1 - kMargin)));
        flags.far_plane = exact_text(static_cast<float>(depths.largest * (1 + kMargin)));
    }
    return flags;
}

// What would make a white or a black map without a word.
void warn_of_depths(const SurfaceDepths& depths, const Camera& camera, Size size, double radius,
                    const std::string& name) {
    if (depths.empty())
        return warn_on_stderr(name + ": no surface anywhere (every depth is +inf); all is open");
    if (depths.least < camera.near_plane || depths.largest > camera.far_plane)
        warn_on_stderr(name + ": depths beyond the planes (" + significant_text(depths.least, 4) + " .. " +
                       significant_text(depths.largest, 4) + ", --near " +
                       significant_text(camera.near_plane, 4) + " --far " +
                       significant_text(camera.far_plane, 4) + "); give those it was drawn with");
    if (!(radius > 0)) return;
    const bool ortho = camera.projection == Projection::orthographic;
    const double height = ortho ? camera.ortho_height : 2 * depths.least * std::tan(camera.fov_y_rad / 2);
    constexpr double kManyTimes = 10;
    if (radius / height * size.height < 1)
        warn_on_stderr(name + ": the radius is less than a pixel everywhere (" + significant_text(radius, 3) +
                       ", depths from " + significant_text(depths.least, 3) +
                       "), so that nothing can occlude; give --param radius=R in the units of the depths");
    if (!ortho && radius > kManyTimes * depths.largest)
        warn_on_stderr(name + ": the radius is larger than all that is seen (" + significant_text(radius, 3) +
                       ", depths up to " + significant_text(depths.largest, 3) +
                       "); give --param radius=R in the units of the depths");
}

void require_projection(const CameraFlags& flags) {
    if (!flags.fov_y && !flags.ortho)
        throw UsageError(
            "--depth: how much the camera saw is not in the file; give --fov-y DEG, or --ortho H");
    if (flags.eye || flags.target)
        throw UsageError(std::string(flags.eye ? "--eye" : "--target") +
                         ": buffers in view space know no place; leave it away");
}

void require_screen_space(const Method& method) {
    if (!method.computes_ao())
        throw UsageError(std::string("--ao: computes nothing (") + method.name + "); give another method");
    if (method.casts_rays || method.bake)
        throw UsageError(std::string("--ao: casts rays through a scene, which buffers are not (") +
                         method.name + "); give another method");
}

// What of the frame's passes there is to do.
Frame occluded(const PreparedRender& prepared, GBuffer gbuffer) {
    const FrameRequest& request = prepared.request;
    const Method& method = *request.method;
    Frame frame;
    frame.camera = prepared.camera;
    frame.gbuffer = std::move(gbuffer);
    const AoView view{prepared.argument.scene, frame.camera, frame.gbuffer};
    const bool blurs = method.denoiser.denoised != nullptr &&
                       value_of(method, request.settings.method, "blur_iterations").value_or(1) != 0;
    Stopwatch stopwatch;
    for (int repeat = 0; repeat < request.repeats; ++repeat) {
        stopwatch.time("frame", [&] {
            RawAo raw;
            stopwatch.time("ao", [&] { raw = method.ao(view, request.settings.method.ao, request.run); });
            if (blurs)
                stopwatch.time("blur", [&] {
                    frame.ao_blurred = denoised(method, raw, request.settings.method, request.run).ao;
                });
            if (request.wanted.contains(kBentNormal))
                stopwatch.time(kBentNormal, [&] {
                    frame.bent_normal =
                        bent_normals(method, raw.inputs, request.settings.method, request.run);
                });
            if (!blurs) frame.ao_blurred = raw.ao;
            frame.ao_raw = std::move(raw.ao);
        });
    }
    frame.passes = stopwatch.summaries();
    frame.left_out = {{"normal_depth", "the buffers were given"}, {"lit", "buffers are no scene"}};
    if (!blurs) frame.left_out.push_back({"blur", "the method has no denoiser, or blur_iterations is 0"});
    return frame;
}

}  // namespace

void render_given_buffers(const RenderOptions& options, const GivenBuffers& buffers) {
    PreparedRender prepared{{}, {}, options.request};
    FrameRequest& request = prepared.request;
    validate(request.run);
    require_screen_space(*request.method);
    request.settings = settings_of(*request.method, options.params);
    if (request.settings.history.longest > 1)
        throw UsageError("--param history: there is no frame before this one; leave it away");
    require_projection(options.camera);
    if (!buffers.normals && request.method->reads_normals)
        throw UsageError(std::string("--depth: ") + request.method->name +
                         " reads normals as well; give --normals FILE, too, or --ao msvo");
    const Image<float> view_depth = planes_in(buffers.depth, "view_depth", 1).front();
    request.size = view_depth.size;
    Image3 normal =
        buffers.normals ? normals_in(*buffers.normals) : Image3(view_depth.size, glm::vec3(0, 0, -1));
    const SurfaceDepths depths = depths_of_surfaces(view_depth);
    prepared.camera = chosen_camera(SceneArgument(), with_planes(options.camera, depths));
    prepared.camera.reversed_z = request.settings.reversed_z;
    const std::string names =
        (buffers.normals ? buffers.normals->string() + ", " : "") + buffers.depth.string();
    GBuffer gbuffer;
    try {
        if (buffers.normals && normal.x.size == view_depth.size)
            make_unit(normal, view_depth, buffers.normals->string());
        gbuffer = gbuffer_of(normal, view_depth, prepared.camera, request.settings.buffers.depth_format);
    } catch (const InputError& error) {
        const std::string what = error.what();
        throw InputError(
            buffers.normals && what.starts_with(buffers.normals->string()) ? what : names + ": " + what);
    }
    warn_of_depths(depths, prepared.camera, request.size,
                   value_of(*request.method, request.settings.method, "radius").value_or(0),
                   buffers.depth.string());
    try_output_directory(options.out);
    write_frame(options, prepared, options.out, occluded(prepared, std::move(gbuffer)), {}, &std::cout);
}

}  // namespace crevice
