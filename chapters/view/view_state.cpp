#include "chapters/view/view_state.h"

#include <algorithm>

#include "chapters/frame/presets.h"
#include "chapters/terminal/parse.h"

namespace crevice {

void ViewState::use_scene(const std::string& name) {
    wish.words.scene = name;
    first_camera = {};
    wish.pixel.reset();
    reset_camera();
}

void ViewState::use_method(const std::string& name) {
    wish.words.ao = name;
    wish.words.params.clear();
    const std::vector<std::string> known = buffers_to_show(name);
    for (std::string& buffer : wish.shown) {
        if (std::find(known.begin(), known.end(), buffer) == known.end()) buffer = "ao_blurred";
    }
    ask_truth(wish.truth);
    redraw();
}

void ViewState::use_size(const std::string& word) {
    wish.words.size = word;
    const Size size = parse_size("--size", word);
    if (wish.pixel && (wish.pixel->first >= size.width || wish.pixel->second >= size.height))
        wish.pixel.reset();
    redraw();
}

void ViewState::use_preset(const std::string& name) {
    const Preset& preset = find_preset(name);
    if (wish.words.scene != preset.scene) use_scene(preset.scene);
    use_method(preset.method);
    wish.words.params = preset.words;
}

void ViewState::show(std::size_t place, const std::string& buffer) {
    if (place == 0) {
        wish.shown.front() = buffer;
    } else {
        wish.shown.resize(1);
        if (!buffer.empty()) wish.shown.push_back(buffer);
        if (buffer.empty()) {
            layout = ViewLayout::one;
        } else if (layout == ViewLayout::one) {
            layout = ViewLayout::split;
        }
    }
    if (buffer == kTruth || buffer == kAoError) wish.truth = true;
    redraw();
}

void ViewState::ask_truth(bool asked) { wish.truth = asked && find_method(wish.words.ao).computes_ao(); }

void ViewState::reset_camera() {
    wish.camera.reset();
    wish.words.camera = first_camera;
    redraw();
}

void ViewState::note_times(const ViewFrame& frame) {
    times.push_back(frame.passes);
    if (times.size() > kFramesInGraph) times.pop_front();
}

std::vector<std::string> buffers_to_show(const std::string& method) {
    std::vector<std::string> buffers(std::begin(kBufferNames), std::end(kBufferNames));
    const Method& row = find_method(method);
    if (row.bent_normals) buffers.push_back(kBentNormal);
    if (row.computes_ao()) buffers.insert(buffers.end(), {kTruth, kAoError});
    return buffers;
}

const Picture* picture_in(const ViewFrame& frame, const std::string& buffer) {
    if (frame.truth && buffer == kTruth) return &frame.truth->truth;
    if (frame.truth && buffer == kAoError) return &frame.truth->ao_error;
    for (const auto& [name, picture] : frame.pictures) {
        if (name == buffer) return &picture;
    }
    return nullptr;
}

}  // namespace crevice
