#include "rasterizer/obj/material_textures.h"

#include <doctest/doctest.h>

#include "rasterizer/scene/tangents.h"
#include "tests/tools/loaded_obj.h"
#include "tests/tools/picture_files.h"

using namespace crevice;
using namespace std::string_literals;
namespace fs = std::filesystem;

namespace {

// A square whose texture coordinates are its x and y, of material `m`; `mtl` is what the MTL says of it.
struct Square {
    ScratchDirectory scratch;

    void put(const std::string& name, const std::string& bytes) const { write_text(scratch / name, bytes); }

    LoadedObj load(const std::string& mtl, const ObjOptions& options = {}) const {
        std::string obj = "mtllib a.mtl\n";
        obj += kCorners;
        obj += "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nvn 0 0 1\nusemtl m\nf 1/1/1 2/2/1 4/3/1 3/4/1\n";
        put("a.mtl", "newmtl m\nKd 1 1 1\n" + mtl);
        put("a.obj", obj);
        LoadedObj loaded = load_obj(scratch / "a.obj", options);
        check_whole(loaded);
        return loaded;
    }
    Material material(const std::string& mtl, const ObjOptions& options = {}) const {
        const LoadedObj loaded = load(mtl, options);
        CHECK(loaded.report.warnings == std::vector<std::string>{});
        return loaded.scene.materials[0];
    }
};

std::string grey_png(Size size, const std::string& samples) {
    return png_file(size, {.colour_type = 0}, samples);
}
std::string rgb_png(Size size, const std::string& samples) {
    return png_file(size, {.colour_type = 2}, samples);
}

std::string repeated(const std::string& texel, int count) {
    std::string samples;
    for (int i = 0; i < count; ++i) samples += texel;
    return samples;
}

glm::vec3 normal_at(const Material& m, int x, int y) {
    REQUIRE(m.normal_map != nullptr);
    const glm::vec3 c(m.normal_map->texel(0, x, y));
    const Vec3<float> n = mapped_normal<float>({c.x, c.y, c.z});
    return {n.x, n.y, n.z};
}

}  // namespace

TEST_CASE("material textures: alpha of map_Kd cuts out") {
    const Square square;
    square.put("leaf.png", png_file({2, 1}, {}, "\xff\0\0\xff\xff\0\0\0"s));
    square.put("thin.png", png_file({2, 1}, {}, "\xff\0\0\x40\xff\0\0\0"s));
    square.put("solid.png", png_file({2, 1}, {}, "\xff\0\0\xff\xff\0\0\xff"s));
    const Material leaf = square.material("map_Kd leaf.png\n");
    CHECK(leaf.alpha_cutoff == kCutoutAlpha);
    REQUIRE(leaf.texture);
    CHECK(leaf.texture->texel(0, 0, 0) == glm::vec4(1, 0, 0, 1));
    CHECK(leaf.texture->texel(0, 1, 0).w == 0);
    CHECK(square.material("map_Kd solid.png\n").alpha_cutoff == 0);
    // Holes are part of the shape; colours are not.
    CHECK(square.material("map_Kd leaf.png\n", {.want_textures = false}).alpha_cutoff == kCutoutAlpha);
    CHECK_FALSE(square.material("map_Kd solid.png\n", {.want_textures = false}).texture);
    const LoadedObj thin = square.load("map_Kd thin.png\n");
    CHECK(has_warning(thin.report, "a.mtl:3: a texture cuts out the whole of a material (1 line)"));
    CHECK(thin.scene.materials[0].alpha_cutoff == 0);
    CHECK(thin.scene.materials[0].texture);
}

