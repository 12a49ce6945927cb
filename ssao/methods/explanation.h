// The numbers behind one texel of an AO map, as the kernel computes them in its one-lane form.
#pragma once

#include <functional>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace crevice {

struct ExplainedSample {
    glm::vec3 offset{0};       // q - p, view space, scene units
    glm::vec3 q_view{0};       // the point that is asked about
    glm::vec2 q_screen{0};     // pixels of the picture
    glm::vec3 r_view{0};       // the surface that the depth map shows there
    float dz = 0;              // p.z - r.z, scene units; positive: r is in front of p
    float dp = 0;              // how much r faces p, [0,1]
    float weight = 0;          // how much an occluder at dz counts, [0,1]
    float contribution = 0;    // what the sample takes from p, [0,1]
    const char* verdict = "";  // why it takes that: "occludes", or what rules it out
};

struct Explanation {
    bool surface = false;  // false: background, which has no samples and is open
    glm::vec3 p_view{0}, n_view{0};
    std::vector<ExplainedSample> samples;

    // The texel that follows from the sum of all contributions, added in their order from 0 on: the value in
    // the map, to the last bit.
    std::function<float(float sum)> value_of_sum;
};

}  // namespace crevice
