// Comparisons within limits: which pairs pass, what is reported to programs, and how goldens are renewed.
#include "chapters/compare/compare_limits.h"

#include <fstream>
#include <iterator>
#include <limits>
#include <sstream>

#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

#include "chapters/compare/compare.h"
#include "rasterizer/base/error.h"
#include "rasterizer/base/image_io.h"
#include "tests/tools/compared_files.h"
#include "tests/tools/error_message.h"
#include "tests/tools/scratch_directory.h"

using namespace crevice;
namespace fs = std::filesystem;

namespace {

// Greys of a picture, `off` added to the first `count` pixels.
Image<float> greys(float off, int count) {
    Image<float> image({16, 16}, 0.0f);
    for (int y = 0; y < 16; ++y)
        for (int x = 0; x < 16; ++x)
            image.at(x, y) = 0.25f + static_cast<float>(x) / 64 + (16 * y + x < count ? off : 0.0f);
    return image;
}

std::string refusal(const std::string& text) {
    try {
        limits_from_text(text, "limits.json", {});
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

}  // namespace

TEST_CASE("limits: each holds at its own value and not below it") {
    const ScratchDirectory scratch;
    write_npy(scratch / "a.npy", greys(0.125f, 4));
    write_npy(scratch / "b.npy", greys(0, 0));
    const auto code = [&](const CompareLimits& limits) {
        return compare({.a = scratch / "a.npy", .b = scratch / "b.npy", .limits = limits}).code;
    };
    CHECK(code({}) == 1);
    CHECK(code({.max_abs = 0.125}) == 0);
    CHECK(code({.max_abs = 0.1249}) == 1);
    CHECK(code({.rmse = 0.015625}) == 0);  // 1/8 in 4 of 256 pixels: 1/64
    CHECK(code({.rmse = 0.0156}) == 1);
    CHECK(code({.max_pixels = 4}) == 0);
    CHECK(code({.max_pixels = 3}) == 1);
    CHECK(code({.ssim = 0.5}) == 0);
    CHECK(code({.ssim = 1}) == 1);
    CHECK(code({.flip = 1}) == 0);
    CHECK(code({.flip = 1e-6}) == 1);
    CHECK(code({.max_abs = 0.125, .max_pixels = 3}) == 1);
}

TEST_CASE("limits: no limit lets a NaN pass") {
    const ScratchDirectory scratch;
    Image<float> broken = greys(0, 0);
    broken.at(2, 3) = std::numeric_limits<float>::quiet_NaN();
    write_npy(scratch / "a.npy", broken);
    for (const CompareLimits& limits :
         {CompareLimits{.max_abs = 1e9}, CompareLimits{.flip = 1}, CompareLimits{.max_pixels = 1000}}) {
        const ComparedOutcome outcome =
            compare({.a = scratch / "a.npy", .b = scratch / "a.npy", .limits = limits});
        CHECK(outcome.code == 1);
        CHECK(contains(outcome.report, "1 pixel is NaN or infinite"));
    }
}

TEST_CASE("limits: a file beside the goldens names buffers, flags stand for the others") {
    const ScratchDirectory scratch;
    for (const char* side : {"a", "b"}) {
        fs::create_directory(scratch / side);
        const float off = side[0] == 'a' ? 0.125f : 0.0f;
        write_npy(scratch / side / "ao_raw.npy", greys(off, 4));
        write_npy(scratch / side / "lit.npy", greys(off, 8));
    }
    const CompareOptions options{.a = scratch / "a", .b = scratch / "b"};
    CHECK(contains(compare(options).report, "2 of 2 differ\n"));
    std::ofstream(scratch / "b" / "limits.json") << R"({"limits": {"ao_raw": {"max_abs": 0.2}}})";
    const ComparedOutcome one = compare(options);
    CHECK(one.code == 1);
    CHECK(contains(one.report, "lit.npy: differs"));
    CHECK(contains(one.report, "1 of 2 differ more than they may\n"));
    CompareOptions with_flag = options;
    with_flag.limits.max_pixels = 8;
    CHECK(compare(with_flag).code == 0);
    std::ofstream(scratch / "other.json") << R"({"default": {"max_pixels": 6}})";
    with_flag.limits_file = scratch / "other.json";
    const ComparedOutcome other = compare(with_flag);
    CHECK(other.code == 1);
    CHECK(contains(other.report, "lit.npy: beyond its limits (8 pixels differ, limit 6)"));
    with_flag.limits_file = scratch / "none.json";
    CHECK_THROWS_WITH_AS(compare(with_flag), doctest::Contains("none.json"), InputError);
}

TEST_CASE("limits: what a file of them cannot say is named with its line") {
    CHECK(contains(refusal("{\n\"limits\": {,}\n}"), "limits.json:2: not JSON"));
    CHECK(contains(refusal("[]"), "limits.json:1: not an object ([])"));
    CHECK(
        contains(refusal("{\"default\": {\"rmse\": 1e999}}"), "a number is too large to be read (1e999); "));
    const std::string deep = "{\"default\":\n" + std::string(300000, '[') + std::string(300000, ']') + "}";
    CHECK(contains(refusal(deep), "limits.json:2: nested too deeply (more than 100 levels); "));
    // The line is that of the value itself, not of the first one by its name.
    CHECK(contains(refusal("{\"limits\": {\"normal\": {\n\"rmse\": 1}, \"ao_raw\": {\n\"rmse\": -1}}}"),
                   "limits.json:3: ao_raw: rmse is out of range (-1)"));
    CHECK(contains(refusal("{\n\"limit\": {}}"), "limits.json:2: no such member (limit)"));
    CHECK(contains(refusal("{\"limits\": 3}"), "\"limits\" is not an object (3)"));
    CHECK(contains(refusal("{\"limits\": {\n\"ao\": 1}}"), "limits.json:2: no limits (ao: 1)"));
    CHECK(contains(refusal("{\"limits\": {\"ao\": {\n\"psnr\": 1}}}"),
                   "limits.json:2: ao: no such limit (psnr)"));
    CHECK(contains(refusal("{\"default\": {\"rmse\": -1}}"), "default: rmse is out of range (-1)"));
    CHECK(contains(refusal("{\"default\": {\"rmse\": \"1\"}}"), "default: rmse is out of range (\"1\")"));
    CHECK(contains(refusal("{\"default\": {\"flip\": 1.5}}"), "default: flip is out of range (1.5)"));
    CHECK(contains(refusal("{\"default\": {\"max_pixels\": 1.5}}"), "max_pixels is no whole number (1.5)"));
    CHECK(refusal("{\"limits\": {\"ao\": {\"ssim\": -1, \"max_pixels\": 0}}, \"default\": {}}") == "");
}

TEST_CASE("limits: FLIP is refused of what is no picture") {
    const ScratchDirectory scratch;
    write_npy(scratch / "depth.npy", Image<float>({16, 16}, 34.0f));
    const ComparedOutcome outcome = compare(
        {.a = scratch / "depth.npy", .b = scratch / "depth.npy", .limits = {.flip = 1}, .json = true});
    CHECK(outcome.code == 3);
    CHECK(contains(outcome.report, "depth.npy: FLIP is of pictures"));
}

TEST_CASE("reports: JSON and JUnit say which pairs failed and why") {
    const ScratchDirectory scratch;
    for (const char* side : {"a", "b"}) {
        fs::create_directory(scratch / side);
        write_npy(scratch / side / "same.npy", greys(0, 0));
        write_npy(scratch / side / "other.npy", greys(side[0] == 'a' ? 0.5f : 0.0f, 2));
    }
    write_npy(scratch / "b" / "missing.npy", greys(0, 0));
    const ComparedOutcome outcome = compare({.a = scratch / "a",
                                             .b = scratch / "b",
                                             .limits = {.max_abs = 0.25},
                                             .junit = scratch / "j.xml",
                                             .json = true});
    CHECK(outcome.code == 1);
    const auto report = nlohmann::json::parse(outcome.report);
    CHECK(report["failed"] == 2);
    REQUIRE(report["pairs"].size() == 3);
    CHECK(report["pairs"][0]["name"] == "missing.npy");
    CHECK(report["pairs"][0]["failures"][0] == "only in " + (scratch / "b").string());
    CHECK(report["pairs"][1]["name"] == "other.npy");
    CHECK(report["pairs"][1]["max_abs"] == 0.5);
    CHECK(report["pairs"][1]["failures"][0] == "max 0.5, limit 0.25");
    CHECK(report["pairs"][1]["shape"] == nlohmann::json({16, 16, 1}));
    CHECK(report["pairs"][2]["passed"] == true);
    const std::string junit = bytes_in(scratch / "j.xml");
    CHECK(contains(junit, "tests=\"3\" failures=\"2\""));
    CHECK(contains(junit, "<testcase classname=\"crevice.compare\" name=\"same.npy\"/>"));
    CHECK(contains(junit, "<failure message=\"max 0.5, limit 0.25\">RMSE "));
}

TEST_CASE("bless: what failed becomes the golden, what passed and what is missing stay") {
    const ScratchDirectory scratch;
    for (const char* side : {"a", "b"}) {
        fs::create_directory(scratch / side);
        write_npy(scratch / side / "ao.npy", greys(side[0] == 'a' ? 0.5f : 0.0f, 2));
    }
    write_npy(scratch / "a" / "new.npy", greys(0, 0));
    write_npy(scratch / "b" / "old.npy", greys(0, 0));
    const CompareOptions options{.a = scratch / "a", .b = scratch / "b", .bless = true};
    const ComparedOutcome outcome = compare(options);
    CHECK(outcome.code == 1);  // of old.npy they are still not the same
    CHECK(contains(outcome.report, "ao.npy: written from "));
    CHECK(contains(outcome.report, "old.npy: stays; "));
    CHECK(bytes_in(scratch / "a" / "ao.npy") == bytes_in(scratch / "b" / "ao.npy"));
    CHECK(fs::exists(scratch / "b" / "new.npy"));
    CHECK(fs::exists(scratch / "b" / "old.npy"));
}
