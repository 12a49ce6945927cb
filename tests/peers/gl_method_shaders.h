// Ambient occlusion of the methods that are public as shaders, as GLSL, after kGBuffer and kPixels. Before each text stands
// what gl_ao_shaders.h says; `noise` is a tile over the AO map, and SAMPLES counts `samples`.
#pragma once

namespace crevice {

// What the methods that step from pixel to pixel have in common.
inline constexpr const char* kPixels = R"(
layout(binding = 1) uniform sampler2D noise;
uniform vec3 samples[SAMPLES];
uniform float radius, exponent, pixels_per_unit;

vec4 noise_here() { return texelFetch(noise, ivec2(gl_FragCoord.xy) & (textureSize(noise, 0) - 1), 0); }
// Of a length across the view at view depth z.
float length_px(float len, float z) { return len * pixels_per_unit / (PERSPECTIVE == 1 ? z : 1.0); }
bool is_outside(vec2 position) {
    return any(lessThan(position, vec2(0))) || any(greaterThanEqual(position, textureSize(normal_depth, 0)));
}
// The surface that the pixel at a place of the picture shows; beyond the picture it is far away.
vec3 surface_at(vec2 position) {
    vec2 centre = floor(position) + 0.5;
    float z = is_outside(position) ? background_depth : texelFetch(normal_depth, ivec2(centre), 0).w;
    return p_view_at(centre / textureSize(normal_depth, 0), z);
}
float with_contrast(float access) { return clamp(pow(max(access, 0.0), exponent), 0.0, 1.0); })";

// ssao/methods/hemisphere.h: LearnOpenGL's, its errata cured.
inline constexpr const char* kHemispherePixels = R"(
out float accessibility;
uniform float bias;

float range_weight(float distance) { return smoothstep(0.0, 1.0, radius / max(abs(distance), radius)); }
void main() {
    float z = texel_depth(uv);
    accessibility = 1;
    if (z >= background()) return;
    vec3 n = normal(uv), p = p_view_at(uv, z), turn = vec3(noise_here().xy, 0);
    vec3 across = turn - dot(turn, n) * n, z_across = vec3(0, 0, 1) - n.z * n;
    vec3 t = normalize(dot(across, across) > 1e-4 ? across : z_across);
    mat3 frame = mat3(t, cross(n, t), n);
    float sum = 0;
    for (int i = 0; i < SAMPLES; ++i) {
        vec3 q = p + radius * (frame * samples[i]);
        if (q.z <= near_plane) continue;
        vec3 r = surface_at(uv_of(q) * textureSize(normal_depth, 0));
        if (r.z <= q.z - bias && dot(n, r - p) > bias) sum += range_weight(p.z - r.z);
    }
    accessibility = with_contrast(1 - sum / SAMPLES);
})";

// A mean along rows or columns, ssao/blur/box_blur.h; surfaces alone.
inline constexpr const char* kBoxPixels = R"(
out float blurred;
layout(binding = 1) uniform sampler2D accessibility;
uniform vec2 step_uv;
uniform float weights[5];
void main() {
    float sum = 0;
    for (int i = -2; i <= 2; ++i) sum += weights[i + 2] * textureLod(accessibility, uv + i * step_uv, 0).r;
    bool last_direction = step_uv.x == 0;
    blurred = last_direction && texel_depth(uv) >= background() ? 1.0 : sum;
})";

// ssao/inputs/depth_pyramid.h: a level from the one before by the rotated grid; level 0 from the first pass.
inline constexpr const char* kPyramidPixels = R"(
out float depth;
layout(binding = 3) uniform sampler2D pyramid;
uniform float level;
void main() {
    ivec2 cell = ivec2(gl_FragCoord.xy);
    if (level == 0)
        depth = texelFetch(normal_depth, cell, 0).w;
    else
        depth = texelFetch(pyramid, 2 * cell + ((cell.yx & 1) ^ 1), int(level) - 1).r;
})";

// ssao/methods/sao.h. The map keeps the depth beside the accessibility, for the blur, as the published shader does.
inline constexpr const char* kSaoPixels = R"(
out vec2 accessibility_depth;
layout(binding = 3) uniform sampler2D pyramid;
uniform float inverse_radius, intensity, bias, epsilon, levels;
// Which pixel a level's cell was picked from.
const int kOther[6] = int[](0, 1, 2, 5, 10, 21), kOwn[6] = int[](0, 0, 1, 2, 5, 10);

