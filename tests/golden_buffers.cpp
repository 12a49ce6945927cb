#include "tests/golden_buffers.h"

#include "chapters/frame.h"
#include "chapters/references.h"
#include "scenes/builtin_scenes.h"

namespace crevice {

namespace {

constexpr Size kGoldenSize = {160, 90};

std::vector<GoldenBuffer> rendered_scenes() {
    std::vector<GoldenBuffer> buffers;
    for (const BuiltinScene& builtin : builtin_scenes()) {
        const Scene scene = builtin.make();
        const std::string method = builtin.name == std::string("columns_luna") ? "luna" : "xjun";
        FrameRequest request;
        request.size = kGoldenSize;
        request.method = &find_method(method);
        request.settings = request.method->defaults;
        const Frame frame = render_frame(scene, scene.camera, request);
        const auto add = [&](const char* buffer, Planes values) {
            buffers.push_back({builtin.name, buffer,
                               "render " + scene.name + " --size 160x90 --ao " + method + " --only " + buffer,
                               std::move(values)});
        };
        add("normal", planes_of(frame.gbuffer.normal));
        add("view_depth", planes_of(frame.gbuffer.view_depth));
        add("ndc_depth", planes_of(ndc_depth(frame.gbuffer.depth)));
        add("ao_raw", planes_of(frame.ao_raw));
        add("ao_blurred", planes_of(frame.ao_blurred));
        add("lit", planes_of(frame.lit));
    }
    return buffers;
}

// The references, smaller: what they are made of is seen in few pixels.
std::vector<GoldenBuffer> referenced_scenes() {
    std::vector<GoldenBuffer> buffers;
    for (const BuiltinScene& builtin : builtin_scenes()) {
        const Scene scene = builtin.make();
        ReferenceRequest request;
        request.size = {80, 45};
        request.method = &find_method("xjun");
        request.ao = settings_of(*request.method, {}, scene.length_unit).ao;
        request.rays.rays = 64;
        request.rays.radius = request.ao.radius;
        request.limit_seeds = 16;
        const References r = make_references(scene, scene.camera, request);
        const auto add = [&](const char* buffer, const Reference& reference) {
            buffers.push_back({builtin.name, buffer,
                               "truth " + scene.name + " --size 80x45 --rays 64 --limit-seeds 16 --no-cache",
                               planes_of(reference.image.mean)});
        };
        add("truth_hard", r.hard);
        add("truth_soft", r.soft);
        add("truth_screen", r.screen);
        add("truth_limit", r.limit);
    }
    return buffers;
}

}  // namespace

std::vector<GoldenBuffer> golden_buffers() {
    std::vector<GoldenBuffer> buffers = rendered_scenes();
    for (GoldenBuffer& buffer : referenced_scenes()) buffers.push_back(std::move(buffer));
    return buffers;
}

}  // namespace crevice
