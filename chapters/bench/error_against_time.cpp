#include "chapters/bench/error_against_time.h"

#include <algorithm>
#include <functional>
#include <memory>
#include <ostream>

#include "chapters/bench/error_page.h"
#include "chapters/bench/machine.h"
#include "chapters/terminal/number_text.h"
#include "chapters/terminal/progress.h"
#include "rasterizer/base/error.h"
#include "rasterizer/base/write_file.h"

namespace crevice {

namespace {

// The chain of each error is long: the demo shows that of the two tutorials alone.
constexpr std::size_t kQuickChains = 2;

// Every method against one truth, each point whole.
Table methods_table(const MethodsStudy& study) {
    Table table{"error_methods",
                {"method", "setting", "time_ms", "time_mad_ms", "runs", "truth_rmse", "lowest", "highest",
                 "standard_error", "truth_bias"},
                {}};
    for (const StudyPoint& p : study.points) {
        table.rows.push_back(
            {p.method, p.setting, TableValue(p.time.wall_ms, 3), TableValue(p.time.wall_ms_mad, 3),
             TableValue(p.time.runs, 0), TableValue(p.truth.rmse, 5), TableValue(p.truth.lowest, 5),
             TableValue(p.truth.highest, 5), TableValue(p.truth.error, 5), TableValue(p.truth.bias, 5)});
    }
    return table;
}

// Every point of a study, whole.
Table point_table(const ErrorStudy& study) {
    Table table{std::string("error_points_") + study.method->name,
                {"method", "setting", "time_ms", "time_mad_ms", "runs", "truth_rmse", "lowest", "highest",
                 "standard_error", "truth_bias", "screen_rmse", "limit_rmse", "truth_rmse_fitted_power"},
                {}};
    for (const StudyPoint& p : study.points) {
        table.rows.push_back(
            {p.method, p.setting, TableValue(p.time.wall_ms, 3), TableValue(p.time.wall_ms_mad, 3),
             TableValue(p.time.runs, 0), TableValue(p.truth.rmse, 5), TableValue(p.truth.lowest, 5),
             TableValue(p.truth.highest, 5), TableValue(p.truth.error, 5), TableValue(p.truth.bias, 5),
             TableValue(p.screen.rmse, 5), p.limit ? TableValue(p.limit->rmse, 5) : TableValue(),
             p.fitted_rmse ? TableValue(*p.fitted_rmse, 5) : TableValue()});
    }
    return table;
}

Table part_table(const ErrorStudy& study) {
    Table table{
        std::string("error_parts_") + study.method->name, {"step", "bias", "rmse_alone", "share_of_mse"}, {}};
    for (const ErrorPart& part : study.parts.parts)
        table.rows.push_back(
            {part.step, TableValue(part.bias, 6), TableValue(part.rmse, 6), TableValue(part.share, 8)});
    const ErrorPart& total = study.parts.total;
    table.rows.push_back(
        {"total", TableValue(total.bias, 6), TableValue(total.rmse, 6), TableValue(total.share, 8)});
    return table;
}

Table reference_table(const ErrorStudy& study) {
    Table table{std::string("error_references_") + study.method->name,
                {"reference", "rays_or_seeds", "mean", "mean_standard_error", "max_standard_error"},
                {}};
    const std::pair<const char*, const Reference*> references[] = {{"truth", &study.references.soft},
                                                                   {"screen", &study.references.screen},
                                                                   {"limit", &study.references.limit}};
    for (const auto& [name, r] : references) {
        table.rows.push_back({name, TableValue(static_cast<double>(r->rays), 0), TableValue(r->mean, 5),
                              TableValue(r->mean_error, 6), TableValue(r->max_error, 6)});
    }
    return table;
}

Facts facts_of(const BenchErrorOptions& options, const std::vector<ErrorStudy>& studies) {
    const ErrorPlan& plan = studies.front().plan;
    Facts facts = machine_facts(options.run);
    facts.push_back({"scene", options.scene});
    facts.push_back({"size", std::to_string(plan.size.width) + "x" + std::to_string(plan.size.height)});
    facts.push_back({"seeds", counted(plan.seeds, "image") + " of each setting"});
    facts.push_back(
        {"timed", "the AO pass and its blur; the rays of ray casting; the rays of a bake; median of " +
                      counted(plan.rounds, "round") + " in turns (" + std::to_string(plan.slow_rounds) +
                      " above " + decimal_text(kSlow_ms, 0) + " ms)"});
    for (const ErrorStudy& study : studies) {
        const std::string name = study.method->name;
        std::string fitted = decimal_text(study.fitted_exponent, 3) + ", fitted on";
        for (const std::string& scene : study.fitted_on) fitted += " " + scene;
        facts.push_back({name + ", radius", decimal_text(study.cast.radius, 3) + " scene units"});
        facts.push_back({name + ", power", fitted});
        facts.push_back(
            {name + ", apart", "G-buffer and points " + decimal_text(study.references.points_ms, 1) +
                                   " ms, both trees " + decimal_text(study.references.build_ms, 1) + " ms"});
    }
    return facts;
}

// A bar for each stage of a study.
class StageBars {
 public:
    explicit StageBars(std::string of) : of_(std::move(of)) {}
    void operator()(const char* stage, long long done, long long total) {
        if (shown_ != stage) {
            bar_ = nullptr;
            bar_ = std::make_unique<Progress>(of_ + " " + stage, total);
            shown_ = stage;
            last_ = 0;
        }
        bar_->advance(done - last_);
        last_ = done;
    }

