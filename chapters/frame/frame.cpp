#include "chapters/frame/worked_frame.h"

#include <utility>

#include "chapters/frame/second_drawing.h"
#include "ssao/light/ao_lookup.h"
#include "ssao/light/scene_shadow.h"
#include "ssao/light/sky.h"

namespace crevice {

namespace {

AoWork ao_work(const Method& method, const FrameSettings& settings) {
    AoWork work{method.computes_ao(), method.reads_normals || settings.ao_lookup == AoLookup::joint};
    work.lit_reads_bent_normals =
        method.bent_normals && settings.ambient.specular_occlusion == SpecularOcclusion::cones;
    if (!method.denoiser.denoised) work.why_no_blur = "the method has no denoiser";
    if (value_of(method, settings.method, "blur_iterations") == 0) work.why_no_blur = "blur_iterations is 0";
    return work;
}

FrameInputs frame_inputs(const Scene& scene, const Camera& camera, const FrameRequest& request) {
    const FrameSettings& settings = request.settings;
    const Method& method = *request.method;
    const Run& run = request.run;
    const Needs needs = needs_of(scene, request.wanted, ao_work(method, settings),
                                 !run.leaves_out(Skip::passes), settings.buffers.mapped_normals);
    FrameInputs inputs;
    inputs.view = {camera, request.size, settings.buffers, needs.normals, run.tile_size, run.kept};
    inputs.view.camera.reversed_z = settings.reversed_z;
    inputs.view.buffers.with_material = needs.lit && needs.materials;
    inputs.map = {&method, {}, settings.history.longest > 1};
    for (const auto& p : method.parameters) inputs.map.settings.push_back(p.get(settings.method.ao));
    for (const auto& p : method.denoiser.parameters)
        inputs.denoiser.push_back(p.get(settings.method.denoiser));
    inputs.lookup = settings.ao_lookup;
    inputs.light = {scene.lights,   scene.point_light, scene.ambient_light, scene.sky,
                    scene.lighting, settings.lit,      settings.ambient,    settings.light_space};
    inputs.sky_cube = scene.sky_cube;
    inputs.shadow = scene.shadow;
    inputs.needs = needs;
    return inputs;
}

// The passes of one frame, each timed, over what it works on. A pass that was kept, or that nobody needs, does not run.
struct Passes {
    const Scene& scene;
    const FrameRequest& request;
    const AoHistory& last;
    const FrameInputs& inputs;
    const KeptPasses& kept;
    WorkedFrame& worked;
    Stopwatch stopwatch = {};

    // Of the scene at rest, once for all repeats: what rays are cast through, and what is baked with them.
    void prepare();
    void draw();
    void occlude();
    // `sky_before` is the lit picture of the frame before, whose sky is kept.
    void light(const Image3& sky_before);

    template <class Body>
    void pass(bool runs, const char* name, const Body& body) {
        if (runs) stopwatch.time(name, body);
    }

