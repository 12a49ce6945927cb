#include "chapters/lab/render_words.h"

#include <algorithm>
#include <cctype>
#include <string_view>

namespace crevice {

std::string shell_word(const std::string& word) {
    constexpr std::string_view kHarmless = "_.,=:/+-";
    const bool harmless = !word.empty() && std::all_of(word.begin(), word.end(), [&](char c) {
        return std::isalnum(static_cast<unsigned char>(c)) != 0 || kHarmless.find(c) != kHarmless.npos;
    });
    if (harmless) return word;
    std::string quoted = "'";
    for (const char c : word) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return quoted + "'";
}

std::string render_command(const LabWords& words) {
    std::string command =
        "crevice render " + shell_word(words.scene) + " --size " + words.size + " --ao " + words.ao;
    const CameraFlags& camera = words.camera;
    const std::pair<const char*, const std::optional<std::string>&> flags[] = {
        {"--eye=", camera.eye},         {"--target=", camera.target}, {"--fov-y=", camera.fov_y},
        {"--near=", camera.near_plane}, {"--far=", camera.far_plane}, {"--ortho=", camera.ortho}};
    for (const auto& [flag, word] : flags) {
        if (word) command += " " + shell_word(flag + *word);
    }
    for (const std::string& assignment : words.params) command += " --param " + shell_word(assignment);
    return command;
}

void set_param(LabWords& words, const std::string& name, const std::string& word) {
    std::erase_if(words.params, [&](const std::string& other) { return other.starts_with(name + "="); });
    words.params.push_back(name + "=" + word);
}

}  // namespace crevice
