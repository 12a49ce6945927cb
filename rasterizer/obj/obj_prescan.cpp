#include "rasterizer/obj/obj_prescan.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <map>

#include "rasterizer/obj/ear_clip.h"
#include "rasterizer/obj/obj_lines.h"

namespace crevice {
namespace {

// Statements that change nothing in what is drawn here: names, groups, display hints.
bool is_harmless_statement(std::string_view keyword) {
    static constexpr std::array<std::string_view, 11> kHarmless = {
        "g",        "o",          "mg",        "lod",    "bevel", "c_interp",
        "d_interp", "shadow_obj", "trace_obj", "maplib", "usemap"};
    return std::find(kHarmless.begin(), kHarmless.end(), keyword) != kHarmless.end();
}

void check_index(const ObjPlace& place, std::string_view field, std::string_view corner) {
    const bool sign = !field.empty() && (field[0] == '-' || field[0] == '+');
    const std::string_view digits = field.substr(sign);
    const bool whole = !digits.empty() &&
                       std::all_of(digits.begin(), digits.end(), [](char c) { return c >= '0' && c <= '9'; });
    if (!whole) {
        place.fail("this is not a whole index (" + std::string(corner) +
                   "); write v, v/vt, v//vn or v/vt/vn");
    }
    // The sign changes nothing here: a file small enough to be read has no room for 2^31 vertices.
    std::int32_t value = 0;
    const std::errc error = std::from_chars(digits.data(), digits.data() + digits.size(), value).ec;
    if (error != std::errc()) {
        place.fail("the index is too large (" + std::string(corner) +
                   "); give the number of a vertex of this file");
    }
    if (value == 0) place.fail("an index is zero (" + std::string(corner) + "); OBJ counts from 1");
}

// How many corners `rest` has, if it is written as nearly every face is, so that nothing can be said against it
// and it can go on as it stands: a blank before each corner, and one to three indices with slashes between them.
// 0 if it is not.
std::size_t plain_corners(std::string_view rest) {
    constexpr int kDigits = 9;  // any number of so many fits
    std::size_t corners = 0;
    int fields = 0, digits = 0;
    bool above_zero = false;
    for (std::size_t i = 0; i < rest.size(); ++i) {
        const char c = rest[i];
        if (c >= '0' && c <= '9') {
            if (++digits > kDigits || fields == 0) return 0;
            above_zero = above_zero || c != '0';
            continue;
        }
        const bool no_texcoord = c == '/' && fields == 2 && rest[i - 1] == '/';
        if (i > 0 && !above_zero && !no_texcoord) return 0;
        if (c == ' ') {
            ++corners;
            fields = 1;
        } else if (c != '/' || ++fields > 3) {
            return 0;
        }
        digits = 0;
        above_zero = false;
    }
    return above_zero ? corners : 0;
}

// v, v/vt, v//vn or v/vt/vn, also with empty last fields, which some exporters write.
void check_corner(const ObjPlace& place, std::string_view corner) {
    std::string_view rest = corner;
    for (int field_number = 0; field_number < 3; ++field_number) {
        const std::size_t slash = rest.find('/');
        const std::string_view field = rest.substr(0, slash);
        if (field_number == 0 || !field.empty()) check_index(place, field, corner);
        if (slash == std::string_view::npos) return;
        rest.remove_prefix(slash + 1);
    }
    place.fail("a corner has more than three indices (" + std::string(corner) + "); write v/vt/vn");
}

struct Scanner {
    ObjPlace place;
    ObjPrescan found = {};
    FaceOrigin of_next_face = {};
    std::map<std::string, std::int32_t> material_of_name = {};
    std::map<std::string, std::size_t> ignored_at = {};  // in the report

