#include "chapters/compare/compare.h"

#include <fstream>
#include <iterator>
#include <limits>
#include <sstream>

#include <doctest/doctest.h>

#include "chapters/compare/difference_page.h"
#include "chapters/notebook/picture.h"
#include "rasterizer/base/error.h"
#include "rasterizer/textures/texture.h"
#include "tests/tools/compared_files.h"
#include "tests/tools/error_message.h"
#include "tests/tools/picture_files.h"
#include "tests/tools/scratch_directory.h"

using namespace crevice;
namespace fs = std::filesystem;

namespace {

Image<float> ramp(Size size) {
    Image<float> image(size, 0.0f);
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) image.at(x, y) = static_cast<float>(x + y) / 64;
    }
    return image;
}

}  // namespace

TEST_CASE("identical files: exit code 0, and no error image is left lying about") {
    const ScratchDirectory scratch;
    write_npy(scratch / "a.npy", ramp({20, 15}));
    write_npy(scratch / "b.npy", ramp({20, 15}));
    const ComparedOutcome outcome =
        compare({.a = scratch / "a.npy", .b = scratch / "b.npy", .out = scratch.path()});
    CHECK(outcome.code == 0);
    CHECK(contains(outcome.report, "identical"));
    CHECK(contains(outcome.report, "SSIM              1\n"));
    CHECK(contains(outcome.report, "differing pixels  0 of 300\n"));
    CHECK(!fs::exists(scratch / "error.png"));
}

TEST_CASE("one pixel off: exit code 1, numbers, and the signed error image") {
    const ScratchDirectory scratch;
    Image<float> a = ramp({20, 15});
    write_npy(scratch / "b.npy", a);
    a.at(3, 2) += 0.5f;
    write_npy(scratch / "a.npy", a);
    const ComparedOutcome outcome =
        compare({.a = scratch / "a.npy", .b = scratch / "b.npy", .out = scratch.path()});
    CHECK(outcome.code == 1);
    CHECK(contains(outcome.report, "max               0.5\n"));
    CHECK(contains(outcome.report, "signed bias       0.00166667\n"));
    CHECK(contains(outcome.report, "differing pixels  1 of 300\n"));
    CHECK(contains(outcome.report, "NaN or infinite   0 of 300\n"));
    const Planes error = read_npy(scratch / "error.npy");
    CHECK(error[0].at(3, 2) == 0.5f);
    CHECK(error[0].at(2, 3) == 0);
    const Image3 picture = read_png(scratch / "error.png").colour;
    CHECK(picture.at(0, 0) == glm::vec3(1));
    CHECK(picture.at(3, 2).x > picture.at(3, 2).z);  // red: A is larger
}

TEST_CASE("a NaN on both sides is a failure") {
    const ScratchDirectory scratch;
    Image<float> a = ramp({12, 12});
    a.at(0, 0) = std::numeric_limits<float>::quiet_NaN();
    write_npy(scratch / "a.npy", a);
    const ComparedOutcome outcome =
        compare({.a = scratch / "a.npy", .b = scratch / "a.npy", .out = scratch.path()});
    CHECK(outcome.code == 1);
    CHECK(contains(outcome.report, "NaN or infinite   1 of 144\n"));
}

TEST_CASE("png files compare by their stored values") {
    const ScratchDirectory scratch;
    write_picture(scratch / "a.png", ao_picture(Image<float>({4, 4}, 100.0f / 255)));
    write_picture(scratch / "b.png", ao_picture(Image<float>({4, 4}, 101.0f / 255)));
    CHECK(compare({.a = scratch / "a.png", .b = scratch / "a.png", .out = scratch.path()}).code == 0);
    const ComparedOutcome outcome =
        compare({.a = scratch / "b.png", .b = scratch / "a.png", .out = scratch.path()});
    CHECK(outcome.code == 1);
    CHECK(contains(outcome.report, "signed bias       0.00392157\n"));
}

TEST_CASE("directories: all common files, and those on one side only count") {
    const ScratchDirectory scratch;
    for (const char* side : {"a", "b"}) {
        fs::create_directory(scratch / side);
        write_npy(scratch / side / "same.npy", ramp({9, 9}));
        write_npy(scratch / side / "other.npy", Image<float>({9, 9}, side[0] == 'a' ? 0.0f : 1.0f));
        write_npy(scratch / side / "shape.npy", Image<float>({side[0] == 'a' ? 9 : 8, 9}, 0.0f));
    }
    write_npy(scratch / "a" / "alone.npy", ramp({9, 9}));
    write_npy(scratch / "b" / "new.npy", ramp({9, 9}));
    std::ofstream(scratch / "b" / "passes.json") << "{}";
    const ComparedOutcome outcome = compare(
        {.a = scratch / "a", .b = scratch / "b", .html = scratch / "page.html", .out = scratch.path()});
    CHECK(outcome.code == 1);
    CHECK(!contains(outcome.report, "same.npy"));  // only what differs is told
    CHECK(contains(outcome.report, "other.npy: differs\n"));
    CHECK(contains(outcome.report, "alone.npy: only in " + (scratch / "a").string() + "\n"));
    CHECK(contains(outcome.report, "new.npy: only in " + (scratch / "b").string() + "\n"));
    CHECK(contains(outcome.report, "shape.npy: shapes differ: 9x9x1 and 8x9x1\n"));
    CHECK(contains(outcome.report, "4 of 5 differ\n"));
    CHECK(fs::exists(scratch / "other_error.png"));
    CHECK(!fs::exists(scratch / "same_error.png"));
    const std::string page = bytes_in(scratch / "page.html");
    CHECK(page.find("other.npy") < page.find("same.npy"));
    CHECK(page.find("shape.npy") < page.find("same.npy"));
}