TEST_CASE("material textures: map_d cuts out, by alpha, by luminance or by a channel") {
    const Square square;
    square.put("colour.png", rgb_png({2, 2}, repeated("\xff\x80\0"s, 4)));
    square.put("grey.png", grey_png({2, 2}, "\xff\0\0\xff"s));
    square.put("rgba.png", png_file({2, 2}, {}, "\0\xff\0\xff\0\xff\0\0\xff\0\0\0\xff\0\0\xff"s));
    struct Row {
        std::string mtl;
        std::array<float, 4> alpha;
    };
    const std::vector<Row> rows = {
        {"map_Kd colour.png\nmap_d grey.png\n", {1, 0, 0, 1}},
        {"map_d grey.png\n", {1, 0, 0, 1}},
        {"map_d rgba.png\n", {1, 0, 0, 1}},
        {"map_Kd colour.png\nmap_d -imfchan g rgba.png\n", {1, 1, 0, 0}},
        {"map_Kd rgba.png\nmap_d rgba.png\n", {1, 0, 0, 1}},
        {"map_Kd rgba.png\nmap_d -imfchan r rgba.png\n", {0, 0, 1, 1}},
    };
    for (const Row& row : rows) {
        CAPTURE(row.mtl);
        for (const bool surfaces : {true, false}) {
            const Material m = square.material(row.mtl, {.want_textures = surfaces});
            CHECK(m.alpha_cutoff == kCutoutAlpha);
            REQUIRE(m.texture);
            for (int i = 0; i < 4; ++i) {
                CAPTURE(i);
                CHECK(m.texture->texel(0, i % 2, i / 2).w == row.alpha[static_cast<std::size_t>(i)]);
            }
        }
    }
    // The map_Kd itself without alpha cuts nothing out, whatever its luminance.
    CHECK(square.material("map_Kd colour.png\nmap_d colour.png\n").alpha_cutoff == 0);
    CHECK(square.material("map_d grey.png\n").texture->texel(0, 0, 0) == glm::vec4(1));
}

TEST_CASE("material textures: colours and cut-out of two sizes are brought to the larger one") {
    const Square square;
    square.put("colour.png", rgb_png({1, 1}, "\xff\0\0"s));
    square.put("mask.png", grey_png({4, 2}, "\xff\xff\0\0\xff\xff\0\0"s));
    const Material m = square.material("map_Kd colour.png\nmap_d mask.png\n");
    REQUIRE(m.texture);
    CHECK(m.texture->size() == Size{4, 2});
    CHECK(m.texture->texel(0, 1, 1) == glm::vec4(1, 0, 0, 1));
    CHECK(m.texture->texel(0, 2, 0) == glm::vec4(1, 0, 0, 0));
}

TEST_CASE("material textures: green of a normal map points up, as v does in the file") {
    const Square square;
    // (0.6, 0, 0.8) and (0, 0.6, 0.8) as colours, rounded.
    square.put("n.png", rgb_png({2, 1}, "\xcc\x80\xe6\x80\xcc\xe6"s));
    for (const std::string keyword : {"norm", "map_Kn", "map_bump", "bump", "map_Bump", "map_Disp", "disp"}) {
        CAPTURE(keyword);
        const LoadedObj loaded = square.load(keyword + " n.png\n");
        CHECK(loaded.report.warnings == std::vector<std::string>{});
        const Material& m = loaded.scene.materials[0];
        CHECK(glm::length(normal_at(m, 0, 0) - glm::vec3(0.6f, 0, 0.8f)) < 0.01f);
        // The lab's green is along v down the picture.
        CHECK(glm::length(normal_at(m, 1, 0) - glm::vec3(0, -0.6f, 0.8f)) < 0.01f);
        CHECK(mesh_of(loaded).tangents.size() == mesh_of(loaded).positions.size());
        CHECK_FALSE(m.normal_map->has_alpha());
    }
    const Material steep = square.material("bump -bm 2 n.png\n");
    CHECK(glm::length(normal_at(steep, 0, 0) - glm::normalize(glm::vec3(1.2f, 0, 0.8f))) < 0.02f);
    CHECK_FALSE(square.material("norm n.png\n", {.want_textures = false}).normal_map);
}

