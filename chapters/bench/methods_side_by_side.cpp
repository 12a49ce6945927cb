#include "chapters/bench/methods_side_by_side.h"

#include <memory>
#include <ostream>

#include "chapters/bench/machine.h"
#include "chapters/frame/scene_argument.h"
#include "chapters/notebook/html.h"
#include "chapters/notebook/picture.h"
#include "chapters/notebook/report_page.h"
#include "chapters/notebook/table.h"
#include "chapters/study/method_view.h"
#include "chapters/study/methods_study.h"
#include "chapters/terminal/exit_code.h"
#include "chapters/terminal/number_text.h"
#include "chapters/terminal/progress.h"
#include "rasterizer/base/error.h"
#include "rasterizer/base/image_io.h"
#include "rasterizer/base/write_file.h"
#include "ssao/light/ao_lookup.h"
#include "ssao/light/widened_ao.h"

namespace crevice {

namespace {

constexpr int kTruthRays = 256;
constexpr int kRounds = 5;  // a time is their median

// What one method makes of a scene.
struct MethodShown {
    const Method* method = nullptr;
    Picture raw, denoised, difference;
    MeanError error;
    double bake_ms = 0, ao_ms = 0, blur_ms = 0;
};

struct SceneShown {
    std::string name;
    float radius = 0;
    Reference truth;
    std::vector<MethodShown> methods;
};

double ms_of(const std::vector<PassTime>& times, const std::string& pass) {
    for (const PassTime& time : times) {
        if (time.name == pass) return time.wall_ms;
    }
    return 0;
}

MethodShown shown(const Method& method, const SceneArgument& argument, const MethodsTruth& truth, Size size,
                  const Run& run) {
    const Scene& scene = argument.scene;
    const FrameSettings settings = settings_for_study(method, scene.length_unit, truth.radius);
    MethodView view = method_view(scene, scene.camera, size, method, run);
    Stopwatch stopwatch;
    if (method.bake) stopwatch.time("bake", [&] { view = with_bake(view, settings, run); });
    const AoView ao_view = ao_view_of(view, settings);
    RawAo raw;
    AoMap smooth;
    for (int round = 0; round < kRounds; ++round) {
        stopwatch.time("ao", [&] { raw = method.ao(ao_view, settings.method.ao, run); });
        stopwatch.time("blur", [&] { smooth = denoised(method, raw, settings.method, run); });
    }
    const Image<float> picture = ao_at_picture_size(smooth.ao, size, run);
    Image<float> difference(size, 0.0f);
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x)
            difference.at(x, y) = picture.at(x, y) - truth.reference.image.mean.at(x, y);
    }
    const std::vector<PassTime> times = stopwatch.summaries();
    return {&method,
            ao_picture(raw.ao),
            ao_picture(picture),
            difference_picture(difference),
            mean_error(picture, truth.reference.image, truth.kinds, Region::surface),
            ms_of(times, "bake"),
            ms_of(times, "ao"),
            ms_of(times, "blur")};
}

SceneShown shown(const std::string& name, const BenchMethodsOptions& options) {
    const SceneArgument argument = load_scene(
        name, {.surfaces = false, .crease_angle_rad = options.crease_angle_rad, .run = options.run});
    const Scene& scene = argument.scene;
    if (triangle_count(scene) == 0)
        throw InputError(name + ": nothing to compare methods on (0 triangles); give a scene with some");
    MethodsTruth truth =
        methods_truth(scene, scene.camera, options.size, kTruthRays, options.cache, options.run);
    SceneShown all{name, truth.radius, {}, {}};
    Progress progress(name, static_cast<long long>(ao_methods().size()));
    for (const Method& method : ao_methods()) {
        if (method.computes_ao())
            all.methods.push_back(shown(method, argument, truth, options.size, options.run));
        progress.advance(1);
    }
    all.truth = std::move(truth.reference);
    return all;
}

