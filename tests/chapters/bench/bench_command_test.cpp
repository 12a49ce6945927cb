// `crevice bench` as a user meets it, and what its scale measurements rest on. No test looks at a time.
#include <doctest/doctest.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>

#include <glm/geometric.hpp>

#include <nlohmann/json.hpp>

#include "chapters/bench/height_field.h"
#include "chapters/bench/machine.h"
#include "chapters/bench/scale.h"
#include "chapters/frame/frame.h"
#include "chapters/terminal/child.h"
#include "rasterizer/base/error.h"
#include "tests/tools/report_checks.h"
#include "tests/tools/scratch_directory.h"

using namespace crevice;

namespace {

ChildOutcome bench(std::vector<std::string> arguments, std::vector<std::string> environment = {}) {
    arguments.insert(arguments.begin(), "bench");
    return run_child({CREVICE_PROGRAM, arguments, environment, 120});
}

}  // namespace

TEST_CASE("a wrong word is refused with exit code 2 and a line that names it") {
    struct Mistake {
        std::vector<std::string> arguments;
        const char* named;
    };
    const Mistake mistakes[] = {
        {{"--peers", "--pairs", "14"}, "14"},
        {{"--peers", "--pairs", "1000"}, "1000"},
        {{"--peers", "--pairs", "many"}, "many"},
        {{"--peers", "--size", "319x180"}, "319x180"},
        {{"--peers", "--size", "x"}, "--size"},
        {{"--peers", "--scale"}, "one at a time"},
        {{"--peers", "columns"}, "SCENE"},
        {{"--peers", "--quick"}, "--quick"},
        {{"--peers", "--scene", "no_such_scene"}, "no_such_scene"},
        {{"--peers", "--eye", "1"}, "--eye"},
        {{"--peers", "--preset", "moon"}, "moon"},
        {{"--peers", "--preset", "luna", "--scene", "columns"}, "--preset"},
        {{"--peers", "--preset", "luna", "--ao", "luna"}, "--preset"},
        {{"--peers", "--preset", "learnopengl"}, "point lights"},
        {{"--peers", "--preset", "xjun2022_published"},
         "the peer has no integer depth; choose another scene, --preset or --ao"},
        {{"--peers", "--ao", "hbao"}, "hbao"},
        {{"--preset", "luna"}, "--preset"},
        {{"--scale", "--size", "320x180"}, "--size"},
        {{"--scale", "--eye", "1,2,3"}, "--eye"},
        {{"--instructions", "--pairs", "21"}, "--pairs"},
        {{"--scene", "columns"}, "--scene"},
        {{"--bless"}, "--bless"},
        {{"--figures", "x"}, "--figures"},
        {{"--threads", "-1"}, "--threads"},
        {{"--threads", "two"}, "two"},
        {{"--point", "320x180,columns,14,1"}, "--point"},
        {{"--point", "320x180,columns,15,1,1"}, "15"},
        {{"--point", "320x180,10001x1,14,1,1"}, "10001"},
        {{"--pears"}, "--pears"},
    };
    for (const Mistake& mistake : mistakes) {
        const ChildOutcome outcome = bench(mistake.arguments);
        CAPTURE(mistake.arguments.back());
        CAPTURE(outcome.output);
        CHECK(outcome.exit_code == 2);
        CHECK(outcome.output.find(mistake.named) != std::string::npos);
        CHECK(std::count(outcome.output.begin(), outcome.output.end(), '\n') == 1);
    }
}

TEST_CASE("what is missing is named, with exit code 3") {
    const ScratchDirectory scratch;
    CHECK(bench({"no_such_scene"}).exit_code == 2);
    CHECK(bench({"--scale", "--out", "/dev/null/no"}).exit_code == 4);
    const std::string figures = (scratch / "none.json").string();
    const ChildOutcome no_figures = bench({"--instructions", "--figures", figures});
    CHECK(no_figures.exit_code == 3);
    CHECK(no_figures.output.find(figures) != std::string::npos);

    std::ofstream(figures) << R"({"compiler": "x", "instructions": {}})";
    const ChildOutcome no_valgrind =
        bench({"--instructions", "--figures", figures}, {"PATH=" + scratch.path().string()});
    CHECK(no_valgrind.exit_code == 3);
    CHECK(no_valgrind.output.find("package valgrind") != std::string::npos);
    CHECK(bench({"--instructions", "--bless", "--figures", figures}, {"CI=1"}).exit_code == 2);
}

TEST_CASE("plain bench: a table on the terminal, as CSV and as JSON") {
    const ScratchDirectory scratch;
    const ChildOutcome outcome =
        bench({"cornell", "--size", "64x36", "--threads", "1", "--out", (scratch / "out").string()});
    CAPTURE(outcome.output);
    REQUIRE(outcome.exit_code == 0);
    CHECK(outcome.output.find("cornell") != std::string::npos);
    std::ifstream file(scratch / "out" / "bench_frames.json");
    const auto row = nlohmann::json::parse(file).at("tables").at("frames").at(0);
    for (const char* column :
         {"normal_depth_ms", "ao_ms", "blur_ms", "lit_ms", "frame_ms", "load_ms", "start_up_ms"}) {
        CAPTURE(column);
        CHECK(row.at(column).get<double>() > 0);
    }
    CHECK(wrong_in_bench(scratch / "out", "frames") == "");
}

