// The passes that draw triangles, but for the lights, as GLSL. Spaces and conventions are the lab's
// (rasterizer/spaces.h). OpenGL's own y points up and its first row is the bottom one; every picture here is drawn
// upside down, by a sign, so that the first row is the top one, uv (0, 0) its left corner, and the rule for pixels on
// edges is ours. Before each text stands what is fixed while it is compiled: PERSPECTIVE (0 or 1), and what a surface
// needs: TEXTURED, MAPPED, CUTOUT (0 or 1).
#pragma once

namespace crevice {

// All passes that draw triangles run this very text, so that their depths are equal.
inline constexpr const char* kGeometryVertices = R"(
layout(location = 0) in vec3 p_world;
layout(location = 1) in vec3 n_world;
uniform vec3 eye_world;
uniform mat4 clip_from_relative, view_from_relative;
out vec3 p_view, n_view;
#if TEXTURED == 1 || MAPPED == 1 || CUTOUT == 1
layout(location = 2) in vec2 uv_of_vertex;
out vec2 uv;
#endif
#if MAPPED == 1
layout(location = 3) in vec4 tangent_world;
out vec4 tangent_view;
#endif
invariant gl_Position;
void main() {
    vec3 p_relative = p_world - eye_world;
    p_view = mat3(view_from_relative) * p_relative;
    n_view = mat3(view_from_relative) * n_world;
#if TEXTURED == 1 || MAPPED == 1 || CUTOUT == 1
    uv = uv_of_vertex;
#endif
#if MAPPED == 1
    tangent_view = vec4(mat3(view_from_relative) * tangent_world.xyz, tangent_world.w);
#endif
    gl_Position = vec4(1, -1, 1, 1) * (clip_from_relative * vec4(p_relative, 1));
})";

// The interpolated normal as a unit vector, turned over on a back face; and what a surface has holes where.
inline constexpr const char* kSurface = R"(
in vec3 p_view, n_view;
#if TEXTURED == 1 || MAPPED == 1 || CUTOUT == 1
in vec2 uv;
layout(binding = 1) uniform sampler2D diffuse_map;
#endif
uniform float alpha_cutoff;
vec3 unit_normal() {
    vec3 n = normalize(n_view);
    return gl_FrontFacing ? n : -n;
}
void cut_out() {
#if CUTOUT == 1
    if (texture(diffuse_map, uv).a < alpha_cutoff) discard;
#endif
})";

inline constexpr const char* kNormalDepthPixels = R"(
out vec4 normal_depth;
void main() {
    cut_out();
    normal_depth = vec4(unit_normal(), p_view.z);
})";

inline constexpr const char* kShadowPixels = R"(
void main() { cut_out(); })";

}  // namespace crevice
