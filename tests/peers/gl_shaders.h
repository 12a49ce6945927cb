// The tutorials' passes as GLSL. Spaces and conventions are the lab's (rasterizer/spaces.h). OpenGL's own y
// points up and its first row is the bottom one; every picture here is drawn upside down, by a sign, so that
// the first row is the top one, uv (0, 0) its left corner, and the rule for pixels on edges is ours.
//
// `normal_depth` holds the unit view-space normal in xyz and view depth in w; nothing there: X_Jun's clear
// values, (0, 0, -1) and background_depth. Before each text stands what is fixed while it is compiled:
// PERSPECTIVE, PHONG (0 or 1), SAMPLES, LIGHTS.
#pragma once

namespace crevice {

// Both geometry passes run this very text, so that their depths are equal.
inline constexpr const char* kGeometryVertices = R"(
layout(location = 0) in vec3 p_world;
layout(location = 1) in vec3 n_world;
uniform vec3 eye_world;
uniform mat4 clip_from_relative, view_from_relative;
out vec3 p_view, n_view;
invariant gl_Position;
void main() {
    vec3 p_relative = p_world - eye_world;
    p_view = mat3(view_from_relative) * p_relative;
    n_view = mat3(view_from_relative) * n_world;
    gl_Position = vec4(1, -1, 1, 1) * (clip_from_relative * vec4(p_relative, 1));
})";

// The interpolated normal as a unit vector, turned over on a back face.
inline constexpr const char* kUnitNormal = R"(
in vec3 p_view, n_view;
vec3 unit_normal() {
    vec3 n = normalize(n_view);
    return gl_FrontFacing ? n : -n;
})";

inline constexpr const char* kNormalDepthPixels = R"(
out vec4 normal_depth;
void main() { normal_depth = vec4(unit_normal(), p_view.z); })";

// One triangle that covers the picture.
inline constexpr const char* kPictureVertices = R"(
out vec2 uv;
void main() {
    uv = vec2((gl_VertexID << 1) & 2, gl_VertexID & 2);
    gl_Position = vec4(2 * uv - 1, 0, 1);
})";

// The estimator of ssao/methods/luna_occlusion.h, as X_Jun fetches: normals and view depth linear.
inline constexpr const char* kOcclusionPixels = R"(
in vec2 uv;
out float accessibility;
layout(binding = 0) uniform sampler2D normal_depth;
layout(binding = 1) uniform sampler2D random_map;
uniform vec3 offsets[SAMPLES];
uniform vec2 ray_scale;
uniform float near_plane, background_depth, radius, fade_end, inverse_fade, epsilon, exponent;

vec3 p_view_at(vec2 at, float z) {
    vec2 ray = vec2(2 * at.x - 1, 1 - 2 * at.y) * ray_scale;
    return PERSPECTIVE == 1 ? vec3(ray * z, z) : vec3(ray, z);
}
vec2 uv_of(vec3 p) {
    vec2 ndc = p.xy / ray_scale / (PERSPECTIVE == 1 ? p.z : 1.0);
    return vec2(0.5 + 0.5 * ndc.x, 0.5 - 0.5 * ndc.y);
}
float occlusion(float distance_z) {
    return distance_z > epsilon ? clamp((fade_end - distance_z) * inverse_fade, 0.0, 1.0) : 0.0;
}
void main() {
    vec4 here = textureLod(normal_depth, uv, 0);
    if (here.w >= background_depth) {
        accessibility = 1;
        return;
    }
    vec3 n = here.xyz, p = p_view_at(uv, here.w);
    vec3 random = normalize(2 * textureLod(random_map, 4 * uv, 0).xyz - 1);
    float sum = 0;
    for (int i = 0; i < SAMPLES; ++i) {
        vec3 d = reflect(offsets[i], random);
        vec3 q = p + (dot(d, n) < 0 ? -radius : radius) * d;
        if (q.z <= near_plane) continue;
        float r_z = textureLod(normal_depth, uv_of(q), 0).w;
        vec3 r = PERSPECTIVE == 1 ? (r_z / q.z) * q : vec3(q.xy, r_z);
        vec3 from_p = r - p;
        float dp = max(dot(n, from_p) * inversesqrt(max(dot(from_p, from_p), 1e-20)), 0.0);
        sum += dp * occlusion(p.z - r_z);
    }
    accessibility = clamp(pow(max(1 - sum / SAMPLES, 0.0), exponent), 0.0, 1.0);
})";

