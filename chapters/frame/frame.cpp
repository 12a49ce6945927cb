#include "chapters/frame/worked_frame.h"

#include <utility>

#include "ssao/light/ao_lookup.h"
#include "ssao/light/deferred_point_light.h"
#include "ssao/light/scene_shadow.h"
#include "ssao/light/shade.h"
#include "ssao/light/sky.h"

namespace crevice {

namespace {

// How the second drawing meets the first, in the terms of its depth direction: nearer is nearer.
ShadeSettings lit_settings(const FrameSettings& settings) {
    ShadeSettings lit = settings.lit;
    lit.normal_matrix = settings.buffers.normal_matrix;
    if (!settings.reversed_z) return lit;
    if (lit.depth_function == DepthFunction::less_equal) lit.depth_function = DepthFunction::greater_equal;
    lit.depth_bias.constant = -lit.depth_bias.constant;
    return lit;
}

// With EQUAL and the first pass's positions and holes its geometry serves again; else the scene is drawn anew.
bool shares_geometry(const FrameSettings& settings) {
    ShadeSettings as_first;
    as_first.position_order = settings.buffers.position_order;
    as_first.normal_matrix = settings.buffers.normal_matrix;
    return settings.buffers.cutouts && lit_settings(settings) == as_first;
}

AmbientUse ambient_use(const FrameSettings& settings, const Frame& frame, const Image3& texel_normals) {
    AmbientUse ambient{settings.ambient};
    if (!frame.bent_normal.empty()) {
        ambient.bent_normals = &frame.bent_normal;
        ambient.texel_normals = &texel_normals;
    }
    return ambient;
}

LitImage lit_image(const Scene& scene, const ScreenGeometry& geometry, const Frame& frame,
                   const Image<float>& ao, const Image3& texel_normals, const ShadowMap* shadow,
                   const FrameRequest& request) {
    const FrameSettings& settings = request.settings;
    if (scene.point_light)
        return {deferred_point_light(scene, frame.camera, frame.gbuffer, ao, settings.light_space,
                                     request.run, settings.ambient.multi_bounce),
                TileMap(geometry.size, geometry.tile_size)};
    const AmbientUse ambient = ambient_use(settings, frame, texel_normals);
    if (shares_geometry(settings))
        return shade(scene, frame.camera, geometry, frame.gbuffer, ao, request.run, shadow, ambient);
    return {shade(scene, frame.camera, frame.gbuffer.depth, ao, lit_settings(settings), request.run, shadow,
                  ambient),
            TileMap(geometry.size, geometry.tile_size)};
}

AoWork ao_work(const Method& method, const FrameSettings& settings) {
    AoWork work{method.computes_ao(), method.reads_normals || settings.ao_lookup == AoLookup::joint};
    work.lit_reads_bent_normals =
        method.bent_normals && settings.ambient.specular_occlusion == SpecularOcclusion::cones;
    if (!method.denoiser.denoised) work.why_no_blur = "the method has no denoiser";
    if (value_of(method, settings.method, "blur_iterations") == 0) work.why_no_blur = "blur_iterations is 0";
    return work;
}

// Maps that were asked for but had nothing to compute: everything is open, and background.
void fill_open_maps(Frame& frame, const FrameRequest& request) {
    const std::optional<double> scale = value_of(*request.method, request.settings.method, "ao_scale");
    const Size size = ao_map_size(request.size, static_cast<float>(scale.value_or(1)));
    if (frame.ao_raw.empty() && request.wanted.contains("ao_raw")) frame.ao_raw = Image<float>(size, 1.0f);
    if (frame.ao_blurred.empty() && request.wanted.contains("ao_blurred")) {
        frame.ao_blurred = frame.ao_raw.empty() ? Image<float>(size, 1.0f) : frame.ao_raw;
    }
    if (frame.bent_normal.empty() && request.wanted.contains(kBentNormal))
        frame.bent_normal = Image3(size, glm::vec3(0));
}

}  // namespace

Frame render_frame(const Scene& scene, const Camera& camera, const FrameRequest& request,
                   const AoHistory& last) {
    return frame_of(worked_frame(scene, camera, request, last), request);
}

Frame frame_of(WorkedFrame worked, const FrameRequest& request) {
    worked.frame.ao_raw = std::move(worked.raw.ao);
    fill_open_maps(worked.frame, request);
    return std::move(worked.frame);
}

WorkedFrame worked_frame(const Scene& scene, const Camera& camera, const FrameRequest& request,
                         const AoHistory& last, const AtRest& at_rest) {
    const FrameSettings& settings = request.settings;
    const Method& method = *request.method;
    const Needs needs = needs_of(scene, request.wanted, ao_work(method, settings),
                                 !request.run.leaves_out(Skip::passes), settings.buffers.mapped_normals);
    WorkedFrame worked;
    Frame& frame = worked.frame;
    ScreenGeometry& geometry = worked.geometry;
    RawAo& raw = worked.raw;
    Image<float>& at_pixels = worked.at_pixels;
    std::shared_ptr<const ShadowMap>& shadow = worked.shadow;
    std::shared_ptr<const RayScene>& rays = worked.rays;
    std::shared_ptr<const VertexAo>& baked = worked.baked;
    frame.camera = camera;
    frame.camera.reversed_z = settings.reversed_z;
    frame.left_out = needs.left_out;

    Stopwatch stopwatch;
    // Of the scene at rest: built once for all repeats.
    if (needs.ao && method.casts_rays) {
        if (at_rest.rays && at_rest.rays->origin == frame.camera.eye)
            rays = at_rest.rays;
        else
            stopwatch.time("ray_scene", [&] {
                rays = std::make_shared<const RayScene>(ray_scene(scene, frame.camera.eye, request.run));
            });
    }
    if (needs.shadow) shadow = at_rest.shadow;
    const bool draws_shadow = needs.shadow && !shadow;
    if (needs.ao && method.bake)
        stopwatch.time("bake", [&] { baked = method.bake(scene, *rays, settings.method.ao, request.run); });
    for (int repeat = 0; repeat < request.repeats; ++repeat) {
        stopwatch.time("frame", [&] {
            stopwatch.time("normal_depth", [&] {
                GeometrySettings geometry_with = geometry_settings(settings.buffers);
                geometry_with.with_normals = needs.normals;
                geometry = screen_geometry(scene, frame.camera, request.size, geometry_with, request.run);
                NormalDepthSettings buffers = settings.buffers;
                buffers.with_material = needs.lit && needs.materials;
                frame.gbuffer = normal_depth(scene, geometry, frame.camera.reversed_z, buffers, request.run);
            });
            if (needs.ao) {
                stopwatch.time("ao", [&] {
                    raw = method.ao({scene, frame.camera, frame.gbuffer, rays.get(), baked.get()},
                                    settings.method.ao, request.run);
                });
            }
            if (needs.ao && settings.history.longest > 1) {
                stopwatch.time("history", [&] {
                    frame.history = temporal_accumulation(raw.ao, raw.inputs, frame.camera, last,
                                                          settings.history, request.run);
                    raw.ao = frame.history.ao;
                });
            }
            if (needs.blur) {
                stopwatch.time("blur", [&] {
                    AoMap blurred = denoised(method, raw, settings.method, request.run);
                    frame.ao_blurred = std::move(blurred.ao);
                    frame.tiles.blur = std::move(blurred.tiles);
                });
            }
            if (needs.bent_normals) {
                stopwatch.time(kBentNormal, [&] {
                    frame.bent_normal = bent_normals(method, raw.inputs, settings.method, request.run);
                });
            }
            const Image<float>& map = needs.blur ? frame.ao_blurred : raw.ao;
            const bool looks_up = needs.ao && needs.lit && settings.ao_lookup != AoLookup::exact;
            if (looks_up) {
                stopwatch.time("ao_lookup", [&] {
                    at_pixels = looked_up(map, raw.inputs, frame.gbuffer, settings.ao_lookup, request.run);
                });
            }
            if (draws_shadow) {
                stopwatch.time("shadow", [&] {
                    shadow = std::make_shared<const ShadowMap>(scene_shadow(scene, request.run));
                });
            }
            if (needs.lit) {
                stopwatch.time("lit", [&] {
                    LitImage lit = lit_image(scene, geometry, frame, lit_map(worked), raw.inputs.normal,
                                             shadow.get(), request);
                    frame.lit = std::move(lit.image);
                    frame.tiles.lit = std::move(lit.tiles);
                });
            }
            if (needs.sky) {
                stopwatch.time("sky", [&] {
                    frame.lit = with_sky(std::move(frame.lit), frame.gbuffer.depth, frame.camera,
                                         *scene.sky_cube, request.run);
                });
            }
        });
    }
    frame.passes = stopwatch.summaries();
    frame.precision = precision_account(scene, frame.camera, geometry, frame.gbuffer, raw.inputs, rays.get(),
                                        method, settings, request.run);
    frame.tiles.ao = raw.tiles;
    frame.tiles.raster = raster_tiles(geometry, request.run);
    frame.skipped = skipped_work(geometry, frame.gbuffer, frame.tiles);
    return worked;
}

const Image<float>& lit_map(const WorkedFrame& worked) {
    if (!worked.at_pixels.empty()) return worked.at_pixels;
    return worked.frame.ao_blurred.empty() ? worked.raw.ao : worked.frame.ao_blurred;
}

LitExplanation explain_lit(const Scene& scene, const FrameRequest& request, const WorkedFrame& worked, int x,
                           int y) {
    const FrameSettings& settings = request.settings;
    const Frame& frame = worked.frame;
    const Image<float>& ao = lit_map(worked);
    LitExplanation lit;
    if (scene.point_light) {
        lit = explain_deferred_point_light(scene, frame.camera, frame.gbuffer, ao, settings.light_space,
                                           settings.ambient.multi_bounce, x, y);
    } else {
        const ShadowMap* const shadow = worked.shadow.get();
        const AmbientUse ambient = ambient_use(settings, frame, worked.raw.inputs.normal);
        lit = shares_geometry(settings)
                  ? explain_shade(scene, frame.camera, worked.geometry, frame.gbuffer, ao, x, y, request.run,
                                  shadow, ambient)
                  : explain_shade(scene, frame.camera, frame.gbuffer.depth, ao, lit_settings(settings), x, y,
                                  request.run, shadow, ambient);
    }
    if (scene.sky_cube == nullptr) return lit;
    const std::optional<glm::vec3> sky = sky_at(frame.gbuffer.depth, frame.camera, *scene.sky_cube, x, y);
    if (!sky) return lit;
    LitExplanation behind;
    behind.formula = kSumOfTerms;
    behind.terms = {{LitTerm::sky, -1, *sky}};
    behind.colour = *sky;
    return behind;
}

}  // namespace crevice
