// What files hold when they are compared: kinds of numbers and of files, pairs of directories.
#include "chapters/compare/compared_files.h"

#include <fstream>
#include <sstream>

#include <doctest/doctest.h>

#include "chapters/images/pfm.h"
#include "chapters/notebook/picture.h"
#include "rasterizer/base/error.h"
#include "rasterizer/base/image_io.h"
#include "tests/tools/error_message.h"
#include "tests/tools/scratch_directory.h"
#include "tests/tools/tiff_by_hand.h"

using namespace crevice;
namespace fs = std::filesystem;

namespace {

template <class T>
std::string in_memory(std::initializer_list<T> values) {
    return {reinterpret_cast<const char*>(values.begin()), values.size() * sizeof(T)};
}

std::string refusal(const std::string& pfm) {
    try {
        planes_from_pfm(pfm, "a.pfm");
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

}  // namespace

TEST_CASE("PFM: rows from the lowest up, both orders of bytes, one component or three") {
    const Planes grey = planes_from_pfm("Pf\n2 2\n-1.0\n" + in_memory<float>({1, 2, 3, 4}), "a");
    REQUIRE(grey.size() == 1);
    CHECK(grey[0].at(0, 0) == 3);
    CHECK(grey[0].at(1, 1) == 2);
    const Planes colour = planes_from_pfm("PF 1 1 -0.5 " + in_memory<float>({1, 2, 3}), "a");
    REQUIRE(colour.size() == 3);
    CHECK(colour[1].at(0, 0) == 2);
    CHECK(planes_from_pfm("Pf\n1 1\n1\n" + std::string("\x3f\x80\0\0", 4), "a")[0].at(0, 0) == 1);

    CHECK(contains(refusal("P6\n1 1\n255\nabc"), "a.pfm: not a PFM file"));
    CHECK(contains(refusal("Pf\n0 1\n-1\n"), "its size is no size (0 1)"));
    CHECK(contains(refusal("Pf\n99999 99999\n-1\n"), "its size is no size"));
    CHECK(contains(refusal("Pf\n1 1\n0\n1234"), "its scale is no scale (0)"));
    CHECK(contains(refusal("Pf\n1 1\nnan\n1234"), "its scale is no scale (nan)"));
    CHECK(contains(refusal("Pf\n1 1\n-1\n123"), "holds 3 bytes of values where its size needs 4"));
    CHECK(contains(refusal(""), "not a PFM file"));
}

TEST_CASE("compared files: a grey TIFF and a grey PNG are a pair; a coloured one is of another shape") {
    const ScratchDirectory scratch;
    const unsigned char grey[] = {51, 51, 51, 255, 255, 255}, colour[] = {51, 51, 51, 255, 0, 255};
    write_png(scratch / "grey.png", {2, 1}, 3, grey);
    write_png(scratch / "colour.png", {2, 1}, 3, colour);
    std::ofstream(scratch / "grey.tif", std::ios::binary)
        << tiff_by_hand(2, 1, 8, 1, 1, std::string("\x33\xff", 2));
    std::ostringstream warnings;
    const auto pair = [&](const char* png) {
        return compared_entries(scratch / "grey.tif", scratch / png, warnings);
    };
    try {
        const std::vector<DifferenceEntry> entries = pair("grey.png");
        REQUIRE(entries.size() == 1);
        REQUIRE(entries[0].b.size() == 1);
        CHECK(entries[0].b[0].at(0, 0) == entries[0].a[0].at(0, 0));
        CHECK(entries[0].b[0].at(1, 0) == 1);
        CHECK(contains(message_of<InputError>([&] { pair("colour.png"); }), "2x1x3 and 2x1x1"));
    } catch (const UsageError& error) {
        CHECK(contains(error.what(), "built without libtiff"));
    }
}

TEST_CASE("compared files: a PFM and a .npy of the same floats are the same image") {
    const ScratchDirectory scratch;
    Image<float> image({2, 1}, 0.0f);
    image.at(0, 0) = 0.1f;
    image.at(1, 0) = 7;
    write_npy(scratch / "a.npy", image);
    std::ofstream(scratch / "a.pfm", std::ios::binary) << "Pf\n2 1\n-1\n" + in_memory<float>({0.1f, 7});
    std::ostringstream warnings;
    const auto entries = compared_entries(scratch / "a.npy", scratch / "a.pfm", warnings);
    REQUIRE(entries.size() == 1);
    CHECK(compare_images(entries[0].a, entries[0].b).identical());
    CHECK(warnings.str() == "");
}

TEST_CASE("compared files: endings count in capitals, too") {
    const ScratchDirectory scratch;
    write_npy(scratch / "A.NPY", Image<float>({2, 1}, 0.5f));
    std::ostringstream warnings;
    CHECK(compared_entries(scratch / "A.NPY", scratch / "A.NPY", warnings).size() == 1);
    CHECK(image_names(scratch.path()) == std::vector<std::string>{"A.NPY"});
}

TEST_CASE("compared files: lost precision and unlike encodings are said") {
    const ScratchDirectory scratch;
    const std::string header = "{'descr': '<f8', 'fortran_order': False, 'shape': (1, 2), }\n";
    std::ofstream(scratch / "d.npy", std::ios::binary)
        << std::string("\x93NUMPY\x01\x00", 8) + static_cast<char>(header.size()) + std::string(1, '\0') +
               header + in_memory<double>({0.5, 0.1});
    write_npy(scratch / "f.npy", Image<float>({2, 1}, 0.5f));
    write_picture(scratch / "p.png", ao_picture(Image<float>({2, 1}, 0.5f)));
    std::ostringstream warnings;
    compared_entries(scratch / "d.npy", scratch / "f.npy", warnings);
    CHECK(contains(warnings.str(), "d.npy: 1 of its values are doubles that no float holds"));
    warnings.str("");
    CHECK_THROWS_AS(compared_entries(scratch / "p.png", scratch / "f.npy", warnings),
                    InputError);  // three components
}

TEST_CASE("compared files: of directories a picture is left out where both have its numbers") {
    const ScratchDirectory scratch;
    for (const char* side : {"a", "b"}) {
        fs::create_directory(scratch / side);
        write_npy(scratch / side / "ao.npy", Image<float>({3, 3}, 1.0f));
        write_picture(scratch / side / "ao.png", ao_picture(Image<float>({3, 3}, 1.0f)));
        write_picture(scratch / side / "lit.png", ao_picture(Image<float>({3, 3}, 1.0f)));
    }
    write_npy(scratch / "a" / "lit.npy", Image<float>({3, 3}, 1.0f));
    std::ostringstream warnings;
    const auto entries = compared_entries(scratch / "a", scratch / "b", warnings);
    CHECK(contains(warnings.str(), "1 picture is not compared"));
    REQUIRE(entries.size() == 3);
    CHECK(entries[0].title() == "ao.npy");
    CHECK(entries[1].title() == "lit.npy");
    CHECK(entries[1].note == "only in " + (scratch / "a").string());
    CHECK(entries[2].title() == "lit.png");
}
