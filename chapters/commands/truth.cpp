#include "chapters/commands/truth.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iostream>

#include <nlohmann/json.hpp>

#include "chapters/frame/buffer_writer.h"
#include "chapters/frame/frame_settings.h"
#include "chapters/study/tutorial_units.h"
#include "chapters/terminal/json_text.h"
#include "chapters/terminal/number_text.h"
#include "chapters/terminal/output_directory.h"
#include "chapters/terminal/program_version.h"
#include "rasterizer/base/error.h"
#include "rasterizer/base/float_text.h"
#include "rasterizer/base/write_file.h"

namespace crevice {

namespace {

using Json = nlohmann::ordered_json;

struct NamedReference {
    const char* name;
    const char* meaning;
    const Reference& reference;
};

std::vector<NamedReference> named(const References& references) {
    return {
        {"truth_hard", "rays through the scene, cut at the radius", references.hard},
        {"truth_soft", "rays through the scene, weighted by the method's fade", references.soft},
        {"truth_screen", "rays against the depth buffer, weighted by the method's fade", references.screen},
        {"truth_limit", "the method with ever more samples, full resolution, no blur", references.limit},
    };
}

Json reference_json(const NamedReference& r, bool of_rays) {
    return {{"name", r.name},
            {"meaning", r.meaning},
            {of_rays ? "rays" : "seeds", r.reference.rays},
            {"mean", r.reference.mean},
            {"mean_error", r.reference.mean_error},
            {"max_error", r.reference.max_error},
            {"from_cache", r.reference.from_cache}};
}

Json passes_json(const References& references) {
    const auto pass = [](const char* name, double ms) {
        return Json{{"name", name}, {"wall_ms", ms}, {"runs", 1}};
    };
    return {pass("points", references.points_ms), pass("build", references.build_ms),
            pass("truth", references.soft.wall_ms), pass("screen", references.screen.wall_ms),
            pass("limit", references.limit.wall_ms)};
}

std::vector<std::string> warnings_of(const References& references, float radius) {
    std::vector<std::string> warnings;
    if (references.lifted_far > 0) {
        warnings.push_back("offset-exceeds-radius/100: " + std::to_string(references.lifted_far) + " of " +
                           std::to_string(references.points.points.size()) +
                           " points start more than radius / 100 above their surface (radius " +
                           shortest_text(radius) + "); bring the camera nearer or take a larger --radius");
    }
    if (references.dropped_triangles > 0) {
        warnings.push_back(
            "not-finite: " +
            counted(static_cast<long long>(references.dropped_triangles),
                    "triangle has a corner that is no finite number, or is too far from all "
                    "others for rays, and is left out; ",
                    "triangles have a corner that is no finite number, or are too far from all "
                    "others for rays, and are left out; ") +
            "mend the file");
    }
    return warnings;
}

const char* const kWeights[] = {"cosine", "uniform"};
const char* const kHemispheres[] = {"interpolated", "geometric"};

Json report(const TruthOptions& options, const ReferenceRequest& request, const References& references,
            const std::vector<std::string>& warnings, const Json& buffers) {
    Json described = Json::array();
    for (const NamedReference& r : named(references)) {
        const bool limit = &r.reference == &references.limit;
        if (!r.reference.image.mean.empty()) described.push_back(reference_json(r, !limit));
    }
    const RayAoSettings& rays = request.rays;
    const AoQuestion question = request.method->question(request.settings.ao);
    const ProgramVersion version = program_version();
    return {{"program", {{"version", version.number}, {"commit", version.commit}}},
            {"scene", options.scene},
            {"size", {request.size.width, request.size.height}},
            {"method", request.method->name},
            {"radius", std::isinf(rays.radius) ? Json("inf") : Json(rays.radius)},
            {"fade", {question.fade_start, question.fade_end}},
            {"weight", kWeights[static_cast<int>(rays.weight)]},
            {"hemisphere", kHemispheres[static_cast<int>(rays.hemisphere)]},
            {"seed", rays.seed},
            {"threads", thread_count(request.run)},
            {"lanes", lane_count(request.run)},
            {"isa", isa_name(isa_of(request.run))},
            {"points", references.points.points.size()},
            {"references", described},
            {"passes", passes_json(references)},
            {"warnings", warnings},
            {"buffers", buffers}};
}

// Errors are small: white is the largest there is.
Picture error_picture(const Image<float>& error) {
    return grey_picture(error, 0, std::max(buffer_statistics(error).max, 1e-6f));
}

void print_reference(const NamedReference& r, std::size_t points) {
    const Reference& reference = r.reference;
    std::printf("%-12s mean %.5f; standard error of a pixel: mean %.3g, at most %.3g; ", r.name,
                reference.mean, reference.mean_error, reference.max_error);
    if (reference.from_cache) {
        std::printf("found in the cache\n");
        return;
    }
    const double rays = static_cast<double>(points) * static_cast<double>(reference.rays);
    std::printf("%lld a pixel in %.0f ms, %.1f million/s\n", reference.rays, reference.wall_ms,
                rays / std::max(reference.wall_ms, 1e-3) / 1e3);
}

}  // namespace

void write_truth(const TruthOptions& options) {
    ReferenceRequest request = options.request;
    validate(request.run);
    if (!request.method->computes_ao())
        throw UsageError(std::string("--ao: this method has no fade to compare with (") +
                         request.method->name + "); give one that computes ambient occlusion");
    // Before the scene is loaded, for a quick answer to a wrong word.
    request.settings = settings_of(*request.method, options.params).method;
    request.rays.radius = options.radius.value_or(1);
    validate(request.rays);
    const SceneArgument argument = load_scene(options.scene, {.surfaces = false,
                                                              .outside_files = options.outside_files,
                                                              .crease_angle_rad = options.crease_angle_rad,
                                                              .run = request.run});
    if (triangle_count(argument.scene) == 0)
        std::cerr << options.scene << ": 0 triangles; everything is open\n";
    const Camera camera = chosen_camera(argument, options.camera);
    request.settings = settings_for(argument, options.scene, *request.method, options.params).method;
    request.rays.radius = options.radius.value_or(request.method->question(request.settings.ao).radius);
    validate(request.rays);
    try_output_directory(options.out);

    const ViewInUnits view = in_tutorial_units(argument.scene, camera, request);
    const References references = make_references(view.scene, view.camera, view.request);
    const std::vector<std::string> warnings = warnings_of(references, request.rays.radius);
    for (const std::string& warning : warnings) std::cerr << options.scene << ": " << warning << "\n";
    BufferWriter writer(options.out, BufferFiles::npy, std::cout);
    for (const NamedReference& r : named(references)) {
        const ReferenceImage& image = r.reference.image;
        if (image.mean.empty()) continue;
        writer.add(r.name, image.mean, [&image] { return ao_picture(image.mean); });
        writer.add(std::string(r.name) + "_error", image.error,
                   [&image] { return error_picture(image.error); });
    }
    writer.finish(request.run);
    std::cout.flush();
    for (const NamedReference& r : named(references)) {
        if (!r.reference.image.mean.empty()) print_reference(r, references.points.points.size());
    }
    const std::filesystem::path path = options.out / "passes.json";
    write_file_atomically(path,
                          json_text(report(options, request, references, warnings, writer.described())));
    std::printf("%s\n", path.string().c_str());
}

}  // namespace crevice