Table table_of(const std::vector<SceneShown>& scenes) {
    Table table{"methods", {"scene", "method", "rmse", "bias", "ao_ms", "blur_ms", "bake_ms"}, {}};
    for (const SceneShown& scene : scenes) {
        for (const MethodShown& m : scene.methods) {
            table.rows.push_back({scene.name, m.method->name, TableValue(m.error.squared.root(), 4),
                                  TableValue(m.error.bias, 4), TableValue(m.ao_ms, 2),
                                  TableValue(m.blur_ms, 2),
                                  m.bake_ms > 0 ? TableValue(m.bake_ms, 1) : TableValue()});
        }
    }
    return table;
}

std::string figure(const Picture& picture, const std::string& caption) {
    return "<div>" +
           image_element(png_bytes(picture.size, picture.channels, picture.pixels), picture.size, caption) +
           "<p>" + escape_html(caption) + "</p></div>\n";
}

std::string section(const MethodShown& m) {
    const std::string name = m.method->name;
    std::string time = decimal_text(m.ao_ms, 1) + " + " + decimal_text(m.blur_ms, 1) + " ms";
    if (m.bake_ms > 0) time += ", and once " + decimal_text(m.bake_ms, 0) + " ms for the bake";
    return "<h3>" + name + "</h3>\n<p>" + escape_html(m.method->title) + ". " + time + ".</p>\n" +
           "<div class=\"pictures row\">\n" + figure(m.raw, name + ", raw") +
           figure(m.denoised, m.method->denoiser.denoised ? "denoised" : "no denoiser: as it is") +
           figure(m.difference, "RMSE " + decimal_text(m.error.squared.root(), 3) + ", bias " +
                                    decimal_text(m.error.bias, 3)) +
           "</div>\n";
}

std::string section(const SceneShown& scene) {
    std::string html = "<h2>" + escape_html(scene.name) + "</h2>\n<div class=\"pictures row\">\n" +
                       figure(ao_picture(scene.truth.image.mean),
                              "truth: " + std::to_string(scene.truth.rays) + " rays a pixel, radius " +
                                  decimal_text(scene.radius, 3) + ", mean standard error " +
                                  decimal_text(scene.truth.mean_error, 4)) +
                       "</div>\n";
    for (const MethodShown& m : scene.methods) html += section(m);
    return html;
}

std::string page_of(const BenchReport& report, const std::vector<SceneShown>& scenes) {
    std::string body =
        "<h1>Every method, side by side</h1>\n" + facts_element(report.facts) +
        "<p>Each method with its defaults, but the radius of the truth: of the rays over a point, "
        "cosine-weighted, "
        "the share that meets nothing within it. What a method asks by itself may differ, in fade, weight or "
        "exponent, and is then a part of its error. Signed error: red too open, blue too closed, full colour "
        "at " +
        decimal_text(static_cast<double>(kDifferenceScale), 2) + " and beyond.</p>\n";
    for (const SceneShown& scene : scenes) body += section(scene);
    return html_page("crevice bench --methods", body + table_elements(report.tables));
}

}  // namespace

int bench_methods(const BenchMethodsOptions& options, std::ostream& out) {
    validate(options.run);
    std::vector<std::string> names = options.scenes;
    if (names.empty()) names.assign(std::begin(kSideBySideScenes), std::end(kSideBySideScenes));
    std::vector<SceneShown> scenes;
    for (const std::string& name : names) scenes.push_back(shown(name, options));
    BenchReport report{"methods", machine_facts(options.run), {table_of(scenes)}};
    report.facts.push_back({"size", size_text(options.size)});
    report.facts.push_back({"timed", "the AO pass and its denoiser, median of " + std::to_string(kRounds)});
    out << facts_text(report.facts) << "\n" << table_text(report.tables.front());
    if (options.out) {
        write_report(report, *options.out, out);
        const std::filesystem::path page = *options.out / "bench_methods.html";
        write_file_atomically(page, page_of(report, scenes));
        out << page.string() << "\n";
    }
    return static_cast<int>(ExitCode::done);
}

}  // namespace crevice
