#include "rasterizer/draw/vertex_transform.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "rasterizer/base/error.h"
#include "rasterizer/base/parallel.h"
#include "rasterizer/base/run.h"
#include "rasterizer/draw/clusters_in_view.h"
#include "rasterizer/draw/vertex_lanes.h"
#include "rasterizer/scene/relative_position.h"
#include "rasterizer/spaces.h"

namespace crevice {

namespace {

// Vertices are handed out in blocks of this many.
constexpr int kBlockVertices = 4096;
// Vertices are reached by 32-bit offsets (triangle_blocks.cpp).
constexpr std::size_t kMostVertices = std::numeric_limits<std::int32_t>::max();

// The matrices of one instance under one PositionOrder.
struct PositionTransform {
    PositionOrder order;
    RelativeFromObject relative;  // PositionOrder::relative
    glm::mat4 before;             // the other two; affine
    glm::mat4 after;
};

PositionTransform position_transform(const glm::mat4& world_from_object, const Camera& camera,
                                     const CameraMatrices& m, PositionOrder order) {
    const RelativeFromObject relative(world_from_object, camera.eye);
    switch (order) {
        case PositionOrder::relative: return {order, relative, glm::mat4(1), m.clip_from_relative};
        case PositionOrder::premultiplied:
            return {order, relative, m.clip_from_view * m.view_from_world * world_from_object, glm::mat4(1)};
        case PositionOrder::view_first:
            return {order, relative, m.view_from_world * world_from_object, m.clip_from_view};
    }
    return {order, relative, glm::mat4(1), glm::mat4(1)};
}

template <class F>
struct Vec4 {
    F x, y, z, w;
};

// Column-vector product, summed left to right: the one expression every pass shares.
template <class F>
CREVICE_INLINE F row_product(const glm::mat4& m, int row, Vec4<F> p) {
    return F(m[0][row]) * p.x + F(m[1][row]) * p.y + F(m[2][row]) * p.z + F(m[3][row]) * p.w;
}
template <class F>
CREVICE_INLINE Vec4<F> product(const glm::mat4& m, Vec4<F> p) {
    return {row_product(m, 0, p), row_product(m, 1, p), row_product(m, 2, p), row_product(m, 3, p)};
}

template <class F>
struct ProjectedLanes {
    Int<F> x, y, outside;
    F x_rest, y_rest, z_ndc, inverse_w;
};

template <class F>
CREVICE_INLINE Vec4<F> before_projection(const PositionTransform& transform, Vec3<F> p_object) {
    if (transform.order != PositionOrder::relative)
        return product<F>(transform.before, {p_object.x, p_object.y, p_object.z, F(1)});
    const Vec3<F> p = transform.relative.position(p_object);
    return {p.x, p.y, p.z, F(1)};
}

template <class F>
CREVICE_INLINE ProjectedLanes<F> project(Vec4<F> clip, Size size, const DepthRange& range) {
    using I = Int<F>;
    const F width = F(static_cast<float>(size.width)), height = F(static_cast<float>(size.height));
    const auto in_front = clip.w > F(0);
    const F w = select(in_front, clip.w, F(1));
    const F x = screen_x_from_ndc(clip.x / w, width), y = screen_y_from_ndc(clip.y / w, height);
    const F band = F(kGuardBand_px);

    const auto too_near = range.by_w ? clip.w < F(range.nearest) : clip.z < F(0);
    const auto too_far = range.by_w ? clip.w > F(range.farthest) : clip.z > clip.w;
    I outside = select(too_near, I(kOutsideNear), I(0)) | select(too_far, I(kOutsideFar), I(0));
    outside = outside | select(in_front, I(0), I(kOutsideEye));
    // Written so that NaN is outside, and so that a point behind the eye is on no side.
    const auto in_band = (absolute(x) <= band) & (absolute(y) <= band);
    outside = outside | select(in_band, I(0), I(kOutsideGuardBand));
    outside = outside | select(in_front & (x < F(-1)), I(kOutsideLeft), I(0));
    outside = outside | select(in_front & (x > width + F(1)), I(kOutsideRight), I(0));
    outside = outside | select(in_front & (y < F(-1)), I(kOutsideTop), I(0));
    outside = outside | select(in_front & (y > height + F(1)), I(kOutsideBottom), I(0));
    // 0 * a is 0 for every number, and NaN for infinities and NaN.
    const F zero = F(0) * clip.x + F(0) * clip.y + F(0) * clip.z + F(0) * clip.w;
    outside = outside | select(zero == F(0), I(0), I(kNotANumber));

    const F steps = F(static_cast<float>(kSubpixelSteps));
    const F x_steps = select(in_band, x, F(0)) * steps, y_steps = select(in_band, y, F(0)) * steps;
    const I x_snapped = round_half_even(x_steps), y_snapped = round_half_even(y_steps);
    return {
        x_snapped,  y_snapped, outside, x_steps - F(to_float(x_snapped)), y_steps - F(to_float(y_snapped)),
        clip.z / w, F(1) / w};
}

struct VertexBlock {
    const Mesh* mesh;
    const PositionTransform* positions;
    const glm::mat3* normals;
    int first, count;    // in the mesh
    std::size_t output;  // index of `first` in TransformedVertices
    bool in_view;        // false: marked as kNotTransformed and left
};

template <class F>
CREVICE_INLINE void store_projected(const ProjectedLanes<F>& p, std::size_t at, int count,
                                    ProjectedVertices& out) {
    store_first(out.x.data() + at, p.x, count);
    store_first(out.y.data() + at, p.y, count);
    store_first(out.x_rest.data() + at, p.x_rest, count);
    store_first(out.y_rest.data() + at, p.y_rest, count);
    store_first(out.z_ndc.data() + at, p.z_ndc, count);
    store_first(out.inverse_w.data() + at, p.inverse_w, count);
    store_first(out.outside.data() + at, p.outside, count);
}

void transform_block(const VertexBlock& block, Size size, const DepthRange& range, TransformedVertices& out,
                     const Run& run) {
    if (!block.in_view) {
        std::int32_t* const outside = out.projected.outside.data() + block.output;
        std::fill(outside, outside + block.count, std::int32_t{kNotTransformed});
        return;
    }
    run_narrow_kernel(run, [&]<class F>(Lanes<F>) {
        for (int i = 0; i < block.count; i += kLanes<F>) {
            const int filled = block.count - i < kLanes<F> ? block.count - i : kLanes<F>;
            const std::size_t mesh_index = static_cast<std::size_t>(block.first + i);
            const std::size_t index = block.output + static_cast<std::size_t>(i);
            const Vec3<F> p = load_vec3<F>(block.mesh->positions.data() + mesh_index, filled);
            const Vec4<F> clip = product(block.positions->after, before_projection(*block.positions, p));
            store_projected(project(clip, size, range), index, filled, out.projected);
            if (!out.p_clip.empty()) {
                for (int lane = 0; lane < filled; ++lane) {
                    out.p_clip[index + static_cast<std::size_t>(lane)] = {
                        element(clip.x, lane), element(clip.y, lane), element(clip.z, lane),
                        element(clip.w, lane)};
                }
            }
            if (!out.with_normals) continue;
            const Vec3<F> n = load_vec3<F>(block.mesh->normals.data() + mesh_index, filled);
            const glm::mat3& m = *block.normals;
            const Vec3<F> turned = {F(m[0][0]) * n.x + F(m[1][0]) * n.y + F(m[2][0]) * n.z,
                                    F(m[0][1]) * n.x + F(m[1][1]) * n.y + F(m[2][1]) * n.z,
                                    F(m[0][2]) * n.x + F(m[1][2]) * n.y + F(m[2][2]) * n.z};
            const Vec3<F> n_view = normalize_any_length<F>(turned);
            for (int lane = 0; lane < filled; ++lane) {
                out.n_view[index + static_cast<std::size_t>(lane)] = {
                    element(n_view.x, lane), element(n_view.y, lane), element(n_view.z, lane)};
            }
        }
    });
}

glm::dmat3 normal_matrix_by(NormalMatrix kind, const glm::mat4& world_from_object, const CameraMatrices& m) {
    const glm::dmat4 world(world_from_object);
    const glm::dmat3 view_from_object = glm::dmat3(glm::dmat4(m.view_from_relative)) * glm::dmat3(world);
    switch (kind) {
        case NormalMatrix::inverse_transpose: return normal_matrix(view_from_object);
        case NormalMatrix::with_translation:
            return glm::dmat3(glm::dmat4(m.view_from_world) * glm::transpose(glm::inverse(world)));
        case NormalMatrix::world: return view_from_object;
    }
    return {};
}

// Scaled to order 1, so that normalising neither overflows nor finds the normal too short.
glm::mat3 scaled_to_one(const glm::dmat3& normals) {
    double largest = 0;
    for (int column = 0; column < 3; ++column) {
        for (int row = 0; row < 3; ++row) largest = std::fmax(largest, std::fabs(normals[column][row]));
    }
    return largest > 0 ? glm::mat3(normals / largest) : glm::mat3(0);
}

}  // namespace

DepthRange depth_range(const Camera& camera) {
    const double n = camera.near_plane, f = camera.far_plane;
    if (camera.projection == Projection::orthographic) return {};
    const double a = camera.reversed_z ? -n / (f - n) : f / (f - n),
                 b = (camera.reversed_z ? n * f : -n * f) / (f - n);
    return {true, static_cast<float>(n), static_cast<float>(f), a, b};
}

ProjectedVertex project_vertex(glm::vec4 p_clip, Size size, const DepthRange& range) {
    const ProjectedLanes<float> p = project<float>({p_clip.x, p_clip.y, p_clip.z, p_clip.w}, size, range);
    return {p.x, p.y, p.x_rest, p.y_rest, p.z_ndc, p.inverse_w, p.outside};
}

void ProjectedVertices::resize(std::size_t count) {
    for (VertexArray<std::int32_t>* const member : {&x, &y, &outside}) member->resize(count);
    for (VertexArray<float>* const member : {&x_rest, &y_rest, &z_ndc, &inverse_w}) member->resize(count);
}

void ProjectedVertices::set(std::size_t i, const ProjectedVertex& v) {
    x[i] = v.x;
    y[i] = v.y;
    x_rest[i] = v.x_rest;
    y_rest[i] = v.y_rest;
    z_ndc[i] = v.z_ndc;
    inverse_w[i] = v.inverse_w;
    outside[i] = v.outside;
}

TransformedVertices transform_vertices(const Scene& scene, const Camera& camera, Size size,
                                       const VertexSettings& settings, const Run& run) {
    const CameraMatrices matrices = camera_matrices(camera, size);
    const DepthRange range = depth_range(camera);
    TransformedVertices result;
    result.in_view = clusters_in_view(scene, camera, size, settings.position_order, run);
    // The matrices of the instances in view.
    std::vector<PositionTransform> positions;
    std::vector<glm::mat3> normals;
    positions.reserve(scene.instances.size());
    normals.reserve(scene.instances.size());
    std::vector<VertexBlock> blocks;
    std::size_t total = 0;
    for (std::size_t i = 0; i < scene.instances.size(); ++i) {
        result.first_vertex.push_back(static_cast<std::uint32_t>(total));
        if (!result.in_view[i].any()) continue;
        const Instance& instance = scene.instances[i];
        const Mesh& mesh = scene.meshes[static_cast<std::size_t>(instance.mesh)];
        const int count = static_cast<int>(mesh.positions.size());
        positions.push_back(
            position_transform(instance.world_from_object, camera, matrices, settings.position_order));
        normals.push_back(settings.with_normals
                              ? scaled_to_one(normal_matrix_by(settings.normal_matrix,
                                                               instance.world_from_object, matrices))
                              : glm::mat3(1));
        for (const VertexRun& run_of : vertex_runs(mesh, result.in_view[i], kBlockVertices)) {
            blocks.push_back({&mesh, &positions.back(), &normals.back(), run_of.first, run_of.count,
                              total + static_cast<std::size_t>(run_of.first), run_of.in_view});
        }
        total += static_cast<std::size_t>(count);
    }
    if (total > kMostVertices) {
        throw InputError("scene: too many vertices, its instances counted (" + std::to_string(total) +
                         "); draw it in parts of at most " + std::to_string(kMostVertices));
    }
    result.projected.resize(total);
    if (settings.with_clip_positions) result.p_clip.resize(total);
    result.with_normals = settings.with_normals;
    if (settings.with_normals) result.n_view.resize(total);
    parallel_for(static_cast<int>(blocks.size()), run, [&](int block) {
        transform_block(blocks[static_cast<std::size_t>(block)], size, range, result, run);
    });
    return result;
}

}  // namespace crevice
