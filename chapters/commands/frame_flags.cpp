#include "chapters/commands/frame_flags.h"

#include "chapters/frame/frame_settings.h"
#include "chapters/frame/presets.h"
#include "chapters/terminal/parse.h"
#include "rasterizer/base/error.h"

namespace crevice {

void add_frame_flags(CommandLine& command, FrameWords& words) {
    command.option("--preset", words.preset,
                   "a tutorial's scene, method and parameters: xjun2020, xjun2022, luna or learnopengl; with "
                   "_published behind it, its traps, too");
    command.option("--size", words.size, "size of the picture in pixels, WxH");
    add_camera_flags(command, words.camera);
    command.option("--ao", words.ao, "ambient-occlusion method (crevice methods); default: xjun");
    command.option("--param", words.params, "name=value, any number of times (crevice params METHOD)");
    command.option("--ao-scale", words.ao_scale,
                   "size of the AO map: .5 or 1 times the picture; default: the method's");
    command.option("--time", words.time, "seconds that the scene's lights have been turning");
    command.flag("--outside-files", words.outside_files, kOutsideFilesMeaning);
    add_crease_flag(command, words.crease);
    add_run_flags(command, words.run);
}

RenderOptions frame_options(const std::string& command, const FrameWords& words) {
    const Preset* const preset = words.preset ? &find_preset(*words.preset) : nullptr;
    if (words.scene.empty() && preset == nullptr)
        throw UsageError("crevice " + command + ": neither SCENE nor --preset; give one, such as crevice " +
                         command + " columns");
    if (preset != nullptr && !words.scene.empty())
        throw UsageError("--preset: names its own scene (" + std::string(preset->scene) +
                         "); leave SCENE away");
    RenderOptions options;
    options.scene = preset != nullptr ? preset->scene : words.scene;
    options.camera = words.camera;
    const std::string method = !words.ao.empty() ? words.ao : preset != nullptr ? preset->method : "xjun";
    // A preset's parameters are those of its own method.
    if (preset != nullptr && method == preset->method) options.params = preset->words;
    options.params.insert(options.params.end(), words.params.begin(), words.params.end());
    options.time_s = parse_number("--time", words.time);
    options.outside_files = words.outside_files;
    options.crease_angle_rad = crease_angle_of(words.crease);
    FrameRequest& request = options.request;
    request.run = run_of(words.run);
    request.size = parse_size("--size", words.size);
    request.method = named_as({{"method", "--ao"}}, [&] { return &find_method(method); });
    if (!words.ao_scale.empty()) {
        const auto scale = static_cast<float>(parse_number("--ao-scale", words.ao_scale));
        named_as({{"ao_scale", "--ao-scale"}}, [&] { ao_map_size(request.size, scale); });
        options.params.push_back("ao_scale=" + words.ao_scale);
    }
    return options;
}

}  // namespace crevice
