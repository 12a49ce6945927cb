// Rounding against the judge: the bounds that every pass and every method holds, and that what is not rounding shows.
#include "chapters/stability/rounding.h"

#include <cmath>
#include <map>
#include <set>

#include <doctest/doctest.h>

#include "chapters/stability/stiff_scenes.h"

using namespace crevice;

namespace {

double p99_of(const MethodRounding& method, RoundingCause cause) { return method.of(cause)->off.p99; }

}  // namespace

TEST_CASE("rounding: figures are the largest, the mean, and the 99th of a hundred") {
    std::vector<double> off;
    for (int i = 1; i <= 100; ++i) off.push_back(i);
    const RoundingFigures figures = rounding_figures(off);
    CHECK(figures.max == 100);
    CHECK(figures.p99 == 99);
    CHECK(figures.mean == doctest::Approx(50.5));
    CHECK(rounding_figures({}).max == 0);
}

TEST_CASE("rounding: cases have unique names, and a quick run some of them") {
    std::set<std::string> names;
    for (const RoundingCase& one : rounding_cases(false)) CHECK(names.insert(one.name).second);
    for (const RoundingCase& one : rounding_cases(true)) CHECK(names.count(one.name) == 1);
    CHECK(names.size() > rounding_cases(true).size());
}

TEST_CASE("rounding: every pass is a few ulps off, and no distance from the origin changes that") {
    for (const double away : {0.0, 1e4, 4e6}) {
        CAPTURE(away);
        const RoundingView view = rounding_view(moved(block_view(), away), {});
        for (const PassRounding& pass : pass_rounding(view)) {
            CAPTURE(pass.pass);
            const bool in_pixels = pass.unit == "px";
            CHECK(pass.off.mean > 0);
            CHECK(pass.off.mean < (in_pixels ? 1e-4 : 3));
            CHECK(pass.off.p99 < (in_pixels ? 1e-3 : 8));
            CHECK(pass.off.max < (in_pixels ? 1e-3 : 64));
        }
    }
}

TEST_CASE("rounding: every method's kernel and its buffers change next to nothing of an ordinary scene") {
    const RoundingView view = rounding_view(block_view(), {});
    for (const Method& method : ao_methods()) {
        if (!method.computes_ao()) continue;
        CAPTURE(std::string(method.name));
        const MethodRounding rounding = method_rounding(view, method, {});
        for (const RoundingCause cause : kRoundingCauses) {
            const std::optional<AoRounding>& found = rounding.of(cause);
            CAPTURE(std::string(word_of(cause)));
            const bool needs_double = cause != RoundingCause::all && cause != RoundingCause::blurred;
            CHECK(found.has_value() == (method.ao_in_double || !needs_double));
            if (!found) continue;
            CHECK(found->off.mean < 1e-5);
            CHECK(found->off.p99 < 1e-4);
            CHECK(found->off.max < 2e-3);
            CHECK(found->decided_otherwise < 0.005);
        }
        CHECK((why_not_in_double(method) == "") == static_cast<bool>(method.ao_in_double));
    }
}

TEST_CASE(
    "rounding: xjun's kernel loses most where it looks up random vectors 1024 times across the picture") {
    // At powers of two the texels' coordinates are floats, and nothing is lost there.
    StiffView even = block_view(), odd = block_view();
    even.size = {128, 64};
    odd.size = {125, 63};
    const auto kernel_error = [](const StiffView& view) {
        return p99_of(method_rounding(rounding_view(view, {}), find_method("xjun"), {}),
                      RoundingCause::kernel);
    };
    CHECK(kernel_error(odd) > 2 * kernel_error(even));
}

TEST_CASE("rounding: a coarse depth format is luna's error alone, and it shows") {
    StiffView coarse = block_view();
    coarse.params = {"depth_format=d16"};
    const RoundingView view = rounding_view(coarse, {});
    const auto depth_error = [&](const char* name) {
        return p99_of(method_rounding(view, find_method(name), {}), RoundingCause::depth);
    };
    CHECK(depth_error("luna") > 1e-3);
    CHECK(depth_error("xjun") < 1e-4);
    CHECK(depth_error("gtao") < 1e-4);
}
