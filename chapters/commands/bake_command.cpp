// `crevice bake`
#include <iostream>
#include <limits>
#include <memory>

#include "chapters/commands/bake.h"
#include "chapters/commands/commands.h"
#include "chapters/commands/ray_flags.h"
#include "chapters/commands/run_flags.h"
#include "chapters/terminal/parse.h"
#include "rasterizer/base/error.h"

namespace crevice {

namespace {

// As they were typed.
struct BakeWords {
    std::string scene, texels = "512", out = "out";
    RayWords rays{.rays = "256", .radius = {}};
    std::optional<std::string> crease;
    RunWords run;
    bool vertex = false, lightmap = false, mesh_texcoords = false, outside_files = false;
};

BakeOptions options_of(const BakeWords& words) {
    if (words.vertex == words.lightmap)
        throw UsageError("bake: neither or both of --vertex --lightmap; give one");
    if (words.mesh_texcoords && words.vertex)
        throw UsageError("--mesh-texcoords: only with --lightmap; leave it away");
    BakeOptions options;
    options.scene = words.scene;
    options.rays = ray_settings_of(words.rays);
    if (!words.rays.radius) options.rays.radius = std::numeric_limits<float>::infinity();
    options.texels = static_cast<int>(parse_whole("--texels", words.texels, 16, 4096));
    options.mesh_texcoords = words.mesh_texcoords;
    options.outside_files = words.outside_files;
    options.crease_angle_rad = crease_angle_of(words.crease);
    options.out = words.out;
    options.run = run_of(words.run);
    return options;
}

}  // namespace

Command add_bake_command(CommandLine& program) {
    const auto words = std::make_shared<BakeWords>();
    CommandLine bake = program.subcommand(
        "bake", "Ray-cast accessibility kept with the mesh: vertex colours or a lightmap, as OBJ and PNG");
    bake.required("SCENE", words->scene, kSceneMeaning);
    bake.flag("--vertex", words->vertex, "one value a vertex, as vertex colours of an OBJ");
    bake.flag("--lightmap", words->lightmap, "one value a texel, with texture coordinates of its own");
    bake.flag("--mesh-texcoords", words->mesh_texcoords,
              "with --lightmap: the mesh's own texture coordinates, if they lie in [0,1] and do not overlap");
    bake.option("--texels", words->texels, "with --lightmap: side of the map, 16..4096");
    add_ray_flags(bake, words->rays, "inf");
    add_run_flags(bake, words->run);
    bake.flag("--outside-files", words->outside_files, kOutsideFilesMeaning);
    add_crease_flag(bake, words->crease);
    bake.option("--out", words->out, "the directory for the files");
    return {bake, [words] {
                const BakeOptions options = options_of(*words);
                words->vertex ? bake_vertex(options, std::cout) : bake_lightmap(options, std::cout);
                return static_cast<int>(ExitCode::done);
            }};
}

}  // namespace crevice
