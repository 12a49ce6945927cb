#include "rasterizer/obj/obj_prescan.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>

#include "rasterizer/base/error.h"
#include "rasterizer/base/float_text.h"
#include "rasterizer/obj/ear_clip.h"
#include "rasterizer/obj/obj_lines.h"

namespace crevice {
namespace {

// A number in correct form that float cannot hold: infinity, or 0 when it is too small.
float beyond_float(std::string_view token) {
    const bool negative = token.front() == '-';
    const std::size_t exponent = token.find_first_of("eE");
    const bool has_exponent = exponent != std::string_view::npos;
    const bool whole = token.find_first_of("123456789") < std::min(token.find('.'), exponent);
    const bool tiny = has_exponent ? token[exponent + 1] == '-' : !whole;
    const float magnitude = tiny ? 0.0f : std::numeric_limits<float>::infinity();
    return negative ? -magnitude : magnitude;
}

// What old Microsoft run-times print for NaN and infinity: 1.#QNAN, -1.#IND, 1.#INF.
bool is_microsoft_nan(std::string_view token) { return token.find(".#") != std::string_view::npos; }

// Statements that change nothing in what is drawn here: names, groups, smoothing, display hints.
bool is_harmless(std::string_view keyword) {
    static constexpr std::array<std::string_view, 12> kHarmless = {
        "g",        "o",        "s",          "mg",        "lod",    "bevel",
        "c_interp", "d_interp", "shadow_obj", "trace_obj", "maplib", "usemap"};
    return std::find(kHarmless.begin(), kHarmless.end(), keyword) != kHarmless.end();
}

struct Scanner {
    const std::string& name;
    std::size_t line = 0;
    std::size_t vertex_or_face_lines = 0;
    ObjPrescan found;

    [[noreturn]] void fail(const std::string& what) const {
        throw InputError(name + ":" + std::to_string(line) + ": " + what);
    }

    float number(std::string_view token) const {
        const bool plus = token.size() > 1 && token[0] == '+' && token[1] != '-';
        const char* const end = token.data() + token.size();
        float value = 0;
        const auto [stop, error] = number_from_text(token.data() + plus, end, value);
        if (stop == end && error == std::errc()) return value;
        if (stop == end && error == std::errc::result_out_of_range) return beyond_float(token);
        if (is_microsoft_nan(token)) return std::numeric_limits<float>::quiet_NaN();
        const bool comma = token.find(',') != std::string_view::npos;
        fail("this is not a number (" + std::string(token) + "); " +
             (comma ? "write it with a decimal point" : "write it in decimal, as in 1.5 or 2e-3"));
    }

    // The first `Wanted` numbers of a statement that has between `least` and `most`; absent ones are 0.
    template <std::size_t Wanted>
    std::array<float, Wanted> numbers(std::string_view keyword, std::string_view rest, std::size_t least,
                                      std::size_t most) const {
        std::array<float, Wanted> values{};
        std::size_t count = 0;
        for (std::string_view token = take_word(rest); !token.empty(); token = take_word(rest)) {
            const float value = number(token);
            if (count < Wanted) values[count] = value;
            ++count;
        }
        if (count < least || count > most) {
            const std::string wanted =
                std::to_string(least) + (least == most ? "" : " to " + std::to_string(most));
            fail("`" + std::string(keyword) + "` has the wrong count of numbers (" + std::to_string(count) +
                 "); give " + wanted);
        }
        return values;
    }

    void check_index(std::string_view field, std::string_view corner) const {
        const bool sign = !field.empty() && (field[0] == '-' || field[0] == '+');
        const std::string_view digits = field.substr(sign);
        const bool whole = !digits.empty() && std::all_of(digits.begin(), digits.end(),
                                                          [](char c) { return c >= '0' && c <= '9'; });
        if (!whole) {
            fail("this is not a whole index (" + std::string(corner) + "); write v, v/vt, v//vn or v/vt/vn");
        }
        // The sign changes nothing here: a file small enough to be read has no room for 2^31 vertices.
        std::int32_t value = 0;
        const std::errc error = std::from_chars(digits.data(), digits.data() + digits.size(), value).ec;
        if (error != std::errc()) {
            fail("the index is too large (" + std::string(corner) +
                 "); give the number of a vertex of this file");
        }
        if (value == 0) fail("an index is zero (" + std::string(corner) + "); OBJ counts from 1");
    }