 private:
    std::string of_, shown_;
    std::unique_ptr<Progress> bar_;
    long long last_ = 0;
};

}  // namespace

std::vector<ErrorPoint> points_against_truth(std::span<const StudyPoint> of) {
    std::vector<ErrorPoint> points;
    for (const StudyPoint& p : of)
        points.push_back({p.method, p.setting, p.time.wall_ms, p.truth.rmse, p.truth.lowest, p.truth.highest,
                          std::max(0.0, p.time.wall_ms - p.time.wall_ms_mad),
                          p.time.wall_ms + p.time.wall_ms_mad});
    return points;
}

int bench_error(const BenchErrorOptions& options, std::ostream& out) {
    validate(options.run);
    const SceneArgument argument =
        load_scene(options.scene, {.surfaces = false, .crease_angle_rad = options.crease_angle_rad});
    if (triangle_count(argument.scene) == 0)
        throw InputError(options.scene + ": no error to measure (0 triangles); give a scene with some");
    const Camera camera = chosen_camera(argument, options.camera);
    std::vector<ErrorStudy> studies;
    BenchReport report{"error", {}, {}};
    MethodsPlan together = options.quick ? quick_methods_plan() : full_methods_plan();
    if (options.size) together.size = *options.size;
    StageBars all_bars("all methods");
    const MethodsStudy all =
        methods_study(argument.scene, camera, together, options.cache, true, options.run, std::ref(all_bars));
    const std::vector<ErrorPoint> all_points = points_against_truth(all.points);
    report.tables = {methods_table(all), equal_time_table(all_points, kBudgets_ms),
                     equal_error_table(all_points, kErrorLevels)};
    for (const Method& method : ao_methods()) {
        if (!method.computes_ao()) continue;
        if (options.quick && studies.size() == kQuickChains) break;
        ErrorPlan plan = options.quick ? quick_error_plan(method) : full_error_plan(method);
        if (options.size) plan.size = *options.size;
        StageBars bars(method.name);
        studies.push_back(error_study(argument.scene, camera, method, plan, options.cache, true, options.run,
                                      std::ref(bars)));
        const ErrorStudy& study = studies.back();
        const std::vector<ErrorPoint> points = points_against_truth(study.points);
        report.tables.push_back(reference_table(study));
        report.tables.push_back(point_table(study));
        for (Table table : {equal_time_table(points, kBudgets_ms), equal_error_table(points, kErrorLevels)}) {
            table.name += std::string("_") + method.name;
            report.tables.push_back(std::move(table));
        }
        report.tables.push_back(part_table(study));
    }
    report.facts = facts_of(options, studies);
    out << facts_text(report.facts);
    for (const Table& table : report.tables) out << "\n" << table.name << "\n" << table_text(table);
    if (options.out) {
        write_report(report, *options.out, out);
        const std::filesystem::path page = *options.out / "bench_error.html";
        write_file_atomically(page, error_page(report, all, studies));
        out << page.string() << "\n";
    }
    return static_cast<int>(ExitCode::done);
}

}  // namespace crevice
