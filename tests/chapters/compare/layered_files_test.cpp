// Layers of EXRs as pairs: with another EXR, with a directory, with limits, and when goldens are renewed.
#include "chapters/compare/compared_files.h"

#include <doctest/doctest.h>

#include "chapters/images/exr.h"
#include "rasterizer/base/error.h"
#include "rasterizer/base/image_io.h"
#include "rasterizer/base/write_file.h"
#include "tests/tools/compared_files.h"
#include "tests/tools/error_message.h"
#include "tests/tools/has_openexr.h"
#include "tests/tools/scratch_directory.h"

using namespace crevice;
namespace fs = std::filesystem;

namespace {

Image3 normals() {
    Image3 image({12, 12}, {0, 0, -1});
    image.set(3, 4, {0.6f, 0, -0.8f});
    return image;
}

// `off` is added to one texel of the AO map, which is of half the size.
void write_frame_exr(const fs::path& path, float off, bool with_ao = true) {
    const Image3 n = normals();
    Image<float> ao({6, 6}, 0.5f);
    ao.at(1, 2) += off;
    std::vector<ExrChannel> channels = {{"normal.X", &n.x}, {"normal.Y", &n.y}, {"normal.Z", &n.z}};
    if (with_ao) channels.push_back({"ao.raw", &ao});
    write_file_atomically(path, exr_bytes(channels));
}

void write_frame_npy(const fs::path& directory, float off) {
    fs::create_directory(directory);
    Image<float> ao({6, 6}, 0.5f);
    ao.at(1, 2) += off;
    write_npy(directory / "normal.npy", normals());
    write_npy(directory / "ao_raw.npy", ao);
}

std::string input_error(const CompareOptions& options) {
    try {
        compare(options);
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

}  // namespace

TEST_CASE("layers: two EXRs are compared layer by layer, and only what differs is told") {
    if (!has_openexr()) return;
    const ScratchDirectory scratch;
    write_frame_exr(scratch / "a.exr", 0.25f);
    write_frame_exr(scratch / "b.exr", 0);
    CHECK(compare({.a = scratch / "a.exr", .b = scratch / "a.exr"}).report == "0 of 2 differ\n");
    const ComparedOutcome outcome =
        compare({.a = scratch / "a.exr", .b = scratch / "b.exr", .out = scratch / "out"});
    CHECK(outcome.code == 1);
    CHECK(contains(outcome.report, "ao_raw: differs\n"));
    CHECK(contains(outcome.report, "max               0.25\n"));
    CHECK(contains(outcome.report, "worst pixel       1 2\n"));
    CHECK(contains(outcome.report, "differing pixels  1 of 36\n"));
    CHECK(!contains(outcome.report, "normal"));
    CHECK(contains(outcome.report, "1 of 2 differ\n"));
    CHECK(fs::exists(scratch / "out" / "ao_raw_error.npy"));
    // Limits go by the layer's name.
    std::ofstream(scratch / "limits.json") << R"({"limits": {"ao_raw": {"max_abs": 0.25}}})";
    CHECK(compare({.a = scratch / "a.exr", .b = scratch / "b.exr", .limits_file = scratch / "limits.json"})
              .code == 0);
}

TEST_CASE("layers: an EXR against a directory, either way round") {
    if (!has_openexr()) return;
    const ScratchDirectory scratch;
    write_frame_exr(scratch / "frame.exr", 0);
    write_frame_npy(scratch / "same", 0);
    write_frame_npy(scratch / "other", 0.125f);
    CHECK(compare({.a = scratch / "frame.exr", .b = scratch / "same"}).report == "0 of 2 differ\n");
    CHECK(compare({.a = scratch / "same", .b = scratch / "frame.exr"}).code == 0);
    CHECK(contains(compare({.a = scratch / "frame.exr", .b = scratch / "other"}).report,
                   "signed bias       -0.00347222\n"));
    CHECK(contains(compare({.a = scratch / "other", .b = scratch / "frame.exr"}).report,
                   "signed bias       0.00347222\n"));
    write_npy(scratch / "same" / "lit.npy", Image3({12, 12}, {0, 0, 0}));
    write_npy(scratch / "same" / "normal.npy", Image<float>({12, 12}, 0.0f));
    const ComparedOutcome outcome = compare({.a = scratch / "frame.exr", .b = scratch / "same"});
    CHECK(contains(outcome.report, "lit: only in " + (scratch / "same").string() + "\n"));
    CHECK(contains(outcome.report, "normal: shapes differ: 12x12x3 and 12x12x1\n"));
}

TEST_CASE("layers: an EXR of one layer is an image like any other; one of several is none") {
    if (!has_openexr()) return;
    const ScratchDirectory scratch;
    write_frame_exr(scratch / "one.exr", 0, false);
    write_frame_exr(scratch / "two.exr", 0);
    write_frame_npy(scratch / "npy", 0);
    CHECK(contains(compare({.a = scratch / "one.exr", .b = scratch / "npy" / "normal.npy"}).report,
                   "one.exr: identical\n"));
    CHECK(contains(input_error({.a = scratch / "one.exr", .b = scratch / "npy" / "ao_raw.npy"}),
                   "(6x6x1 and 12x12x3,"));
    CHECK(contains(input_error({.a = scratch / "npy" / "normal.npy", .b = scratch / "two.exr"}),
                   "two.exr: holds several layers (normal, ao_raw), but"));
}

TEST_CASE("layers: directories of EXRs, and goldens that are renewed whole") {
    if (!has_openexr()) return;
    const ScratchDirectory scratch;
    for (const char* side : {"a", "b"}) fs::create_directory(scratch / side);
    write_frame_exr(scratch / "a" / "frame.exr", 0.5f);
    write_frame_exr(scratch / "b" / "frame.exr", 0);
    const CompareOptions both{.a = scratch / "a", .b = scratch / "b"};
    CHECK(contains(compare(both).report, "frame.exr, ao_raw: differs\n"));
    CompareOptions blessing = both;
    blessing.bless = true;
    const ComparedOutcome renewed = compare(blessing);
    CHECK(renewed.code == 0);
    CHECK(contains(renewed.report, (scratch / "b" / "frame.exr").string() + ": written from "));
    CHECK(bytes_in(scratch / "a" / "frame.exr") == bytes_in(scratch / "b" / "frame.exr"));
    CHECK(compare(both).code == 0);
    write_frame_npy(scratch / "npy", 0);
    CHECK_THROWS_AS(compare({.a = scratch / "a" / "frame.exr", .b = scratch / "npy", .bless = true}),
                    UsageError);
}
