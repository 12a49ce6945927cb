#include "chapters/commands/run_flags.h"

#include "chapters/terminal/parse.h"
#include "rasterizer/base/error.h"

namespace crevice {

namespace {

Isa isa_named(const std::string& word) {
    std::vector<std::pair<const char*, Isa>> choices;
    for (const Isa isa : kEveryIsa) choices.emplace_back(isa_name(isa), isa);
    return parse_choice("--isa", word, choices);
}

// The run with so many lanes: of the instruction set that was named, else of one that has as many.
Run with_lanes(Run run, int lanes, bool isa_was_named) {
    std::string offered = "1";
    for (const Isa isa : kEveryIsa) {
        if (!isa_available(isa) || (isa_was_named && isa != run.isa)) continue;
        offered += " or " + std::to_string(lanes_of(isa));
        if (lanes == lanes_of(isa)) run.isa = isa;
    }
    run.lanes = lanes;
    if (lanes != 1 && lanes != lanes_of(run.isa))
        throw UsageError("--lanes: " + std::string(isa_was_named ? isa_name(run.isa) : "this machine") +
                         " has no form with so many (" + std::to_string(lanes) + "); give " + offered);
    return run;
}

}  // namespace

void add_crease_flag(CommandLine& command, std::optional<std::string>& word) {
    command.option("--crease", word,
                   "of an OBJ without normals: edges between faces that turn by more degrees than this stay "
                   "sharp, 0..180; 0: every face flat; default: 180, smooth within its smoothing groups");
}

void add_run_flags(CommandLine& command, RunWords& words) {
    command.option("--threads", words.threads, "0: all; 1: a plain loop");
    command.option("--lanes", words.lanes, "pixels at a time: 1, or as many as --isa has; default: those");
    command.option("--isa", words.isa, "baseline, avx2 or avx512; default: the best this machine has");
    command.option("--tile", words.tile, "tile size in pixels, 16 32 64 or 128");
}

Run run_of(const RunWords& words) {
    Run run;
    run.threads = static_cast<int>(parse_whole("--threads", words.threads, 0, 1024));
    run.tile_size = static_cast<int>(parse_whole("--tile", words.tile, kSmallestTile_px, kLargestTile_px));
    if (words.keep_all) run.kept = KeptWork::all();
    if (!words.isa.empty()) run.isa = isa_named(words.isa);
    if (!words.lanes.empty()) {
        run = with_lanes(run, static_cast<int>(parse_whole("--lanes", words.lanes, 1, kMostLanes)),
                         !words.isa.empty());
    }
    named_as({{"instruction set", "--isa"}, {"tile size", "--tile"}}, [&] { validate(run); });
    return run;
}

void add_camera_flags(CommandLine& command, CameraFlags& camera) {
    command.option("--eye", camera.eye, "where the camera stands, x,y,z in the scene's own coordinates");
    command.option("--target", camera.target, "what it looks at, x,y,z");
    command.option("--fov-y", camera.fov_y, "vertical field of view, degrees");
    command.option("--near", camera.near_plane,
                   "near plane, scene units; of an OBJ near and far follow the eye");
    command.option("--far", camera.far_plane, "far plane, scene units");
    command.option("--ortho", camera.ortho, "orthographic camera; height of the picture, scene units");
}

}  // namespace crevice
