// What `crevice bench --peers` makes of Embree's answers, and the real peer where it was built.
#include "chapters/bench/ray_peers.h"

#include <doctest/doctest.h>

#include <sys/stat.h>

#include <algorithm>
#include <fstream>
#include <sstream>

#include "chapters/terminal/child.h"
#include "rasterizer/base/error.h"
#include "tests/tools/error_message.h"
#include "tests/tools/report_checks.h"
#include "tests/tools/scratch_directory.h"

using namespace crevice;

namespace {

std::string trace_line(const std::string& length, const std::string& tracer, int threads, const char* ms) {
    return R"({"kind":"trace","length":)" + length + R"(,"tracer":")" + tracer + R"(","threads":)" +
           std::to_string(threads) + R"(,"rays":6000,"ms":)" + ms + R"(,"cpu_ms":)" + ms +
           R"(,"differing_embree1":3,"differing_embree8":5})";
}

std::string agreement_line(double same_rays, double own_rays) {
    return R"({"kind":"agreement","radius":"unbounded","points":10,"rays":640,"differing":1,"ours":0.5,)"
           R"("embree_same_rays":0.5,"embree_own_rays":0.51,"error":0.01,"same_rays_errors":)" +
           std::to_string(same_rays) + R"(,"own_rays_errors":)" + std::to_string(own_rays) +
           R"(,"point_rms_errors":1})";
}

const std::vector<std::string> kLines = {
    R"({"kind":"scene","triangles":12})",
    R"({"kind":"build","threads":1,"ours_ms":[2,2,2,2,2,2],"embree_ms":[5,5,5,5,5,5]})",
    trace_line("0.5", "ours", 1, "[3,3,3,3,3,3]"),
    trace_line("0.5", "ours_again", 1, "[3,3,3,3.3,3.3,3.3]"),
    trace_line("0.5", "embree1", 1, "[6,6,6,6,6,6]"),
    trace_line("0.5", "embree8", 1, "[1.5,1.5,1.5,1.5,1.5,1.5]"),
    trace_line("0.5", "ours", 2, "[2,2,2,2,2,2]"),
    trace_line("0.5", "ours_again", 2, "[2,2,2,2,2,2]"),
    trace_line("0.5", "embree1", 2, "[3,3,3,3,3,3]"),
    trace_line("0.5", "embree8", 2, "[1,1,1,1,1,1]"),
    agreement_line(0, 3.9),
    R"({"kind":"end"})"};

double number(const Table& table, std::size_t row, const std::string& column) {
    const auto at = std::find(table.columns.begin(), table.columns.end(), column);
    REQUIRE_MESSAGE(at != table.columns.end(), column);
    return table.rows.at(row).at(static_cast<std::size_t>(at - table.columns.begin())).number;
}

}  // namespace

TEST_CASE("answers become rates, paired ratios and verdicts") {
    const std::vector<Table> tables = ray_tables("box", kLines);
    REQUIRE(tables.size() == 4);
    for (const Table& table : tables) {
        CAPTURE(table.name);
        REQUIRE(!table.rows.empty());
        for (const auto& row : table.rows) CHECK(row.size() == table.columns.size());
    }
    const ScratchDirectory scratch;
    std::ostringstream told;
    write_report({"ray_peers", {{"compiler", ""}}, tables}, scratch.path(), told);
    CHECK(wrong_in_bench(scratch.path(), "ray_peers") == "");
    const Table &rays = tables[0], &threads = tables[1], &builds = tables[2], &agreement = tables[3];
    REQUIRE(rays.rows.size() == 2);
    CHECK(number(rays, 0, "ours_Mray/s") == 2);
    CHECK(number(rays, 0, "embree1_Mray/s") == 1);
    CHECK(number(rays, 0, "embree8_Mray/s") == 4);
    CHECK(number(rays, 0, "ours/embree1") == 2);
    CHECK(number(rays, 0, "ours/embree8") == 0.5);
    CHECK(number(rays, 1, "threads") == 2);
    CHECK(number(rays, 1, "ours_Mray/s") == 3);
    CHECK(number(rays, 0, "noise_low") == 1);
    CHECK(number(rays, 0, "noise_high") == doctest::Approx(1.1));
    CHECK(number(rays, 0, "unlike1") == 3);
    CHECK(number(rays, 0, "unlike8") == 5);
    CHECK(rays.rows[0][1].text == "0.5");
    CHECK(rays.rows[0][9].text == "met");
    CHECK(rays.rows[0][13].text == "missed");
    REQUIRE(threads.rows.size() == 3);
    CHECK(number(threads, 0, "ratio_to_1") == 1.5);
    CHECK(threads.rows[0].back().text == "missed");
    CHECK(number(threads, 1, "ratio_to_1") == 2);
    CHECK(threads.rows[1].back().kind == TableValue::Kind::nothing);
    CHECK(number(builds, 0, "embree/ours") == 2.5);
    CHECK(agreement.rows[0][1].text == "unbounded");
    CHECK(agreement.rows[0].back().text == "same");
}

