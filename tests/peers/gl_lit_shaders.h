// The lit picture as GLSL. Before each text stands what is fixed while it is compiled: what gl_geometry_shaders.h
// says, and PHONG, SHADOW, SKY (0 or 1), LIGHTS.
#pragma once

namespace crevice {

// Of ssao/light/shadow_factor.h: nine taps, a texel apart, each the linear mean of four comparisons.
inline constexpr const char* kShadowFactor = R"(
#if SHADOW == 1
layout(binding = 3) uniform sampler2DShadow shadow_map;
uniform vec4 shadow_u, shadow_v, shadow_depth;
uniform float shadow_bias, shadow_texel;
float shadow_factor() {
    vec4 p = vec4(p_view, 1);
    vec3 at = vec3(dot(shadow_u, p), dot(shadow_v, p), dot(shadow_depth, p) - shadow_bias);
    float sum = 0;
    for (int y = -1; y <= 1; ++y) {
        for (int x = -1; x <= 1; ++x)
            sum += textureLod(shadow_map, vec3(at.xy + vec2(x, y) * shadow_texel, at.z), 0);
    }
    return sum / 9;
}
#else
float shadow_factor() { return 1; }
#endif
)";

// What the surface's textures say: rasterizer/draw/surface_textures.h.
inline constexpr const char* kSurfaceTextures = R"(
#if MAPPED == 1
in vec4 tangent_view;
layout(binding = 2) uniform sampler2D normal_map;
#endif
vec3 texture_colour() {
#if TEXTURED == 1
    return texture(diffuse_map, uv).rgb;
#else
    return vec3(1);
#endif
}
// The normal that the map makes of n, and how much of the shininess it leaves.
vec4 mapped(vec3 n) {
#if MAPPED == 1
    vec4 map = texture(normal_map, uv);
    vec3 n_tangent = normalize(2 * map.rgb - 1);
    vec3 t = normalize(tangent_view.xyz - dot(tangent_view.xyz, n) * n);
    bool mirrored = (tangent_view.w < 0) == gl_FrontFacing;
    vec3 b = mirrored ? cross(t, n) : cross(n, t);
    return vec4(normalize(n_tangent.x * t + n_tangent.y * b + n_tangent.z * n), map.a);
#else
    return vec4(n, 1);
#endif
})";

// ssao/light/lighting.h: X_Jun's Phong, Luna's Blinn-Phong with Schlick's Fresnel term; cube_reflection.h.
inline constexpr const char* kLitPixels = R"(
out vec4 lit;
layout(binding = 0) uniform sampler2D accessibility_map;
#if SKY == 1
layout(binding = 4) uniform samplerCube sky_cube;
uniform mat4 world_from_view;
#endif
uniform vec2 picture_size;
uniform vec3 diffuse, ambient, specular, ambient_light;
uniform float shininess;
uniform vec3 light_direction[LIGHTS], light_ambient[LIGHTS], light_diffuse[LIGHTS], light_specular[LIGHTS];

vec3 phong(vec3 n, vec3 to_eye, vec3 colour, float accessibility, float shadow) {
    vec3 albedo_light = vec3(0), highlights = vec3(0);
    for (int i = 0; i < LIGHTS; ++i) {
        vec3 to_light = -light_direction[i];
        float facing = dot(n, to_light), arriving = i == 0 ? shadow : 1.0;
        albedo_light += accessibility * light_ambient[i] * ambient;
        albedo_light += arriving * max(facing, 0.0) * light_diffuse[i] * diffuse;
        if (facing > 0) {
            float along = max(dot(2 * facing * n - to_light, to_eye), 0.0);
            highlights += arriving * pow(along, shininess) * light_specular[i] * specular;
        }
    }
    return colour * albedo_light + highlights;
}
vec3 fresnel(float cosine) {
    float grazing = 1 - clamp(cosine, 0.0, 1.0), grazing2 = grazing * grazing;
    return specular + grazing2 * grazing2 * grazing * (1 - specular);
}
vec3 blinn_schlick(vec3 n, vec3 to_eye, vec3 colour, float gloss, float accessibility, float shadow) {
    vec3 albedo = colour * diffuse, sum = accessibility * ambient_light * albedo;
    float m = gloss * shininess;
    for (int i = 0; i < LIGHTS; ++i) {
        vec3 to_light = -light_direction[i], half_way = normalize(to_light + to_eye);
        float roughness = (m + 8) * pow(max(dot(n, half_way), 0.0), m) * 0.125;
        vec3 highlight = roughness * fresnel(dot(half_way, to_light));
        float arriving = max(dot(n, to_light), 0.0) * (i == 0 ? shadow : 1.0);
        sum += arriving * light_diffuse[i] * (albedo + highlight / (highlight + 1));
    }
#if SKY == 1
    vec3 mirrored = mat3(world_from_view) * (2 * dot(n, to_eye) * n - to_eye);
    sum += m / 256 * fresnel(dot(n, to_eye)) * textureLod(sky_cube, mirrored, 0).rgb;
#endif
    return sum;
}
void main() {
    vec4 surface = mapped(unit_normal());
    vec3 to_eye = PERSPECTIVE == 1 ? normalize(-p_view) : vec3(0, 0, -1), colour = texture_colour();
    float accessibility = textureLod(accessibility_map, gl_FragCoord.xy / picture_size, 0).r;
    float shadow = shadow_factor();
    lit = vec4(PHONG == 1 ? phong(surface.xyz, to_eye, colour, accessibility, shadow)
                          : blinn_schlick(surface.xyz, to_eye, colour, surface.w, accessibility, shadow), 1);
})";

// ssao/light/sky.h: at the far plane.
inline constexpr const char* kSkyVertices = R"(
out vec2 uv;
void main() {
    uv = vec2((gl_VertexID << 1) & 2, gl_VertexID & 2);
    gl_Position = vec4(2 * uv - 1, 1, 1);
})";
inline constexpr const char* kSkyPixels = R"(
in vec2 uv;
out vec4 lit;
layout(binding = 4) uniform samplerCube sky_cube;
uniform mat4 world_from_view;
uniform vec2 ray_scale;
void main() {
    vec3 sight = PERSPECTIVE == 1 ? vec3(vec2(2 * uv.x - 1, 1 - 2 * uv.y) * ray_scale, 1) : vec3(0, 0, 1);
    lit = vec4(textureLod(sky_cube, mat3(world_from_view) * sight, 0).rgb, 1);
})";

}  // namespace crevice