TEST_CASE("directories: a pair that allows no verdict is told, and the others are judged") {
    const ScratchDirectory scratch;
    for (const char* side : {"a", "b"}) {
        fs::create_directory(scratch / side);
        write_npy(scratch / side / "normal.npy", Image3({9, 9}, glm::vec3(-1, 0, 0)));
        write_npy(scratch / side / "other.npy", Image<float>({9, 9}, side[0] == 'a' ? 0.0f : 1.0f));
        write_npy(scratch / side / "torn.npy", ramp({9, 9}));
    }
    fs::resize_file(scratch / "a" / "torn.npy", 150);
    const ComparedOutcome outcome = compare({.a = scratch / "a",
                                             .b = scratch / "b",
                                             .limits = {.flip = 0.5},
                                             .junit = scratch / "reports" / "j.xml"});
    CHECK(outcome.code == 3);
    CHECK(contains(outcome.report, "torn.npy"));
    CHECK(contains(outcome.report, "normal.npy"));
    CHECK(contains(outcome.report, "other.npy: beyond its limits ("));
    const std::string junit = bytes_in(scratch / "reports" / "j.xml");
    CHECK(contains(junit, "tests=\"3\" failures=\"3\""));
    CHECK(contains(junit, "values lie in [0, 1]"));
}

TEST_CASE("bless: 0 only where the goldens hold what was given; NaN is no golden; a first golden is made") {
    const ScratchDirectory scratch;
    Image<float> nan = ramp({9, 9});
    nan.at(0, 0) = std::numeric_limits<float>::quiet_NaN();
    for (const char* side : {"a", "b"}) {
        fs::create_directory(scratch / side);
        write_npy(scratch / side / "other.npy", Image<float>({9, 9}, side[0] == 'a' ? 0.0f : 1.0f));
    }
    CompareOptions options{.a = scratch / "a", .b = scratch / "b", .bless = true};
    CHECK(compare(options).code == 0);
    CHECK(compare(options).report == "0 of 1 differ\n");
    write_npy(scratch / "b" / "golden_only.npy", ramp({9, 9}));
    CHECK(compare(options).code == 1);
    fs::remove(scratch / "b" / "golden_only.npy");
    write_npy(scratch / "a" / "bad.npy", nan);
    const ComparedOutcome outcome = compare(options);
    CHECK(outcome.code == 1);
    CHECK(contains(outcome.report, "bad.npy: stays; "));
    CHECK(!fs::exists(scratch / "b" / "bad.npy"));
    CHECK(compare({.a = scratch / "a" / "other.npy", .b = scratch / "new.npy", .bless = true}).code == 0);
    CHECK(bytes_in(scratch / "new.npy") == bytes_in(scratch / "a" / "other.npy"));
}

TEST_CASE("limits of a buffer that neither side has are refused: misspelt, they would hold nothing") {
    const ScratchDirectory scratch;
    for (const char* side : {"a", "b"}) {
        fs::create_directory(scratch / side);
        write_npy(scratch / side / "ao_raw.npy", ramp({9, 9}));
    }
    std::ofstream(scratch / "b" / "limits.json") << R"({"limits": {"ao-raw": {"rmse": 0}}})";
    CHECK(message_of<InputError>([&] { compare({.a = scratch / "a", .b = scratch / "b"}); }) ==
          (scratch / "b" / "limits.json").string() +
              ": there is no such buffer on either side (ao-raw); did you mean ao_raw? There are ao_raw");
}

