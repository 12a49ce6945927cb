#include "chapters/props/judged_view.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "chapters/terminal/number_text.h"
#include "rasterizer/base/error.h"
#include "scenes/builtin_scenes.h"
#include "ssao/light/ao_lookup.h"
#include "ssao/light/widened_ao.h"
#include "ssao/rays/ray_cast.h"

namespace crevice {

namespace {

Scene scene_named(const std::string& name) {
    const BuiltinScene* const found = find_builtin_scene(name);
    if (found == nullptr)
        throw UsageError("scene: there is no such scene (" + name + "); see `crevice scenes`");
    return found->make();
}

bool knows(const Method& method, const std::string& word) {
    return std::ranges::any_of(frame_parameters(method), [&](const Parameter<FrameSettings>& parameter) {
        return word.starts_with(std::string(parameter.name) + "=");
    });
}

}  // namespace

JudgedView::JudgedView(const std::string& scene, Size size, std::uint32_t seed)
    : scene_(scene_named(scene)), camera_(scene_.camera), size_(size), seed_(seed) {
    draw();
}

JudgedView::JudgedView(const Notebook& book, const std::string& scene, const std::string& own, Size size)
    : JudgedView(book.scene(scene), size, book.seed()) {
    own_ = own;
    reader_words_ = book.options().words;
}

void JudgedView::look(const Camera& camera, const std::string& flags) {
    camera_ = camera;
    flags_ = " " + flags;
    draw();
}

void JudgedView::draw() {
    gbuffer_ = normal_depth(scene_, camera_, size_);
    rays_ = std::make_shared<const RayScene>(ray_scene(scene_, camera_.eye));
}

MethodMap JudgedView::map(const std::string& name, const Words& words) const {
    MethodMap result;
    result.method = &find_method(name);
    Words all = words;
    for (const std::string& word : reader_words_) {
        if (name == own_ || knows(*result.method, word)) all.push_back(word);
    }
    FrameSettings settings = settings_of(*result.method, all, scene_.length_unit);
    settings.method = with_value(*result.method, settings.method, "seed", seed_);
    result.settings = settings.method;
    const AoView view = {scene_, camera_, gbuffer_, rays_.get()};
    result.raw = result.method->ao(view, result.settings.ao, {});
    result.denoised = denoised(*result.method, result.raw, result.settings).ao;
    result.picture = ao_at_picture_size(result.denoised, size_);
    return result;
}

Explanation JudgedView::explanation(const MethodMap& map, int x, int y) const {
    return map.method->explain({scene_, camera_, gbuffer_, rays_.get()}, map.raw, map.settings.ao, x, y);
}

AoQuestion JudgedView::question_of(const MethodMap& map) const {
    return map.method->question(map.settings.ao);
}

Truth JudgedView::truth(const AoQuestion& question) const {
    RayAoSettings rays;
    rays.rays = kJudgedRays;
    rays.radius = question.radius;
    rays.weight = question.cosine_weighted ? RayWeight::cosine : RayWeight::uniform;
    const Fade fade{question.fade_start, question.fade_end};
    const SurfacePoints points = surface_points(scene_, camera_, gbuffer_);
    const std::vector<AoEstimate> estimates = ray_cast_reference(*rays_, points.points, rays, &fade).soft;
    const auto image_of = [&](const auto& value, float background) {
        std::vector<float> values;
        for (const AoEstimate& estimate : estimates) values.push_back(value(estimate));
        return picture_of(points, values, background);
    };
    Truth truth{question,
                {image_of([](const AoEstimate& e) { return e.mean; }, 1),
                 image_of([](const AoEstimate& e) { return e.error; }, 0),
                 {image_of([](const AoEstimate& e) { return e.half[0]; }, 1),
                  image_of([](const AoEstimate& e) { return e.half[1]; }, 1)}}};
    double squares = 0;
    for (const AoEstimate& e : estimates)
        squares += static_cast<double>(e.error) * static_cast<double>(e.error);
    if (!estimates.empty()) truth.noise = std::sqrt(squares / static_cast<double>(estimates.size()));
    return truth;
}

MapError JudgedView::error(const MethodMap& map, const Truth& truth) const {
    const MeanError error =
        mean_error(map.picture, truth.image, surface_kinds(gbuffer_, camera_), Region::surface);
    return {error.squared.root(), error.bias};
}

Picture JudgedView::difference(const MethodMap& map, const Truth& truth) const {
    return difference_picture(difference_of(map.picture, truth.image.mean));
}

std::string JudgedView::command(const std::string& method, const Words& words) const {
    std::string text = "`crevice render " + scene_.name + flags_ + " --ao " + method;
    for (const std::string& word : words) text += " --param " + word;
    return text + "`";
}

JudgedView judged_column_foot(const Notebook& book, const std::string& own, Size size) {
    JudgedView view(book, "columns", own, size);
    const SwitchedView foot = column_foot(book);
    if (view.scene().name == "columns") view.look(foot.camera(), "--eye -4.6,-1.4,-2.6 --target -6.2,-2.8,0");
    return view;
}

std::vector<std::string> error_row(const std::string& name, const MapError& error) {
    return {name, decimal_text(error.rmse, 4), decimal_text(error.bias, 4)};
}

}  // namespace crevice