TEST_CASE("bench --left-out: its tables are as the schema has them") {
    const ScratchDirectory scratch;
    const std::string out = (scratch / "out").string();
    bench({"--left-out", "cornell", "--size", "64x36", "--threads", "1", "--out", out});
    CHECK(wrong_in_bench(out, "left_out") == "");
}

TEST_CASE("a point is measured in a program of its own and comes back whole") {
    const BenchPoint point{.size = {64, 36}, .cells = {3, 2}, .samples = 2, .threads = 1, .frames = 1};
    CHECK(point_word(point_from_word(point_word(point))) == point_word(point));
    const ChildOutcome outcome = bench({"--point", point_word(point)});
    REQUIRE(outcome.exit_code == 0);
    const PointFigures figures = figures_from_json(outcome.output);
    CHECK(figures.triangles == 12);
    CHECK(figures.peak_bytes > 1e6);
    CHECK(figures.passes.back().name == "frame");
    CHECK(figures_json(figures) + "\n" == outcome.output);
    CHECK_THROWS_AS(figures_from_json("{}"), InputError);
    CHECK_THROWS_AS(figures_from_json("Segmentation fault"), InputError);
}

TEST_CASE("height_field_scene: as many triangles as asked for, hills that face up and fill the picture") {
    for (const Size cells : {Size{2, 3}, Size{40, 25}}) {
        const Scene scene = height_field_scene(cells.width, cells.height);
        CAPTURE(cells.width);
        CHECK(triangle_count(scene) == static_cast<std::size_t>(2 * cells.width * cells.height));
        const Mesh& mesh = scene.meshes.front();
        for (const auto& t : mesh.triangles) {
            const glm::vec3 a = mesh.positions[t[0]],
                            face = glm::cross(mesh.positions[t[1]] - a, mesh.positions[t[2]] - a);
            CHECK(face.y > 0);
            CHECK(mesh.normals[t[0]].y > 0);
        }
        const GBuffer gbuffer = normal_depth(scene, scene.camera, {64, 36});
        int bare = 0;
        for (int y = 0; y < 36; ++y) {
            for (int x = 0; x < 64; ++x) bare += gbuffer.view_depth.at(x, y) < 100 ? 0 : 1;
        }
        CHECK(bare == 0);
    }
    CHECK_THROWS_AS(height_field_scene(0, 5), UsageError);
    CHECK_THROWS_AS(height_field_scene(5, kMostCells + 1), UsageError);
}

TEST_CASE("scale tables: exact laws give their exponents, bytes their slopes, 8K its need") {
    ScaleStudy pixels{"pixels", {1e4, 1e5, 1e6}, {}, {}}, triangles{"triangles", {10, 1000}, {}, {}};
    for (const double x : pixels.x)
        pixels.figures.push_back(
            {18000, 5e6 + 50 * x, {{"ao", 1e-5 * x, 0, 0, 15}, {"frame", 2e-5 * x, 0, 0, 15}}});
    for (const double x : triangles.x)
        triangles.figures.push_back({x, 4e7 + 80 * x, {{"frame", 3, 0, 0, 15}}});
    const Table table = exponent_table({pixels, triangles});
    REQUIRE(table.rows.size() == 3);
    CHECK(table.rows[0][2].number == doctest::Approx(1));
    CHECK(table.rows[0][4].number == doctest::Approx(1));
    CHECK(table.rows[2][2].number == doctest::Approx(0));
    const MemoryNeed need = memory_need(pixels, triangles);
    CHECK(need.bytes_per_pixel == doctest::Approx(50));
    CHECK(need.bytes_per_triangle == doctest::Approx(80));
    CHECK(need.largest_picture_bytes == doctest::Approx(5e6 + 50.0 * 7680 * 4320));
    CHECK(!need.measured);
}

TEST_CASE("a figure comes with the machine it was measured on") {
    const Facts facts = machine_facts({});
    for (const char* name : {"cpu", "compiler", "threads", "isa"}) {
        CAPTURE(name);
        CHECK(std::any_of(facts.begin(), facts.end(),
                          [&](const auto& fact) { return fact.first == name && !fact.second.empty(); }));
    }
    CHECK(peak_memory_bytes() > 1e6);
    CHECK(busy_note({"frame", 10, 19.9, 0, 15}, 2).empty());
    CHECK(busy_note({"frame", 10, 10, 0, 15}, 2).find("50 %") != std::string::npos);
    CHECK(busy_note({"frame", 1, 1, 0, 15}, 2).empty());
}
