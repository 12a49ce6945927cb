#include "chapters/view/view_panels.h"

#include <algorithm>
#include <cstdlib>

#include <imgui.h>

#include "chapters/frame/presets.h"
#include "chapters/lab/render_words.h"
#include "chapters/terminal/number_text.h"
#include "scenes/builtin_scenes.h"

namespace crevice {

namespace {

constexpr int kDigits = 6;           // of a value that is set by dragging
constexpr float kDragSpeed = 0.01f;  // of a value's size, for a pixel
constexpr const char* kNothing = "(nothing)";

// A list to choose from; true when another word was chosen.
bool choose(const char* label, const std::string& chosen, const std::vector<std::string>& words,
            std::string& choice) {
    bool changed = false;
    if (ImGui::BeginCombo(label, chosen.c_str())) {
        for (const std::string& word : words) {
            if (ImGui::Selectable(word.c_str(), word == chosen) && word != chosen) {
                choice = word;
                changed = true;
            }
        }
        ImGui::EndCombo();
    }
    return changed;
}

// The widget of one parameter's kind; true when `word` was changed.
bool edit(const Parameter<FrameSettings>& p, std::string& word) {
    const char* const label = p.name.c_str();
    if (p.kind == ParameterKind::yes_no) {
        bool value = word == "true";
        if (!ImGui::Checkbox(label, &value)) return false;
        word = value ? "true" : "false";
        return true;
    }
    if (p.kind == ParameterKind::choice) return choose(label, word, p.choices, word);
    if (p.kind == ParameterKind::whole) {
        auto value = static_cast<int>(std::strtol(word.c_str(), nullptr, 10));
        constexpr long long kMostOnSlider = 1 << 16;  // seeds have no useful slider beyond
        if (!ImGui::DragInt(label, &value, 0.1f, static_cast<int>(p.lowest),
                            static_cast<int>(std::min(p.highest, kMostOnSlider)), "%d",
                            ImGuiSliderFlags_AlwaysClamp))
            return false;
        word = std::to_string(value);
        return true;
    }
    float value = std::strtof(word.c_str(), nullptr);
    if (!ImGui::DragFloat(label, &value, std::max(std::abs(value), kDragSpeed) * kDragSpeed, 0, 0, "%.4g"))
        return false;
    word = significant_text(value, kDigits);
    return true;
}

void draw_parameters(ViewState& state, const ViewFrame& newest) {
    if (!ImGui::CollapsingHeader("parameters", ImGuiTreeNodeFlags_DefaultOpen)) return;
    ImGui::TextDisabled("drag, or Ctrl-click to type");
    const std::vector<Parameter<FrameSettings>> parameters = frame_parameters(find_method(newest.words.ao));
    for (const Parameter<FrameSettings>& p : parameters) {
        // It takes frames before this one.
        if (p.name.starts_with("history")) continue;
        const auto told = std::find_if(newest.parameters.begin(), newest.parameters.end(),
                                       [&](const auto& named) { return named.first == p.name; });
        if (told == newest.parameters.end()) continue;
        std::string word = told->second;
        if (edit(p, word)) {
            set_param(state.wish.words, p.name, word);
            state.redraw();
        }
        if (ImGui::IsItemHovered())
            ImGui::SetTooltip("%s\nrange %s, unit %s", p.effect.c_str(), p.range.c_str(), p.unit.c_str());
    }
}

void draw_choices(ViewState& state) {
    std::string choice;
    std::vector<std::string> scenes, methods, preset_names;
    for (const BuiltinScene& scene : builtin_scenes()) scenes.push_back(scene.name);
    for (const Method& method : ao_methods()) methods.push_back(method.name);
    for (const Preset& preset : presets()) preset_names.push_back(preset.name);
    LabWords& words = state.wish.words;
    if (choose("scene", words.scene, scenes, choice)) state.use_scene(choice);
    if (choose("preset", "", preset_names, choice)) state.use_preset(choice);
    if (choose("method", words.ao, methods, choice)) state.use_method(choice);
    if (choose("size", words.size, {"320x180", "640x360", "960x540", "1280x720", "1920x1080"}, choice))
        state.use_size(choice);
}

void draw_buffers(ViewState& state) {
    std::string choice;
    std::vector<std::string> buffers = buffers_to_show(state.wish.words.ao);
    if (choose("buffer", state.wish.shown.front(), buffers, choice)) state.show(0, choice);
    buffers.insert(buffers.begin(), kNothing);
    const bool is_pair = state.wish.shown.size() > 1;
    if (choose("beside", is_pair ? state.wish.shown.back() : kNothing, buffers, choice))
        state.show(1, choice == kNothing ? "" : choice);
    if (!is_pair) return;
    const std::pair<const char*, ViewLayout> layouts[] = {{"side by side", ViewLayout::side_by_side},
                                                          {"split", ViewLayout::split},
                                                          {"flip (space)", ViewLayout::flip}};
    for (const auto& [name, layout] : layouts) {
        if (layout != ViewLayout::side_by_side) ImGui::SameLine();
        if (ImGui::RadioButton(name, state.layout == layout)) state.layout = layout;
    }
    if (state.layout == ViewLayout::split) ImGui::SliderFloat("split at", &state.split_at, 0, 1, "%.2f");
}

// The last frames' times of each pass as a curve, with the newest one in words.
void draw_times(const ViewState& state, const ViewFrame& newest) {
    for (const PassTime& pass : newest.passes) {
        std::vector<float> wall_ms;
        for (const std::vector<PassTime>& frame : state.times) {
            for (const PassTime& other : frame) {
                if (other.name == pass.name) wall_ms.push_back(static_cast<float>(other.wall_ms));
            }
        }
        if (wall_ms.empty()) continue;
        const float highest = *std::max_element(wall_ms.begin(), wall_ms.end());
        const std::string label = pass.name + "  " + significant_text(pass.wall_ms, 3) + " ms";
        ImGui::PlotLines(label.c_str(), wall_ms.data(), static_cast<int>(wall_ms.size()), 0, nullptr, 0,
                         1.1f * highest, ImVec2(150, 22));
    }
    for (const std::string& pass : newest.unchanged) ImGui::TextDisabled("%s  unchanged", pass.c_str());
}

void draw_lines(const std::vector<std::string>& lines) {
    for (const std::string& line : lines) ImGui::TextWrapped("%s", line.c_str());
}

void draw_told(const ViewState& state, const ViewFrame& newest) {
    if (!newest.error.empty()) ImGui::TextColored(ImVec4(1, 0.5f, 0.4f, 1), "not drawn:");
    if (!newest.error.empty()) draw_lines({newest.error});
    if (newest.truth) {
        ImGui::TextWrapped("truth, %d rays a pixel: RMSE %s, bias %s", newest.truth->rays,
                           significant_text(newest.truth->rmse, 3).c_str(),
                           significant_text(newest.truth->bias, 3).c_str());
    }
    draw_lines(newest.warnings);
    if (ImGui::CollapsingHeader("times", ImGuiTreeNodeFlags_DefaultOpen)) draw_times(state, newest);
    if (ImGui::CollapsingHeader("left out")) draw_lines(newest.left_out);
}

}  // namespace

void draw_controls(ViewState& state, const ViewFrame* newest) {
    ImGui::SetNextWindowPos(ImVec2(0, 0));
    ImGui::SetNextWindowSize(ImVec2(kPanel_px, ImGui::GetIO().DisplaySize.y));
    ImGui::Begin("Crevice", nullptr,
                 ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoTitleBar);
    ImGui::PushItemWidth(190);
    draw_choices(state);
    draw_buffers(state);
    bool truth = state.wish.truth;
    if (ImGui::Checkbox("truth (T)", &truth)) state.ask_truth(truth);
    ImGui::SameLine();
    ImGui::Checkbox("left out (L)", &state.shows_left_out);
    ImGui::SameLine();
    ImGui::Checkbox("fly (F)", &state.flies);
    if (state.shows_left_out) ImGui::TextWrapped("blue: no surface; green: all open; yellow: lit once");
    if (ImGui::Button("copy as command (C)")) state.copies_command = true;
    ImGui::SameLine();
    if (ImGui::Button("screenshot (F12)")) state.takes_screenshot = true;
    if (ImGui::Button("camera back (R)")) state.reset_camera();
    if (!state.said.empty()) ImGui::TextWrapped("%s", state.said.c_str());
    if (newest != nullptr) {
        draw_told(state, *newest);
        draw_parameters(state, *newest);
    }
    ImGui::PopItemWidth();
    ImGui::End();
}

void draw_probe(const ViewFrame& newest) {
    const ImVec2 size = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos(ImVec2(kPanel_px, 0.6f * size.y), ImGuiCond_FirstUseEver);
    ImGui::SetNextWindowSize(ImVec2(size.x - kPanel_px, 0.4f * size.y), ImGuiCond_FirstUseEver);
    ImGui::Begin("pixel (Escape closes it)", nullptr, ImGuiWindowFlags_HorizontalScrollbar);
    ImGui::TextUnformatted(newest.probe.empty() ? "..." : newest.probe.c_str());
    ImGui::End();
}

}  // namespace crevice
