#include "chapters/props/switched_ao.h"

#include <utility>

#include "chapters/terminal/number_text.h"
#include "rasterizer/base/error.h"
#include "scenes/builtin_scenes.h"

namespace crevice {

Scene scene_named(const std::string& name) {
    const BuiltinScene* const found = find_builtin_scene(name);
    if (found == nullptr)
        throw UsageError("scene: there is no such scene (" + name + "); see `crevice scenes`");
    return found->make();
}

SwitchedView::SwitchedView(const std::string& scene, Size size, const std::string& method)
    : scene_(scene_named(scene)), camera_(scene_.camera), size_(size), method_(find_method(method)) {
    if (method != "xjun") flags_ = " --ao " + method;
}

SwitchedView::SwitchedView(const Notebook& book, const std::string& scene, const std::string& method)
    : SwitchedView(book, scene, book.size(), method) {}

SwitchedView::SwitchedView(const Notebook& book, const std::string& scene, Size size,
                           const std::string& method)
    : SwitchedView(book.scene(scene), size, method) {
    reader_words_ = book.options().words;
}

void SwitchedView::look(const Camera& camera, const std::string& flags) {
    camera_ = camera;
    flags_ += " " + flags;
}

FrameSettings SwitchedView::settings(const Words& words) const {
    Words all = words;
    all.insert(all.end(), reader_words_.begin(), reader_words_.end());
    return settings_of(method_, all, scene_.length_unit);
}

SwitchedAo SwitchedView::ao(const Words& words, float ao_scale) const {
    FrameSettings settings = this->settings(words);
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

Explanation SwitchedView::explanation(const SwitchedAo& shown, int x, int y) const {
    RawAo raw;
    raw.ao = shown.raw;
    raw.inputs = shown.inputs;
    return method_.explain({scene_, camera_, shown.gbuffer}, raw, AnySettings::of(shown.settings), x, y);
}

std::string SwitchedView::command(const Words& words) const {
    std::string text = "`crevice render " + scene_.name + flags_;
    for (const std::string& word : words) text += " --param " + word;
    return text + "`";
}

FrameRequest SwitchedView::request(const Words& words) const {
    FrameRequest request;
    request.size = size_;
    request.method = &method_;
    request.settings = settings(words);
    return request;
}

std::string SwitchedView::flags(const Words& words) const {
    std::string text = "--size " + size_text(size_) + flags_;
    for (const Words& some : {words, reader_words_}) {
        for (const std::string& word : some) text += " --param " + word;
    }
    return text;
}

std::string SwitchedView::render_command(const Words& words, const std::string& buffer) const {
    return "crevice render " + scene_.name + " " + flags(words) + " --only " + buffer;
}

std::string SwitchedView::probe_command(const Words& words, const Texel& texel) const {
    const double scale = value_of(method_, settings(words).method, "ao_scale").value_or(1);
    const Texel pixel = pixel_of(texel, ao_map_size(size_, static_cast<float>(scale)), size_);
    return "crevice probe " + scene_.name + " " + std::to_string(pixel.x) + " " + std::to_string(pixel.y) +
           " " + flags(words) + " --pass ao";
}

Texel pixel_of(const Texel& texel, Size ao_map, Size picture) {
    const auto middle = [](int place, int among, int of) { return (2 * place + 1) * of / (2 * among); };
    return {middle(texel.x, ao_map.width, picture.width), middle(texel.y, ao_map.height, picture.height)};
}

SwitchedView column_foot(const Notebook& book) { return column_foot(book, book.size()); }

SwitchedView column_foot(const Notebook& book, Size size) {
    SwitchedView view(book, "columns", size);
    if (view.scene().name == "columns") {
        Camera camera = view.camera();
        camera.eye = {-4.6, -1.4, -2.6};
        camera.target = {-6.2, -2.8, 0};
        view.look(camera, "--eye -4.6,-1.4,-2.6 --target -6.2,-2.8,0");
    }
    return view;
}

Texel followed_texel(Size ao_map) {
    constexpr float kAcross = 0.612f, kDown = 0.58f;
    return {static_cast<int>(kAcross * static_cast<float>(ao_map.width)),
            static_cast<int>(kDown * static_cast<float>(ao_map.height))};
}

Image<float> difference_of(Image<float> a, const Image<float>& b) {
    for (int y = 0; y < a.size.height; ++y) {
        for (int x = 0; x < a.size.width; ++x) a.at(x, y) -= b.at(x, y);
    }
    return a;
}

Image3 difference_of(Image3 a, const Image3& b) {
    for (int y = 0; y < a.size().height; ++y) {
        for (int x = 0; x < a.size().width; ++x) a.set(x, y, a.at(x, y) - b.at(x, y));
    }
    return a;
}

}  // namespace crevice
