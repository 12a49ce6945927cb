#include "chapters/tune/tune_views.h"

#include "chapters/frame/camera_path.h"
#include "chapters/frame/scene_argument.h"
#include "chapters/study/methods_study.h"
#include "chapters/terminal/progress.h"
#include "rasterizer/base/error.h"

namespace crevice {

namespace {

constexpr int kTurnedFrames = 2;  // of a turntable, for the second view of the only scene

// The truth of one view, and of which kind each pixel is.
void judge_by_rays(TuneView& view, const TuneViewsRequest& request) {
    const Scene& scene = *view.scene;
    const Camera& camera = view.view.camera;
    if (request.truth == TuneTruth::hard) {
        MethodsTruth truth =
            methods_truth(scene, camera, request.size, request.rays, request.cache, request.run);
        view.truth = std::move(truth.reference);
        view.kinds = std::move(truth.kinds);
        return;
    }
    const auto radius = kAskedRadius * scene.length_unit;
    ReferenceRequest asked;
    asked.size = request.size;
    asked.method = request.method;
    asked.settings = settings_for_study(*request.method, scene.length_unit, radius).method;
    asked.rays = rays_asking(request.method->question(asked.settings.ao));
    asked.rays.rays = request.rays;
    asked.limit_seeds = 0;
    asked.cache = request.cache;
    asked.run = request.run;
    References references = make_references(scene, camera, asked);
    view.truth = std::move(references.soft);
    view.kinds = surface_kinds(references.gbuffer, camera);
}

TuneView judged_view(const std::string& name, const std::shared_ptr<const Scene>& scene, const Camera& camera,
                     const TuneViewsRequest& request) {
    TuneView view{
        name, scene, method_view(*scene, camera, request.size, *request.method, request.run), {}, {}};
    judge_by_rays(view, request);
    return view;
}

}  // namespace

TuneViews tune_views(const TuneViewsRequest& request) {
    TuneViews views;
    const std::size_t count = request.scenes.size();
    Progress progress("truth", static_cast<long long>(count == 1 ? 2 : count));
    for (std::size_t i = 0; i < count; ++i) {
        const std::string& name = request.scenes[i];
        SceneArgument argument = load_scene(
            name, {.surfaces = false, .crease_angle_rad = request.crease_angle_rad, .run = request.run});
        if (triangle_count(argument.scene) == 0)
            throw InputError(name + ": nothing to tune for (0 triangles); give a scene with some");
        settings_for(argument, name, *request.method,
                     {});  // where its defaults do not fit the scene, it says so
        const Camera camera = argument.scene.camera;
        const auto scene = std::make_shared<const Scene>(std::move(argument.scene));
        const bool held_out = count > 1 && i + 1 == count;
        (held_out ? views.held_out : views.searched).push_back(judged_view(name, scene, camera, request));
        progress.advance();
        if (count > 1) continue;
        const int degrees = 360 / kFramesOfTurn * kTurnedFrames;
        views.held_out.push_back(judged_view(name + ", turned by " + std::to_string(degrees) + " degrees",
                                             scene, turned_camera(camera, kTurnedFrames), request));
        progress.advance();
    }
    return views;
}

}  // namespace crevice
