#include "chapters/sweep/sweep_words.h"

#include <sstream>

#include "chapters/terminal/number_text.h"
#include "chapters/terminal/shell_word.h"

namespace crevice {

namespace {

bool has_seed(const std::string& name) {
    const Method& method = find_method(name);
    return value_of(method, defaults_of(method), "seed").has_value();
}

}  // namespace

std::string words_of(const SweepSetting& setting) {
    std::string words = setting.method;
    for (const auto& [name, word] : setting.parameters) words += " " + name + "=" + word;
    return words;
}

std::string words_of(const SweepView& view) {
    return view.scene + (view.camera.empty() ? "" : " " + view.camera) + " " + size_text(view.size);
}

std::string error_job_words(const SweepView& view, const SweepSetting& setting, std::uint32_t seed) {
    return words_of(view) + ", " + words_of(setting) + ", seed " + std::to_string(seed);
}

std::string time_job_words(const SweepView& view, std::size_t settings, int threads) {
    return words_of(view) + ", times of " + counted(static_cast<long long>(settings), "setting") + " on " +
           counted(threads, "thread");
}

std::string words_of(const SweepJob& job) {
    return job.timed ? time_job_words(job.view, job.settings.size(), job.threads)
                     : error_job_words(job.view, job.settings.front(), job.seed);
}

FrameSettings frame_settings(const SweepSetting& setting, std::uint32_t seed, float length_unit) {
    std::vector<std::string> words;
    for (const auto& [name, word] : setting.parameters) words.push_back(name + "=" + word);
    if (has_seed(setting.method)) words.push_back("seed=" + std::to_string(seed));
    return settings_of(find_method(setting.method), words, length_unit);
}

std::vector<std::string> render_words(const SweepView& view, const SweepSetting& setting,
                                      std::uint32_t seed) {
    std::vector<std::string> words = {"render", view.scene, "--size", size_text(view.size)};
    std::istringstream camera(view.camera);
    for (std::string word; camera >> word;) words.push_back(word);
    words.insert(words.end(), {"--ao", setting.method});
    for (const auto& [name, word] : setting.parameters)
        words.insert(words.end(), {"--param", name + "=" + word});
    if (has_seed(setting.method)) words.insert(words.end(), {"--param", "seed=" + std::to_string(seed)});
    words.insert(words.end(), {"--only", "ao_blurred"});
    return words;
}

std::string command_of(const SweepView& view, const SweepSetting& setting, std::uint32_t seed, int threads) {
    std::string command = "crevice";
    for (const std::string& word : render_words(view, setting, seed)) command += " " + shell_word(word);
    if (threads > 0) command += " --threads " + std::to_string(threads);
    return command + " --out out";
}

}  // namespace crevice