// One direction of ssao/blur/bilateral_blur.h. A tap outside the map sees the border, which is too far away.
inline constexpr const char* kBlurPixels = R"(
in vec2 uv;
out float blurred;
layout(binding = 0) uniform sampler2D normal_depth;
layout(binding = 1) uniform sampler2D accessibility;
uniform vec2 step_uv;
uniform float weights[11], normal_threshold, depth_threshold;
void main() {
    vec4 centre = textureLod(normal_depth, uv, 0);
    float sum = weights[5] * textureLod(accessibility, uv, 0).r, total = weights[5];
    for (int i = -5; i <= 5; ++i) {
        if (i == 0) continue;
        vec2 at = uv + i * step_uv;
        vec4 tap = textureLod(normal_depth, at, 0);
        if (dot(tap.xyz, centre.xyz) >= normal_threshold && abs(tap.w - centre.w) <= depth_threshold) {
            sum += weights[i + 5] * textureLod(accessibility, at, 0).r;
            total += weights[i + 5];
        }
    }
    blurred = sum / total;
})";

// ssao/light/lighting.h: X_Jun's Phong, Luna's Blinn-Phong with Schlick's Fresnel term.
inline constexpr const char* kLitPixels = R"(
out vec4 lit;
layout(binding = 0) uniform sampler2D accessibility_map;
uniform vec2 picture_size;
uniform vec3 diffuse, ambient, specular, ambient_light;
uniform float shininess;
uniform vec3 light_direction[LIGHTS], light_ambient[LIGHTS], light_diffuse[LIGHTS], light_specular[LIGHTS];

vec3 phong(vec3 n, vec3 to_eye, float accessibility) {
    vec3 colour = vec3(0);
    for (int i = 0; i < LIGHTS; ++i) {
        vec3 to_light = -light_direction[i];
        float facing = dot(n, to_light);
        colour += accessibility * light_ambient[i] * ambient + max(facing, 0.0) * light_diffuse[i] * diffuse;
        if (facing > 0) {
            float along = max(dot(2 * facing * n - to_light, to_eye), 0.0);
            colour += pow(along, shininess) * light_specular[i] * specular;
        }
    }
    return colour;
}
vec3 blinn_schlick(vec3 n, vec3 to_eye, float accessibility) {
    vec3 colour = accessibility * ambient_light * diffuse;
    for (int i = 0; i < LIGHTS; ++i) {
        vec3 to_light = -light_direction[i], half_way = normalize(to_light + to_eye);
        float roughness = (shininess + 8) * pow(max(dot(n, half_way), 0.0), shininess) * 0.125;
        float grazing = 1 - clamp(dot(half_way, to_light), 0.0, 1.0), grazing2 = grazing * grazing;
        vec3 highlight = roughness * (specular + grazing2 * grazing2 * grazing * (1 - specular));
        colour += max(dot(n, to_light), 0.0) * light_diffuse[i] * (diffuse + highlight / (highlight + 1));
    }
    return colour;
}
void main() {
    vec3 n = unit_normal(), to_eye = PERSPECTIVE == 1 ? normalize(-p_view) : vec3(0, 0, -1);
    float accessibility = textureLod(accessibility_map, gl_FragCoord.xy / picture_size, 0).r;
    lit = vec4(PHONG == 1 ? phong(n, to_eye, accessibility) : blinn_schlick(n, to_eye, accessibility), 1);
})";

}  // namespace crevice
