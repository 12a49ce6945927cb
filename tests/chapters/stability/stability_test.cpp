// `crevice stability`: what is wrong comes out as wrong, and nothing is.
#include "chapters/stability/stability.h"

#include <fstream>
#include <iterator>
#include <set>

#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

#include "chapters/stability/rounding.h"
#include "chapters/stability/stiff_scenes.h"
#include "tests/tools/crevice_says.h"
#include "tests/tools/report_checks.h"
#include "tests/tools/scratch_directory.h"

using namespace crevice;

namespace {

StabilityVerdict verdict_on(const StiffCase& stiff, const char* method = "xjun") {
    return stability_cell(stiff, find_method(method), {}).verdict;
}

}  // namespace

TEST_CASE("stability: answers that do not hold come out as wrong, or warned where the frame warns") {
    CHECK(verdict_on({"corner", "a corner is not open", Answer::open, corner_view}) ==
          StabilityVerdict::wrong);
    CHECK(verdict_on({"others", "other views", Answer::same, corner_view, block_view}) ==
          StabilityVerdict::wrong);
    CHECK(verdict_on({"seen", "a corner is seen", Answer::background, corner_view}) ==
          StabilityVerdict::wrong);
    CHECK(verdict_on({"itself", "the same", Answer::same, corner_view, corner_view}) ==
          StabilityVerdict::exact);
    const auto far_corner = [] {
        StiffView view = moved(corner_view(), 4e6);  // where a step is half a unit
        return view;
    };
    CHECK(verdict_on({"far", "a corner far away is not open", Answer::open, far_corner}) ==
          StabilityVerdict::warned);
}

TEST_CASE("stability: refusals where they are stated, and surfaces where they must be") {
    const auto with_samples = [](const char* words) {
        StiffView view = block_view();
        view.params = {words};
        return view;
    };
    const auto none = [&] { return with_samples("samples=0"); };
    const auto one = [&] { return with_samples("samples=1"); };
    CHECK(verdict_on({"none", "no samples", Answer::refused, none}) == StabilityVerdict::exact);
    CHECK(verdict_on({"one", "a sample is no error", Answer::refused, one}) == StabilityVerdict::wrong);
    CHECK(verdict_on({"line", "refused, where a map is asked for", Answer::in_range, none}) ==
          StabilityVerdict::warned);
    const auto plane = [] { return tilted_plane_view(0); };
    CHECK(verdict_on({"full", "a plane fills the picture", Answer::open, plane, {}, 1.0}, "vbao") ==
          StabilityVerdict::exact);
    CHECK(verdict_on({"half", "it does not fill half of it", Answer::open, plane, {}, 0.5}, "vbao") ==
          StabilityVerdict::wrong);
}

TEST_CASE("stability: case names are unique words, and a quick run has some of each answer") {
    std::set<std::string> names;
    for (const StiffCase& stiff : stiff_cases(false)) {
        CAPTURE(stiff.name);
        CHECK(names.insert(stiff.name).second);
        CHECK(stiff.name.find(' ') == std::string::npos);
        CHECK(!stiff.question.empty());
        CHECK((stiff.answer == Answer::same) == static_cast<bool>(stiff.same_as));
    }
    std::set<Answer> answers;
    for (const StiffCase& stiff : stiff_cases(true)) {
        CHECK(names.count(stiff.name) == 1);
        answers.insert(stiff.answer);
    }
    CHECK(answers.size() == 5);
}

TEST_CASE("stability --quick: no method is wrong in silence, and each cell has its picture and command") {
    const ScratchDirectory scratch;
    const Outcome outcome = crevice_says("stability --quick --out '" + (scratch / "out").string() + "'");
    CAPTURE(outcome.text);
    CHECK(outcome.code == 0);
    CHECK(wrong_in_bench(scratch / "out", "stability", "stability.schema.json") == "");
    std::ifstream json(scratch / "out" / "bench_stability.json"), html(scratch / "out" / "stability.html");
    const nlohmann::json report = nlohmann::json::parse(json);
    std::size_t methods = 0;
    for (const Method& method : ao_methods()) methods += method.computes_ao() ? 1 : 0;
    const std::size_t cells = methods * stiff_cases(true).size();
    CHECK(report["tables"]["stability"].size() == cells);
    const std::string page((std::istreambuf_iterator<char>(html)), {});
    for (const nlohmann::json& row : report["tables"]["stability"]) {
        CHECK(row["verdict"] != "wrong");
        CHECK(page.find(row["command"].get<std::string>()) != std::string::npos);
        const std::string anchor = row["method"].get<std::string>() + "-" + row["case"].get<std::string>();
        CHECK(page.find("href=\"#" + anchor + "\"") != std::string::npos);
        CHECK(page.find("id=\"" + anchor + "\"") != std::string::npos);
        CHECK(!row["answer"].get<std::string>().empty());
    }
    CHECK(report["tables"]["rounding_methods"].size() ==
          methods * rounding_cases(true).size() * std::size(kRoundingCauses));
    CHECK(page.find("id=\"rounding\"") != std::string::npos);
    CHECK(crevice_says("stability --case no_such_case").code == 2);
    CHECK(crevice_says("stability --ao no_such_method").code == 2);
}
