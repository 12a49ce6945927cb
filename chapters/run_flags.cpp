#include "chapters/run_flags.h"

#include "chapters/parse.h"
#include "rasterizer/error.h"

namespace crevice {

namespace {

Isa isa_of(const std::string& word) {
    for (const Isa isa : {Isa::baseline, Isa::avx2, Isa::avx512}) {
        if (word == isa_name(isa)) return isa;
    }
    throw UsageError("--isa: no such instruction set (" + word + "); give baseline, avx2 or avx512");
}

}  // namespace

void add_run_flags(CLI::App& command, RunWords& words) {
    command.add_option("--threads", words.threads, "0: all; 1: a plain loop")->capture_default_str();
    command.add_option("--lanes", words.lanes, "pixels at a time, 1 or 8")->capture_default_str();
    command.add_option("--isa", words.isa, "baseline, avx2 or avx512; default: the best this CPU has");
    command.add_option("--tile", words.tile, "tile size in pixels, 8 16 32 64 or 128")->capture_default_str();
}

Run run_of(const RunWords& words) {
    Run run;
    run.threads = static_cast<int>(parse_whole("--threads", words.threads, 0, 1024));
    run.lanes = static_cast<int>(parse_whole("--lanes", words.lanes, 1, 8));
    run.tile_size = static_cast<int>(parse_whole("--tile", words.tile, kSmallestTile_px, kLargestTile_px));
    if (words.keep_all) run.kept = KeptWork::all();
    if (!words.isa.empty()) run.isa = isa_of(words.isa);
    validate(run);
    return run;
}

void add_camera_flags(CLI::App& command, CameraFlags& camera) {
    command.add_option("--eye", camera.eye, "where the camera stands, x,y,z in the scene's own coordinates");
    command.add_option("--target", camera.target, "what it looks at, x,y,z");
    command.add_option("--fov-y", camera.fov_y, "vertical field of view, degrees");
    command.add_option("--near", camera.near_plane, "near plane, scene units");
    command.add_option("--far", camera.far_plane, "far plane, scene units");
    command.add_option("--ortho", camera.ortho, "orthographic camera; height of the picture, scene units");
}

}  // namespace crevice
