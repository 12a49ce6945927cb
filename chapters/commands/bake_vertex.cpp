// The vertex bake of `crevice bake`.
#include <iomanip>
#include <iostream>
#include <sstream>

#include "chapters/commands/bake.h"
#include "chapters/frame/scene_argument.h"
#include "chapters/terminal/number_text.h"
#include "chapters/terminal/output_directory.h"
#include "chapters/terminal/progress.h"
#include "chapters/terminal/stopwatch.h"
#include "rasterizer/base/error.h"
#include "rasterizer/obj/obj_write.h"
#include "rasterizer/scene/world_mesh.h"
#include "ssao/bakes/vertex_ao.h"

namespace crevice {

namespace {

std::string comment_of(const Scene& scene, const RayAoSettings& settings) {
    std::ostringstream text;
    text << "Accessibility of " << scene.name << " as grey vertex colours, linear, 1 open. "
         << counted(settings.rays, "ray") << " a vertex, radius " << settings.radius << " scene units, "
         << (settings.weight == RayWeight::cosine ? "cosine" : "uniform") << " weight, seed " << settings.seed
         << ".";
    return text.str();
}

// What the numbers of the bake cannot show.
void warn(const RayScene& rays, const VertexAo& ao, const BakeOptions& options) {
    print_warning(options, "not-finite", rays.not_finite,
                  "triangle has a corner that is no finite number or beyond 2^36 units and blocks no ray; "
                  "mend the file",
                  "triangles have a corner that is no finite number or beyond 2^36 units and block no ray; "
                  "mend the file");
    print_warning(options, "no-area", rays.degenerate, "triangle has no area and blocks no ray",
                  "triangles have no area and block no ray");
    print_warning(options, "unused", ao.unused, "vertex belongs to no triangle that blocks rays and is open",
                  "vertices belong to no triangle that blocks rays and are open");
    print_warning(options, "offset-exceeds-radius/100", ao.lifted_far,
                  "ray's origin is more than radius / 100 above its surface; take a larger --radius",
                  "rays' origins are more than radius / 100 above their surface; take a larger --radius");
}

}  // namespace

void bake_vertex(const BakeOptions& options, std::ostream& out) {
    validate(options.rays);
    validate(options.run);
    const Scene scene = load_scene(options.scene, {.surfaces = false,
                                                   .outside_files = options.outside_files,
                                                   .crease_angle_rad = options.crease_angle_rad,
                                                   .run = options.run})
                            .scene;
    try_output_directory(options.out);
    const double start_ms = clocks().wall_ms;
    const RayScene rays = centred_ray_scene(scene, options.scene, options.run);
    const double built_ms = clocks().wall_ms;
    VertexAo ao;
    {
        Progress progress("vertices", static_cast<long long>(rays.triangles.size()));
        ao = vertex_ao_from_corners(scene, rays, options.rays, options.run,
                                    [&](long long triangles) { progress.advance(triangles); });
    }
    const double trace_ms = clocks().wall_ms - built_ms;

    const Mesh mesh = world_mesh(scene);
    std::vector<glm::vec3> colours;
    colours.reserve(mesh.positions.size());
    for (const float value : joined(ao)) colours.emplace_back(value);
    const std::filesystem::path path = options.out / (scene.name + "_vertex_ao.obj");
    write_obj(path, mesh, colours, comment_of(scene, options.rays), scene.origin);

    warn(rays, ao, options);
    out << std::fixed << std::setprecision(1)
        << counted(static_cast<long long>(rays.triangles.size()), "triangle") << ", "
        << counted(static_cast<long long>(mesh.positions.size()), "vertex", "vertices") << "\n"
        << ao.rays_cast << " rays, " << static_cast<double>(ao.rays_cast) / trace_ms / 1e3
        << " million/s; BVH " << built_ms - start_ms << " ms, rays " << trace_ms << " ms\n"
        << path.string() << std::endl;
}

}  // namespace crevice
