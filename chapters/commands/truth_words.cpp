#include "chapters/commands/truth_words.h"

#include <iostream>
#include <limits>

#include "chapters/commands/bake.h"
#include "chapters/commands/truth.h"
#include "chapters/terminal/parse.h"
#include "rasterizer/base/error.h"

namespace crevice {

namespace {

template <class T>
T choice(const std::string& flag, const std::string& word,
         const std::vector<std::pair<const char*, T>>& choices) {
    std::string known;
    for (const auto& [name, value] : choices) {
        if (word == name) return value;
        known += std::string(known.empty() ? "" : " or ") + name;
    }
    throw UsageError(flag + ": no such choice (" + word + "); give " + known);
}

float radius_of(const std::string& word) {
    const float radius = word == "inf" ? std::numeric_limits<float>::infinity()
                                       : static_cast<float>(parse_number("--radius", word));
    if (!(radius > 0))
        throw UsageError("--radius: must lie in (0, inf] (" + word +
                         "); choose how far an occluder may be, scene units");
    return radius;
}

RayAoSettings ray_settings(const RayWords& words) {
    RayAoSettings rays;
    rays.rays = static_cast<int>(parse_whole("--rays", words.rays, 1, 1 << 20));
    rays.weight = choice<RayWeight>("--weight", words.weight,
                                    {{"cosine", RayWeight::cosine}, {"uniform", RayWeight::uniform}});
    rays.seed = static_cast<std::uint32_t>(parse_whole("--seed", words.seed, 0, 0xffffffffLL));
    return rays;
}

void add_ray_flags(CLI::App& command, RayWords& words, const char* default_radius) {
    command.add_option("--rays", words.rays, "rays a point, 1..1048576")->capture_default_str();
    command.add_option(
        "--radius", words.radius,
        std::string("how far an occluder may be, scene units or inf; default: ") + default_radius);
    command.add_option("--weight", words.weight, "how directions are spread: cosine or uniform")
        ->capture_default_str();
    command.add_option("--seed", words.seed, "of the rays' directions")->capture_default_str();
}

}  // namespace

void add_truth(CLI::App& app, TruthWords& words) {
    CLI::App* truth = app.add_subcommand(
        "truth", "Cast rays: truth_hard, truth_soft, truth_screen and truth_limit, each with its error");
    truth->add_option("SCENE", words.scene, "a built-in scene (crevice scenes) or the path of an OBJ file")
        ->required();
    truth->add_option("--size", words.size, "size of the picture in pixels, WxH")->capture_default_str();
    add_camera_flags(*truth, words.camera);
    truth->add_option("--ao", words.ao, "the method whose radius and fade are used")->capture_default_str();
    truth->add_option("--param", words.params, "name=value of that method, any number of times")
        ->allow_extra_args(false);
    add_ray_flags(*truth, words.rays, "the method's");
    truth->add_option("--hemisphere", words.hemisphere, "rays about the interpolated or the geometric normal")
        ->capture_default_str();
    truth->add_option("--error", words.error,
                      "double the rays until the mean standard error of a pixel is at most this");
    truth->add_option("--limit-seeds", words.limit_seeds, "seeds of truth_limit; 0: leave it out")
        ->capture_default_str();
    truth->add_option("--cache", words.cache,
                      "where finished references are kept; default: ~/.cache/crevice");
    truth->add_flag("--no-cache", words.no_cache, "make everything anew and keep nothing");
    add_run_flags(*truth, words.run);
    truth->add_option("--out", words.out, "the directory for the files")->capture_default_str();
}

void truth(const TruthWords& words) {
    TruthOptions options;
    options.scene = words.scene;
    options.camera = words.camera;
    options.params = words.params;
    options.out = words.out;
    if (words.rays.radius) options.radius = radius_of(*words.rays.radius);
    ReferenceRequest& request = options.request;
    request.run = run_of(words.run);
    request.size = parse_size("--size", words.size);
    request.method = named_as("--ao", [&] { return &find_method(words.ao); });
    request.rays = ray_settings(words.rays);
    request.rays.hemisphere = choice<Hemisphere>(
        "--hemisphere", words.hemisphere,
        {{"interpolated", Hemisphere::interpolated}, {"geometric", Hemisphere::geometric}});
    if (words.error) {
        request.wanted_error = parse_number("--error", *words.error);
        if (!(request.wanted_error > 0))
            throw UsageError("--error: must be above 0 (" + *words.error + "); choose another value");
    }
    request.limit_seeds = static_cast<int>(parse_whole("--limit-seeds", words.limit_seeds, 0, 1 << 20));
    if (request.limit_seeds > 0 && request.limit_seeds < kReplicates)
        throw UsageError("--limit-seeds: must be 0 or at least " + std::to_string(kReplicates) + " (" +
                         words.limit_seeds + "); choose another number");
    if (words.no_cache && words.cache)
        throw UsageError("--no-cache: not together with --cache; leave one away");
    if (!words.no_cache)
        request.cache = words.cache ? std::optional<std::filesystem::path>(*words.cache) : default_cache();
    truth_command(options);
}

void add_bake(CLI::App& app, BakeWords& words) {
    CLI::App* bake = app.add_subcommand(
        "bake", "Ray-cast accessibility kept with the mesh: vertex colours or a lightmap, as OBJ and PNG");
    bake->add_option("SCENE", words.scene, "a built-in scene (crevice scenes) or the path of an OBJ file")
        ->required();
    bake->add_flag("--vertex", words.vertex, "one value a vertex, as vertex colours of an OBJ");
    bake->add_flag("--lightmap", words.lightmap, "one value a texel, with texture coordinates of its own");
    bake->add_flag(
        "--mesh-texcoords", words.mesh_texcoords,
        "with --lightmap: the mesh's own texture coordinates, if they lie in [0,1] and do not overlap");
    bake->add_option("--texels", words.texels, "with --lightmap: side of the map, 16..4096")
        ->capture_default_str();
    add_ray_flags(*bake, words.rays, "inf");
    add_run_flags(*bake, words.run);
    bake->add_option("--out", words.out, "the directory for the files")->capture_default_str();
}

void bake(const BakeWords& words) {
    if (words.vertex == words.lightmap)
        throw UsageError("bake: neither or both of --vertex --lightmap; give one");
    BakeOptions options;
    options.scene = words.scene;
    options.rays = ray_settings(words.rays);
    options.rays.radius =
        words.rays.radius ? radius_of(*words.rays.radius) : std::numeric_limits<float>::infinity();
    options.texels = static_cast<int>(parse_whole("--texels", words.texels, 16, 4096));
    if (words.mesh_texcoords && words.vertex)
        throw UsageError("--mesh-texcoords: only with --lightmap; leave it away");
    options.mesh_texcoords = words.mesh_texcoords;
    options.out = words.out;
    options.run = run_of(words.run);
    words.vertex ? bake_vertex(options, std::cout) : bake_lightmap(options, std::cout);
}

}  // namespace crevice
