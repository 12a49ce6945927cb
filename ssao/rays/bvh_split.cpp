#include "ssao/rays/bvh_split.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include "rasterizer/base/parallel.h"
#include "ssao/rays/bvh.h"

namespace crevice {

namespace {

constexpr std::size_t kBins = 16;
// Longer ranges are gone through in pieces of this many, on all threads.
constexpr std::size_t kPiece = std::size_t{1} << 16;

// Sums what `measure` finds in the pieces of a range, in their order.
template <class Sum, class Measure>
Sum over_pieces(std::span<BoxedTriangle> triangles, const Run& run, const Measure& measure) {
    const std::size_t pieces = (triangles.size() + kPiece - 1) / kPiece;
    if (pieces <= 1) return measure(triangles);
    std::vector<Sum> sums(pieces);
    parallel_for(static_cast<int>(pieces), run, [&](int piece) {
        const std::size_t first = static_cast<std::size_t>(piece) * kPiece;
        sums[static_cast<std::size_t>(piece)] =
            measure(triangles.subspan(first, std::min(kPiece, triangles.size() - first)));
    });
    for (std::size_t i = 1; i < pieces; ++i) sums[0].add(sums[i]);
    return sums[0];
}

struct RangeBoxes {
    Box box, centres;
    void add(const RangeBoxes& o) {
        box.include(o.box.low, o.box.high);
        centres.include(o.centres.low, o.centres.high);
    }
};

struct Bin {
    Box box;
    std::size_t count = 0;
    void add(const Bin& o) {
        box.include(o.box.low, o.box.high);
        count += o.count;
    }
};

struct Bins {
    std::array<std::array<Bin, kBins>, 3> of_axis;
    void add(const Bins& o) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            for (std::size_t i = 0; i < kBins; ++i) of_axis[axis][i].add(o.of_axis[axis][i]);
        }
    }
};

// Which bin a centre is in. In double: the extent may be as small as a float can be.
struct Binning {
    glm::dvec3 low, per_unit;

    explicit Binning(const Box& centres) : low(centres.low) {
        const glm::dvec3 extent = glm::dvec3(centres.high) - low;
        for (int axis = 0; axis < 3; ++axis) per_unit[axis] = extent[axis] > 0 ? kBins / extent[axis] : 0;
    }
    std::size_t bin(glm::vec3 centre, int axis) const {
        const double place = (static_cast<double>(centre[axis]) - low[axis]) * per_unit[axis];
        return std::min(static_cast<std::size_t>(place), kBins - 1);
    }
};

struct Cut {
    double cost = std::numeric_limits<double>::infinity();
    int axis = -1;
    std::size_t first_right = 0;  // the first bin on the right side
};

double cost_of(const Bin& bin) {
    const std::size_t blocks = (bin.count + kBvhWidth - 1) / kBvhWidth;
    return bin.box.half_area() * static_cast<double>(blocks);
}

Cut cheapest_cut(const Bins& bins) {
    Cut best;
    for (int axis = 0; axis < 3; ++axis) {
        const std::array<Bin, kBins>& row = bins.of_axis[static_cast<std::size_t>(axis)];
        std::array<Bin, kBins> right;  // everything from bin i on
        right[kBins - 1] = row[kBins - 1];
        for (std::size_t i = kBins - 1; i-- > 0;) {
            right[i] = row[i];
            right[i].add(right[i + 1]);
        }
        Bin left;
        for (std::size_t i = 1; i < kBins; ++i) {
            left.add(row[i - 1]);
            if (left.count == 0 || right[i].count == 0) continue;
            const double cost = cost_of(left) + cost_of(right[i]);
            if (cost < best.cost) best = {cost, axis, i};
        }
    }
    return best;
}

}  // namespace

TriangleRange range_of(std::span<BoxedTriangle> triangles, const Run& run) {
    const auto boxes = over_pieces<RangeBoxes>(triangles, run, [](std::span<BoxedTriangle> piece) {
        RangeBoxes found;
        for (const BoxedTriangle& t : piece) {
            found.box.include(t.low, t.high);
            found.centres.include(t.centre(), t.centre());
        }
        return found;
    });
    return {triangles, boxes.box, boxes.centres};
}

std::pair<TriangleRange, TriangleRange> split_by_area(const TriangleRange& range, const Run& run) {
    const Binning binning(range.centres);
    const Bins bins = over_pieces<Bins>(range.triangles, run, [&](std::span<BoxedTriangle> piece) {
        Bins found;
        for (const BoxedTriangle& t : piece) {
            for (int axis = 0; axis < 3; ++axis) {
                Bin& bin = found.of_axis[static_cast<std::size_t>(axis)][binning.bin(t.centre(), axis)];
                bin.box.include(t.low, t.high);
                ++bin.count;
            }
        }
        return found;
    });
    const Cut cut = cheapest_cut(bins);
    if (cut.axis < 0) return split_in_halves(range, run);
    const auto middle = std::partition(
        range.triangles.begin(), range.triangles.end(),
        [&](const BoxedTriangle& t) { return binning.bin(t.centre(), cut.axis) < cut.first_right; });
    const auto left = static_cast<std::size_t>(middle - range.triangles.begin());
    return {range_of(range.triangles.first(left), run), range_of(range.triangles.subspan(left), run)};
}

std::pair<TriangleRange, TriangleRange> split_in_halves(const TriangleRange& range, const Run& run) {
    const std::size_t left = (range.triangles.size() + 1) / 2;
    return {range_of(range.triangles.first(left), run), range_of(range.triangles.subspan(left), run)};
}

}  // namespace crevice
