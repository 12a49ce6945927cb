// The orientation is found where EXIF has it, in either byte order, and nothing else is taken for one.
#include "rasterizer/textures/exif_orientation.h"

#include <doctest/doctest.h>

#include "tests/tools/picture_files.h"

using namespace crevice;
using namespace std::string_literals;

TEST_CASE("exif_orientation: what a JPEG says, 1 where it says none") {
    for (int orientation = 1; orientation <= 8; ++orientation)
        CHECK(exif_orientation(grey_jpeg(exif_segment(orientation))) == orientation);
    CHECK(exif_orientation(grey_jpeg()) == 1);
    CHECK(exif_orientation(grey_jpeg(exif_segment(0))) == 1);
    CHECK(exif_orientation(grey_jpeg(exif_segment(9))) == 1);
    const std::string comment = "\xff\xfe\0\4ab"s;
    CHECK(exif_orientation(grey_jpeg(comment + exif_segment(6))) == 6);
    const std::string little =
        "\xff\xe1\0\x22"s + "Exif\0\0II*\0\x08\0\0\0\1\0\x12\1\3\0\1\0\0\0\3\0\0\0\0\0\0\0"s;
    CHECK(exif_orientation(grey_jpeg(little)) == 3);
}

TEST_CASE("exif_orientation: any cut and any other file gives 1 or what is there, and ends") {
    const std::string whole = grey_jpeg(exif_segment(6));
    for (std::size_t length = 0; length < whole.size(); ++length) {
        CAPTURE(length);
        const int found = exif_orientation(whole.substr(0, length));
        CHECK((found == 1 || found == 6));
    }
    CHECK(exif_orientation("\xff\xd8\xff\xe1\0\0\xff\xe1\0\0"s) == 1);
    CHECK(exif_orientation("\x89PNG\r\n\x1a\n") == 1);
}
