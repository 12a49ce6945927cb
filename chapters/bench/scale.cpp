#include "chapters/bench/scale.h"

#include <algorithm>
#include <cmath>
#include <ostream>

#include "chapters/bench/machine.h"
#include "chapters/bench/scale_page.h"
#include "chapters/bench/threads.h"
#include "chapters/study/statistics.h"
#include "chapters/terminal/number_text.h"
#include "chapters/terminal/progress.h"
#include "rasterizer/base/error.h"
#include "rasterizer/base/write_file.h"

namespace crevice {

namespace {

constexpr const char* kPassesShown[] = {"normal_depth", "ao", "blur", "lit", "frame"};
constexpr double kMegabyte = 1e6;

double pixels_of(Size size) { return double{1} * size.width * size.height; }

ScaleStudy pixel_study(const ScaleOptions& options) {
    ScaleStudy study{"pixels", {}, {}, {}};
    for (const Size size : {Size{64, 36}, Size{128, 72}, Size{320, 180}, Size{640, 360}, Size{1280, 720},
                            Size{1920, 1080}, Size{3840, 2160}, kLargestPicture}) {
        if (options.quick && size.width > 1920) continue;
        study.points.push_back({.size = size, .cells = {}, .threads = options.threads});
        study.x.push_back(pixels_of(size));
    }
    return study;
}

ScaleStudy triangle_study(const ScaleOptions& options) {
    ScaleStudy study{"triangles", {}, {}, {}};
    for (const Size cells : {Size{2, 3}, Size{16, 16}, Size{71, 71}, Size{224, 224}, Size{500, 500},
                             Size{1000, 1000}, Size{2237, 2236}}) {
        if (options.quick && cells.width > 500) continue;
        study.points.push_back({.cells = cells, .threads = options.threads});
        study.x.push_back(2 * pixels_of(cells));
    }
    return study;
}

ScaleStudy sample_study(const ScaleOptions& options) {
    ScaleStudy study{"samples", {}, {}, {}};
    for (const int samples : {1, 2, 4, 7, 10, 14}) {
        study.points.push_back({.cells = {}, .samples = samples, .threads = options.threads});
        study.x.push_back(samples);
    }
    return study;
}

std::vector<ScaleStudy> measured_studies(const ScaleOptions& options) {
    std::vector<ScaleStudy> studies = {pixel_study(options), triangle_study(options), sample_study(options)};
    long long points = 0;
    for (const ScaleStudy& study : studies) points += static_cast<long long>(study.points.size());
    Progress progress("scale", points);
    for (ScaleStudy& study : studies) {
        for (const BenchPoint& point : study.points) {
            study.figures.push_back(measure_apart(point));
            progress.advance();
        }
    }
    return studies;
}

Table point_table(const std::vector<ScaleStudy>& studies) {
    Table table{"scale", {"study", "size", "triangles", "samples"}, {}};
    for (const char* pass : kPassesShown) table.columns.push_back(std::string(pass) + "_ms");
    for (const char* more : {"frame_mad", "peak_MB"}) table.columns.push_back(more);
    for (const ScaleStudy& study : studies) {
        for (std::size_t i = 0; i < study.points.size(); ++i) {
            const BenchPoint& point = study.points[i];
            const PointFigures& figures = study.figures[i];
            std::vector<TableValue> row = {
                study.name, std::to_string(point.size.width) + "x" + std::to_string(point.size.height),
                TableValue(figures.triangles, 0), TableValue(point.samples, 0)};
            for (const char* pass : kPassesShown) row.push_back(TableValue(study.wall_ms(pass)[i], 3));
            row.push_back(TableValue(figures.passes.back().wall_ms_mad, 3));
            row.push_back(TableValue(figures.peak_bytes / kMegabyte, 1));
            table.rows.push_back(std::move(row));
        }
    }
    return table;
}

Table memory_table(const MemoryNeed& need) {
    const TableValue limit(kMemoryLimit_bytes / kMegabyte, 0);
    return {"scale_memory",
            {"what", "value", "error", "limit"},
            {{"bytes per pixel", TableValue(need.bytes_per_pixel, 1),
              TableValue(need.bytes_per_pixel_error, 1), TableValue()},
             {"bytes per triangle", TableValue(need.bytes_per_triangle, 1),
              TableValue(need.bytes_per_triangle_error, 1), TableValue()},
             {std::string("MB at 7680x4320, ") + (need.measured ? "measured" : "from the line"),
              TableValue(need.largest_picture_bytes / kMegabyte, 0), TableValue(), limit}}};
}

}  // namespace

std::vector<double> ScaleStudy::wall_ms(const std::string& pass) const {
    std::vector<double> times;
    for (const PointFigures& point : figures) {
        const auto at = std::find_if(point.passes.begin(), point.passes.end(),
                                     [&](const PassTime& time) { return time.name == pass; });
        times.push_back(at == point.passes.end() ? 0 : at->wall_ms);
    }
    return times;
}

std::vector<double> ScaleStudy::peak_bytes() const {
    std::vector<double> bytes;
    for (const PointFigures& point : figures) bytes.push_back(point.peak_bytes);
    return bytes;
}

Table exponent_table(const std::vector<ScaleStudy>& studies) {
    Table table{"scale_exponents", {"study", "pass", "exponent", "error", "between_largest_two"}, {}};
    for (const ScaleStudy& study : studies) {
        for (const char* pass : kPassesShown) {
            const std::vector<double> y = study.wall_ms(pass);
            if (std::any_of(y.begin(), y.end(), [](double ms) { return !(ms > 0); })) continue;
            const PowerLaw all = fitted_power_law(study.x, y);
            const PowerLaw last = fitted_power_law(std::span(study.x).last(2), std::span(y).last(2));
            table.rows.push_back({study.name, pass, all.exponent, all.exponent_error, last.exponent});
        }
    }
    return table;
}

MemoryNeed memory_need(const ScaleStudy& pixels, const ScaleStudy& triangles) {
    const Line per_pixel = fitted_line(pixels.x, pixels.peak_bytes()),
               per_triangle = fitted_line(triangles.x, triangles.peak_bytes());
    MemoryNeed need{
        per_pixel.slope, per_pixel.slope_error, per_triangle.slope, per_triangle.slope_error, 0, false};
    const double largest = pixels_of(kLargestPicture);
    need.measured = pixels.x.back() == largest;
    need.largest_picture_bytes =
        need.measured ? pixels.peak_bytes().back() : per_pixel.intercept + per_pixel.slope * largest;
    return need;
}

int bench_scale(const ScaleOptions& options, std::ostream& out) {
    Run run;
    run.threads = options.threads;
    validate(run);
    const std::vector<ScaleStudy> studies = measured_studies(options);
    const MemoryNeed need = memory_need(studies[0], studies[1]);
    BenchReport report{"scale",
                       machine_facts(run),
                       {point_table(studies), exponent_table(studies), memory_table(need), thread_table()}};
    out << facts_text(report.facts);
    for (const Table& table : report.tables) out << "\n" << table_text(table);
    for (const ScaleStudy& study : studies) {
        for (const PointFigures& figures : study.figures) {
            const std::string note = busy_note(figures.passes.back(), thread_count(run));
            if (!note.empty())
                out << study.name << ", " << counted(static_cast<long long>(figures.triangles), "triangle")
                    << ": " << note << "\n";
        }
    }
    const bool fits = need.largest_picture_bytes < kMemoryLimit_bytes;
    if (!fits) out << "7680x4320 needs more than " << kMemoryLimit_bytes / kMegabyte << " MB.\n";
    if (options.out) {
        write_report(report, *options.out, out);
        const std::filesystem::path page = *options.out / "bench_scale.html";
        write_file_atomically(page, scale_page(report, studies));
        out << page.string() << "\n";
    }
    return static_cast<int>(fits ? ExitCode::done : ExitCode::check_failed);
}

}  // namespace crevice
