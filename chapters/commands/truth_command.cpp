// `crevice truth`
#include <memory>

#include "chapters/commands/commands.h"
#include "chapters/commands/ray_flags.h"
#include "chapters/commands/run_flags.h"
#include "chapters/commands/truth.h"
#include "chapters/terminal/parse.h"
#include "rasterizer/base/error.h"

namespace crevice {

namespace {

// As they were typed.
struct TruthWords {
    std::string scene, size = "1280x720", ao = "xjun", hemisphere = "interpolated", limit_seeds = "256",
                       out = "out";
    std::vector<std::string> params;
    std::optional<std::string> error, cache;
    RayWords rays{.rays = "1024", .radius = {}};
    CameraFlags camera;
    std::optional<std::string> crease;
    RunWords run;
    bool no_cache = false, outside_files = false;
};

TruthOptions options_of(const TruthWords& words) {
    TruthOptions options;
    options.scene = words.scene;
    options.camera = words.camera;
    options.params = words.params;
    options.outside_files = words.outside_files;
    options.crease_angle_rad = crease_angle_of(words.crease);
    options.out = words.out;
    ReferenceRequest& request = options.request;
    request.run = run_of(words.run);
    request.size = parse_size("--size", words.size);
    request.method = named_as({{"method", "--ao"}}, [&] { return &find_method(words.ao); });
    request.rays = ray_settings_of(words.rays);
    if (words.rays.radius) options.radius = request.rays.radius;
    request.rays.hemisphere = parse_choice<Hemisphere>(
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
    return options;
}

}  // namespace

Command add_truth_command(CommandLine& program) {
    const auto words = std::make_shared<TruthWords>();
    CommandLine truth = program.subcommand(
        "truth", "Cast rays: truth_hard, truth_soft, truth_screen and truth_limit, each with its error");
    truth.required("SCENE", words->scene, kSceneMeaning);
    truth.option("--size", words->size, "size of the picture in pixels, WxH");
    add_camera_flags(truth, words->camera);
    truth.option("--ao", words->ao, "the method whose radius and fade are used");
    truth.option("--param", words->params, "name=value of that method, any number of times");
    add_ray_flags(truth, words->rays, "the method's");
    truth.option("--hemisphere", words->hemisphere, "rays about the interpolated or the geometric normal");
    truth.option("--error", words->error,
                 "double the rays until the mean standard error of a pixel is at most this");
    truth.option("--limit-seeds", words->limit_seeds, "seeds of truth_limit; 0: leave it out");
    truth.option("--cache", words->cache, "where finished references are kept; default: ~/.cache/crevice");
    truth.flag("--no-cache", words->no_cache, "make everything anew and keep nothing");
    add_run_flags(truth, words->run);
    truth.flag("--outside-files", words->outside_files, kOutsideFilesMeaning);
    add_crease_flag(truth, words->crease);
    truth.option("--out", words->out, "the directory for the files");
    return {truth, [words] {
                write_truth(options_of(*words));
                return static_cast<int>(ExitCode::done);
            }};
}

}  // namespace crevice
