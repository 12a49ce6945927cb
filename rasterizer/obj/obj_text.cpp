#include "rasterizer/obj/obj_text.h"

#include <algorithm>
#include <exception>
#include <map>
#include <utility>

#include "rasterizer/base/parallel.h"
#include "rasterizer/obj/obj_parse.h"

namespace crevice {
namespace {

struct ReadPiece {
    ObjPrescan prescan;
    WrittenFaces faces;
    std::exception_ptr failure;  // null: none
};

ReadPiece read_piece(const TextPiece& piece, const std::string& name) {
    ReadPiece read;
    try {
        read.prescan = prescan_obj(piece, name);
        read.faces = parse_faces(std::exchange(read.prescan.statements, {}));
    } catch (...) {
        read.failure = std::current_exception();
    }
    return read;
}

// Where the lists of a piece begin in those of the whole text, and what was said before it.
struct PieceStart {
    std::size_t positions = 0, texcoords = 0, normals = 0, faces = 0, corners = 0;
    std::uint32_t smoothing = kNoSmoothing;
    std::int32_t material = -1;                      // into ObjText::materials
    std::vector<std::int32_t> material_of_use = {};  // the same, for each of the materials of the piece
};

// Appends one piece after the other.
struct Joiner {
    ObjText whole = {};
    std::map<std::string, std::int32_t> material_of_name = {};
    PieceStart next = {};

    PieceStart add(ObjPrescan& piece, std::size_t corners) {
        PieceStart start = next;
        for (ObjMaterialUse& use : piece.materials) {
            const auto number = static_cast<std::int32_t>(whole.materials.size());
            const auto [at, is_new] = material_of_name.emplace(use.name, number);
            if (is_new) whole.materials.push_back(std::move(use));
            start.material_of_use.push_back(at->second);
        }
        next.positions += piece.vertices.positions.size();
        next.texcoords += piece.texcoords.size();
        next.normals += piece.normals.size();
        next.faces += piece.face_origins.size();
        next.corners += corners;
        if (piece.smoothing.last) next.smoothing = *piece.smoothing.last;
        if (piece.material.last)
            next.material = start.material_of_use[static_cast<std::size_t>(*piece.material.last)];
        std::move(piece.libraries.begin(), piece.libraries.end(), std::back_inserter(whole.libraries));
        whole.report.add_tallies(piece.report);
        for (const IgnoredStatement& ignored : piece.report.ignored_statements) ignore(ignored);
        return start;
    }

    void ignore(const IgnoredStatement& ignored) {
        auto& all = whole.report.ignored_statements;
        const auto same =
            std::find_if(all.begin(), all.end(), [&](const auto& s) { return s.keyword == ignored.keyword; });
        // A file of another kind can start every line with another word: the ninth and later are counted
        // together.
        constexpr std::size_t kMostKeywords = 8;
        if (same != all.end()) {
            same->lines.add(ignored.lines);
        } else if (all.size() <= kMostKeywords) {
            all.push_back({all.size() == kMostKeywords ? "others" : ignored.keyword, ignored.lines});
        } else {
            all.back().lines.add(ignored.lines);
        }
    }
};

// `index` as written: from 1, negative ones back from the `listed_before`, 0 for none.
std::int32_t absolute_index(std::int32_t index, std::size_t listed_before) {
    if (index > 0) return index - 1;
    if (index == 0) return kAbsentIndex;
    const std::int64_t absolute = static_cast<std::int64_t>(listed_before) + index;
    return absolute >= 0 ? static_cast<std::int32_t>(absolute) : kBeforeFirst;
}

// Puts the faces of a piece where they belong.
void place_faces(const ReadPiece& piece, const PieceStart& start, ObjFaces& whole) {
    const ObjPrescan& prescan = piece.prescan;
    std::size_t corner = 0;
    for (std::size_t f = 0; f < prescan.face_origins.size(); ++f) {
        const FaceOrigin& origin = prescan.face_origins[f];
        const std::uint32_t count = piece.faces.corner_counts[f];
        whole.faces[start.faces + f] = {
            .first_corner = start.corners + corner,
            .corner_count = count,
            .material = f < prescan.material.faces_before || !prescan.material.last
                            ? start.material
                            : start.material_of_use[static_cast<std::size_t>(origin.material)],
            .line = origin.line,
            .smoothing = f < prescan.smoothing.faces_before || !prescan.smoothing.last ? start.smoothing
                                                                                       : origin.smoothing};
        const std::size_t positions = start.positions + static_cast<std::size_t>(origin.positions),
                          texcoords = start.texcoords + static_cast<std::size_t>(origin.texcoords),
                          normals = start.normals + static_cast<std::size_t>(origin.normals);
        for (const std::size_t end = corner + count; corner < end; ++corner) {
            const ObjCorner& written = piece.faces.corners[corner];
            whole.corners[start.corners + corner] = {absolute_index(written.position, positions),
                                                     absolute_index(written.texcoord, texcoords),
                                                     absolute_index(written.normal, normals)};
        }
    }
}

}  // namespace

ObjText read_obj_text(std::span<const TextPiece> pieces, const std::string& name, const Run& run) {
    const auto count = static_cast<int>(pieces.size());
    std::vector<ReadPiece> read(pieces.size());
    parallel_for(count, run, [&](int i) {
        const auto at = static_cast<std::size_t>(i);
        read[at] = read_piece(pieces[at], name);
    });
    Joiner joiner;
    std::vector<PieceStart> starts;
    std::size_t vertex_or_face_lines = 0;
    for (ReadPiece& piece : read) {
        if (piece.failure) std::rethrow_exception(piece.failure);
        starts.push_back(joiner.add(piece.prescan, piece.faces.corners.size()));
        vertex_or_face_lines += piece.prescan.vertex_or_face_lines;
    }
    ObjText& whole = joiner.whole;
    const std::size_t lines = read.back().prescan.last_line;
    if (vertex_or_face_lines == 0) {
        throw InputError(name + ": this is not an OBJ (no `v` and no `f` line in " + std::to_string(lines) +
                         " lines); give an OBJ with vertices and faces");
    }
    if (joiner.next.positions == 0) {
        throw InputError(name + ":" + std::to_string(lines) +
                         ": the file has faces and no vertices; give an OBJ with vertices and faces");
    }
    whole.faces.faces.resize(joiner.next.faces);
    whole.faces.corners.resize(joiner.next.corners);
    parallel_for(count, run, [&](int i) {
        const auto at = static_cast<std::size_t>(i);
        place_faces(read[at], starts[at], whole.faces);
        read[at].faces = {};
        read[at].prescan.face_origins = {};
    });
    whole.vertices.reserve(joiner.next.positions);
    whole.texcoords.reserve(joiner.next.texcoords);
    whole.normals.reserve(joiner.next.normals);
    for (ReadPiece& piece : read) {
        const ObjPrescan& lists = piece.prescan;
        whole.vertices.append(lists.vertices);
        whole.texcoords.insert(whole.texcoords.end(), lists.texcoords.begin(), lists.texcoords.end());
        whole.normals.insert(whole.normals.end(), lists.normals.begin(), lists.normals.end());
        piece = {};
    }
    whole.vertices.finish_colours(name, whole.report.warnings);
    return std::move(whole);
}

}  // namespace crevice
