#include <iostream>

#include "chapters/commands/bake.h"
#include "chapters/frame/scene_argument.h"
#include "chapters/notebook/picture.h"
#include "chapters/terminal/number_text.h"
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

struct Bake {
    RayScene rays;
    LightmapCharts charts;
    LightmapAo map;
    double build_ms = 0, charts_ms = 0, rays_ms = 0;
};

Bake bake(const Scene& scene, const BakeOptions& options) {
    Bake result;
    const double start_ms = clocks().wall_ms;
    result.rays = centred_ray_scene(scene, options.scene, options.run);
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
    print_warning(
        options, "not-finite", done.rays.not_finite,
        "triangle has a corner that is no finite number or beyond 2^36 units and is left out; mend the file",
        "triangles have a corner that is no finite number or beyond 2^36 units and are left out; mend the "
        "file");
    print_warning(options, "no-area", done.rays.degenerate, "triangle has no area and is left out",
                  "triangles have no area and are left out");
    print_warning(options, "offset-exceeds-radius/100", done.map.lifted_far,
                  "texel's rays start more than radius / 100 above their surface; take a larger --radius",
                  "texels' rays start more than radius / 100 above their surface; take a larger --radius");
    if (!done.charts.note.empty()) std::cerr << options.scene << ": " << done.charts.note << "\n";
}

void print(const Bake& done, std::ostream& out) {
    const LightmapAo& map = done.map;
    const double texels = double(done.charts.texels) * done.charts.texels;
    const auto share = [&](std::size_t count) { return percent_text(static_cast<double>(count) / texels); };
    const std::size_t centre = map.count(TexelKind::centre), touched = map.count(TexelKind::touched);
    out << counted(static_cast<long long>(done.charts.rects.size()), "chart") << " for "
        << counted(static_cast<long long>(done.rays.triangles.size()), "triangle") << ", "
        << decimal_text(done.charts.density, 3) << " texels a scene unit\n"
        << share(centre + touched) << " of the texels are used, " << share(touched)
        << " of them at edges; dilation fills another " << share(map.count(TexelKind::dilated)) << "\n"
        << map.rays_cast << " rays, "
        << decimal_text(static_cast<double>(map.rays_cast) / done.rays_ms / 1e3, 1) << " million/s; BVH "
        << decimal_text(done.build_ms, 1) << " ms, charts " << decimal_text(done.charts_ms, 1) << " ms, rays "
        << decimal_text(done.rays_ms, 1) << " ms\n";
}

}  // namespace

void bake_lightmap(const BakeOptions& options, std::ostream& out) {
    // Before the scene is loaded, for a quick answer to a wrong word.
    validate(options.run);
    validate(options.rays);
    validate(ChartSettings{.texels = options.texels});
    const SceneArgument argument = load_scene(options.scene, {.surfaces = false,
                                                              .unused_texcoords = options.mesh_texcoords,
                                                              .outside_files = options.outside_files,
                                                              .crease_angle_rad = options.crease_angle_rad,
                                                              .run = options.run});
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
              "materials' textures.",
              argument.scene.origin);
    out << map.string() << ": " << picture.mapping << "\n" << mesh.string() << "\n";
}

}  // namespace crevice
