// Pictures that are decoded ahead of their use are those that are decoded when they are used.
#include "rasterizer/obj/images_ahead.h"

#include <doctest/doctest.h>

#include "tests/tools/loaded_obj.h"
#include "tests/tools/picture_files.h"

using namespace crevice;
namespace fs = std::filesystem;

namespace {

std::string grey_picture_of(int value, Size size = {2, 2}) {
    const auto pixels = static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height);
    return png_file(size, {.colour_type = 0}, std::string(pixels, static_cast<char>(value)));
}

std::string error_of_taking(ImagesAhead& images, const fs::path& path, std::int64_t most_pixels) {
    try {
        images.take(path, TextureEncoding::linear, most_pixels);
    } catch (const InputError& error) {
        return error.what();
    }
    return "no error";
}

}  // namespace

TEST_CASE("images ahead: each picture is the one that was asked for, in any order and more than once") {
    const ScratchDirectory scratch;
    for (int i = 0; i < 7; ++i) write_text(scratch / std::to_string(i), grey_picture_of(10 * i));
    for (const int threads : {1, 2, 7}) {
        ImagesAhead images({.threads = threads});
        for (int i = 0; i < 6; ++i) images.expect(scratch / std::to_string(i), TextureEncoding::linear);
        images.expect(scratch / "2", TextureEncoding::srgb);
        // 3 is passed over and asked for later, 6 was not expected, and 2 is asked for twice.
        for (const int i : {0, 1, 2, 4, 3, 6, 2, 5}) {
            CAPTURE(i);
            const DecodedFile file = images.take(scratch / std::to_string(i), TextureEncoding::linear, 100);
            CHECK(file.image.colour.at(1, 1).x == static_cast<float>(10 * i) / 255);
            CHECK(file.exif_orientation == 1);
        }
        CHECK(images.take(scratch / "2", TextureEncoding::srgb, 100).image.colour.at(0, 0).x < 0.02f);
    }
}

TEST_CASE("images ahead: a picture that cannot be read, or is too large, is the error that it is without") {
    const ScratchDirectory scratch;
    write_text(scratch / "good", grey_picture_of(1));
    write_text(scratch / "large", grey_picture_of(1, {20, 20}));
    write_text(scratch / "damaged", grey_picture_of(1).substr(0, 40));
    for (const char* const name : {"damaged", "large", "missing"}) {
        CAPTURE(name);
        ImagesAhead ahead({.threads = 2}), not_ahead({.threads = 2});
        ahead.expect(scratch / "good", TextureEncoding::linear);
        ahead.expect(scratch / name, TextureEncoding::linear);
        ahead.take(scratch / "good", TextureEncoding::linear, 100);
        const std::string error = error_of_taking(ahead, scratch / name, 100);
        CHECK(error == error_of_taking(not_ahead, scratch / name, 100));
        CHECK(error.find(name) != std::string::npos);
    }
}

TEST_CASE("load_obj: textures and warnings are the same on any number of threads") {
    const ScratchDirectory scratch;
    std::string mtl, obj = "mtllib a.mtl\n";
    obj += kCorners;
    obj += "vt 0 0\nvt 1 0\nvt 1 1\n";
    for (int i = 0; i < 6; ++i) {
        const std::string n = std::to_string(i);
        write_text(scratch / ("c" + n + ".png"), grey_picture_of(20 * i + 5));
        write_text(scratch / ("n" + n + ".png"), grey_picture_of(9 * i, {4, 4}));
        mtl += "newmtl m" + n + "\nKd 1 1 1\nKs 1 1 1\nmap_Kd c" + n + ".png\nmap_Ks c" + n + ".png\nbump n" +
               n + ".png\nmap_d " + (i % 2 == 0 ? "c1.png" : "none.png") + "\n";
        obj += "usemtl m" + n + "\nf 1/1 2/2 3/3\n";
    }
    write_text(scratch / "n3.png", "no picture");
    write_text(scratch / "a.mtl", mtl);
    write_text(scratch / "a.obj", obj);
    const LoadedObj one = load_obj(scratch / "a.obj", {}, {.threads = 1});
    for (const int threads : {2, 5}) {
        const LoadedObj many = load_obj(scratch / "a.obj", {}, {.threads = threads});
        CHECK(many.report.warnings == one.report.warnings);
        CHECK(one.report.warnings.size() > 3);
        REQUIRE(many.scene.materials.size() == one.scene.materials.size());
        for (std::size_t m = 0; m + 1 < one.scene.materials.size(); ++m) {
            CAPTURE(m);
            const Material &a = one.scene.materials[m], &b = many.scene.materials[m];
            CHECK(a.specular == b.specular);
            REQUIRE(a.texture != nullptr);
            REQUIRE(b.texture != nullptr);
            CHECK(a.texture->texel(0, 1, 1) == b.texture->texel(0, 1, 1));
            REQUIRE((a.normal_map == nullptr) == (b.normal_map == nullptr));
            if (a.normal_map) CHECK(a.normal_map->texel(0, 1, 1) == b.normal_map->texel(0, 1, 1));
        }
    }
}
