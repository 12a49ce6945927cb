#include "rasterizer/scene/direction_tree.h"

#include <algorithm>
#include <tuple>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace crevice {

namespace {

constexpr std::size_t kLeaf = 8;

}  // namespace

DirectionSum sum_within(std::span<const WeightedDirection> directions, const glm::dvec3& axis,
                        double least_cosine) {
    DirectionSum found;
    for (const WeightedDirection& d : directions) {
        if (glm::dot(d.direction, axis) >= least_cosine) found.add(d);
    }
    return found;
}

DirectionTree::DirectionTree(std::vector<WeightedDirection> directions) : directions_(std::move(directions)) {
    add_node(0, directions_.size());
}

void DirectionTree::add_node(std::size_t first, std::size_t count) {
    const std::size_t index = nodes_.size();
    Node& node = nodes_.emplace_back(Node{.first = first, .count = count});
    const auto here = std::span(directions_).subspan(first, count);
    node.low = node.high = here.empty() ? glm::dvec3(0) : here.front().direction;
    for (const WeightedDirection& d : here) {
        node.low = glm::min(node.low, d.direction);
        node.high = glm::max(node.high, d.direction);
    }
    if (count <= kLeaf) {
        for (const WeightedDirection& d : here) node.sum.add(d);
        return;
    }
    const glm::dvec3 extent = node.high - node.low;
    const int axis = extent.x >= extent.y ? (extent.x >= extent.z ? 0 : 2) : (extent.y >= extent.z ? 1 : 2);
    // Sorted by all they hold, so that every machine adds in the same order.
    std::sort(here.begin(), here.end(), [=](const WeightedDirection& a, const WeightedDirection& b) {
        const auto key = [=](const WeightedDirection& d) {
            return std::tuple(d.direction[axis], d.direction.x, d.direction.y, d.direction.z, d.weight);
        };
        return key(a) < key(b);
    });
    add_node(first, count / 2);
    nodes_[index].right = nodes_.size();
    add_node(first + count / 2, count - count / 2);
    nodes_[index].sum = nodes_[index + 1].sum;
    nodes_[index].sum.add(nodes_[nodes_[index].right].sum);
}

DirectionSum DirectionTree::sum_within(const glm::dvec3& axis, double least_cosine) const {
    DirectionSum found;
    std::vector<std::size_t> waiting = {0};
    while (!waiting.empty()) {
        const std::size_t index = waiting.back();
        const Node& node = nodes_[index];
        waiting.pop_back();
        // The corners of the box that lie least and furthest along the axis. Rounding keeps the order of products
        // and of sums, so no dot product of a direction in the box is beyond these two.
        const glm::dvec3 a = node.low * axis, b = node.high * axis;
        const glm::dvec3 least = glm::min(a, b), most = glm::max(a, b);
        if (most.x + most.y + most.z < least_cosine) continue;
        if (least.x + least.y + least.z >= least_cosine) {
            found.add(node.sum);
        } else if (node.right == 0) {
            found.add(crevice::sum_within(std::span(directions_).subspan(node.first, node.count), axis,
                                          least_cosine));
        } else {
            waiting.push_back(node.right);
            waiting.push_back(index + 1);
        }
    }
    return found;
}

}  // namespace crevice
