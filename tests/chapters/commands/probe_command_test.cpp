// `crevice probe` as a user meets it.
#include <algorithm>
#include <filesystem>
#include <fstream>

#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

#include "rasterizer/base/image_io.h"
#include "tests/tools/crevice_says.h"
#include "tests/tools/scratch_directory.h"

using namespace crevice;
using nlohmann::json;

namespace {

std::string quoted(const std::filesystem::path& path) { return "'" + path.string() + "'"; }

json document_of(const std::string& arguments) {
    const Outcome outcome = crevice_says("probe " + arguments + " --json");
    CAPTURE(outcome.text);
    REQUIRE(outcome.code == 0);
    // Warnings on stderr come before it.
    return json::parse(outcome.text.substr(outcome.text.find('{')));
}

}  // namespace

TEST_CASE("probe command: a wrong word is refused with exit code 2 and one line that names it") {
    const std::pair<const char*, const char*> mistakes[] = {
        {"", "SCENE"},
        {"columns", "SCENE X Y"},
        {"columns 3", "SCENE X Y"},
        {"columns 3 x", "Y: "},
        {"columns 3.5 1", "3.5"},
        {"columns 64 0 --size 64x36", "picture of 64x36 (64 0); give X in 0..63 and Y in 0..35"},
        {"columns 0 36 --size 64x36", "picture of 64x36"},
        {"columns 0 0 --pass raw", "give one of normal_depth, ao, blur, lit"},
        {"columns 0 0 --ao gtoa", "--ao"},
        {"columns 0 0 --param radius=-1", "radius"},
        {"columns 0 0 --param history=3", "--param history"},
        {"columns 0 0 --size 0x3", "0x3"},
        {"columns 0 0 --preset luna", "--preset"},
        {"columns 0 0 0", "0"},
    };
    for (const auto& mistake : mistakes) {
        const std::string arguments = mistake.first, named = mistake.second;
        CAPTURE(arguments);
        const Outcome outcome = crevice_says("probe " + arguments);
        CAPTURE(outcome.text);
        CHECK(outcome.code == 2);
        CHECK(outcome.text.find(named) != std::string::npos);
        CHECK(std::count(outcome.text.begin(), outcome.text.end(), '\n') == 1);
    }
    CHECK(crevice_says("probe no_such_scene 0 0").code == 2);
    CHECK(crevice_says("probe columns 0 0 --size 8x8 --picture --out /proc/nowhere").code == 4);
}

TEST_CASE("probe command: its AO and its light are those that render writes") {
    const ScratchDirectory scratch;
    const std::string view = "columns --size 64x36 --ao gtao --param radius=1 --ao-scale 1";
    REQUIRE(crevice_says("render " + view + " --out " + quoted(scratch / "frame")).code == 0);
    const Image<float> raw = read_npy(scratch / "frame" / "ao_raw.npy").front(),
                       blurred = read_npy(scratch / "frame" / "ao_blurred.npy").front();
    const Planes lit = read_npy(scratch / "frame" / "lit.npy");
    const json passes =
        document_of("columns 30 24 --size 64x36 --ao gtao --param radius=1 --ao-scale 1").at("passes");
    CHECK(passes["ao"]["value"].get<float>() == raw.at(30, 24));
    CHECK(passes["ao"]["texel"] == json({30, 24}));
    CHECK(passes["blur"]["value"].get<float>() == blurred.at(30, 24));
    for (std::size_t c = 0; c < 3; ++c) CHECK(passes["lit"]["value"][c].get<float>() == lit[c].at(30, 24));
}

TEST_CASE("probe command: the answer comes first, tables follow, and no file is written unasked") {
    const ScratchDirectory scratch;
    const std::string pixel = "columns 320 195 --size 640x360";
    const Outcome whole = crevice_says("probe " + pixel + " --out " + quoted(scratch / "none"));
    CHECK(whole.code == 0);
    CHECK(whole.text.starts_with("columns, 640x360, pixel (320, 195), method xjun\n\nAO 0.4305"));
    for (const char* heading : {"---- normal_depth", "---- ao", "---- blur", "---- lit"}) {
        CAPTURE(std::string(heading));
        CHECK(whole.text.find(heading) != std::string::npos);
    }
    CHECK(!std::filesystem::exists(scratch / "none"));
    const Outcome blur = crevice_says("probe " + pixel + " --pass blur");
    CHECK(blur.text.find("---- blur") != std::string::npos);
    CHECK(blur.text.find("---- lit") == std::string::npos);
    for (const std::string& line : {std::string("iteration 4, down"), std::string("the normals differ")})
        CHECK(blur.text.find(line) != std::string::npos);
}

TEST_CASE("probe command: --picture writes the samples into the picture and a section, for every method") {
    const ScratchDirectory scratch;
    for (const char* method : {"xjun", "hbao", "gtao", "vbao", "ray_cast", "msvo"}) {
        CAPTURE(std::string(method));
        const std::filesystem::path out = scratch / method;
        const Outcome outcome = crevice_says("probe columns 160 98 --size 320x180 --picture --ao " +
                                             std::string(method) + " --out " + quoted(out));
        CAPTURE(outcome.text);
        CHECK(outcome.code == 0);
        std::ifstream svg(out / "probe_section.svg");
        std::string begin;
        std::getline(svg, begin);
        CHECK(begin.starts_with("<svg"));
        CHECK(std::filesystem::file_size(out / "probe_overlay.png") > 200);
    }
    // The background has no samples, so there is nothing to cut.
    const Outcome sky =
        crevice_says("probe columns 0 0 --size 320x180 --picture --out " + quoted(scratch / "sky"));
    CHECK(sky.code == 0);
    CHECK(sky.text.find("no probe_section.svg: AO 1") != std::string::npos);
    CHECK(std::filesystem::exists(scratch / "sky" / "probe_overlay.png"));
    CHECK(!std::filesystem::exists(scratch / "sky" / "probe_section.svg"));
}

TEST_CASE(
    "probe command: presets, a picture of one pixel, an orthographic camera, an OBJ, a pixel of an empty "
    "scene") {
    CHECK(document_of("--preset luna 20 20 --size 64x36")["method"] == "luna");
    CHECK(document_of("cornell 0 0 --size 1x1")["passes"]["normal_depth"]["surface"] == true);
    CHECK(document_of("cornell 32 18 --size 64x36 --ortho 5")["passes"]["normal_depth"]["surface"] == true);
    const json empty = document_of("empty 3 2 --size 8x8");
    CHECK(empty["answer"] == "AO 1: the scene has no triangles: everything is open.");
    CHECK(empty["passes"]["raster"]["triangles"].empty());
    const json none = document_of("columns 160 98 --size 320x180 --ao none");
    CHECK(none["passes"]["ao"]["value"] == 1);
    CHECK(none["passes"]["ao"]["samples"].empty());

    const ScratchDirectory scratch;
    std::ofstream(scratch / "triangle.obj") << "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
    const json triangle = document_of(quoted(scratch / "triangle.obj") + " 20 20 --size 40x40");
    CHECK(triangle["passes"]["raster"]["triangles"].size() == 1);
}