void main() {
    float z = texel_depth(uv);
    accessibility_depth = vec2(1, z);
    if (z >= background()) return;
    vec3 n = normal(uv), p = p_view_at(uv, z);
    vec2 size = textureSize(normal_depth, 0), turn = noise_here().xy;
    float radius_px = length_px(radius, p.z), sum = 0;
    for (int i = 0; i < SAMPLES; ++i) {
        vec2 offset = mat2(turn.x, turn.y, -turn.y, turn.x) * samples[i].xy, position = uv * size + radius_px * offset;
        if (is_outside(position)) continue;
        int level = clamp(findMSB(int(samples[i].z * radius_px)) - 3, 0, int(levels));
        ivec2 cell = min(ivec2(position) >> level, textureSize(pyramid, level) - 1);
        float r_z = texelFetch(pyramid, cell, level).r;
        if (r_z <= near_plane || r_z >= background_depth) continue;
        ivec2 odd = cell & 1, picked = (cell << level) + kOther[level] * (1 - odd.yx) + kOwn[level] * odd;
        vec3 v = inverse_radius * (p_view_at((picked + 0.5) / size, r_z) - p);
        float vv = dot(v, v), near = max(1 - vv, 0.0);
        sum += 5 * intensity * near * near * near * max(dot(v, n) - bias, 0.0) / (epsilon + vv);
    }
    accessibility_depth.x = with_contrast(1 - sum / SAMPLES);
})";

// ssao/blur/sao_blur.h: the mean of four texels, of which the published shader's derivatives are the two differences ...
inline constexpr const char* kQuadPixels = R"(
out vec2 blurred;
layout(binding = 1) uniform sampler2D accessibility_depth;
uniform float quad_limit;

vec2 evened(vec2 a, vec2 b) { return vec2(abs(a.y - b.y) < quad_limit ? 0.5 * (a.x + b.x) : a.x, a.y); }
vec2 at(ivec2 texel) { return texelFetch(accessibility_depth, min(texel, textureSize(accessibility_depth, 0) - 1), 0).xy; }
vec2 across(ivec2 texel) { return evened(at(texel), at(ivec2(texel.x ^ 1, texel.y))); }
void main() {
    ivec2 texel = ivec2(gl_FragCoord.xy);
    blurred = evened(across(texel), across(ivec2(texel.x, texel.y ^ 1)));
})";
// ... and the weighted mean along rows or columns.
inline constexpr const char* kSaoBlurPixels = R"(
out vec2 blurred;
layout(binding = 1) uniform sampler2D accessibility_depth;
uniform float weights[5], taps, step_texels, down, inverse_depth;
void main() {
    ivec2 texel = ivec2(gl_FragCoord.xy), last = textureSize(accessibility_depth, 0) - 1;
    vec2 here = texelFetch(accessibility_depth, texel, 0).xy;
    float sum = weights[0] * here.x, total = weights[0];
    ivec2 along = int(step_texels) * (down == 0 ? ivec2(1, 0) : ivec2(0, 1));
    for (int i = -int(taps); i <= int(taps); ++i) {
        ivec2 at = texel + i * along;
        if (i == 0 || any(lessThan(at, ivec2(0))) || any(greaterThan(at, last))) continue;
        vec2 tap = texelFetch(accessibility_depth, at, 0).xy;
        float weight = weights[abs(i)] * max(1 - abs(tap.y - here.y) * inverse_depth, 0.0);
        sum += weight * tap.x;
        total += weight;
    }
    blurred = vec2(clamp(sum / total, 0.0, 1.0), here.y);
})";

// ssao/methods/gtao.h, GtaoForm::losses; `samples` are the directions of the slices.
inline constexpr const char* kGtaoPixels = R"(
out float accessibility;
uniform float reach, inverse_fade, steps;
const float kGolden = 0.6180339887498948482, kHalfPi = 1.57079632679;

// What a side loses of which everything from the angle of cosine c on is closed.
float closed_beyond(float c, float cosine, float sine, float gamma) {
    float s = sqrt(max(1 - c * c, 0.0));
    float of_double_angle = (2 * c * c - 1) * cosine + 2 * c * s * sine;
    float loss = 0.25 * (cosine + of_double_angle + 2 * (gamma + kHalfPi - acos(clamp(c, -1.0, 1.0))) * sine);
    return c > -sine ? max(loss, 0.0) : 0.0;
}
void main() {
    float z = texel_depth(uv);
    accessibility = 1;
    if (z >= background()) return;
    vec3 n = normal(uv), p = p_view_at(uv, z), v = PERSPECTIVE == 1 ? normalize(-p) : vec3(0, 0, -1);
    vec3 noise_of_texel = noise_here().xyz;
    vec2 here = uv * textureSize(normal_depth, 0);
    float radius_px = length_px(reach, p.z), own_squared = 1e-12 * dot(p, p), sum = 0;
    for (int i = 0; i < SAMPLES; ++i) {
        vec2 turn = noise_of_texel.xy, along = mat2(turn.x, turn.y, -turn.y, turn.x) * samples[i].xy;
        vec3 t = normalize(vec3(along, 0) - dot(along, v.xy) * v), axis = cross(t, v);
        float n_t = dot(n, t), towards = max(dot(n, v), 0.0), len = sqrt(n_t * n_t + towards * towards);
        if (len <= 1e-6) continue;
        float cosine = towards / len, sine = n_t / len, angle = acos(clamp(cosine, -1.0, 1.0));
        float gamma = sine < 0 ? -angle : angle;
        for (float side = 1; side >= -1; side -= 2) {
            float c = -side * sine;
            for (int k = 0; k < int(steps); ++k) {
                float part = (k + fract(noise_of_texel.z + (i + k * steps) * kGolden)) / steps;
                float distance_px = part * part * radius_px + 1.3;
                vec3 r = surface_at(here + side * distance_px * vec2(along.x, -along.y)), delta = r - p;
                float squared = dot(delta, delta);
                if (r.z <= near_plane || squared <= own_squared) continue;
                float weight = clamp((reach - sqrt(squared)) * inverse_fade, 0.0, 1.0);
                // Moved into the slice along the surface.
                float beside = dot(axis, n) * dot(axis, delta) / len;
                float across = dot(t, delta) + sine * beside, up = dot(v, delta) + cosine * beside;
                float found = side * across > 0 ? up * inversesqrt(across * across + up * up) : -1.0;
                c = max(c, mix(-side * sine, found, weight));
            }
            sum += len * closed_beyond(c, cosine, side * sine, side * gamma);
        }
    }
    accessibility = with_contrast(1 - sum / SAMPLES);
})";

