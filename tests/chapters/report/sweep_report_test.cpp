#include "chapters/report/sweep_report.h"

#include <cmath>
#include <fstream>
#include <sstream>

#include <doctest/doctest.h>

#include "chapters/report/report_summary.h"
#include "chapters/report/sweep_plots.h"
#include "chapters/report/sweep_tables.h"
#include "rasterizer/base/error.h"
#include "tests/tools/scratch_directory.h"
#include "tests/tools/synthetic_sweep.h"
#include "tests/tools/well_formed.h"

using namespace crevice;

namespace {

std::string file_text(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    REQUIRE_MESSAGE(file, path.string());
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

struct WrittenReport {
    ScratchDirectory directory;
    std::string html, markdown;

    explicit WrittenReport(const SweepResults& results) {
        write_sweep_report(results, directory.path());
        html = file_text(directory / "report.html");
        markdown = file_text(directory / "report.md");
    }
    // Each plot is a picture by itself, and both texts show or name it.
    int plots() const {
        int count = 0;
        for (const auto& entry : std::filesystem::directory_iterator(directory / "plots")) {
            CAPTURE(entry.path().string());
            const std::string svg = file_text(entry.path());
            CHECK(xml_fault(svg) == "");
            CHECK(svg.find("var(") == std::string::npos);
            CHECK(svg.find("nan") == std::string::npos);
            CHECK(svg.find("inf") == std::string::npos);
            CHECK(markdown.find("plots/" + entry.path().filename().string()) != std::string::npos);
            ++count;
        }
        return count;
    }
};

bool says(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

std::size_t count_of(const std::string& text, const std::string& part) {
    std::size_t count = 0;
    for (std::size_t at = text.find(part); at != text.npos; at = text.find(part, at + 1)) ++count;
    return count;
}

// One view, one thread: a setting that is slower and worse than another.
SweepResults with_dominated_setting() {
    SweepResults results;
    const auto add = [&](int samples, double rmse, double ms) {
        results.errors.push_back(synthetic_error(kSmallView, with_samples("xjun", samples), rmse, 0.001));
        results.times.push_back(synthetic_time(kSmallView, with_samples("xjun", samples), 1, ms));
    };
    add(1, 0.1, 1);
    add(2, 0.2, 2);
    add(4, 0.05, 4);
    return results;
}

}  // namespace

TEST_CASE("write_sweep_report: a whole plan, as page, Markdown and plots") {
    const SweepResults results = synthetic_sweep();
    const WrittenReport report(results);
    // Of three views: five measures at one and two threads, samples, parts; cost over four variables.
    CHECK(report.plots() == 3 * (2 * 5 + 2) + 4);
    for (const char* const part : {"columns, 640x360", "columns, 1280x720", "cornell, 640x360",
                                   "Equal time and equal error, 2 threads", "crevice sweep quick",
                                   "crevice render columns --ao gtao --param samples=8 --param ao_scale=0.5",
                                   "On 1 thread.", "The plan"}) {
        CAPTURE(part);
        CHECK(says(report.html, part));
        CHECK(says(report.markdown, part));
    }
    CHECK_FALSE(says(report.html, "This sweep is not whole"));
    for (const char* const foreign : {"src=\"http", "href=\"http", "url(http", "src=\"//"}) {
        CAPTURE(foreign);
        CHECK_FALSE(says(report.html, foreign));
    }
    CHECK(count_of(report.html, "type=\"radio\"") == 3 * 2 * 5);
    CHECK(count_of(report.html, " checked>") == 3 * 2);
    // The same results give the same bytes.
    const WrittenReport again(results);
    CHECK(again.html == report.html);
    CHECK(again.markdown == report.markdown);
}

TEST_CASE("write_sweep_report: every point of a plot is a row of its view's table") {
    const SweepResults results = synthetic_sweep();
    for (const ViewFigures& view : view_figures(results)) {
        const TableOutput table = points_table(view);
        for (const int threads : view.threads) {
            for (const ErrorPoint& point : error_points(view, threads, kErrorMeasures[0])) {
                CAPTURE(point.name);
                REQUIRE(point.name.starts_with(view.id + "-"));
                const auto row = static_cast<std::size_t>(std::stoi(point.name.substr(view.id.size() + 1)));
                REQUIRE(row < table.rows.size());
                CHECK(table.rows[row][0].en == point.method);
                CHECK(table.rows[row][1].en == point.setting);
                CHECK(table.rows[row][2].en == std::to_string(threads));
            }
        }
    }
}

TEST_CASE("error over time: a dominated setting is off the line and off the front, and A/A is drawn") {
    SweepResults results = with_dominated_setting();
    results.times.front().same_again = MedianInterval{1, 0.95, 1.1, 0.96};
    const ViewFigures view = view_figures(results)[0];
    const std::string svg = error_over_time(view, 1, methods_of(results))[0].svg.en;
    CHECK(count_of(svg, "r=\"3.0\"") == 3);
    CHECK(count_of(svg, "r=\"6.0\"") == 2);
    CHECK(says(svg, "A/A: the same again, 0.95 to 1.10 times"));
    CHECK(says(svg, "noise of the reference, 0.01"));
    const auto best = best_of_each(error_points(view, 1, kErrorMeasures[0]));
    REQUIRE(best.size() == 2);
    CHECK(best[0].setting == "1 sample");
    CHECK(best[1].setting == "4 samples");
}

TEST_CASE("write_sweep_report: what is missing and what is broken stands first") {
    SweepResults results = with_dominated_setting();
    results.missing = {"the error of gtao_x with <i>4</i> samples"};
    results.errors[1].nan_or_inf = 17;
    const WrittenReport report(results);
    const std::size_t missing =
                          report.html.find("This sweep is not whole.</strong> 1 job of its plan is missing"),
                      broken = report.html.find("1 image is broken"), facts = report.html.find("made by");
    REQUIRE(missing != std::string::npos);
    REQUIRE(broken != std::string::npos);
    CHECK(missing < broken);
    CHECK(broken < facts);
    CHECK(says(report.html, "gtao_x with &lt;i&gt;4&lt;/i&gt; samples"));
    CHECK(says(report.html, "xjun with 2 samples, seed 1, on columns, 640x360: 17 pixels"));
    CHECK(report.plots() > 0);
    results.missing.push_back("another");
    CHECK(says(WrittenReport(results).html, "2 jobs of its plan are missing"));
    results.missing.resize(25, "one of many");
    const std::string many = WrittenReport(results).markdown;
    CHECK(says(many, "25 jobs of its plan are missing"));
    CHECK(count_of(many, "- one of many\n") == 18);
    CHECK(says(many, "- and 5 more\n"));
}

TEST_CASE("write_sweep_report: no times, one point, nothing at all") {
    SweepResults results = with_dominated_setting();
    results.times.clear();
    const WrittenReport errors_only(results);
    CHECK(says(errors_only.html, "Nothing was timed, so that there are errors only."));
    CHECK_FALSE(says(errors_only.html, "type=\"radio\""));
    CHECK(errors_only.plots() == 2);
    results = with_dominated_setting();
    results.errors.resize(1);
    results.times.resize(1);
    const WrittenReport one(results);
    CHECK(one.plots() == 5 + 1);
    CHECK(says(one.html, "Samples were not varied by this plan."));
    CHECK(says(one.markdown, "not varied by this plan"));
    CHECK(says(one.markdown, "Not measured by this plan."));  // on two threads
    const WrittenReport nothing{SweepResults{}};
    CHECK(nothing.plots() == 0);
    CHECK(says(nothing.html, "There are no results: no job of the plan is done yet."));
    results.errors.clear();
    CHECK(says(WrittenReport(results).html, "No image was judged, so that there are times only."));
}

TEST_CASE("write_sweep_report: an error whose own error is not known has no bar") {
    SweepResults results = with_dominated_setting();
    for (SweepErrorResult& error : results.errors) error.soft.rmse_error = error.hard.rmse_error = INFINITY;
    const WrittenReport timed(results);
    CHECK(timed.plots() == 5 + 2 + 1);
    CHECK(says(timed.markdown, "an RMSE of 0.0500 ± unknown in 4 ms"));
    results.times.clear();
    const WrittenReport untimed(results);
    CHECK(untimed.plots() == 2);
    CHECK(says(untimed.markdown, "an RMSE of 0.0500 ± unknown"));
    CHECK_FALSE(says(untimed.markdown, "inf "));
}

TEST_CASE("write_sweep_report: intervals of too few repetitions are said to hold less") {
    SweepResults results = with_dominated_setting();
    CHECK_FALSE(says(WrittenReport(results).markdown, "Too few repetitions"));
    results.times[1].passes[0].wall.confidence = 0.75;
    CHECK(says(WrittenReport(results).markdown, "hold only 75 %, not 95 %"));
    results.times[1].same_again = MedianInterval{1, 1, 1, 0};
    CHECK(says(WrittenReport(results).markdown, "hold nothing, not 95 %"));
}

TEST_CASE("sweep_command: a plan is built in where it is the same, whatever its name") {
    SweepResults results = synthetic_sweep();
    CHECK(sweep_command(results) == "crevice sweep quick && crevice merge out/sweep_quick");
    results.plan_text += " ";
    CHECK(sweep_command(results) == "crevice sweep plan.json && crevice merge out/sweep_quick");
    results.plan = "mine";
    CHECK(sweep_command(results) == "crevice sweep plan.json && crevice merge out/sweep_mine");
}

TEST_CASE("write_sweep_report: a directory that cannot be made is an output error") {
    const ScratchDirectory scratch;
    std::ofstream(scratch / "file") << "x";
    CHECK_THROWS_AS(write_sweep_report(synthetic_sweep(), scratch / "file"), OutputError);
}
