#include "rasterizer/obj/obj_origin.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "rasterizer/base/float_text.h"
#include "rasterizer/base/median.h"
#include "rasterizer/base/parallel.h"

namespace crevice {

namespace {

constexpr double kCoarseStep = 1.0 / 256;  // of a face's size
constexpr double kMostTimesTheExtent = 256;
constexpr double kWorthAMove = 16;        // times as fine must the steps of a face become
constexpr std::size_t kFewestPart = 256;  // of all faces one part in so many must gain
constexpr double kLostShape = 1.0 / 16;   // of a face's size
constexpr double kFlat = 0x1p-40;         // area over the square of the size: all corners on one line

double largest_of(glm::dvec3 v) { return std::max({v.x, v.y, v.z}); }

// The distance between a float of this magnitude and the next.
double float_step(double magnitude) {
    return magnitude > 0 ? std::ldexp(1.0, std::ilogb(magnitude) - (std::numeric_limits<float>::digits - 1))
                         : 0;
}

struct Box {
    glm::dvec3 low = glm::dvec3(HUGE_VAL), high = glm::dvec3(-HUGE_VAL);

    void add(glm::dvec3 p) { low = glm::min(low, p), high = glm::max(high, p); }
    void add(const Box& box) { low = glm::min(low, box.low), high = glm::max(high, box.high); }
    // Of all axes the most; how large it is, and how far from `origin` it reaches.
    double extent() const { return largest_of(high - low); }
    double farthest(glm::dvec3 origin) const {
        return std::max(largest_of(glm::abs(low - origin)), largest_of(glm::abs(high - origin)));
    }
};

bool is_coarse(const Box& face, glm::dvec3 origin) {
    return float_step(face.farthest(origin)) > kCoarseStep * face.extent();
}
// An empty box does not: its extent is negative.
bool lies_far(const Box& all) {
    return all.extent() >= 0 && all.farthest(glm::dvec3(0)) > kMostTimesTheExtent * all.extent();
}

std::span<const ObjCorner> corners_of(const ObjFace& face, const ObjFaces& faces) {
    return std::span(faces.corners).subspan(face.first_corner, face.corner_count);
}

// Whether all corners of a face are there, finite for float.
template <class Position>
bool is_whole(std::span<const ObjCorner> corners, std::span<const Position> positions) {
    constexpr double kMost = std::numeric_limits<float>::max();
    return std::all_of(corners.begin(), corners.end(), [&](const ObjCorner& corner) {
        if (corner.position < 0 || static_cast<std::size_t>(corner.position) >= positions.size())
            return false;
        const glm::dvec3 size = glm::abs(glm::dvec3(positions[static_cast<std::size_t>(corner.position)]));
        return size.x <= kMost && size.y <= kMost && size.z <= kMost;
    });
}

template <class Position>
Box box_of(std::span<const ObjCorner> corners, std::span<const Position> positions) {
    Box box;
    for (const ObjCorner& c : corners) box.add(positions[static_cast<std::size_t>(c.position)]);
    return box;
}

bool has_area(std::span<const ObjCorner> corners, std::span<const glm::dvec3> exact, const Box& box) {
    const auto at = [&](std::size_t i) { return exact[static_cast<std::size_t>(corners[i].position)]; };
    glm::dvec3 area2(0);
    for (std::size_t i = 1; i + 1 < corners.size(); ++i)
        area2 += glm::cross(at(i) - at(0), at(i + 1) - at(0));
    return largest_of(glm::abs(area2)) > kFlat * box.extent() * box.extent();
}

struct DrawnFace {
    std::span<const ObjCorner> corners;
    Box box;
};

std::vector<DrawnFace> drawn_faces(std::span<const glm::dvec3> exact, const ObjFaces& faces) {
    std::vector<DrawnFace> drawn;
    for (const ObjFace& face : faces.faces) {
        const auto corners = corners_of(face, faces);
        if (!is_whole(corners, exact)) continue;
        const Box box = box_of(corners, exact);
        if (has_area(corners, exact, box)) drawn.push_back({corners, box});
    }
    return drawn;
}

// The middle of faces, on the grid of a power of two about as large as they spread around it.
glm::dvec3 middle_of(const std::vector<DrawnFace>& faces) {
    glm::dvec3 middle;
    std::vector<double> values(faces.size());
    const auto median = [&](const auto& value) {
        std::transform(faces.begin(), faces.end(), values.begin(), value);
        return median_of(values);
    };
    for (int axis = 0; axis < 3; ++axis)
        middle[axis] =
            median([=](const DrawnFace& f) { return 0.5 * f.box.low[axis] + 0.5 * f.box.high[axis]; });
    const double spread = median([=](const DrawnFace& f) { return f.box.farthest(middle); });
    const double step = std::ldexp(1.0, std::ilogb(spread) + 1);
    for (int axis = 0; axis < 3; ++axis) middle[axis] = std::nearbyint(middle[axis] / step) * step;
    return middle;
}

// Numbers without exponents as long as that is exact: these are coordinates as people write them.
std::string text_of(glm::dvec3 p) {
    const auto text = [](double value) {
        const bool whole = value == std::nearbyint(value) && std::abs(value) < 1e15;
        return whole ? std::to_string(static_cast<long long>(value)) : shortest_text(value);
    };
    return text(p.x) + ", " + text(p.y) + ", " + text(p.z);
}

}  // namespace

bool may_need_origin(std::span<const glm::vec3> positions, const ObjFaces& faces, const Run& run) {
    constexpr std::size_t kBlock = 16384;  // faces
    struct Found {
        bool coarse = false;
        Box box;
    };
    std::vector<Found> of_block((faces.faces.size() + kBlock - 1) / kBlock);
    parallel_blocks(faces.faces.size(), kBlock, run, [&](std::size_t first, std::size_t end) {
        Found& found = of_block[first / kBlock];
        for (std::size_t f = first; f < end && !found.coarse; ++f) {
            const auto corners = corners_of(faces.faces[f], faces);
            if (!is_whole(corners, positions)) continue;
            const Box box = box_of(corners, positions);
            found.coarse = is_coarse(box, glm::dvec3(0));
            found.box.add(box);
        }
    });
    Box all;
    for (const Found& found : of_block) {
        if (found.coarse) return true;
        all.add(found.box);
    }
    return lies_far(all);
}

glm::dvec3 best_origin(std::span<const glm::dvec3> exact, const ObjFaces& faces) {
    const std::vector<DrawnFace> drawn = drawn_faces(exact, faces);
    Box all;
    for (const DrawnFace& face : drawn) all.add(face.box);
    const bool far = lies_far(all);
    std::vector<DrawnFace> finest;
    std::copy_if(drawn.begin(), drawn.end(), std::back_inserter(finest),
                 [](const DrawnFace& f) { return is_coarse(f.box, glm::dvec3(0)); });
    if (finest.empty() && !far) return glm::dvec3(0);
    const glm::dvec3 origin = middle_of(finest.empty() ? drawn : finest);
    const std::vector<DrawnFace>& needing = far ? drawn : finest;
    const auto gains = std::count_if(needing.begin(), needing.end(), [&](const DrawnFace& f) {
        return kWorthAMove * float_step(f.box.farthest(origin)) <= float_step(f.box.farthest(glm::dvec3(0)));
    });
    const auto loses = std::count_if(drawn.begin(), drawn.end(), [&](const DrawnFace& f) {
        return is_coarse(f.box, origin) && !is_coarse(f.box, glm::dvec3(0));
    });
    const bool worth = gains > loses && static_cast<std::size_t>(gains) * kFewestPart >= drawn.size();
    return worth ? origin : glm::dvec3(0);
}

LostVertices lost_vertices(std::span<const glm::dvec3> exact, glm::dvec3 origin, const ObjFaces& faces) {
    std::vector<bool> lost(exact.size(), false);
    for (const DrawnFace& face : drawn_faces(exact, faces)) {
        for (const ObjCorner& corner : face.corners) {
            const glm::dvec3 p = exact[static_cast<std::size_t>(corner.position)] - origin;
            const double error = largest_of(glm::abs(glm::dvec3(glm::vec3(p)) - p));
            if (error > kLostShape * face.box.extent())
                lost[static_cast<std::size_t>(corner.position)] = true;
        }
    }
    const auto first = std::find(lost.begin(), lost.end(), true);
    return {static_cast<std::size_t>(std::count(lost.begin(), lost.end(), true)),
            static_cast<std::size_t>(first - lost.begin())};
}

std::string origin_warning(glm::dvec3 origin) {
    return "the coordinates lie too far from their origin for the precision of float; the scene is moved by "
           "(" +
           text_of(-origin) + "), --eye and --target stay in the file's coordinates";
}

std::string lost_warning(const LostVertices& lost, glm::dvec3 p) {
    return "a vertex lies so far from the rest that its faces lose their shape to the precision of float (" +
           text_of(p) + "; " + std::to_string(lost.count) +
           (lost.count == 1 ? " vertex" : " vertices, the first here") +
           "); give parts that lie so far apart in files of their own";
}

}  // namespace crevice
