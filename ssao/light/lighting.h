// The two tutorials' lighting models, for one pixel or eight. All vectors in view space, all colours in
// linear light.
#pragma once

#include <limits>
#include <vector>

#include <glm/common.hpp>

#include "rasterizer/lanes/approx_math.h"
#include "rasterizer/scene/scene.h"
#include "ssao/light/fresnel.h"

namespace crevice {

// A point to be lit.
template <class F>
struct LitPoint {
    Vec3<F> n, to_eye;       // unit
    Vec3<F> texture_colour;  // multiplies diffuse and ambient reflectance
    F gloss;                 // [0,1], of a normal map; multiplies the shininess of blinn_schlick
    Vec3<F> ambient;         // accessibility of each colour channel: multiplies every ambient term
    F shadow;                // [0,1], of the light that casts one: 0 nothing of it arrives, 1 all
};

// Those that shine, directions in view space.
struct ViewLight : DirectionalLight {
    bool casts_shadow = false;  // the first at most
    int number = 0;             // index into Scene::lights
};
using ViewLights = std::vector<ViewLight>;

// The terms that a lit colour is the sum of.
enum class LitTerm { ambient, diffuse, specular, diffuse_and_specular, reflection, sky };

// Sees nothing of how a colour comes about, and costs nothing. What a witness is told: the point; of each light the cosine
// between normal and light, and how much arrives; each term as it is added, with its light's number, or -1.
struct NoLightWitness {
    template <class Point>
    CREVICE_INLINE void point(const Point&) const {}
    template <class F>
    CREVICE_INLINE void light(int, const F&, const F&) const {}
    template <class Colour>
    CREVICE_INLINE void term(LitTerm, int, const Colour&) const {}
};

// Material::shininess of a surface with no roughness (Luna).
inline constexpr float kFullShininess = 256;

// As in X_Jun: ambient, diffuse and Phong specular of each light; the texture multiplies the first two. Terms are told as
// they are before that, and before accessibility.
template <class F, class Witness = NoLightWitness>
CREVICE_INLINE Vec3<F> phong(const LitPoint<F>& s, const Material& material, const ViewLights& lights,
                             const Witness& witness = {}) {
    const F zero = F(0);
    Vec3<F> ambient{zero, zero, zero}, diffuse = ambient, specular = ambient;
    for (const ViewLight& light : lights) {
        const Vec3<F> to_light = spread<F>(-light.direction);
        const F facing = dot(s.n, to_light), arriving = light.casts_shadow ? s.shadow : F(1);
        witness.light(light.number, facing, arriving);
        const Vec3<F> ambient_term = spread<F>(light.ambient * material.ambient);
        witness.term(LitTerm::ambient, light.number, ambient_term);
        ambient = ambient + ambient_term;
        if (!any(facing > zero)) continue;  // would add zero
        const Vec3<F> diffuse_term =
            (arriving * max_of(facing, zero)) * spread<F>(light.diffuse * material.diffuse);
        witness.term(LitTerm::diffuse, light.number, diffuse_term);
        diffuse = diffuse + diffuse_term;
        const Vec3<F> mirrored = F(2) * facing * s.n - to_light;
        const F highlight = power(max_of(dot(mirrored, s.to_eye), zero), F(material.shininess));
        const Vec3<F> specular_term = (arriving * select(facing > zero, highlight, zero)) *
                                      spread<F>(light.specular * material.specular);
        witness.term(LitTerm::specular, light.number, specular_term);
        specular = specular + specular_term;
    }
    return s.texture_colour * (s.ambient * ambient + diffuse) + specular;
}

// Where a highlight of blinn_schlick cannot be seen: added to the albedo it changes no bit.
struct InvisibleHighlights {
    // m (1 - cosine) beyond this: m the point's shininess, the cosine that of normal and half vector
    float falloff;
    float albedo;  // and no channel of the point's albedo below this
};
inline constexpr InvisibleHighlights kNoInvisibleHighlights{std::numeric_limits<float>::infinity(), 0};

// Of points whose texture is at least `darkest_texture` in every channel, (0,1]; 1 where there is none. A highlight is
// at most its roughness term (m + 8) / 8 cosine^m, the power at most e^(-m (1 - cosine)), and what is less than
// 2^-26 of every channel of the albedo rounds away. A point's gloss, which is at most 1, only lessens m + 8.
inline InvisibleHighlights invisible_highlights(const Material& material, float darkest_texture) {
    const glm::vec3& albedo = material.diffuse;
    const float m = material.shininess;
    const float darkest = darkest_texture * glm::min(albedo.x, glm::min(albedo.y, albedo.z));
    // With a specular reflectance above 1 so may be the Fresnel term, and a highlight is more than its
    // roughness.
    const bool bounded =
        glm::max(material.specular.x, glm::max(material.specular.y, material.specular.z)) <= 1;
    if (!(darkest >= std::numeric_limits<float>::min()) || !(m > 0) || !bounded)
        return kNoInvisibleHighlights;
    const float log2_highest = log2_of(darkest) - 26 - log2_of((m + 8) / 8);
    if (log2_highest < -125) return kNoInvisibleHighlights;  // power() ends at 2^-126
    constexpr float ln_2 = 0.693147181f, margin = 1.001f;    // of the approximations above and of power()
    return {margin * ln_2 * -log2_highest, darkest};
}

// As in Luna: one ambient term; each light's diffuse albedo plus a Blinn-Phong highlight, normalised, times
// Schlick's Fresnel term and brought into [0,1) for a low dynamic range; told as one term a light. Of a
// group of points whose highlights are all `invisible` they are left out.
template <class F, class Witness = NoLightWitness>
CREVICE_INLINE Vec3<F> blinn_schlick(const LitPoint<F>& s, const Material& material, const ViewLights& lights,
                                     const glm::vec3& ambient_light, InvisibleHighlights invisible,
                                     const Witness& witness = {}) {
    const F zero = F(0), one = F(1);
    const Vec3<F> albedo = s.texture_colour * spread<F>(material.diffuse);
    const Vec3<F> r0 = spread<F>(material.specular);
    const Mask<F> dark = min_of(albedo.x, min_of(albedo.y, albedo.z)) < F(invisible.albedo);
    Vec3<F> colour = s.ambient * (spread<F>(ambient_light) * albedo);
    witness.term(LitTerm::ambient, -1, colour);
    const auto add = [&](LitTerm kind, const ViewLight& light, Vec3<F> term) __attribute__((always_inline)) {
        witness.term(kind, light.number, term);
        colour = colour + term;
    };
    for (const ViewLight& light : lights) {
        const Vec3<F> to_light = spread<F>(-light.direction);
        F facing = max_of(dot(s.n, to_light), zero);
        witness.light(light.number, facing, light.casts_shadow ? s.shadow : one);
        if (light.casts_shadow) facing = facing * s.shadow;
        if (!any(facing > zero)) continue;  // would add zero
        const Vec3<F> half = normalize_or<F>(to_light + s.to_eye, s.n);
        const F m = s.gloss * F(material.shininess), cosine = max_of(dot(s.n, half), zero);
        if (!any((m * (one - cosine) <= F(invisible.falloff)) | dark)) {
            add(LitTerm::diffuse, light, facing * (spread<F>(light.diffuse) * albedo));
            continue;
        }
        const F roughness = (m + F(8)) * power(cosine, m) * F(0.125f);
        const Vec3<F> highlight = roughness * schlick_fresnel(r0, dot(half, to_light));
        const Vec3<F> bounded{highlight.x / (highlight.x + one), highlight.y / (highlight.y + one),
                              highlight.z / (highlight.z + one)};
        add(LitTerm::diffuse_and_specular, light, facing * (spread<F>(light.diffuse) * (albedo + bounded)));
    }
    return colour;
}

}  // namespace crevice