    void face(std::string_view rest) {
        const std::size_t begin = found.statements.size();
        found.statements.push_back('f');
        std::size_t corners = plain_corners(rest);
        if (corners > 0) {
            found.statements.append(rest);
            rest = {};
        }
        for (std::string_view corner = take_word(rest); !corner.empty(); corner = take_word(rest)) {
            check_corner(place, corner);
            // Behind an empty last field tinyobjloader would read on into the next corner.
            while (corner.back() == '/') corner.remove_suffix(1);
            found.statements.append(1, ' ').append(corner);
            ++corners;
        }
        if (corners < 3 || corners > kMaxFaceCorners) {
            (corners < 3 ? found.report.too_few_corners : found.report.too_many_corners).add(place.line);
            found.statements.resize(begin);
            return;
        }
        found.statements.push_back('\n');
        FaceOrigin origin = of_next_face;
        origin.line = static_cast<std::uint32_t>(place.line);
        origin.positions = static_cast<std::int32_t>(found.vertices.positions.size());
        origin.texcoords = static_cast<std::int32_t>(found.texcoords.size());
        origin.normals = static_cast<std::int32_t>(found.normals.size());
        found.face_origins.push_back(origin);
    }

    void use_material(std::string_view rest) {
        const std::string_view named = trimmed(rest);
        const std::string material(without_comment(named).empty() ? std::string_view() : named);
        const auto next = static_cast<std::int32_t>(found.materials.size());
        const auto [at, is_new] = material_of_name.emplace(material, next);
        if (is_new) found.materials.push_back({material, place.line});
        say(found.material, of_next_face.material = at->second);
    }

    void smoothing(std::string_view rest) {
        const std::string group = lower_case(take_word(rest));
        std::uint32_t number = kFlatShaded;
        const char* const end = group.data() + group.size();
        const auto [stop, error] = std::from_chars(group.data(), end, number);
        const bool whole = error == std::errc() && stop == end && number != kNoSmoothing;
        if (whole || group == "off" || group == "null") {
            say(found.smoothing, of_next_face.smoothing = number);
        } else {
            ignore("s");
        }
    }

    template <class T>
    void say(Said<T>& said, T value) {
        if (!said.last) said.faces_before = found.face_origins.size();
        said.last = value;
    }

    void ignore(std::string_view keyword) {
        constexpr std::size_t kLongest = 40;
        auto& all = found.report.ignored_statements;
        const auto [at, is_new] = ignored_at.emplace(keyword.substr(0, kLongest), all.size());
        if (is_new) all.push_back({at->first, {}});
        all[at->second].lines.add(place.line);
    }

    void comment(std::string_view text) {
        constexpr std::string_view kPolypaint = "#MRGB ";
        if (text.starts_with(kPolypaint)) found.vertices.add_polypaint(place, text.substr(kPolypaint.size()));
    }

    void statement(std::string_view rest) {
        const std::string_view written = take_word(rest);
        if (written.empty()) return comment(trimmed(rest));
        std::string small;  // which nearly every keyword is already
        const bool any_capital =
            std::any_of(written.begin(), written.end(), [](char c) { return c >= 'A' && c <= 'Z'; });
        if (any_capital) small = lower_case(written);
        const std::string_view keyword = any_capital ? small : written;
        if (keyword == "v") {
            found.vertices.add(place, rest);
            ++found.vertex_or_face_lines;
        } else if (keyword == "vn") {
            const auto n = place.numbers<float, 3>(keyword, rest, 3).values;
            found.normals.push_back({n[0], n[1], n[2]});
        } else if (keyword == "vt") {
            const auto t = place.numbers<float, 3>(keyword, rest, 1).values;
            found.texcoords.push_back({t[0], t[1]});
        } else if (keyword == "f") {
            face(rest);
            ++found.vertex_or_face_lines;
        } else if (keyword == "s") {
            smoothing(rest);
        } else if (keyword == "usemtl") {
            use_material(rest);
        } else if (keyword == "mtllib") {
            found.libraries.push_back({std::string(trimmed(rest)), place.line});
        } else if (!is_harmless_statement(keyword)) {
            ignore(written);
        }
    }
};

}  // namespace

ObjPrescan prescan_obj(const TextPiece& piece, const std::string& name) {
    Scanner scanner{.place = {name}};
    LogicalLines lines(piece.text, piece.first_line);
    while (lines.advance()) {
        scanner.place.line = lines.line;
        scanner.statement(lines.text);
    }
    scanner.found.last_line = lines.line;
    return std::move(scanner.found);
}

}  // namespace crevice
