#include "chapters/commands/film.h"

#include <algorithm>
#include <cstdio>
#include <iterator>
#include <ostream>
#include <vector>

#include "chapters/frame/demo_view.h"
#include "chapters/frame/frame_buffers.h"
#include "chapters/frame/worked_frame.h"
#include "chapters/notebook/animated_webp.h"
#include "chapters/terminal/output_directory.h"
#include "chapters/terminal/progress.h"
#include "rasterizer/base/error.h"
#include "rasterizer/base/write_file.h"
#include "scenes/builtin_scenes.h"

namespace crevice {

namespace {

// The lit picture if it is wanted, else that of the first wanted buffer of this list.
Picture shown_picture(const Frame& frame, const WantedBuffers& wanted, bool inset) {
    if (wanted.contains("lit")) return demo_view(frame, inset);
    const std::string names[] = {"ao_blurred", "ao_raw", kBentNormal, "normal", "view_depth", "ndc_depth"};
    const std::string& shown = *std::find_if(std::begin(names), std::end(names),
                                             [&](const std::string& name) { return wanted.contains(name); });
    Picture picture;
    for_each_buffer(
        frame, ndc_depth(frame.gbuffer.depth), {shown},
        [&](const char* name, const auto& buffer) { picture = buffer_picture(name, buffer, frame.camera); });
    return picture;
}

std::string frame_name(int frame) {
    char name[32];
    std::snprintf(name, sizeof name, "frame_%04d", frame);
    return name;
}

// Who names a place of his own walks round that.
CameraPath chosen_path(const std::optional<std::string>& word, std::span<const WalkStop> stops,
                       const CameraFlags& camera) {
    const bool own_place = camera.eye || camera.target;
    if (own_place && !word) return CameraPath::turn;
    const CameraPath path = path_of("--path", word, stops);
    if (own_place && path == CameraPath::walk)
        throw UsageError("--path walk: has places of its own; leave --eye and --target away");
    return path;
}

}  // namespace

void render_film(const RenderOptions& options, const FilmOptions& film, std::ostream& out) {
    const BuiltinScene* const builtin = find_builtin_scene(options.scene);
    const std::span<const WalkStop> stops = builtin != nullptr ? builtin->walk : std::span<const WalkStop>();
    const CameraPath path = chosen_path(film.path, stops, options.camera);
    PreparedRender prepared = prepared_render(options);
    Scene& scene = prepared.argument.scene;
    FrameRequest& request = prepared.request;
    const FrameSettings settings = request.settings;
    const bool has_history = settings.history.longest > 1;
    try_output_directory(options.out);
    const auto lights = scene.lights;  // at options.time_s
    const auto [first, last] = film.frames;
    std::vector<std::filesystem::path> pictures;
    WebpFilm webp(static_cast<int>(1000 * kFrame_s));
    AoHistory history;
    WorkedFrame worked;
    Progress progress("frames", last - first + 1);
    for (int i = first; i <= last; ++i) {
        scene.lights = lights;
        if (path != CameraPath::still) scene.lights = lights_at(scene, i * kFrame_s);
        if (has_history) request.settings.method = reseeded(*request.method, settings.method, i);
        const Camera camera =
            moved_planes(prepared.argument, options.camera, camera_on(path, prepared.camera, stops, i));
        worked = worked_frame(scene, camera, request, history, std::move(worked));
        show(worked, request);
        Frame& frame = worked.frame;
        const std::string name = frame_name(i);
        pictures.push_back(options.out / (name + ".png"));
        const Picture picture = shown_picture(frame, request.wanted, options.inset);
        write_picture(pictures.back(), picture, request.run);
        webp.add(picture);
        if (film.buffers) write_frame(options, prepared, options.out / name, frame, worked.unchanged);
        history = std::move(frame.history);
        progress.advance();
    }
    out << pictures.front().string();
    if (pictures.size() > 1) out << " ... " << pictures.back().filename().string();
    out << "\n";
    const std::optional<std::string> bytes = webp.bytes();
    if (!bytes) {
        out << "no animated WebP: this program was built without libwebp\n";
        return;
    }
    const std::filesystem::path whole = options.out / (std::string(path_name(path)) + ".webp");
    write_file_atomically(whole, *bytes);
    out << whole.string() << "\n";
}

}  // namespace crevice