// ssao/blur/packed_edges.h: two bits for each side of a texel: left, right, top, bottom.
inline constexpr const char* kEdgePixels = R"(
out uint edges;
uniform vec2 map_size;

float depth_at(vec2 texel) { return texel_depth((clamp(texel, vec2(0), map_size - 1) + 0.5) / map_size); }
uint continued(float apart, float bent, float width) {
    return uint(clamp(1.25 - min(abs(apart), abs(bent)) / width, 0.0, 1.0) * 2.9 + 0.5);
}
void main() {
    vec2 texel = floor(gl_FragCoord.xy);
    float z = depth_at(texel), width = 0.011 * (PERSPECTIVE == 1 ? z : 1.7320508 * ray_scale.y);
    float left = depth_at(texel - vec2(1, 0)) - z, right = depth_at(texel + vec2(1, 0)) - z;
    float top = depth_at(texel - vec2(0, 1)) - z, bottom = depth_at(texel + vec2(0, 1)) - z;
    float across = 0.5 * (left + right), down = 0.5 * (top + bottom);
    uvec4 sides = uvec4(continued(left, across, width), continued(right, across, width), continued(top, down, width),
                        continued(bottom, down, width));
    bvec4 inside = bvec4(texel.x > 0, texel.x < map_size.x - 1, texel.y > 0, texel.y < map_size.y - 1);
    sides *= uvec4(inside);
    edges = sides.x << 6 | sides.y << 4 | sides.z << 2 | sides.w;
})";
// ssao/blur/edge_blur.h.
inline constexpr const char* kEdgeBlurPixels = R"(
out float blurred;
layout(binding = 1) uniform sampler2D accessibility;
layout(binding = 3) uniform usampler2D edges;
uniform float own_weight;

bool inside(ivec2 at) { return all(greaterThanEqual(at, ivec2(0))) && all(lessThan(at, textureSize(edges, 0))); }
// How far it goes on to the left, right, top, bottom.
vec4 sides(ivec2 at) {
    if (!inside(at)) return vec4(0);
    uint bits = texelFetch(edges, at, 0).r;
    return vec4(bits >> 6 & 3u, bits >> 4 & 3u, bits >> 2 & 3u, bits & 3u) / 3;
}
void main() {
    ivec2 at = ivec2(gl_FragCoord.xy), x = ivec2(1, 0), y = ivec2(0, 1);
    vec4 left = sides(at - x), right = sides(at + x), top = sides(at - y), bottom = sides(at + y);
    // Both neighbours must say so.
    vec4 side = sides(at) * vec4(left.y, right.x, top.w, bottom.z);
    side += 0.5 / 1.5 * clamp(1.5 - dot(side, vec4(1)), 0.0, 1.0);
    side = clamp(side, 0.0, 1.0) * vec4(inside(at - x), inside(at + x), inside(at - y), inside(at + y));
    vec4 corner = 0.425 * vec4(side.x * left.z + side.z * top.x, side.z * top.y + side.y * right.z,
                               side.w * bottom.x + side.x * left.w, side.y * right.w + side.w * bottom.y);
    float total = own_weight + dot(side, vec4(1)) + dot(corner, vec4(1));
    float sum = own_weight * texelFetch(accessibility, at, 0).r;
    ivec2 last = textureSize(accessibility, 0) - 1;
#define TAP(offset) texelFetch(accessibility, clamp(at + offset, ivec2(0), last), 0).r
    sum += dot(side, vec4(TAP(-x), TAP(x), TAP(-y), TAP(y)));
    sum += dot(corner, vec4(TAP(-x - y), TAP(x - y), TAP(-x + y), TAP(x + y)));
    blurred = min(sum / total, 1.0);
})";

}  // namespace crevice