TEST_CASE("means that are four standard errors apart are different, with either rays, either way") {
    for (const auto& errors : {std::pair{4.1, 0.0}, {-4.1, 0.0}, {0.0, 4.1}, {0.0, -4.1}}) {
        INFO(errors.first << ", " << errors.second);
        const std::vector<Table> tables = ray_tables("box", {agreement_line(errors.first, errors.second)});
        CHECK(tables[3].rows.at(0).back().text == "DIFFERENT");
    }
}

TEST_CASE("lines that are no answers are named") {
    const std::string bad[] = {"hello",
                               "",
                               "[1]",
                               "{}",
                               R"({"kind":1})",
                               R"({"kind":"trace","length":0.5})",
                               R"({"kind":"build","threads":1,"ours_ms":"2","embree_ms":[1]})"};
    for (const std::string& line : bad) {
        CAPTURE(line);
        const std::string message = message_of<InputError>([&] { ray_tables("box", {line}); });
        CHECK(message.find("not an answer (" + line) != std::string::npos);
        CHECK(message.find(';') != std::string::npos);
    }
    const std::string unpaired = message_of<InputError>([&] {
        ray_tables("box", {kLines[2], kLines[3], kLines[4]});
    });
    CHECK(unpaired.find("no times of embree8 at length 0.5") != std::string::npos);
}

TEST_CASE("without the peer there is a note and no failure; a peer that dies is an error") {
    RayPeersOptions options;
    options.program = "no_such_peer";
    std::ostringstream out;
    CHECK(bench_ray_peers(options, out) == 0);
    CHECK(out.str().find("libembree-dev") != std::string::npos);

    const ScratchDirectory scratch;
    options.program = scratch / "peer";
    std::ofstream(options.program) << "#!/bin/sh\necho '{\"kind\":\"scene\"}'\nexit 7\n";
    chmod(options.program.c_str(), 0700);
    const std::string message = message_of<InputError>([&] { bench_ray_peers(options, out); });
    CHECK(message.find("exit code 7") != std::string::npos);
}

TEST_CASE("a peer that finds another ambient occlusion fails the benchmark") {
    const ScratchDirectory scratch;
    RayPeersOptions options;
    options.program = scratch / "peer";
    std::ofstream script(options.program);
    script << "#!/bin/sh\ncat <<'END'\n";
    for (const std::string& line : kLines)
        script << (line == kLines[10] ? agreement_line(0, 5) : line) << "\n";
    script << "END\nsleep 5\n";
    script.close();
    chmod(options.program.c_str(), 0700);
    std::ostringstream out;
    CHECK(bench_ray_peers(options, out) == static_cast<int>(ExitCode::check_failed));
    CHECK(out.str().find("DIFFERENT") != std::string::npos);
}

TEST_CASE("Embree finds the same ambient occlusion") {
    RayPeersOptions options;
    options.program = std::filesystem::path(CREVICE_PROGRAM).parent_path() / "embree_peer";
    if (!std::filesystem::exists(options.program)) {
        MESSAGE("skipped: embree_peer was not built (libembree-dev)");
        return;
    }
    const ChildOutcome outcome =
        run_child({options.program,
                   {"columns_luna", "--rounds", "0", "--agreement-size", "96x54", "--agreement-rays", "64"},
                   {},
                   600});
    REQUIRE(outcome.exit_code == 0);
    std::vector<std::string> lines;
    std::istringstream output(outcome.output);
    for (std::string line; std::getline(output, line);) {
        // Its stderr is among them, where oneTBB warns on a machine of one processor.
        if (line.starts_with("{")) lines.push_back(line);
    }
    const Table agreement = ray_tables("columns_luna", lines)[3];
    REQUIRE(agreement.rows.size() == 1);
    CHECK(agreement.rows[0].back().text == "same");
    CHECK(number(agreement, 0, "points") > 1000);
    // Embree is not watertight: a ray in a million may slip through it.
    CHECK(number(agreement, 0, "unlike") <= 3);
    CHECK(number(agreement, 0, "point_rms_errors") > 0.9);
    CHECK(number(agreement, 0, "point_rms_errors") < 1.1);
}