TEST_CASE("what cannot be compared is named") {
    const ScratchDirectory scratch;
    write_npy(scratch / "a.npy", Image<float>({4, 4}, 0.0f));
    write_npy(scratch / "b.npy", Image<float>({4, 5}, 0.0f));
    write_npy(scratch / "c.npy", Image3({4, 4}, {0, 0, 0}));
    std::ofstream(scratch / "a.txt") << "text";
    const auto message = [&](const fs::path& a, const fs::path& b) -> std::string {
        try {
            compare({.a = a, .b = b, .out = scratch.path()});
        } catch (const InputError& error) {
            return error.what();
        }
        return "";
    };
    CHECK(contains(message(scratch / "a.npy", scratch / "b.npy"), "(4x5x1 and 4x4x1,"));
    CHECK(contains(message(scratch / "a.npy", scratch / "c.npy"), "(4x4x3 and 4x4x1,"));
    CHECK(contains(message(scratch / "a.npy", scratch / "none.npy"), "none.npy"));
    CHECK(contains(message(scratch / "a.txt", scratch / "a.npy"), "a.txt"));
    CHECK(contains(message(scratch / "a.npy", scratch.path()), "is none"));
    fs::create_directory(scratch / "empty");
    CHECK(contains(message(scratch / "empty", scratch / "empty"),
                   "holds a .npy, a .pfm, a .png, a .tif or an .exr"));
    CHECK_THROWS_AS(
        compare({.a = scratch / "a.npy", .b = scratch / "a.npy", .html = scratch / "a.npy" / "p.html"}),
        OutputError);
}

TEST_CASE("compare writes nothing that was not asked for") {
    const ScratchDirectory scratch;
    write_npy(scratch / "a.npy", ramp({20, 15}));
    write_npy(scratch / "b.npy", Image<float>({20, 15}, 0.0f));
    CHECK(compare({.a = scratch / "a.npy", .b = scratch / "b.npy"}).code == 1);
    CHECK(std::distance(fs::directory_iterator(scratch.path()), {}) == 2);
    CHECK(compare({.a = scratch / "a.npy", .b = scratch / "b.npy", .out = scratch / "made" / "here"}).code ==
          1);
    CHECK(fs::exists(scratch / "made" / "here" / "error.png"));
}

TEST_CASE("the page: failures first, first pixels with their values, offline, the same bytes twice") {
    Image<float> actual = ramp({20, 15});
    actual.at(3, 2) = 0.625f;
    actual.at(4, 2) = std::numeric_limits<float>::quiet_NaN();
    const DifferenceEntry entries[] = {
        {"alike", planes_of(ramp({20, 15})), planes_of(ramp({20, 15})), "", false},
        {"a<b", planes_of(actual), planes_of(ramp({20, 15})), "see <here>", false},
        {"no golden", planes_of(actual), {}, "run with --bless", false},
        {"colour", planes_of(Image3({3, 2}, {0.5f, 0, -0.5f})), planes_of(Image3({3, 2}, {0.5f, 0, 0.5f})),
         "", false}};
    const std::string page = difference_page(entries, {"Golden images", "actual", "expected"});
    CHECK(page == difference_page(entries, {"Golden images", "actual", "expected"}));
    CHECK(contains(page, "3 of 4 differ."));
    CHECK(page.find("<h2>a&lt;b") < page.find("<h2>alike"));
    CHECK(page.find("<h2>no golden") < page.find("<h2>alike"));
    CHECK(contains(page, "see &lt;here&gt;"));
    CHECK(contains(page,
                   "<td class=\"number\">3</td><td class=\"number\">2</td><td class=\"number\">0.625</td>"
                   "<td class=\"number\">0.078125</td><td class=\"number\">0.546875</td>"));
    CHECK(contains(page, "<td class=\"number\">0.5 0 -0.5</td><td class=\"number\">0.5 0 0.5</td>"));
    CHECK(contains(page, "differing pixels</td><td class=\"number\">2 of 300</td>"));
    for (const char* outside : {"http:", "https:", "url(", "@import", "<script"}) {
        CAPTURE(outside);
        CHECK(!contains(page, outside));
    }
}

TEST_CASE("compare: PNG files are compared with all their bits and their alpha") {
    const ScratchDirectory scratch;
    const auto put = [&](const char* name, const PngKind& kind, const std::string& samples) {
        std::ofstream(scratch / name, std::ios::binary) << png_file({1, 1}, kind, samples);
    };
    put("a.png", {.colour_type = 0, .bits = 16}, std::string("\x64\0", 2));
    put("b.png", {.colour_type = 0, .bits = 16}, "\x64\xc8");
    put("opaque.png", {}, "\1\2\3\xff");
    put("clear.png", {}, "\1\2\3\x7f");
    put("plain.png", {.colour_type = 2}, "\1\2\3");
    const auto outcome = [&](const char* a, const char* b) {
        return compare({.a = scratch / a, .b = scratch / b, .out = scratch.path()});
    };
    CHECK(outcome("a.png", "a.png").code == 0);
    CHECK(outcome("a.png", "b.png").code == 1);
    CHECK(outcome("opaque.png", "plain.png").code == 0);
    const ComparedOutcome alpha = outcome("opaque.png", "clear.png");
    CHECK(alpha.code == 1);
    CHECK(contains(alpha.report, "opaque.png: identical"));
    CHECK(contains(alpha.report, "opaque.png, alpha: differs"));
    CHECK(read_npy(scratch / "error_alpha.npy")[0].at(0, 0) == 1 - 127.0f / 255);
}