    // v, v/vt, v//vn or v/vt/vn, also with empty last fields, which some exporters write.
    void check_corner(std::string_view corner) const {
        std::string_view rest = corner;
        for (int field_number = 0; field_number < 3; ++field_number) {
            const std::size_t slash = rest.find('/');
            const std::string_view field = rest.substr(0, slash);
            if (field_number == 0 || !field.empty()) check_index(field, corner);
            if (slash == std::string_view::npos) return;
            rest.remove_prefix(slash + 1);
        }
        fail("a corner has more than three indices (" + std::string(corner) + "); write v/vt/vn");
    }

    void face(std::string_view rest) {
        const std::size_t begin = found.statements.size();
        found.statements.push_back('f');
        std::size_t corners = 0;
        for (std::string_view corner = take_word(rest); !corner.empty(); corner = take_word(rest)) {
            check_corner(corner);
            // Behind an empty last field tinyobjloader would read on into the next corner.
            while (corner.back() == '/') corner.remove_suffix(1);
            found.statements.append(1, ' ').append(corner);
            ++corners;
        }
        if (corners < 3 || corners > kMaxFaceCorners) {
            (corners < 3 ? found.report.too_few_corners : found.report.too_many_corners).add(line);
            found.statements.resize(begin);
            return;
        }
        found.statements.push_back('\n');
        found.face_origins.push_back({static_cast<std::uint32_t>(line),
                                      static_cast<std::int32_t>(found.positions.size()),
                                      static_cast<std::int32_t>(found.texcoords.size()),
                                      static_cast<std::int32_t>(found.normals.size())});
    }

    void use_material(std::string_view rest) {
        const std::string_view material = trimmed(rest);
        if (material.empty()) fail("`usemtl` without a name; give the name of a material");
        found.statements.append("usemtl ").append(material).push_back('\n');
        found.material_lines.push_back(line);
    }

    void ignore(std::string_view keyword) {
        auto& all = found.report.ignored_statements;
        const auto same =
            std::find_if(all.begin(), all.end(), [&](const auto& s) { return s.keyword == keyword; });
        // A file of another kind can start every line with another word: the ninth and later are counted
        // together.
        constexpr std::size_t kMostKeywords = 8;
        if (same != all.end()) {
            same->lines.add(line);
        } else if (all.size() <= kMostKeywords) {
            const bool last = all.size() == kMostKeywords;
            all.push_back({last ? "others" : std::string(keyword.substr(0, 40)), {}});
            all.back().lines.add(line);
        } else {
            all.back().lines.add(line);
        }
    }

    void statement(std::string_view rest) {
        const std::string_view keyword = take_word(rest);
        if (keyword.empty()) return;
        if (keyword == "v") {
            const auto p = numbers<3>(keyword, rest, 3, 7);  // further ones: weight or colour
            found.positions.push_back({p[0], p[1], p[2]});
            ++vertex_or_face_lines;
        } else if (keyword == "vn") {
            const auto n = numbers<3>(keyword, rest, 3, 3);
            found.normals.push_back({n[0], n[1], n[2]});
        } else if (keyword == "vt") {
            const auto t = numbers<2>(keyword, rest, 1, 3);
            found.texcoords.push_back({t[0], t[1]});
        } else if (keyword == "f") {
            face(rest);
            ++vertex_or_face_lines;
        } else if (keyword == "usemtl") {
            use_material(rest);
        } else if (keyword == "mtllib") {
            found.libraries.push_back({std::string(trimmed(rest)), line});
        } else if (!is_harmless(keyword)) {
            ignore(keyword);
        }
    }
};

}  // namespace

ObjPrescan prescan_obj(std::string_view text, const std::string& name) {
    if (text.empty()) throw InputError(name + ": the file is empty; give an OBJ with vertices and faces");
    constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
    if (text.substr(0, kByteOrderMark.size()) == kByteOrderMark) text.remove_prefix(kByteOrderMark.size());
    Scanner scanner{.name = name, .found = {}};
    LogicalLines lines(text);
    while (lines.advance()) {
        scanner.line = lines.line;
        scanner.statement(lines.text);
    }
    if (scanner.vertex_or_face_lines == 0) {
        throw InputError(name + ": this is not an OBJ (no `v` and no `f` line in " +
                         std::to_string(lines.line) + " lines); give an OBJ with vertices and faces");
    }
    if (scanner.found.positions.empty()) {
        throw InputError(name + ":" + std::to_string(lines.line) +
                         ": the file has faces and no vertices; give an OBJ with vertices and faces");
    }
    return std::move(scanner.found);
}

}  // namespace crevice
