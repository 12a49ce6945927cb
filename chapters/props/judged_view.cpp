#include "chapters/props/judged_view.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "chapters/props/crops.h"
#include "chapters/terminal/number_text.h"
#include "scenes/builtin_scenes.h"
#include "ssao/light/widened_ao.h"
#include "ssao/rays/depth_mesh.h"
#include "ssao/rays/ray_cast.h"

namespace crevice {

namespace {

bool knows(const Method& method, const std::string& word) {
    return std::ranges::any_of(frame_parameters(method), [&](const Parameter<FrameSettings>& parameter) {
        return word.starts_with(std::string(parameter.name) + "=");
    });
}

}  // namespace

JudgedView::JudgedView(Scene scene, Size size, std::uint32_t seed)
    : scene_(std::move(scene)), camera_(scene_.camera), size_(size), seed_(seed) {
    draw();
}

JudgedView::JudgedView(const std::string& scene, Size size, std::uint32_t seed)
    : JudgedView(scene_named(scene), size, seed) {}

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

Words JudgedView::all_words(const Method& method, const Words& words) const {
    Words all = words;
    for (const std::string& word : reader_words_) {
        if (method.name == own_ || knows(method, word)) all.push_back(word);
    }
    return all;
}

MethodSettings JudgedView::settings_for(const Method& method, const Words& words) const {
    const MethodSettings settings = settings_of(method, all_words(method, words), scene_.length_unit).method;
    return with_value(method, settings, "seed", seed_);
}

MethodMap JudgedView::map(const std::string& name, const Words& words) const {
    MethodMap result;
    result.method = &find_method(name);
    result.settings = settings_for(*result.method, words);
    const AoView view = {scene_, camera_, gbuffer_, rays_.get()};
    result.raw = result.method->ao(view, result.settings.ao, {});
    result.denoised = denoised(*result.method, result.raw, result.settings).ao;
    result.picture = at_picture_size(result.denoised);
    if (find_builtin_scene(scene_.name) == nullptr) return result;
    result.rendered =
        "crevice render " + scene_.name + " --size " + size_text(size_) + flags_ + " --ao " + name;
    if (value_of(*result.method, result.settings, "seed"))
        result.rendered += " --param seed=" + std::to_string(seed_);
    for (const std::string& word : all_words(*result.method, words)) result.rendered += " --param " + word;
    return result;
}

Explanation JudgedView::explanation(const MethodMap& map, int x, int y) const {
    return map.method->explain({scene_, camera_, gbuffer_, rays_.get()}, map.raw, map.settings.ao, x, y);
}

AoQuestion JudgedView::question_of(const MethodMap& map) const {
    return map.method->question(map.settings.ao);
}

MethodLimit JudgedView::limit(const std::string& name, const Words& words) const {
    const Method& method = find_method(name);
    const MethodSettings settings = with_value(method, settings_for(method, words), "ao_scale", 1);
    const AoView view = {scene_, camera_, gbuffer_, rays_.get()};
    MethodLimit limit{method.question(settings.ao),
                      method.limit(view, settings.ao, kJudgedSeeds, {}, [](long long) {})};
    // The standard error of a mean over so many is that of one over their root.
    limit.noise = root_mean_square(limit.image.error) * std::sqrt(double{kJudgedSeeds});
    return limit;
}

Truth JudgedView::truth(const AoQuestion& question) const {
    return cast(question, *rays_, surface_points(scene_, camera_, gbuffer_));
}

Truth JudgedView::depth_truth(const AoQuestion& question) const {
    return cast(question, depth_mesh(gbuffer_, camera_, question.radius),
                points_on_depth_mesh(surface_points(scene_, camera_, gbuffer_), gbuffer_, camera_));
}

Truth JudgedView::cast(const AoQuestion& question, const RayScene& rays, const SurfacePoints& points) const {
    RayAoSettings settings;
    settings.rays = kJudgedRays;
    settings.radius = question.radius;
    settings.weight = question.cosine_weighted ? RayWeight::cosine : RayWeight::uniform;
    const Fade fade{question.fade_start, question.fade_end};
    const std::vector<AoEstimate> estimates = ray_cast_reference(rays, points.points, settings, &fade).soft;
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
    truth.noise = root_mean_square(truth.image.error);
    return truth;
}

double JudgedView::root_mean_square(const Image<float>& errors) const {
    double squares = 0, count = 0;
    for (int y = 0; y < size_.height; ++y) {
        for (int x = 0; x < size_.width; ++x) {
            if (!std::isfinite(gbuffer_.view_depth.at(x, y))) continue;
            const double error = static_cast<double>(errors.at(x, y));
            squares += error * error;
            count += 1;
        }
    }
    return count > 0 ? std::sqrt(squares / count) : 0;
}

// Halves that are independent of each other: the mean of their product has the square of no noise in it.
MapError JudgedView::error_of(const Image<float>& mean, const Halves& halves, const Truth& truth) const {
    const ReferenceImage& reference = truth.image;
    double product = 0, sum = 0, count = 0;
    for (int y = 0; y < size_.height; ++y) {
        for (int x = 0; x < size_.width; ++x) {
            if (!std::isfinite(gbuffer_.view_depth.at(x, y))) continue;
            product += static_cast<double>(halves[0].at(x, y) - reference.half[0].at(x, y)) *
                       static_cast<double>(halves[1].at(x, y) - reference.half[1].at(x, y));
            sum += static_cast<double>(mean.at(x, y) - reference.mean.at(x, y));
            count += 1;
        }
    }
    if (count == 0) return {};
    return {std::sqrt(std::max(product / count, 0.0)), sum / count};
}

MapError JudgedView::error(const MethodMap& map, const Truth& truth) const {
    return error_of(map.picture, {map.picture, map.picture}, truth);
}

MapError JudgedView::error(const MethodLimit& limit, const Truth& truth) const {
    return error_of(limit.image.mean, limit.image.half, truth);
}

Picture JudgedView::difference(const MethodMap& map, const Truth& truth) const {
    return difference_picture(difference_of(map.picture, truth.image.mean));
}

Image<float> JudgedView::at_picture_size(const Image<float>& ao) const {
    return ao_at_picture_size(ao, size_);
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

Image<float> around_foot(const Image<float>& ao) {
    constexpr double kLeft = 0.28, kTop = 0.36, kPart = 0.42;
    const auto part = [](int whole, double share) { return static_cast<int>(share * whole); };
    const int x0 = part(ao.size.width, kLeft), y0 = part(ao.size.height, kTop);
    return cropped(ao, {x0, y0, x0 + part(ao.size.width, kPart), y0 + part(ao.size.height, kPart)});
}

std::vector<std::string> error_row(const std::string& name, const MapError& error) {
    return {name, decimal_text(error.rmse, 4), decimal_text(error.bias, 4)};
}

std::vector<std::string> error_row(const std::string& name, const MapError& error, const MethodLimit& limit) {
    std::vector<std::string> row = error_row(name, error);
    row.push_back(decimal_text(limit.noise, 4));
    return row;
}

}  // namespace crevice
