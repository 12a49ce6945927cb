// The numbers behind one texel of an AO map, raw or denoised, as the kernels compute them in their one-lane form.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <variant>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace crevice {

// A number that one method has and others have not, by the name that its kernel or its paper has for it. Bits of a
// mask are a whole number >= 0.
struct NamedNumber {
    const char* name = "";
    std::variant<float, std::int64_t> value;
};

struct ExplainedSample {
    glm::vec3 offset{0};                    // q - p, view space, scene units
    glm::vec3 q_view{0};                    // the point that is asked about
    glm::vec2 q_screen{0};                  // pixels of the picture
    glm::vec3 r_view{0};                    // the surface that the depth map shows there
    float dz = 0;                           // p.z - r.z, scene units; positive: r is in front of p
    float dp = 0;                           // how much r faces p, [0,1]
    float weight = 0;                       // how much an occluder at dz counts, [0,1]
    float contribution = 0;                 // what the sample takes from p, [0,1]
    const char* verdict = "";               // why it takes that: "occludes", or what rules it out
    std::vector<NamedNumber> numbers = {};  // the method's own
};

struct Explanation {
    bool surface = false;  // false: background, which has no samples and is open
    glm::vec3 p_view{0}, n_view{0};
    std::vector<ExplainedSample> samples;
    std::vector<NamedNumber> numbers = {};  // of the texel, the method's own

    // The texel that follows from the sum of all contributions, added in their order from 0 on: the value in
    // the map, to the last bit. Of the background, and where nothing is asked: open.
    std::function<float(float sum)> value_of_sum = [](float) { return 1.0f; };
    std::string formula = "1";  // the same in words, such as "1 - sum / 14"
};

// What one pass of a denoiser makes of a texel.
struct ExplainedTap {
    int x = 0, y = 0;                       // which texel of the map
    float value = 0;                        // what the pass reads there
    float weight = 0;                       // with which it counts; 0: it does not
    const char* verdict = "";               // why it does or does not
    std::vector<NamedNumber> numbers = {};  // that decide, such as the cosine between two normals
};
struct ExplainedPass {
    std::string name;                // such as "iteration 2, down"
    std::vector<ExplainedTap> taps;  // the texel itself among them; none where there is no surface
    const char* last_step = "";      // what makes `value` of the two sums, such as "sum / total"
    float value = 1;                 // what the pass writes

    // In the order of the taps, from 0 on: to the last bit what the kernel adds up.
    float sum() const {
        float of_all = 0;
        for (const ExplainedTap& tap : taps) of_all = of_all + tap.weight * tap.value;
        return of_all;
    }
    float total() const {
        float of_all = 0;
        for (const ExplainedTap& tap : taps) of_all = of_all + tap.weight;
        return of_all;
    }
};

}  // namespace crevice