TEST_CASE("material textures: heights become normals that lean away from what is higher") {
    const Square square;
    std::string ramp;  // rises by 4 / 255 a texel to the right, 8 texels
    for (int y = 0; y < 4; ++y) {
        for (int x = 0; x < 8; ++x) ramp.push_back(static_cast<char>(4 * x));
    }
    square.put("h.png", grey_png({8, 4}, ramp));
    const Material m = square.material("bump -bm 10 h.png\n");
    // 7 texels of 1/8 of the width: black to white would be 10 * kBumpHeight widths high.
    const float slope = 10 * kBumpHeight * (4.0f / 255) * 8;
    const glm::vec3 right = glm::normalize(glm::vec3(-slope, 0, 1));
    CHECK(glm::length(normal_at(m, 3, 2) - right) < 1e-4f);
    const LoadedObj displaced = square.load("disp h.png\n");
    CHECK(has_warning(displaced.report, "a.mtl:3: `disp` is not drawn here"));
    CHECK_FALSE(displaced.scene.materials[0].normal_map);
}

TEST_CASE("material textures: the picture with normals is preferred to the one with heights, which is said") {
    const Square square;
    square.put("n.png", rgb_png({1, 1}, "\xcc\x80\xe6"s));
    square.put("h.png", grey_png({1, 1}, "\x80"s));
    const LoadedObj loaded = square.load("bump h.png\ndisp n.png\n");
    CHECK(normal_at(loaded.scene.materials[0], 0, 0).x > 0.5f);
    CHECK(has_warning(loaded.report, "a.mtl:3: `bump` is not drawn here"));
    const LoadedObj both = square.load("norm n.png\nbump h.png\n");
    CHECK(normal_at(both.scene.materials[0], 0, 0).x > 0.5f);
    CHECK(has_warning(both.report, "`bump` is not drawn here"));
}

TEST_CASE("material textures: a JPEG that a viewer would turn is drawn as it is stored, and said") {
    const Square square;
    square.put("upright.jpg", grey_jpeg(exif_segment(1)));
    square.put("turned.jpg", grey_jpeg(exif_segment(6)));
    square.material("map_Kd upright.jpg\n");
    const LoadedObj turned = square.load("map_Kd turned.jpg\n");
    CHECK(turned.scene.materials[0].texture);
    REQUIRE(turned.report.warnings.size() == 1);
    CHECK(has_warning(turned.report,
                      "a.mtl:3: a texture's EXIF orientation would have it turned or mirrored (1 line); "
                      "drawn as its pixels are stored"));
}

TEST_CASE(
    "material textures: a PNG whose gAMA chunk says another exponent than sRGB's is read by it, and said") {
    const Square square;
    const auto picture = [](const std::string& gamma) {
        return png_file({1, 1}, {.colour_type = 2, .chunks = png_chunk("gAMA", gamma)}, "\x80\x80\x80"s);
    };
    square.put("srgb.png", picture("\0\0\xb1\x8f"s));
    square.put("light.png", picture("\0\1\x86\xa0"s));
    square.material("map_Kd srgb.png\nnorm light.png\n");
    const LoadedObj light = square.load("map_Kd light.png\n");
    REQUIRE(light.scene.materials[0].texture);
    CHECK(light.scene.materials[0].texture->texel(0, 0, 0).x == doctest::Approx(128.0 / 255).epsilon(1e-3));
    REQUIRE(light.report.warnings.size() == 1);
    CHECK(
        has_warning(light.report,
                    "a.mtl:3: a texture's gAMA chunk says that its colours are not sRGB (1 line); drawn with "
                    "the exponent that it gives"));
}

TEST_CASE(
    "material textures: coordinates that are absent, or too far away for floats, are said where they "
    "matter") {
    const ScratchDirectory scratch;
    write_text(scratch / "t.png", rgb_png({1, 1}, "\xff\0\0"s));
    write_text(scratch / "a.mtl", "newmtl shown\nKd 1 1 1\nmap_Kd t.png\nnewmtl plain\nKd 1 1 1\n");
    const auto warnings_of = [&](const std::string& faces) {
        write_text(scratch / "a.obj", "mtllib a.mtl\n" + std::string(kCorners) +
                                          "vt 65537 0\nvt 0 -1e9\nvt 65536 -65536\n" + faces);
        return load_obj(scratch / "a.obj").report.warnings;
    };
    const std::vector<std::string> absent =
        warnings_of("usemtl shown\nf 1/3 2/3 3/3\nf 1 2 3\nf 1/3 2/3 4\n");
    REQUIRE(absent.size() == 1);
    CHECK(
        absent[0].find(
            ":11: a textured material without texture coordinates (2 faces, the first here); (0, 0) used") !=
        std::string::npos);
    const std::vector<std::string> far = warnings_of("usemtl shown\nf 1/3 2/3 3/3\nf 1/1 2/3 3/2\n");
    REQUIRE(far.size() == 1);
    CHECK(
        far[0].find(":11: a texture coordinate beyond 65536, where floats lose their place in the texture (2 "
                    "corners, the first here); ") != std::string::npos);
    CHECK(warnings_of("usemtl plain\nf 1/1 2/3 3/2\nf 1 2 3\n").empty());
}

