// The report of `crevice compare --json` is as its schema has it.
#include <fstream>
#include <limits>

#include <doctest/doctest.h>

#include "rasterizer/base/image_io.h"
#include "tests/tools/compared_files.h"
#include "tests/tools/schema_checks.h"
#include "tests/tools/scratch_directory.h"

using namespace crevice;
using nlohmann::json;

TEST_CASE("compare schema: the report is as the schema has it, whatever is compared") {
    std::ifstream stream(CREVICE_SCHEMA_DIR "/compare.schema.json");
    const SchemaChecks schema(json::parse(stream));
    const ScratchDirectory scratch;
    const std::filesystem::path a = scratch / "a", b = scratch / "b";
    for (const auto& side : {a, b}) {
        std::filesystem::create_directory(side);
        write_npy(side / "same.npy", Image<float>({12, 9}, 0.5f));
    }
    write_npy(a / "other.npy", Image<float>({12, 9}, 0.5f));
    write_npy(b / "other.npy", Image<float>({12, 9}, 0.25f));
    write_npy(a / "infinite.npy", Image<float>({12, 9}, std::numeric_limits<float>::infinity()));
    write_npy(b / "infinite.npy", Image<float>({12, 9}, 1.0f));
    write_npy(a / "alone.npy", Image<float>({12, 9}, 1.0f));
    const ComparedOutcome exactly = compare({.a = a, .b = b, .json = true});
    const json report = json::parse(exactly.report);
    CHECK(schema.against(report) == "");
    CHECK(report["failed"] == 3);
    CHECK(report["pairs"].size() == 4);
    const json within = json::parse(
        compare({.a = a / "other.npy",
                 .b = b / "other.npy",
                 .limits = {.max_abs = 0.3, .rmse = 0.3, .flip = 1, .ssim = -1, .max_pixels = 200},
                 .json = true})
            .report);
    CHECK(schema.against(within) == "");
    CHECK(within["failed"] == 0);
    CHECK(within["pairs"][0].contains("flip"));
    CHECK(within["pairs"][0]["limits"].size() == 5);
    json spoilt = report;
    spoilt["pairs"][0].erase("passed");
    CHECK(schema.against(spoilt) == "/pairs/0: has no \"passed\"");
}
