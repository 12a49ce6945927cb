#include "chapters/report/scene_paragraph.h"

#include <doctest/doctest.h>

#include "tests/tools/synthetic_sweep.h"

using namespace crevice;

namespace {

constexpr double kStandardError = 0.001;

// Settings with times on one thread; the first one's twin was as fast as within 3 %.
struct Timed {
    SweepSetting setting;
    double rmse = 0, ms = 0;
};

SweepResults timed(const std::vector<Timed>& all) {
    SweepResults results;
    for (const Timed& one : all) {
        results.errors.push_back(synthetic_error(kSmallView, one.setting, one.rmse, kStandardError));
        results.times.push_back(synthetic_time(kSmallView, one.setting, 1, one.ms));
    }
    if (!all.empty()) results.times.front().same_again = MedianInterval{1, 0.98, 1.03, 0.96};
    return results;
}

std::string paragraph(const SweepResults& results) {
    const std::vector<ViewFigures> views = view_figures(results);
    REQUIRE(views.size() == 1);
    return scene_paragraph(views[0]);
}

bool says(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

}  // namespace

TEST_CASE("scene_paragraph: what wins at which budget and why") {
    CHECK(paragraph(timed({{with_samples("xjun", 4), 0.08, 2}, {with_samples("gtao", 8), 0.04, 10}})) ==
          "`columns` at 640x360, 1200 triangles: 2 settings of 2 methods.\n\n"
          "**On 1 thread.** Within 5 ms xjun with 4 samples has the least error, an RMSE of 0.0800 ± 0.0020 "
          "in 2 ms; no "
          "other method is done by then. Within 20 and 80 ms gtao with 8 samples has the least error, an "
          "RMSE of 0.0400 ± "
          "0.0020 in 10 ms, ahead of xjun with 4 samples (0.0800). Most of its lead lies in the step "
          "\"sampling\": a share "
          "of 0.00096 in the mean squared error against 0.0038. The largest part of the error is "
          "\"sampling\" for xjun with "
          "4 samples (60 % of the mean squared error) and \"sampling\" for gtao with 8 samples (60 %). An "
          "RMSE of 0.05 is "
          "reached first by gtao with 8 samples, in 10 ms; no other method reaches it. Nothing reaches an "
          "RMSE of 0.02; "
          "gtao with 8 samples comes nearest, with 0.0400. A setting that was timed as if it were two (A/A) "
          "took 0.980 to "
          "1.030 times as long as itself: what is closer than that is a tie.");
}

TEST_CASE(
    "scene_paragraph: why is the step in which the winner gains most, and the largest of each one's error") {
    SweepResults results = timed({{with_samples("gtao", 8), 0.04, 3}, {with_samples("vbao", 8), 0.06, 4}});
    results.errors[0].parts = {{"definition", 0, 0, 0.0018}, {"sampling", 0, 0, 0.0002}};
    results.errors[1].parts = {{"definition", 0, 0, 0.0018}, {"sampling", 0, 0, 0.0018}};
    CHECK(says(paragraph(results),
               "Most of its lead lies in the step \"sampling\": a share of 0.0002 in the mean squared "
               "error against 0.0018. The largest part of the error is \"definition\" for gtao with 8 "
               "samples (90 % of the mean squared error)."));
    results.errors[1].parts.clear();
    CHECK_FALSE(says(paragraph(results), "Most of its lead"));
    results.errors[0].parts = {{"blur", 0, 0, -0.1}};
    CHECK_FALSE(says(paragraph(results), "The largest part"));
}

TEST_CASE("scene_paragraph: errors within their noise are a tie, and a little more is none") {
    // Both margins are 1.96 standard errors; those of a difference are root two of that, 0.00277.
    const auto text = [](double other) {
        return paragraph(timed({{with_samples("gtao", 8), 0.04, 3}, {with_samples("vbao", 8), other, 4}}));
    };
    CHECK(says(
        text(0.0427),
        "Within 5, 20 and 80 ms gtao with 8 samples (RMSE 0.0400 ± 0.0020 in 3 ms) and vbao with 8 samples "
        "(0.0427 ± 0.0020 in 4 ms) tie for the least error: their difference is smaller than the "
        "noise."));
    CHECK_FALSE(says(text(0.0427), "Most of its lead"));
    CHECK(says(text(0.0429), "an RMSE of 0.0400 ± 0.0020 in 3 ms, ahead of vbao with 8 samples (0.0429)."));
    CHECK_FALSE(says(text(0.0429), "tie for the least error"));
}

TEST_CASE("scene_paragraph: times within the noise of A/A are a tie, and a little more is none") {
    const auto text = [](double other_ms, MedianInterval same_again) {
        SweepResults results =
            timed({{with_samples("gtao", 8), 0.03, 3}, {with_samples("vbao", 8), 0.04, other_ms}});
        results.times.front().same_again = same_again;
        return paragraph(results);
    };
    const MedianInterval loud{1, 0.9, 1.05, 0.96}, still{1, 0.99, 1.01, 0.96};
    CHECK(says(text(3.3, loud),
               "gtao with 8 samples (3 ms) and vbao with 8 samples (3.3 ms) tie for the least time to an "
               "RMSE of 0.05: their difference is smaller than the noise."));
    CHECK(says(text(3.3, still),
               "An RMSE of 0.05 is reached first by gtao with 8 samples, in 3 ms, 1.1 times as fast as "
               "vbao with 8 samples."));
    CHECK(says(text(6, loud), "in 3 ms, 2 times as fast as vbao with 8 samples."));
    // Their own intervals meet, 2 % on both sides.
    CHECK(says(text(3.05, still), "tie for the least time"));
}

TEST_CASE("scene_paragraph: budgets that nothing keeps, and levels that all reach") {
    const std::string slow = paragraph(timed({{with_samples("gtao", 8), 0.04, 100}}));
    CHECK(says(slow, "1 setting of 1 method."));
    CHECK(says(slow, "Within 5, 20 and 80 ms nothing is done."));
    CHECK(says(
        slow,
        "An RMSE of 0.05 is reached first by gtao with 8 samples, in 100 ms; no other method reaches it."));
    const std::string good = paragraph(timed({{{"gtao", {}}, 0.01, 1}}));
    CHECK(says(good, "Within 5, 20 and 80 ms gtao with its defaults has the least error"));
    CHECK(says(good, "An RMSE of 0.02 is reached first by gtao with its defaults, in 1 ms"));
    CHECK_FALSE(says(good, "Nothing reaches"));
    CHECK(
        says(paragraph(timed({{{"gtao", {}}, 0, 1}})),
             "gtao with its defaults has the least error, an RMSE below the noise of the reference in 1 ms"));
    CHECK(
        says(paragraph(timed({{{"gtao", {}}, 0.09, 1}})),
             "Nothing reaches an RMSE of 0.05 or 0.02; gtao with its defaults comes nearest, with 0.0900."));
}

TEST_CASE("scene_paragraph: without times errors alone are compared") {
    SweepResults results = timed({{with_samples("gtao", 8), 0.04, 1}, {with_samples("vbao", 8), 0.05, 1}});
    results.times.clear();
    CHECK(paragraph(results) ==
          "`columns` at 640x360, 1200 triangles: 2 settings of 2 methods. Nothing was timed here, so that "
          "only errors can "
          "be compared: gtao with 8 samples has the least error, an RMSE of 0.0400 ± 0.0020, ahead of vbao "
          "with 8 samples "
          "(0.0500). Most of its lead lies in the step \"sampling\": a share of 0.00096 in the mean squared "
          "error against "
          "0.0015. The largest part of the error is \"sampling\" for gtao with 8 samples (60 % of the mean "
          "squared "
          "error).");
    results.errors.resize(1);
    results.errors[0].parts.clear();
    CHECK(paragraph(results) ==
          "`columns` at 640x360, 1200 triangles: 1 setting of 1 method. Nothing was timed here, so that only "
          "errors can "
          "be compared: gtao with 8 samples has the least error, an RMSE of 0.0400 ± 0.0020; no other method "
          "was tried.");
}

TEST_CASE("scene_paragraph: broken images are named, and without any sound one nothing is claimed") {
    SweepResults results = timed({{with_samples("gtao", 8), 0.04, 1}, {with_samples("vbao", 1), 0.05, 1}});
    results.errors[1].nan_or_inf = 3;
    const std::string text = paragraph(results);
    CHECK(says(
        text,
        "Left out, because some of their pixels are no numbers, are images of vbao with 1 sample (1 seed of "
        "1)."));
    CHECK(says(text, "Within 5, 20 and 80 ms gtao with 8 samples has the least error"));
    CHECK_FALSE(says(text, "ahead of vbao"));
    results.errors[0].nan_or_inf = 1;
    CHECK(says(paragraph(results), "**On 1 thread.** No setting has both a time and an error."));
    results.times.clear();
    CHECK(says(paragraph(results), "No error is known."));
}