TEST_CASE("material textures: scale, offset and clamp") {
    const Square square;
    square.put("t.png", rgb_png({1, 1}, "\xff\0\0"s));
    const LoadedObj loaded = square.load("map_Kd -s 2 3 1 -o .5 .25 0 t.png\n");
    CHECK(loaded.report.warnings == std::vector<std::string>{});
    const Mesh& mesh = mesh_of(loaded);
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        const glm::vec3& p = mesh.positions[i];  // whose x and y are the texture coordinates of the file
        CHECK(mesh.texcoords[i] == glm::vec2(2 * p.x + 0.5f, 1 - (3 * p.y + 0.25f)));
    }
    const LoadedObj clamped = square.load("map_Kd -clamp on t.png\n");
    CHECK(clamped.scene.materials[0].sampler.address_u == AddressMode::border);
    CHECK(clamped.scene.materials[0].sampler.border == glm::vec4(1));
    CHECK(has_warning(clamped.report, "-clamp on"));
    CHECK(has_warning(square.load("map_Kd -s 2 2 t.png\nmap_d t.png\nnorm t.png\n").report,
                      "-s, -o or -clamp differ between the textures of material `m` (t.png)"));
}

TEST_CASE("material textures: map_Ks multiplies Ks by its mean") {
    const Square square;
    square.put("s.png", rgb_png({2, 1}, "\xff\xff\xff\0\0\0"s));
    const LoadedObj loaded = square.load("Ks .5 .5 .5\nmap_Ks s.png\n");
    CHECK(loaded.scene.materials[0].specular == glm::vec3(0.25f));
    CHECK(has_warning(loaded.report, "`map_Ks` is drawn as its mean colour alone"));
}

TEST_CASE("material textures: a file is looked for beside its MTL, then beside the OBJ") {
    const ScratchDirectory scratch;
    fs::create_directories(scratch / "m/lib/maps");
    const std::string red = rgb_png({1, 1}, "\xff\0\0"s), green = rgb_png({1, 1}, "\0\xff\0"s);
    write_text(scratch / "m/lib/maps/t.png", red);
    fs::create_directories(scratch / "m/maps");
    write_text(scratch / "m/maps/t.png", green);
    write_text(scratch / "m/top.png", green);
    write_text(scratch / "m/lib/a.mtl",
               "newmtl near\nKd 1 1 1\nmap_Kd maps/t.png\nnewmtl far\nKd 1 1 1\nmap_Kd top.png\n"
               "newmtl absolute\nKd 1 1 1\nmap_Kd D:\\work\\Top.png\n");
    std::string obj = "mtllib lib/a.mtl\n";
    obj += kCorners;
    obj += "vt 0 0\nusemtl near\nf 1/1 2/1 3/1\nusemtl far\nf 1/1 2/1 3/1\nusemtl absolute\nf 1/1 2/1 3/1\n";
    write_text(scratch / "m/a.obj", obj);
    const LoadedObj loaded = load_obj(scratch / "m/a.obj");
    const auto colour = [&](std::size_t m) {
        return glm::vec3(loaded.scene.materials.at(m).texture->texel(0, 0, 0));
    };
    CHECK(colour(0) == glm::vec3(1, 0, 0));
    CHECK(colour(1) == glm::vec3(0, 1, 0));
    CHECK(colour(2) == glm::vec3(0, 1, 0));
    REQUIRE(loaded.report.warnings.size() == 1);
    CHECK(has_warning(loaded.report, "m/lib/a.mtl:9: a texture is not where its path says"));
}
