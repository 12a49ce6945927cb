#include "chapters/frame/second_drawing.h"

#include "ssao/light/deferred_point_light.h"
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

}  // namespace

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