    const FrameSettings& settings = request.settings;
    const Method& method = *request.method;
    const Needs& needs = inputs.needs;
    const Run& run = request.run;
    Frame& frame = worked.frame;
    RawAo& raw = worked.raw;
};

void Passes::prepare() {
    std::shared_ptr<const RayScene>& rays = worked.rays;
    const bool casts_rays = needs.ao && method.casts_rays;
    const bool has_rays = rays && rays->origin == frame.camera.eye;
    if (casts_rays && has_rays) worked.unchanged.emplace_back("ray_scene");
    pass(casts_rays && !has_rays, "ray_scene",
         [&] { rays = std::make_shared<const RayScene>(ray_scene(scene, frame.camera.eye, run)); });
    pass(needs.ao && method.bake && !kept.bake, "bake",
         [&] { worked.baked = method.bake(scene, *rays, settings.method.ao, run); });
}

void Passes::draw() {
    pass(!kept.normal_depth, "normal_depth", [&] {
        GeometrySettings geometry_with = geometry_settings(settings.buffers);
        geometry_with.with_normals = needs.normals;
        worked.geometry = screen_geometry(scene, frame.camera, request.size, geometry_with, run);
        frame.gbuffer =
            normal_depth(scene, worked.geometry, frame.camera.reversed_z, inputs.view.buffers, run);
    });
}

void Passes::occlude() {
    pass(needs.ao && !kept.ao, "ao", [&] {
        raw = method.ao({scene, frame.camera, frame.gbuffer, worked.rays.get(), worked.baked.get()},
                        settings.method.ao, run);
    });
    pass(needs.ao && inputs.map.has_history, "history", [&] {
        frame.history = temporal_accumulation(raw.ao, raw.inputs, frame.camera, last, settings.history, run);
        raw.ao = frame.history.ao;
    });
    pass(needs.blur && !kept.blur, "blur", [&] {
        AoMap blurred = denoised(method, raw, settings.method, run);
        frame.ao_blurred = std::move(blurred.ao);
        frame.tiles.blur = std::move(blurred.tiles);
    });
    pass(needs.bent_normals && !kept.bent_normals, kBentNormal,
         [&] { frame.bent_normal = bent_normals(method, raw.inputs, settings.method, run); });
    pass(looks_up(inputs) && !kept.ao_lookup, "ao_lookup", [&] {
        worked.at_pixels = looked_up(needs.blur ? frame.ao_blurred : raw.ao, raw.inputs, frame.gbuffer,
                                     settings.ao_lookup, run);
    });
}

void Passes::light(const Image3& sky_before) {
    pass(needs.shadow && !kept.shadow, "shadow",
         [&] { worked.shadow = std::make_shared<const ShadowMap>(scene_shadow(scene, run)); });
    pass(needs.lit && !kept.lit, "lit", [&] {
        LitImage lit = lit_image(scene, worked.geometry, frame, lit_map(worked), raw.inputs.normal,
                                 worked.shadow.get(), request);
        frame.lit = std::move(lit.image);
        frame.tiles.lit = std::move(lit.tiles);
    });
    const bool lit_anew = needs.sky && !kept.lit;
    if (lit_anew && kept.sky)
        frame.lit = with_sky(std::move(frame.lit), frame.gbuffer.depth, frame.camera, sky_before, run);
    pass(lit_anew && !kept.sky, "sky", [&] {
        frame.lit = with_sky(std::move(frame.lit), frame.gbuffer.depth, frame.camera, *scene.sky_cube, run);
    });
}

void account_for_precision(WorkedFrame& worked, const Scene& scene, const FrameRequest& request) {
    const Method& method = *request.method;
    const AoInputs& inputs = worked.raw.inputs;
    if (!inputs.view_depth.empty())
        worked.far_vertices =
            far_vertices(scene, method, request.settings.method, worked.far_vertices, request.run);
    Frame& frame = worked.frame;
    const bool casts_rays = worked.inputs->needs.ao && method.casts_rays;
    const DrawnForAccount drawn{scene,
                                frame.camera,
                                worked.geometry,
                                frame.gbuffer,
                                inputs,
                                casts_rays ? worked.rays.get() : nullptr,
                                worked.far_vertices.count};
    frame.precision = precision_account(drawn, method, request.settings, request.run);
}

}  // namespace

Frame render_frame(const Scene& scene, const Camera& camera, const FrameRequest& request,
                   const AoHistory& last) {
    WorkedFrame worked = worked_frame(scene, camera, request, last);
    show(worked, request);
    return std::move(worked.frame);
}

WorkedFrame worked_frame(const Scene& scene, const Camera& camera, const FrameRequest& request,
                         const AoHistory& last, WorkedFrame before) {
    const FrameInputs inputs = frame_inputs(scene, camera, request);
    if (!request.run.leaves_out(Skip::passes)) before = {};
    const KeptPasses kept = before.inputs ? kept_passes(*before.inputs, inputs) : KeptPasses();
    const Image3 sky_before = kept.sky ? std::move(before.frame.lit) : Image3();
    WorkedFrame worked = taken_over(std::move(before), kept);
    Frame& frame = worked.frame;
    worked.inputs = inputs;
    worked.unchanged = names_of(kept, inputs.needs);
    frame.camera = inputs.view.camera;
    frame.left_out = inputs.needs.left_out;

    Passes passes{scene, request, last, inputs, kept, worked};
    passes.prepare();
    for (int repeat = 0; repeat < request.repeats; ++repeat) {
        passes.stopwatch.time("frame", [&] {
            passes.draw();
            passes.occlude();
            passes.light(sky_before);
        });
    }
    frame.passes = passes.stopwatch.summaries();

    if (!kept.precision) account_for_precision(worked, scene, request);
    frame.tiles.ao = worked.raw.tiles;
    frame.tiles.raster = raster_tiles(worked.geometry, request.run);
    frame.skipped = skipped_work(worked.geometry, frame.gbuffer, frame.tiles, kept);
    return worked;
}

}  // namespace crevice
