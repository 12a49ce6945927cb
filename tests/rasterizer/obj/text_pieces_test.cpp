// An OBJ's text is read in pieces: into how many makes no difference.
#include "rasterizer/obj/text_pieces.h"

#include <sstream>

#include <doctest/doctest.h>

#include "rasterizer/base/file_bytes.h"
#include "rasterizer/obj/obj_text.h"
#include "tests/tools/loaded_obj.h"
#include "tests/tools/random_sequence.h"

using namespace crevice;
using namespace std::string_literals;
namespace fs = std::filesystem;

namespace {

// Lines one by one, each with its number.
std::vector<std::pair<std::size_t, std::string>> numbered_lines(const TextPiece& piece) {
    std::vector<std::pair<std::size_t, std::string>> lines;
    for (LogicalLines each(piece.text, piece.first_line); each.advance();)
        lines.emplace_back(each.line, each.text);
    return lines;
}

// Statements as files have them, and as they should not: all that a piece has to know from the pieces before
// (counts, `s`, `usemtl`, lines), and every way to end a line.
std::string random_line(RandomSequence& random, bool flawed) {
    const auto number = [&] { return std::to_string(random.whole(-90, 90) / 10.0); };
    const auto index = [&] {
        const int i = random.whole(-9, 12);
        return std::to_string(i == 0 ? 1 : i);
    };
    const auto corner = [&] {
        switch (random.whole(0, 3)) {
            case 0: return index();
            case 1: return index() + "/" + index();
            case 2: return index() + "//" + index();
            default: return index() + "/" + index() + "/" + index();
        }
    };
    switch (random.whole(0, flawed ? 22 : 20)) {
        case 0: return "vt " + number() + " " + number();
        case 1: return "vn " + number() + " " + number() + " " + number();
        case 2:
            return "usemtl m" + std::to_string(random.whole(0, 4)) + (random.whole(0, 1) == 0 ? "" : " # é");
        case 3: return "s " + std::to_string(random.whole(0, 3));
        case 4: return "s off";
        case 5: return "g side";
        case 6: return "# a comment \\";
        case 7: return "";
        case 8: return "mtllib m" + std::to_string(random.whole(0, 3)) + ".mtl";
        case 9: return "k" + std::to_string(random.whole(0, 14)) + " 1 2";
        case 10: return "v " + number() + " " + number() + " " + number() + " 0.5 1 0.25";
        case 11: return "#MRGB ff" + std::to_string(random.whole(100000, 999999));
        case 12: return "v 1 \\\n\\\r\n 2 " + number();
        case 13: return "f 1 2";
        case 14: return "v nan 1e39 -0";
        case 15:
        case 16:
        case 17: {
            std::string face = "f";
            for (int corners = random.whole(3, 7); corners > 0; --corners) face += " " + corner();
            return face;
        }
        case 21: return random.whole(0, 9) == 0 ? "f 1 2 0" : "F 1 2 3";
        case 22: return random.whole(0, 9) == 0 ? "v 1 x 0" : "V 1 2 3";
        default: return "v " + number() + " " + number() + " " + number();
    }
}

std::string random_text(RandomSequence& random, bool flawed) {
    constexpr const char* kEnds[] = {"\n", "\r\n", "\r", "\n\n"};
    std::string text;
    const int only = random.whole(0, 6);  // most files have one kind of end
    for (int lines = random.whole(1, 80); lines > 0; --lines) {
        text += random_line(random, flawed) + (only < 4 ? kEnds[only] : kEnds[random.whole(0, 3)]);
    }
    if (random.whole(0, 1) == 0) text.pop_back();
    if (random.whole(0, 4) == 0) text += "\\";
    return text;
}

std::string words_of(const Tally& tally) {
    return std::to_string(tally.count) + " from line " + std::to_string(tally.first_line) + "\n";
}

// All that is told of a text, in words; the error where it is refused.
std::string told_of(const fs::path& path, std::size_t piece_bytes, int threads) {
    std::ostringstream told;
    try {
        const LoadedObj loaded = load_obj(path, {.piece_bytes = piece_bytes}, {.threads = threads});
        const Mesh& mesh = mesh_of(loaded);
        const auto bytes = [&](const auto& list) {
            told << list.size() << ": ";
            for (const std::byte b : std::as_bytes(std::span(list))) told << static_cast<int>(b) << ' ';
            told << '\n';
        };
        bytes(mesh.positions), bytes(mesh.normals), bytes(mesh.texcoords), bytes(mesh.colours);
        bytes(mesh.triangles);
        for (const MeshPart& part : mesh.parts)
            told << part.first_triangle << ' ' << part.triangle_count << ' ' << part.material << '\n';
        for (const Material& material : loaded.scene.materials)
            told << material.diffuse.x << ' ' << material.diffuse.y << ' ' << material.diffuse.z << '\n';
        told << loaded.scene.origin.x << ' ' << loaded.scene.origin.y << ' ' << loaded.scene.origin.z << '\n';
        const ObjReport& report = loaded.report;
        for (const std::string& warning : report.warnings) told << warning << '\n';
        for (const Tally& tally : {report.too_few_corners, report.missing_vertices, report.not_finite,
                                   report.zero_area, report.missing_normals, report.missing_texcoords})
            told << words_of(tally);
        for (const IgnoredStatement& ignored : report.ignored_statements)
            told << ignored.keyword << ' ' << words_of(ignored.lines);
        told << report.dropped_faces << ' ' << report.generated_normals;
    } catch (const InputError& error) {
        told << error.what();
    }
    return told.str();
}

// The text in 2, 3 and 7 pieces, and in as many as it has lines, against the text in one.
void check_pieces(const fs::path& path) {
    const std::size_t size = fs::file_size(path);
    const std::string whole = told_of(path, size, 1);
    for (const std::size_t pieces : {std::size_t{2}, std::size_t{3}, std::size_t{7}, size}) {
        CAPTURE(pieces);
        for (const int threads : {1, 2}) CHECK(told_of(path, (size + pieces - 1) / pieces, threads) == whole);
    }
}

}  // namespace

