// Sets of vectors from one point, side by side: x right, y up, z away from the reader, to the upper right. The circle is
// the outline of the sphere of length 1.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <glm/vec3.hpp>

namespace crevice {

struct DrawnVector {
    glm::vec3 v;
    std::string_view colour;
    std::string label = "";
    bool dashed = false;
};

struct VectorPanel {
    std::string words;  // below it
    std::vector<DrawnVector> vectors;
};

std::string vector_panels(const std::string& title, const std::vector<VectorPanel>& panels);

}  // namespace crevice
