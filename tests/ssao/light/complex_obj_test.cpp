// An OBJ of the kind of Crytek's Sponza, with everything that its exporters write: it draws whole.
#include <cmath>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include "rasterizer/scene/tangent_turn.h"
#include "ssao/light/shade.h"
#include "tests/tools/image_checks.h"
#include "tests/tools/loaded_obj.h"
#include "tests/tools/picture_files.h"

using namespace crevice;
using namespace std::string_literals;
namespace fs = std::filesystem;

namespace {

constexpr int kMaterials = 26, kColumns = 7;
constexpr Size kSize{140, 80};

std::string repeated(const std::string& texel, int count) {
    std::string samples;
    for (int i = 0; i < count; ++i) samples += texel;
    return samples;
}

// Red, green and blue of a material's picture, each 0 or 255 and not all 0.
std::array<int, 3> codes_of(int material) {
    const int bits = 1 + material % 7;
    return {255 * (bits & 1), 255 * (bits >> 1 & 1), 255 * (bits >> 2 & 1)};
}

bool is_chain(int material) { return material % 9 == 4; }

// As an exporter of 3ds Max writes it: illum and d 0 for what is solid, Windows paths, TGA, bumps of two kinds.
void write_textures(const fs::path& directory) {
    fs::create_directories(directory);
    for (int m = 0; m < kMaterials; ++m) {
        const auto [r, g, b] = codes_of(m);
        const std::string bgr{static_cast<char>(b), static_cast<char>(g), static_cast<char>(r)};
        write_text(directory / ("colour_" + std::to_string(m) + ".tga"),
                   tga_header(m % 2 == 0 ? 2 : 10, {4, 4}, 24, m % 4 < 2 ? 0 : 0x20) +
                       (m % 2 == 0 ? repeated(bgr, 16) : "\x8f" + bgr));
    }
    // The upper half of a chain is not there.
    write_text(directory / "chain_mask.tga",
               tga_header(3, {4, 4}, 8, 0x20) + repeated("\0"s, 8) + repeated("\xff", 8));
    write_text(directory / "bump.png", png_file({4, 4}, {.colour_type = 0}, repeated("\x20\x40", 8)));
    write_text(directory / "ddn.tga", tga_header(2, {2, 2}, 24, 0x20) + repeated("\xe6\x80\xcc", 4));
}

std::string mtl_text() {
    std::string mtl = "# 3ds Max Wavefront OBJ Exporter\r\n";
    for (int m = 0; m < kMaterials; ++m) {
        const std::string n = std::to_string(m);
        mtl += "\r\nnewmtl Material__" + n + "\r\n\tNs 7.843137\r\n\tNi 1.5\r\n\td " +
               (m % 3 == 0 ? "0" : "1") + "\r\n\tTr " + (m % 3 == 0 ? "1" : "0") +
               "\r\n\tTf 1 1 1\r\n\tillum 2\r\n\tKa 0 0 0\r\n\tKd 0.588 0.588 0.588\r\n\tKs 0 0 0\r\n\tKe 0 "
               "0 0\r\n";
        mtl += "\tmap_Ka Textures\\colour_" + n + ".tga\r\n\tmap_Kd Textures\\colour_" + n + ".tga\r\n";
        if (is_chain(m)) mtl += "\tmap_d textures\\chain_mask.tga\r\n";
        if (m % 2 == 0) mtl += "\tmap_bump textures\\bump.png\r\n\tbump textures\\bump.png\r\n";
        if (m % 5 == 0) mtl += "\tmap_Disp textures\\ddn.tga\r\n";
    }
    return mtl;
}

// A square of one unit for each material, in rows of kColumns, facing the reader.
std::string obj_text_of_squares() {
    std::string obj = "mtllib sponza.mtl\r\nvt 0 0 0\r\nvt 1 0 0\r\nvt 1 1 0\r\nvt 0 1 0\r\nvn 0 0 1\r\n";
    for (int m = 0; m < kMaterials; ++m) {
        const int x = m % kColumns, y = m / kColumns;
        for (const auto& [dx, dy] : {std::pair(0, 0), {1, 0}, {1, 1}, {0, 1}})
            obj += "v " + std::to_string(x + dx) + " " + std::to_string(y + dy) + " 0\r\n";
        obj += "g square" + std::to_string(m) + "\r\nusemtl Material__" + std::to_string(m) + "\r\ns " +
               std::to_string(m % 4) + "\r\nf -4/1/1 -3/2/1 -2/3/1 -1/4/1\r\n";
    }
    return obj;
}

}  // namespace

TEST_CASE("an OBJ like Crytek's Sponza: 26 materials draw whole") {
    const ScratchDirectory scratch;
    write_textures(scratch / "textures");
    write_text(scratch / "sponza.mtl", mtl_text());
    write_text(scratch / "sponza.obj", obj_text_of_squares());
    LoadedObj loaded = load_obj(scratch / "sponza.obj");
    check_whole(loaded);
    CHECK(has_warning(loaded.report,
                      "sponza.mtl:3: a material would be wholly invisible (d 0 or Tr 1) (9 lines"));
    CHECK(has_warning(loaded.report, "`bump` is not drawn here"));
    CHECK(loaded.report.warnings.size() == 2);
    Scene& scene = loaded.scene;
    CHECK(scene.materials.size() == kMaterials + 1);
    CHECK(has_normal_maps(scene));

    scene.sky = glm::vec3(0);
    scene.camera = {.eye = {3.5, 2, -10},
                    .target = {3.5, 2, 0},
                    .projection = Projection::orthographic,
                    .ortho_height = 4,
                    .near_plane = 1,
                    .far_plane = 20};
    const Image3 lit = shade(scene, scene.camera, normal_depth(scene, scene.camera, kSize).depth, {});
    // 20 pixels a square.
    for (int m = 0; m < kMaterials; ++m) {
        CAPTURE(m);
        const int x = 20 * (m % kColumns) + 10, middle = kSize.height - 20 * (m / kColumns) - 10;
        const glm::vec3 upper = lit.at(x, middle - 6), lower = lit.at(x, middle + 6);
        for (int channel = 0; channel < 3; ++channel) {
            CAPTURE(channel);
            const bool shines = codes_of(m)[static_cast<std::size_t>(channel)] > 0;
            CHECK((lower[channel] > 0.1f) == shines);
            CHECK((upper[channel] > 0.1f) == (shines && !is_chain(m)));
        }
    }
}
