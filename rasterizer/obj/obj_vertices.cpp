#include "rasterizer/obj/obj_vertices.h"

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <utility>

#include <glm/common.hpp>

#include "rasterizer/base/float_text.h"
#include "rasterizer/base/parallel.h"
#include "rasterizer/lanes/approx_math.h"
#include "rasterizer/obj/obj_origin.h"

namespace crevice {
namespace {

constexpr glm::vec3 kUncoloured(-1);    // until all are known; white then
constexpr float kByteColours = 255;     // what 1 is where colours are written as bytes
constexpr float kSlightlyAboveOne = 2;  // up to here they are none: rounding, or light

// Homogeneous ones divided by w.
glm::dvec3 exact_position(const ObjPlace& place, std::string_view rest) {
    const auto [p, count] = place.numbers<double, 7>("v", rest, 3);
    return glm::dvec3(p[0], p[1], p[2]) / (count == 4 ? p[3] : 1.0);
}

struct ExactPositions {
    std::vector<glm::dvec3> positions;
    std::vector<std::size_t> lines;
};

ExactPositions exact_positions_of_piece(const TextPiece& piece, const std::string& name) {
    ExactPositions exact;
    for (LogicalLines lines(piece.text, piece.first_line); lines.advance();) {
        std::string_view rest = lines.text;
        if (lower_case(take_word(rest)) != "v") continue;
        exact.positions.push_back(exact_position({name, lines.line}, rest));
        exact.lines.push_back(lines.line);
    }
    return exact;
}

ExactPositions exact_positions(std::span<const TextPiece> pieces, const std::string& name, const Run& run) {
    std::vector<ExactPositions> of_piece(pieces.size());
    parallel_for(static_cast<int>(pieces.size()), run, [&](int i) {
        const auto at = static_cast<std::size_t>(i);
        of_piece[at] = exact_positions_of_piece(pieces[at], name);
    });
    ExactPositions all;
    for (const ExactPositions& exact : of_piece) {
        all.positions.insert(all.positions.end(), exact.positions.begin(), exact.positions.end());
        all.lines.insert(all.lines.end(), exact.lines.begin(), exact.lines.end());
    }
    return all;
}

// The first line that was met, if any was (0: none).
std::size_t first_of(std::size_t line, std::size_t later) { return line != 0 ? line : later; }

}  // namespace

void ObjVertices::add(const ObjPlace& place, std::string_view rest) {
    const auto [p, count] = place.numbers<float, 7>("v", rest, 3);
    if (count == 5) {
        place.fail("`v` has the wrong count of numbers (5); give 3, with w 4, with a colour 6 or 7");
    }
    const bool weighted = count == 4 && p[3] != 1;
    positions.push_back(weighted ? glm::vec3(exact_position(place, rest)) : glm::vec3(p[0], p[1], p[2]));
    if (count >= 6 && first_coloured_line_ == 0) {
        colours.assign(positions.size() - 1, kUncoloured);
        first_coloured_line_ = place.line;
    }
    if (first_coloured_line_ == 0) return;
    colours.push_back(count >= 6 ? glm::vec3(p[3], p[4], p[5]) : kUncoloured);
}

void ObjVertices::append(const ObjVertices& next) {
    first_coloured_line_ = first_of(first_coloured_line_, next.first_coloured_line_);
    if (first_coloured_line_ != 0) {
        colours.resize(positions.size(), kUncoloured);
        colours.insert(colours.end(), next.colours.begin(), next.colours.end());
    }
    positions.insert(positions.end(), next.positions.begin(), next.positions.end());
    polypaint_.insert(polypaint_.end(), next.polypaint_.begin(), next.polypaint_.end());
    first_polypaint_line_ = first_of(first_polypaint_line_, next.first_polypaint_line_);
    unread_polypaint_line_ = first_of(unread_polypaint_line_, next.unread_polypaint_line_);
}

void ObjVertices::add_polypaint(const ObjPlace& place, std::string_view rest) {
    constexpr std::size_t kDigits = 8;
    if (first_polypaint_line_ == 0) first_polypaint_line_ = place.line;
    const std::string_view digits = take_word(rest);
    bool read = digits.size() % kDigits == 0;
    for (std::size_t at = 0; read && at < digits.size(); at += kDigits) {
        const char *const begin = digits.data() + at, *const end = begin + kDigits;
        std::uint32_t mrgb = 0;
        const auto [stop, error] = std::from_chars(begin, end, mrgb, 16);
        read = error == std::errc() && stop == end;
        const auto channel = [&](int shift) {
            const float encoded = static_cast<float>(mrgb >> shift & 255u) / kByteColours;
            return std::min(1.0f, linear_from_srgb(encoded));
        };
        polypaint_.emplace_back(channel(16), channel(8), channel(0));
    }
    if (!read && unread_polypaint_line_ == 0) unread_polypaint_line_ = place.line;
}

// Colours of `v` lines go before.
void ObjVertices::use_polypaint(const std::string& name, std::vector<std::string>& warnings) {
    if (first_polypaint_line_ == 0 || !colours.empty()) return;
    if (unread_polypaint_line_ != 0) {
        warnings.push_back(ObjPlace{name, unread_polypaint_line_}.text() +
                           "`#MRGB` (polypaint) is not eight hexadecimal digits a vertex; drawn without");
    } else if (polypaint_.size() != positions.size()) {
        warnings.push_back(ObjPlace{name, first_polypaint_line_}.text() +
                           "the colours of `#MRGB` (polypaint) are not as many as the vertices (" +
                           std::to_string(polypaint_.size()) + " for " + std::to_string(positions.size()) +
                           "); drawn without");
    } else {
        colours = std::move(polypaint_);
    }
}

void ObjVertices::recentre(std::span<const TextPiece> pieces, const std::string& name, const ObjFaces& faces,
                           std::vector<std::string>& warnings, const Run& run) {
    if (!may_need_origin(positions, faces, run)) return;
    const auto [exact, line_of] = exact_positions(pieces, name, run);
    origin = best_origin(exact, faces);
    if (origin != glm::dvec3(0)) {
        for (std::size_t i = 0; i < exact.size(); ++i) positions[i] = glm::vec3(exact[i] - origin);
        warnings.push_back(name + ": " + origin_warning(origin));
    }
    const LostVertices lost = lost_vertices(exact, origin, faces);
    if (lost.count == 0) return;
    const ObjPlace place{name, line_of[lost.first]};
    warnings.push_back(place.text() + lost_warning(lost, exact[lost.first]));
}

void ObjVertices::finish_colours(const std::string& name, std::vector<std::string>& warnings) {
    if (first_coloured_line_ != 0) colours.resize(positions.size(), kUncoloured);
    float highest = 0;
    bool in_range = true;
    for (const glm::vec3& c : colours) {
        for (int i = 0; c != kUncoloured && i < 3; ++i) {
            in_range = in_range && c[i] >= 0 && c[i] <= kByteColours;
            highest = std::max(highest, c[i]);
        }
    }
    const std::string where = ObjPlace{name, first_coloured_line_}.text();
    if (!in_range) {
        colours.clear();
        warnings.push_back(where + "a vertex colour of the file is out of range; give 0 to 1, drawn without");
    } else if (highest > 1) {
        warnings.push_back(where + "vertex colours are above 1 (the highest is " + shortest_text(highest) +
                           "); " + (highest > kSlightlyAboveOne ? "taken as 0 to 255" : "cut at 1"));
    }
    const float full = highest > kSlightlyAboveOne ? kByteColours : 1;
    for (glm::vec3& c : colours) c = c == kUncoloured ? glm::vec3(1) : glm::min(c / full, glm::vec3(1));
    use_polypaint(name, warnings);
}

}  // namespace crevice
