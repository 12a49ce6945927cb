#include "rasterizer/obj/mtl_texture.h"

#include <doctest/doctest.h>

using namespace crevice;

TEST_CASE("read_texture: options before and behind the name take the numbers that are theirs") {
    struct Row {
        std::string rest, file;
        glm::vec2 scale, offset;
    };
    const glm::vec2 one(1), zero(0);
    const std::vector<Row> rows = {
        {"wood.png", "wood.png", one, zero},
        {"  two words.png  ", "two words.png", one, zero},
        {"\"quoted name.png\"", "quoted name.png", one, zero},
        {"wood.png # oak", "wood.png", one, zero},
        {"C:\\maps\\wood.png", "C:\\maps\\wood.png", one, zero},
        {"-s 2 wood.png", "wood.png", {2, 1}, zero},
        {"-s 2 3 wood.png", "wood.png", {2, 3}, zero},
        {"-s 2 3 4 wood.png", "wood.png", {2, 3}, zero},
        {"-S 2 3 4 wood.png", "wood.png", {2, 3}, zero},
        {"-o .5 wood.png", "wood.png", one, {0.5f, 0}},
        {"-o .5 -.25 0 -s 2 2 wood.png", "wood.png", {2, 2}, {0.5f, -0.25f}},
        {"wood.png -s 2 2 2 -o 1 1", "wood.png", {2, 2}, {1, 1}},
        {"-s 2 2 2 4 seasons.png", "4 seasons.png", {2, 2}, zero},
        {"-s 2 2 1", "1", {2, 2}, zero},  // the last word is the name
        {"-clamp on -blendu on -blendv on -cc off -mm 0 1 -t 0 0 0 wood.png", "wood.png", one, zero},
    };
    for (const Row& row : rows) {
        CAPTURE(row.rest);
        MtlNotes notes;
        const MtlTexture texture = read_texture("map_Kd", row.rest, 7, notes);
        CHECK(texture.file == row.file);
        CHECK(texture.line == 7);
        CHECK(texture.scale == row.scale);
        CHECK(texture.offset == row.offset);
        CHECK(notes.wrong == std::vector<std::string>{});
        CHECK(notes.not_drawn == std::vector<std::string>{});
    }
}

TEST_CASE("read_texture: options that are honoured") {
    MtlNotes notes;
    const MtlTexture texture = read_texture("bump", "-bm 0.5 -clamp on -imfchan m rock.png", 1, notes);
    CHECK(texture.file == "rock.png");
    CHECK(texture.bump_factor == 0.5f);
    CHECK(texture.clamp);
    CHECK(texture.channel == TexelChannel::alpha);
    CHECK((notes.wrong.empty() && notes.not_drawn.empty()));
    CHECK(read_texture("map_d", "wood #2.png", 1, notes).whole_line == "wood #2.png");
}

TEST_CASE("read_texture: options that are not drawn are named and eat nothing of the name") {
    for (const std::string option : {"-mm 0.2 0.5", "-mm .2", "-t 1 1 1", "-boost 2", "-texres 512", "-cc on",
                                     "-blendu off", "-blendv off", "-type sphere"}) {
        CAPTURE(option);
        MtlNotes notes;
        CHECK(read_texture("map_Kd", option + " wood.png", 1, notes).file == "wood.png");
        CHECK(notes.wrong == std::vector<std::string>{});
        CHECK(notes.not_drawn == std::vector<std::string>{option.substr(0, option.find(' '))});
    }
}

TEST_CASE("read_texture: options that are ill written are said") {
    struct Row {
        std::string rest, wrong, file;
    };
    const std::vector<Row> rows = {
        {"-s 0,5 0,5 1 wood.png", "`map_Kd -s` has a number that is none (0,5)", "wood.png"},
        {"-o 0,5 0,25 0 wood.png",
         "`map_Kd -o` has a number that is none (0,5); write it with a decimal point, passed over",
         "wood.png"},
        {"-s nan 1 wood.png", "`map_Kd -s` has a number that is none (nan)", "wood.png"},
        {"-s wood.png", "`map_Kd -s` has no number", "wood.png"},
        {"-clamp wood.png", "`map_Kd -clamp` wants on or off", "wood.png"},
        {"-imfchan q wood.png", "`map_Kd -imfchan` wants r, g, b, m or l", "q wood.png"},
        {"-s 1e38 1e38 1 wood.png", "`map_Kd -s` is beyond 65536 (1e+38)", "wood.png"},
        {"-s -65537 wood.png", "`map_Kd -s` is beyond 65536 (-65537)", "wood.png"},
        {"-o 0 1e9 wood.png", "`map_Kd -o` is beyond 65536 (1e+09)", "wood.png"},
        {"", "`map_Kd` names no file", ""},
        {"# forgotten", "`map_Kd` names no file", ""},
    };
    for (const Row& row : rows) {
        CAPTURE(row.rest);
        MtlNotes notes;
        const MtlTexture texture = read_texture("map_Kd", row.rest, 1, notes);
        REQUIRE(notes.wrong.size() >= 1);
        CHECK(notes.wrong.back().find(row.wrong) == 0);
        CHECK(texture.file == row.file);
        CHECK(texture.scale == glm::vec2(1));
    }
}

TEST_CASE("read_texture: a channel is named where the statement shows more than one") {
    for (const std::string keyword : {"map_Kd", "map_Ks", "map_Ka", "norm"}) {
        CAPTURE(keyword);
        MtlNotes notes;
        CHECK(read_texture(keyword, "-imfchan r wood.png", 1, notes).file == "wood.png");
        CHECK(notes.not_drawn == std::vector<std::string>{"-imfchan"});
    }
    for (const std::string keyword : {"map_d", "MAP_D", "bump", "map_Bump", "disp", "map_disp"}) {
        CAPTURE(keyword);
        MtlNotes notes;
        CHECK(read_texture(keyword, "-imfchan r wood.png", 1, notes).channel == TexelChannel::red);
        CHECK(notes.not_drawn.empty());
    }
}
