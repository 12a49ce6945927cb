#include "chapters/props/switched_ao.h"

#include <utility>

#include "rasterizer/base/error.h"
#include "scenes/builtin_scenes.h"

namespace crevice {

namespace {

Scene scene_named(const std::string& name) {
    const BuiltinScene* const found = find_builtin_scene(name);
    if (found == nullptr)
        throw UsageError("scene: there is no such scene (" + name + "); see `crevice scenes`");
    return found->make();
}

}  // namespace

SwitchedView::SwitchedView(const std::string& scene, Size size, const std::string& method)
    : scene_(scene_named(scene)), camera_(scene_.camera), size_(size), method_(find_method(method)) {
    if (method != "xjun") flags_ = " --ao " + method;
}

SwitchedView::SwitchedView(const std::string& scene, Size size, Camera camera, std::string flags)
    : scene_(scene_named(scene)),
      camera_(std::move(camera)),
      size_(size),
      method_(find_method("xjun")),
      flags_(" " + std::move(flags)) {}

SwitchedAo SwitchedView::ao(const Words& words, float ao_scale) const {
    FrameSettings settings = settings_of(method_, words, scene_.length_unit);
    settings.method = with_value(method_, settings.method, "ao_scale", ao_scale);
    Camera camera = camera_;
    camera.reversed_z = settings.reversed_z;
    SwitchedAo result;
    result.settings = settings.method.ao.as<LunaSettings>();
    result.blur = settings.method.denoiser.as<BlurSettings>();
    result.gbuffer = normal_depth(scene_, camera, size_, settings.buffers);
    RawAo raw = method_.ao({scene_, camera, result.gbuffer}, settings.method.ao, {});
    result.blurred = denoised(method_, raw, settings.method).ao;
    result.raw = std::move(raw.ao);
    result.inputs = std::move(raw.inputs);
    return result;
}

std::string SwitchedView::command(const Words& words) const {
    std::string text = "`crevice render " + scene_.name + flags_;
    for (const std::string& word : words) text += " --param " + word;
    return text + "`";
}

SwitchedView column_foot(Size size) {
    Camera camera = scene_named("columns").camera;
    camera.eye = {-4.6, -1.4, -2.6};
    camera.target = {-6.2, -2.8, 0};
    return SwitchedView("columns", size, camera, "--eye -4.6,-1.4,-2.6 --target -6.2,-2.8,0");
}

Image<float> difference_of(Image<float> a, const Image<float>& b) {
    for (int y = 0; y < a.size.height; ++y) {
        for (int x = 0; x < a.size.width; ++x) a.at(x, y) -= b.at(x, y);
    }
    return a;
}

}  // namespace crevice
