#include "chapters/frame/scene_argument.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <optional>

#include "chapters/terminal/number_text.h"
#include "chapters/terminal/parse.h"
#include "rasterizer/base/float_text.h"
#include "rasterizer/base/no_such.h"
#include "rasterizer/lanes/approx_math.h"
#include "rasterizer/scene/framing_camera.h"
#include "rasterizer/scene/mesh_clusters.h"
#include "rasterizer/scene/outlier_vertex.h"
#include "scenes/builtin_scenes.h"

namespace crevice {

namespace {

// Whether a word that names no file was meant as one.
bool is_path(const std::string& word) {
    const std::filesystem::path path(word);
    return path.has_extension() || path.has_parent_path();
}

// A camera that frames them must lie within 1e30 units, and a few times their size away.
constexpr double kLargestCoordinate = 1e29;

void require_within_reach(const std::string& path, const Bounds& bounds) {
    if (bounds.empty) return;
    for (const glm::dvec3& corner : {bounds.low, bounds.high}) {
        for (int i = 0; i < 3; ++i) {
            if (!(std::fabs(corner[i]) > kLargestCoordinate)) continue;
            throw InputError(path + ": a coordinate is too large to be looked at (" +
                             shortest_text(corner[i]) + ", at most 1e29); scale the model down");
        }
    }
}

// Below this the unit of lengths no longer follows a scene's size (length_unit_of), and neither do the defaults of radii;
// further down squares and products of coordinates vanish.
constexpr double kSmallestExtent = 3e-29;

std::optional<std::string> warning_of_smallness(const std::string& path, const Bounds& bounds) {
    const glm::dvec3 size = bounds.high - bounds.low;
    const double extent = std::max({size.x, size.y, size.z});
    if (!(extent > 0) || extent >= kSmallestExtent) return std::nullopt;
    return path + ": the model is too small for the range of float (its largest extent is " +
           significant_text(extent, 3) + ", less than " + significant_text(kSmallestExtent, 1) +
           "); normals and occlusion may be lost, scale it up";
}

void require_fit(const Scene& scene, const std::string& name, const Method& method) {
    try {
        validate(method, defaults_of(method, scene.length_unit));
    } catch (const UsageError& error) {
        const std::string refusal = error.what();
        throw InputError(name + ": its coordinates are too large for the defaults of " + method.name + ": " +
                         refusal.substr(0, refusal.find(';')) + "; scale the model down, or give --param");
    }
}

}  // namespace

std::optional<double> crease_angle_of(const std::optional<std::string>& word) {
    if (!word) return std::nullopt;
    const double degrees = parse_number("--crease", *word);
    // All the way round, whatever radians() rounds that to.
    if (degrees == 180) return kSmoothEverywhere_rad;
    if (degrees >= 0 && degrees < 180) return radians(degrees);
    throw UsageError("--crease: out of range (" + *word + "); give degrees from 0 to 180");
}

void warn_on_stderr(const std::string& line) { std::cerr << line << "\n"; }

SceneArgument load_scene(const std::string& name_or_path, const WantedOfScene& wanted,
                         const WarningSink& warn) {
    if (const BuiltinScene* builtin = find_builtin_scene(name_or_path)) {
        const auto start = std::chrono::steady_clock::now();
        const SceneDetail detail = wanted.surfaces ? SceneDetail::surfaces : SceneDetail::shapes;
        Scene scene = builtin->make(detail, wanted.run);
        add_clusters(scene, wanted.run);
        const std::chrono::duration<double, std::milli> took = std::chrono::steady_clock::now() - start;
        return {std::move(scene), false, {{"make the scene", took.count()}}};
    }
    std::error_code ignored;
    if (!std::filesystem::exists(name_or_path, ignored)) {
        if (is_path(name_or_path)) throw InputError(name_or_path + ": there is no such file; check the path");
        std::vector<std::string> known;
        for (const BuiltinScene& scene : builtin_scenes()) known.push_back(scene.name);
        throw no_such("SCENE", "scene and no such file", name_or_path, known);
    }
    ObjOptions options;
    options.want_textures = wanted.surfaces;
    options.want_unused_texcoords = wanted.unused_texcoords;
    options.outside_files = wanted.outside_files;
    if (wanted.crease_angle_rad) options.crease_angle_rad = *wanted.crease_angle_rad;
    LoadedObj loaded = load_obj(name_or_path, options, wanted.run);
    const Bounds bounds = world_bounds(loaded.scene);
    require_within_reach(name_or_path, bounds);
    for (const std::string& warning : loaded.report.warnings) warn(warning);
    // At 0 what had no normals has got those of its faces, which are not called generated.
    if (wanted.crease_angle_rad.value_or(0) > 0 && loaded.report.generated_normals == 0)
        warn(name_or_path +
             ": --crease changes nothing (every corner has its normal from the file); leave it away");
    if (const auto warning = warning_of_smallness(name_or_path, bounds)) warn(*warning);
    add_clusters(loaded.scene, wanted.run);
    return {std::move(loaded.scene), true, std::move(loaded.steps)};
}

glm::dvec3 own_coordinates(const SceneArgument& argument, const glm::dvec3& p_world) {
    const glm::dvec3 p = p_world + argument.scene.origin;
    return argument.from_obj ? glm::dvec3(p.x, p.y, -p.z) : p;
}

std::vector<std::string> scene_warnings(const SceneArgument& argument, const std::string& name_or_path) {
    std::vector<std::string> warnings;
    if (triangle_count(argument.scene) == 0)
        warnings.push_back(name_or_path + ": 0 triangles; only the sky will be seen");
    if (const std::optional<OutlierVertex> outlier = outlier_vertex(argument.scene)) {
        constexpr int kDigits = 9;  // millimetres in the metres of a map
        const glm::dvec3 p = own_coordinates(argument, outlier->p_world);
        warnings.push_back("warning: " + name_or_path + ": the vertex at " + significant_text(p.x, kDigits) +
                           ", " + significant_text(p.y, kDigits) + ", " + significant_text(p.z, kDigits) +
                           " makes the scene " + significant_text(outlier->stretch, 3) +
                           " times as large as the others do, and framing, the unit of lengths and the "
                           "shadow follow; remove it, or give --eye, --target, --near and --param radius");
    }
    return warnings;
}

Camera chosen_camera(const SceneArgument& argument, const CameraFlags& flags) {
    Camera camera = argument.scene.camera;
    // An OBJ's coordinates are converted like its vertices.
    const auto point = [&](const char* flag, const std::string& word) {
        const glm::dvec3 p = parse_point(flag, word);
        return (argument.from_obj ? glm::dvec3(p.x, p.y, -p.z) : p) - argument.scene.origin;
    };
    if (flags.eye) {
        camera.eye = point("--eye", *flags.eye);
        const Bounds bounds = world_bounds(argument.scene);
        if (!flags.target && !bounds.empty) camera.target = 0.5 * (bounds.low + bounds.high);
    }
    if (flags.target) camera.target = point("--target", *flags.target);
    camera = moved_planes(argument, flags, camera);
    if (flags.fov_y) camera.fov_y_rad = radians(parse_number("--fov-y", *flags.fov_y));
    if (flags.near_plane) camera.near_plane = parse_number("--near", *flags.near_plane);
    if (flags.far_plane) camera.far_plane = parse_number("--far", *flags.far_plane);
    if (flags.ortho) {
        camera.projection = Projection::orthographic;
        camera.ortho_height = parse_number("--ortho", *flags.ortho);
    }
    named_as({{"eye", "--eye"},
              {"target", "--target"},
              {"fov_y_rad", "--fov-y"},
              {"near_plane", "--near"},
              {"far_plane", "--far"},
              {"ortho_height", "--ortho"}},
             [&] { validate(camera); });
    return camera;
}

Camera moved_planes(const SceneArgument& argument, const CameraFlags& flags, const Camera& camera) {
    // The planes of framing_camera() are close around the scene, as seen from its eye. Those of a built-in scene are part of it.
    const bool follow = argument.from_obj && (flags.eye || flags.target);
    if (!follow || camera.eye == camera.target) return camera;
    const Camera fitted = with_planes_around(camera, world_bounds(argument.scene));
    Camera after = camera;
    if (!flags.near_plane) after.near_plane = fitted.near_plane;
    if (!flags.far_plane) after.far_plane = fitted.far_plane;
    return after;
}

FrameSettings settings_for(const SceneArgument& scene, const std::string& name, const Method& method,
                           const std::vector<std::string>& assignments) {
    try {
        return settings_of(method, assignments, scene.scene.length_unit);
    } catch (const UsageError&) {
        require_fit(scene.scene, name, method);
        throw;
    }
}

}  // namespace crevice
