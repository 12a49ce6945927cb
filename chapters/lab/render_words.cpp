#include "chapters/lab/render_words.h"

#include <utility>

#include "chapters/terminal/shell_word.h"

namespace crevice {

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
    if (words.crease) command += " --crease " + shell_word(*words.crease);
    for (const std::string& assignment : words.params) command += " --param " + shell_word(assignment);
    return command;
}

void set_param(LabWords& words, const std::string& name, const std::string& word) {
    std::erase_if(words.params, [&](const std::string& other) { return other.starts_with(name + "="); });
    words.params.push_back(name + "=" + word);
}

}  // namespace crevice
