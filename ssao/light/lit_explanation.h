// The numbers behind one lit pixel, as the kernels of the lit passes compute them in their one-lane form.
#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

#include "rasterizer/draw/visibility.h"
#include "ssao/light/lighting.h"

namespace crevice {

struct ExplainedTerm {
    LitTerm kind = LitTerm::ambient;
    int light = -1;       // index into Scene::lights; -1: of no light in particular
    glm::vec3 colour{0};  // linear light
};

struct ExplainedLight {
    int number = 0;      // index into Scene::lights
    float facing = 0;    // cosine between the normal and the way to the light
    float arriving = 1;  // share of it that no shadow takes, [0,1]
};

struct LitExplanation {
    bool surface = false;  // false: the sky, whose one term is its colour; what follows is unset
    // The one that is lit, as ScreenGeometry::triangle() takes its number: the last one of equal depths.
    std::int32_t triangle = kNoTriangle;
    std::int32_t material = kNoTriangle;  // index into Scene::materials
    glm::vec3 n_view{0};                  // that is lit: with the normal map, where there is one
    glm::vec3 texture{1};                 // of texture and vertex colours
    float accessibility = 1;              // of the AO map at the pixel
    glm::vec3 ambient_access{1};          // what of it each colour channel is multiplied by
    std::vector<ExplainedLight> lights;   // that shine
    std::vector<ExplainedTerm> terms;     // in the order in which they are added
    const char* formula = "";             // what makes `colour` of the terms, to the last bit
    glm::vec3 colour{0};                  // linear light
};

// The two formulas. All sums begin at 0 and go in the order of the terms.
inline constexpr const char* kSumOfTerms = "sum of all terms";
inline constexpr const char* kPhongSum =
    "texture * (ambient_access * sum of ambient + sum of diffuse) + sum of specular";

// Writes terms down.
struct TermList {
    LitExplanation& result;

    void point(const LitPoint<float>& p) const {
        result.n_view = {p.n.x, p.n.y, p.n.z};
        result.texture = {p.texture_colour.x, p.texture_colour.y, p.texture_colour.z};
        result.ambient_access = {p.ambient.x, p.ambient.y, p.ambient.z};
    }
    void light(int number, float facing, float arriving) const {
        result.lights.push_back({number, facing, arriving});
    }
    void term(LitTerm kind, int number, const Vec3<float>& colour) const {
        result.terms.push_back({kind, number, {colour.x, colour.y, colour.z}});
    }
};

}  // namespace crevice
