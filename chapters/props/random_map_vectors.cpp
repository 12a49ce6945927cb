#include "chapters/props/random_map_vectors.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

namespace crevice {

Image3 as_image(const RandomMap& map) {
    Image3 vectors({kRandomMapSide, kRandomMapSide}, glm::vec3(0));
    std::copy(map.x.begin(), map.x.end(), vectors.x.pixels.begin());
    std::copy(map.y.begin(), map.y.end(), vectors.y.pixels.begin());
    std::copy(map.z.begin(), map.z.end(), vectors.z.pixels.begin());
    return vectors;
}

double not_unit_share(const RandomMap& map) {
    double off = 0;
    for (std::size_t i = 0; i < map.x.size(); ++i)
        off += std::fabs(glm::length(glm::vec3(map.x[i], map.y[i], map.z[i])) - 1) > 0.05f ? 1 : 0;
    return off / static_cast<double>(map.x.size());
}

}  // namespace crevice
