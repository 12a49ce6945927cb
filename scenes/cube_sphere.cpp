#include "scenes/cube_sphere.h"

#include <string>
#include <utility>

#include <glm/geometric.hpp>

#include "rasterizer/base/error.h"
#include "rasterizer/lanes/approx_math.h"

namespace crevice {
namespace {

// The points of a (cells + 1)^3 lattice that lie on its surface, numbered in the order in which they are
// first met.
class SurfaceLattice {
 public:
    explicit SurfaceLattice(int cells) : cells_(cells) {
        const auto side = static_cast<std::size_t>(cells) + 1;
        index_.assign(side * side * side, kUnmet);
    }

    std::uint32_t index(glm::ivec3 at) {
        const int side = cells_ + 1;
        std::uint32_t& known = index_[static_cast<std::size_t>((at.z * side + at.y) * side + at.x)];
        if (known == kUnmet) {
            known = static_cast<std::uint32_t>(directions.size());
            directions.push_back(
                glm::normalize(glm::dvec3(equal_angle(at.x), equal_angle(at.y), equal_angle(at.z))));
        }
        return known;
    }

    std::vector<glm::dvec3> directions;

 private:
    static constexpr std::uint32_t kUnmet = 0xffffffffu;

    // From [0, cells] to [-1, 1] such that steps are equal angles seen from the cube's centre.
    double equal_angle(int step) const { return tangent(kPi / 4 * (2 * step - cells_) / cells_); }

    int cells_;
    std::vector<std::uint32_t> index_;
};

}  // namespace

CubeSphere cube_sphere(int cells) {
    if (cells < 1) throw UsageError("cells is too small (" + std::to_string(cells) + "); give at least 1");
    SurfaceLattice lattice(cells);
    CubeSphere sphere;
    for (int axis = 0; axis < 3; ++axis) {
        for (int side = 0; side < 2; ++side) {
            glm::ivec3 right(0), down(0), corner(0);
            right[(axis + 1 + (1 - side)) % 3] = 1;
            down[(axis + 1 + side) % 3] = 1;
            corner[axis] = side * cells;
            for (int i = 0; i < cells * cells; ++i) {
                const glm::ivec3 at = corner + (i % cells) * right + (i / cells) * down;
                const std::uint32_t a = lattice.index(at), b = lattice.index(at + right);
                const std::uint32_t c = lattice.index(at + down), d = lattice.index(at + right + down);
                sphere.triangles.push_back({a, b, c});
                sphere.triangles.push_back({c, b, d});
            }
        }
    }
    sphere.directions = std::move(lattice.directions);
    return sphere;
}

}  // namespace crevice
