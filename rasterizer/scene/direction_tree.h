// Sums over those of many directions that lie within an angle of another one.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

namespace crevice {

struct WeightedDirection {
    glm::dvec3 direction = glm::dvec3(0);  // unit, or 0
    double weight = 0;
};

struct DirectionSum {
    glm::dvec3 sum = glm::dvec3(0);  // of weight * direction
    double weight = 0;

    void add(const DirectionSum& other) {
        sum += other.sum;
        weight += other.weight;
    }
    void add(const WeightedDirection& d) { add(DirectionSum{d.weight * d.direction, d.weight}); }
};

// Sum over the directions d with dot(d, axis) >= least_cosine, one after the other.
DirectionSum sum_within(std::span<const WeightedDirection> directions, const glm::dvec3& axis,
                        double least_cosine);

// The same for many axes: of the same directions, in another order. A binary tree of boxes, whose nodes are
// added or passed by as a whole where their boxes allow; a sum over n directions takes about sqrt(n) steps when
// they are spread over the sphere, and log(n) when they lie on a circle or together.
class DirectionTree {
 public:
    explicit DirectionTree(std::vector<WeightedDirection> directions);
    DirectionSum sum_within(const glm::dvec3& axis, double least_cosine) const;

 private:
    struct Node {
        std::size_t first = 0, count = 0;  // of directions_
        std::size_t right = 0;             // the left child comes next; 0: a leaf
        glm::dvec3 low = glm::dvec3(0), high = glm::dvec3(0);
        DirectionSum sum = {};
    };
    void add_node(std::size_t first, std::size_t count);

    std::vector<WeightedDirection> directions_;
    std::vector<Node> nodes_;
};

}  // namespace crevice
