#include <cmath>
#include <iostream>
#include <sstream>

#include "chapters/commands/bake.h"
#include "chapters/frame/scene_argument.h"
#include "chapters/notebook/picture.h"
#include "chapters/terminal/output_directory.h"
#include "chapters/terminal/progress.h"
#include "chapters/terminal/stopwatch.h"
#include "rasterizer/base/error.h"
#include "rasterizer/base/image_io.h"
#include "rasterizer/obj/obj_write.h"
#include "ssao/bakes/lightmap_ao.h"
#include "ssao/bakes/lightmap_mesh.h"

namespace crevice {

namespace {

std::string fixed(double value, int digits) {
    std::ostringstream text;
    text.precision(digits);
    text << std::fixed << value;
    return text.str();
}

struct Bake {
    RayScene rays;
    LightmapCharts charts;
    LightmapAo map;
    double build_ms = 0, charts_ms = 0, rays_ms = 0;
};

// What rays are relative to: the largest coordinate decides how far they start above their surface, and is
// smallest from the middle. Vertices that are no numbers spoil the bounds.
glm::dvec3 middle_of(const Scene& scene) {
    const Bounds bounds = world_bounds(scene);
    const glm::dvec3 middle = 0.5 * (bounds.low + bounds.high);
    return std::isfinite(middle.x + middle.y + middle.z) ? middle : glm::dvec3(0);
}

Bake bake(const Scene& scene, const BakeOptions& options) {
    Bake result;
    const double start_ms = clocks().wall_ms;
    result.rays = ray_scene(scene, middle_of(scene), options.run);
    if (result.rays.triangles.empty())
        throw InputError(options.scene + ": no triangle that could be baked (" +
                         std::to_string(triangle_count(scene)) +
                         " triangles in all); give a scene with triangles that have an area");
    const double built_ms = clocks().wall_ms;
    result.charts =
        lightmap_charts(scene, result.rays,
                        {.texels = options.texels, .mesh_texcoords = options.mesh_texcoords}, options.run);
    const double charted_ms = clocks().wall_ms;
    const LightmapPoints points = lightmap_points(scene, result.rays, result.charts, options.run);
    Progress progress("lightmap", static_cast<long long>(points.texels.points.size()));
    result.map = lightmap_ao(result.rays, result.charts, points, options.rays, options.run,
                             [&](long long texels) { progress.advance(texels); });
    result.build_ms = built_ms - start_ms;
    result.charts_ms = charted_ms - built_ms;
    result.rays_ms = clocks().wall_ms - charted_ms;
    return result;
}

void warn(const Bake& done, const BakeOptions& options) {
    if (done.map.lifted_far > 0)
        std::cerr << options.scene << ": offset-exceeds-radius/100: " << done.map.lifted_far
                  << " texels start more than radius / 100 above their surface (radius "
                  << options.rays.radius << "); take a larger --radius\n";
    if (done.rays.not_finite > 0)
        std::cerr << options.scene << ": not-finite: " << done.rays.not_finite
                  << " triangles have a corner that is no finite number and are left out; mend the file\n";
    if (!done.charts.note.empty()) std::cerr << options.scene << ": " << done.charts.note << "\n";
    if (done.rays.degenerate > 0)
        std::cerr << options.scene << ": no-area: " << done.rays.degenerate
                  << " triangles have no area and are left out\n";
}

void print(const Bake& done, std::ostream& out) {
    const LightmapAo& map = done.map;
    const double texels = double(done.charts.texels) * done.charts.texels;
    const auto share = [&](std::size_t count) {
        return fixed(100 * static_cast<double>(count) / texels, 1) + " %";
    };
    const std::size_t centre = map.count(TexelKind::centre), touched = map.count(TexelKind::touched);
    out << done.charts.rects.size() << " charts for " << done.rays.triangles.size() << " triangles, "
        << fixed(done.charts.density, 3) << " texels a scene unit\n"
        << share(centre + touched) << " of the texels are used, " << share(touched)
        << " of them at edges; dilation fills another " << share(map.count(TexelKind::dilated)) << "\n"
        << map.rays_cast << " rays, " << fixed(static_cast<double>(map.rays_cast) / done.rays_ms / 1e3, 1)
        << " million/s; BVH " << fixed(done.build_ms, 1) << " ms, charts " << fixed(done.charts_ms, 1)
        << " ms, rays " << fixed(done.rays_ms, 1) << " ms\n";
}

}  // namespace

void bake_lightmap(const BakeOptions& options, std::ostream& out) {
    // Before the scene is loaded, for a quick answer to a wrong word.
    validate(options.run);
    validate(options.rays);
    validate(ChartSettings{.texels = options.texels});
    const SceneArgument argument =
        load_scene(options.scene, {.surfaces = false, .unused_texcoords = options.mesh_texcoords});
    try_output_directory(options.out);
    const Bake done = bake(argument.scene, options);
    warn(done, options);
    print(done, out);

    const Picture picture = ao_picture(done.map.ao);
    const std::string name = std::filesystem::path(options.scene).stem().string();
    const std::filesystem::path map = options.out / "lightmap.png",
                                mesh = options.out / (name + "_lightmap.obj");
    write_npy(options.out / "lightmap.npy", done.map.ao);
    write_picture(map, picture);
    write_obj(mesh, lightmap_mesh(argument.scene, done.rays, done.charts), {},
              "Ambient accessibility is in lightmap.png (and, as floats, in lightmap.npy).\n"
              "An OBJ file has one set of texture coordinates: these lead into the lightmap, not into the\n"
              "materials' textures.");
    out << map.string() << ": " << picture.mapping << "\n" << mesh.string() << "\n";
}

}  // namespace crevice