TEST_CASE("text_pieces: their lines are those of the text, with the same numbers") {
    RandomSequence random(1);
    for (int round = 0; round < 300; ++round) {
        std::string text;
        for (int i = random.whole(0, 60); i > 0; --i) text += "a\\\n\r\n#"[random.whole(0, 5)];
        CAPTURE(text);
        const auto whole = numbered_lines({text});
        for (std::size_t piece_bytes = 1; piece_bytes <= text.size() + 1; ++piece_bytes) {
            std::vector<std::pair<std::size_t, std::string>> lines;
            std::size_t bytes = 0;
            for (const TextPiece& piece : text_pieces(text, piece_bytes, {.threads = 1})) {
                const auto of_piece = numbered_lines(piece);
                lines.insert(lines.end(), of_piece.begin(), of_piece.end());
                bytes += piece.text.size();
            }
            CHECK(bytes == text.size());
            CHECK(lines == whole);
        }
    }
}

TEST_CASE("text_pieces: a text without a line end is one piece, and no text is one, too") {
    CHECK(text_pieces("", 1, {}).size() == 1);
    CHECK(text_pieces("v 1 2 3", 1, {}).size() == 1);
    CHECK(text_pieces("v 1 \\\n2 \\\r\n3", 1, {}).size() == 1);
    CHECK(text_pieces("v\nv\n", 1, {}).size() == 2);
}

TEST_CASE("load_obj: the scene, the warnings and the error are the same for any number of pieces") {
    const ScratchDirectory scratch;
    SUBCASE("what the fuzzer starts from") {
        int files = 0;
        for (const fs::directory_entry& seed : fs::directory_iterator(CREVICE_OBJ_SEED_DIR)) {
            CAPTURE(seed.path());
            check_pieces(seed.path());
            ++files;
        }
        CHECK(files > 0);
    }
    SUBCASE("random statements") {
        RandomSequence random(2);
        int refused = 0;
        for (int round = 0; round < 150; ++round) {
            const std::string text = random_text(random, round % 2 == 0);
            CAPTURE(round);
            CAPTURE(text);
            write_text(scratch / "a.obj", text);
            check_pieces(scratch / "a.obj");
            refused += error_of(scratch / "a.obj") != "no error" ? 1 : 0;
        }
        CHECK(refused > 10);
        CHECK(refused < 140);
    }
    SUBCASE("of two errors the first is told") {
        write_text(scratch / "a.obj", kCorners + "f 1 2 x\n"s + kCorners + "f 1 2 y\n");
        check_pieces(scratch / "a.obj");
        CHECK(error_of(scratch / "a.obj").find("a.obj:5: ") != std::string::npos);
    }
    SUBCASE("more keywords than are told one by one") {
        std::string text = kCorners;
        for (int i = 0; i < 40; ++i) text += "others 1\nkey" + std::to_string(i % 12) + " 1\n";
        write_text(scratch / "a.obj", text + "f 1 2 3\n");
        check_pieces(scratch / "a.obj");
    }
    SUBCASE("far from the origin") {
        write_text(scratch / "a.obj",
                   "v 4000000.25 0 0\nv 4000001.5 0 0\nv 4000000 1 0\nf 1 2 3\nf -3 -2 -1\n");
        check_pieces(scratch / "a.obj");
        CHECK(has_warning(load_obj(scratch / "a.obj").report, "too far from their origin"));
    }
}
