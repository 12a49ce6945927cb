// `crevice tune`
#include <iostream>
#include <memory>

#include "chapters/commands/commands.h"
#include "chapters/commands/run_flags.h"
#include "chapters/terminal/parse.h"
#include "chapters/tune/tune.h"
#include "rasterizer/base/error.h"

namespace crevice {

namespace {

// As they were typed.
struct TuneWords {
    std::vector<std::string> scenes;
    std::string method, against = "hard", size = "1280x720", seeds = "6";
    std::optional<std::string> ms, error, out, crease;
    RunWords run;
};

// Above 0.
std::optional<double> limit(const char* flag, const std::optional<std::string>& word) {
    if (!word) return std::nullopt;
    const double value = parse_number(flag, *word);
    if (value > 0) return value;
    throw UsageError(std::string(flag) + ": out of range (" + *word + "); give a number above 0");
}

TuneGoal goal_of(const TuneWords& words) {
    const TuneGoal goal{limit("--ms", words.ms), limit("--error", words.error)};
    if (goal.ms && goal.error)
        throw UsageError("crevice tune: both --ms and --error (" + *words.ms + ", " + *words.error +
                         "); give one of them, the other is what is searched for");
    if (!goal.ms && !goal.error)
        throw UsageError(
            "crevice tune: neither --ms nor --error; give one, such as crevice tune columns --method gtao "
            "--ms 8");
    return goal;
}

TuneOptions options_of(const TuneWords& words) {
    if (words.scenes.empty())
        throw UsageError(
            "crevice tune: no SCENE; give one or more, such as crevice tune columns --method gtao --ms 8");
    if (words.method.empty())
        throw UsageError("crevice tune: no --method; give one of those that crevice methods lists");
    TuneOptions options;
    options.goal = goal_of(words);
    options.seeds = static_cast<int>(parse_whole("--seeds", words.seeds, 1, 64));
    if (words.out) options.out = *words.out;
    TuneViewsRequest& views = options.views;
    views.scenes = words.scenes;
    views.method = named_as({{"method", "--method"}}, [&] { return &find_method(words.method); });
    views.size = parse_size("--size", words.size);
    views.truth = parse_choice<TuneTruth>("--against", words.against,
                                          {{"soft", TuneTruth::soft}, {"hard", TuneTruth::hard}});
    views.cache = default_cache();
    views.crease_angle_rad = crease_angle_of(words.crease);
    views.run = run_of(words.run);
    return options;
}

}  // namespace

Command add_tune_command(CommandLine& program) {
    const auto words = std::make_shared<TuneWords>();
    CommandLine tune = program.subcommand(
        "tune",
        "Search a method's parameters: the least error within a time, or the least time within an error");
    tune.option("SCENE", words->scenes,
                "scenes or OBJ files to search on; the last of several is held out, of one a second view");
    tune.option("--method", words->method, "an ambient-occlusion method (crevice methods)");
    tune.option("--ms", words->ms, "the time that AO and its blur may take, ms a frame");
    tune.option("--error", words->error, "or the RMSE that they may have against rays");
    tune.option("--against", words->against,
                "hard: what lies within the radius occludes; soft: by the method's own fade");
    tune.option("--size", words->size, "size of the picture in pixels, WxH");
    tune.option("--seeds", words->seeds,
                "images of each setting and view, 1..64; below 5 no gain is told from noise");
    add_crease_flag(tune, words->crease);
    add_run_flags(tune, words->run);
    tune.option("--out", words->out, "the directory for tune.json (schemas/tune.schema.json) and tune.csv");
    return {tune, [words] { return crevice::tune(options_of(*words), std::cout); }};
}

}  // namespace crevice
