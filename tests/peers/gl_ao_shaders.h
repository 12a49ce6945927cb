// Ambient occlusion and its blur as GLSL, pixel by pixel of the AO map. `normal_depth` holds the unit view-space normal
// in xyz and view depth in w; nothing there: X_Jun's clear values, (0, 0, -1) and background_depth. Before each text
// stands what is fixed while it is compiled: PERSPECTIVE, HALF_SIZE, NDC_DEPTH, POINT_NORMALS (0 or 1), SAMPLES.
#pragma once

namespace crevice {

// One triangle that covers the picture.
inline constexpr const char* kPictureVertices = R"(
out vec2 uv;
void main() {
    uv = vec2((gl_VertexID << 1) & 2, gl_VertexID & 2);
    gl_Position = vec4(2 * uv - 1, 0, 1);
})";

// The G-buffer as the AO passes read it, before their own text. X_Jun filters normals and view depth; Luna takes the
// nearest pixel's normal and filters ndc depth, the other methods take that normal, and filter view depth.
inline constexpr const char* kGBuffer = R"(
in vec2 uv;
layout(binding = 0) uniform sampler2D normal_depth;
layout(binding = 2) uniform sampler2D ndc_depth;
uniform vec2 ray_scale;
uniform float near_plane, background_depth, depth_a, depth_b;

float view_depth(vec2 at) {
    if (NDC_DEPTH == 0) return textureLod(normal_depth, at, 0).w;
    float ndc = textureLod(ndc_depth, at, 0).r;
    return PERSPECTIVE == 1 ? depth_b / (ndc - depth_a) : (ndc - depth_a) / depth_b;
}
// The pixel that holds a place; of two that meet there the second, whatever rounding says.
ivec2 pixel_at(vec2 at) { return ivec2(floor(at * textureSize(normal_depth, 0) + 0.001)); }
vec3 normal(vec2 at) {
    if (POINT_NORMALS == 0) return textureLod(normal_depth, at, 0).xyz;
    return texelFetch(normal_depth, pixel_at(at), 0).xyz;
}
// Of a texel at its centre. Where the map is as large as the picture it is its pixel's alone: a filter's rounding would
// mix in what is far behind.
float texel_depth(vec2 at) {
    bool filtered = HALF_SIZE == 1 || NDC_DEPTH == 1;
    return filtered ? view_depth(at) : texelFetch(normal_depth, pixel_at(at), 0).w;
}
// From here on there is no surface.
float background() {
    if (NDC_DEPTH == 0) return background_depth;
    return 0.9999 * (PERSPECTIVE == 1 ? depth_b / (1 - depth_a) : (1 - depth_a) / depth_b);
}
vec3 p_view_at(vec2 at, float z) {
    vec2 ray = vec2(2 * at.x - 1, 1 - 2 * at.y) * ray_scale;
    return PERSPECTIVE == 1 ? vec3(ray * z, z) : vec3(ray, z);
}
vec2 uv_of(vec3 p) {
    vec2 ndc = p.xy / ray_scale / (PERSPECTIVE == 1 ? p.z : 1.0);
    return vec2(0.5 + 0.5 * ndc.x, 0.5 - 0.5 * ndc.y);
})";

// The estimator of ssao/methods/luna_occlusion.h.
inline constexpr const char* kLunaPixels = R"(
out float accessibility;
layout(binding = 1) uniform sampler2D random_map;
uniform vec3 samples[SAMPLES];
uniform float radius, fade_end, inverse_fade, epsilon, exponent;

float occlusion(float distance_z) {
    return distance_z > epsilon ? clamp((fade_end - distance_z) * inverse_fade, 0.0, 1.0) : 0.0;
}
void main() {
    float z = texel_depth(uv);
    if (z >= background()) {
        accessibility = 1;
        return;
    }
    vec3 n = normal(uv), p = p_view_at(uv, z);
    vec3 random = normalize(2 * textureLod(random_map, 4 * uv, 0).xyz - 1);
    float sum = 0;
    for (int i = 0; i < SAMPLES; ++i) {
        vec3 d = reflect(samples[i], random);
        vec3 q = p + (dot(d, n) < 0 ? -radius : radius) * d;
        if (q.z <= near_plane) continue;
        float r_z = view_depth(uv_of(q));
        vec3 r = PERSPECTIVE == 1 ? (r_z / q.z) * q : vec3(q.xy, r_z);
        vec3 from_p = r - p;
        float dp = max(dot(n, from_p) * inversesqrt(max(dot(from_p, from_p), 1e-20)), 0.0);
        sum += dp * occlusion(p.z - r_z);
    }
    accessibility = clamp(pow(max(1 - sum / SAMPLES, 0.0), exponent), 0.0, 1.0);
})";

// One direction of ssao/blur/bilateral_blur.h. A tap outside the map sees the border, which is too far away.
inline constexpr const char* kBilateralPixels = R"(
out float blurred;
layout(binding = 1) uniform sampler2D accessibility;
uniform vec2 step_uv;
uniform float weights[11], normal_threshold, depth_threshold;
void main() {
    vec3 n = normal(uv);
    float z = view_depth(uv);
    float sum = weights[5] * textureLod(accessibility, uv, 0).r, total = weights[5];
    for (int i = -5; i <= 5; ++i) {
        if (i == 0) continue;
        vec2 at = uv + i * step_uv;
        if (dot(normal(at), n) >= normal_threshold && abs(view_depth(at) - z) <= depth_threshold) {
            sum += weights[i + 5] * textureLod(accessibility, at, 0).r;
            total += weights[i + 5];
        }
    }
    blurred = sum / total;
})";

}  // namespace crevice
