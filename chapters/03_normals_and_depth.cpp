// Question: what does the first pass leave behind for AO, and what can go wrong with it?
//
// The one idea: for each pixel, the normal and the depth of the nearest surface are enough to rebuild the
// visible side of the scene. Both are in view space: x right, y up, z into the picture.
//
// Source: seed 000, "Rendering normals and depths", "Transforming normals"; seeds 002 and 003, the same pass.
// Look for: how little of the range of ndc depth the scene uses; the wrong normals, which point towards the
//           eye or away from it because a translation has crept into a direction.
// Run: crevice chapter 03
#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "chapters/chapter.h"
#include "rasterizer/normal_depth.h"
#include "scenes/builtin_scenes.h"
#include "scenes/shapes.h"

namespace crevice {
namespace {

// Ndc depth, up to 1, over view depths from 0 to 20 scene units.
Picture ndc_curve(const CameraMatrices& m) {
    Image<float> canvas({400, 100}, 1.0f);
    for (int x = 1; x < 400; ++x) {
        const float ndc = m.depth_a + m.depth_b / (static_cast<float>(x) / 20);
        const int height = static_cast<int>(100 * ndc);
        for (int y = 0; y < height; ++y) canvas.at(x, 99 - y) = x % 100 == 0 ? 0.5f : 0.3f;
    }
    return grey_picture(canvas, 0, 1);
}

// What the comments in normal_depth.h promise, pixel by pixel.
void buffers_hold(Notebook& book, const GBuffer& gbuffer, const Image<float>& ndc, const CameraMatrices& m) {
    const ViewRays rays{m.ray_scale, ndc.size, true};
    float length_error = 0, depth_error = 0;
    int surface = 0, facing = 0, dirty = 0;
    for (int i = 0; i < ndc.size.width * ndc.size.height; ++i) {
        const int x = i % ndc.size.width, y = i / ndc.size.width;
        const float z = gbuffer.view_depth.at(x, y), d = ndc.at(x, y);
        const glm::vec3 n = gbuffer.normal.at(x, y);
        if (std::isinf(z)) {
            dirty += d == 1 && n == glm::vec3(0) ? 0 : 1;
            continue;
        }
        const float u = (static_cast<float>(x) + 0.5f) / static_cast<float>(ndc.size.width);
        const float v = (static_cast<float>(y) + 0.5f) / static_cast<float>(ndc.size.height);
        ++surface;
        facing += dot(rays.p_view(u, v, z), spread<float>(n)) < 0 ? 1 : 0;
        length_error = std::max(length_error, std::fabs(glm::length(n) - 1));
        depth_error = std::max(depth_error, std::fabs(m.depth_b / (d - m.depth_a) / z - 1));
    }
    book.check("normals are unit", length_error < 1e-6f, exact_text(length_error));
    book.check("nearly all face the eye, n . p < 0", facing > 0.99 * surface,
               std::to_string(facing) + " of " + std::to_string(surface));
    book.check("view depth = B / (ndc depth - A), relatively", depth_error < 1e-4f, exact_text(depth_error));
    book.check("background: normal 0, view depth infinite, ndc depth 1", dirty == 0);
}

// Interpolation cuts corners: the shortest mean of a triangle's three unit normals.
float shortest_mean(const Mesh& mesh) {
    float shortest = 1;
    for (const auto& [a, b, c] : mesh.triangles) {
        shortest = std::min(shortest, glm::length(mesh.normals[a] + mesh.normals[b] + mesh.normals[c]) / 3);
    }
    return shortest;
}

// Naive, as in seed 003: W keeps its translation, so its inverse transpose moves normals out of w = 0.
glm::vec3 naive_normal(const glm::mat4& view_from_world, const glm::mat4& world_from_object, glm::vec3 n) {
    return glm::vec3(view_from_world * glm::transpose(glm::inverse(world_from_object)) * glm::vec4(n, 0));
}

void normal_matrices(Notebook& book, const glm::mat4& view_from_world) {
    // Turned by atan(3/4) about z, stretched, moved.
    const glm::mat4 world_from_object({1.6f, 1.2f, 0, 0}, {-.6f, .8f, 0, 0}, {0, 0, 0.5f, 0}, {3, -1, 4, 1});
    const glm::mat3 view_from_object(view_from_world * world_from_object);
    const glm::vec3 n(1, 1, 1), tangents[] = {{1, 0, -1}, {0, 1, -1}};
    std::vector<std::vector<std::string>> rows;
    std::vector<float> worst;
    const auto row = [&](const char* name, glm::vec3 n_view) {
        const float a = glm::dot(glm::normalize(n_view), glm::normalize(view_from_object * tangents[0]));
        const float b = glm::dot(glm::normalize(n_view), glm::normalize(view_from_object * tangents[1]));
        rows.push_back({name, std::to_string(a), std::to_string(b)});
        worst.push_back(std::max(std::fabs(a), std::fabs(b)));
    };
    row("cofactors of 3 x 3 (this lab)", glm::mat3(normal_matrix(view_from_object)) * n);
    row("W itself (seed 002)", view_from_object * n);
    row("inverse transpose of 4 x 4 (seed 003)", naive_normal(view_from_world, world_from_object, n));
    book.table({"normal by", "cosine to one tangent", "to another"}, rows);
    book.check("only the first stays perpendicular", worst[0] < 1e-6f && worst[1] > 0.1f && worst[2] > 0.1f);
}

void normals_and_depth(Notebook& book) {
    const Scene scene = find_builtin_scene("columns")->make();
    const Camera camera = scene.camera;
    const GBuffer gbuffer = normal_depth(scene, camera, book.size());
    const Image<float> ndc = ndc_depth(gbuffer.depth);
    const CameraMatrices m = camera_matrices(camera, book.size());
    book.text(R"(
        # 03 Normals and depth

        Drawn before any light: for each pixel, the nearest surface's normal and depth.
    )");
    book.show("normal", normal_picture(gbuffer.normal), "Normals: red right, green up, blue away from you.");
    book.show("view_depth", view_depth_picture(gbuffer.view_depth), "View depth, linear in distance.");
    book.show("ndc_depth", ndc_depth_picture(ndc), "Ndc depth z / w, as the depth buffer keeps it.");
    book.text("It is `A + B / z`, `A = " + exact_text(m.depth_a) + ", B = " + exact_text(m.depth_b) + "`:");
    book.show("ndc_curve", ndc_curve(m), "Ndc depth over z from 0 to 20: half of it is below z = 2.");
    std::vector<std::vector<std::string>> rows;
    for (const float z : {1.0f, 2.0f, 10.0f, 100.0f, 1000.0f}) {
        const float d24_step = z * z / -m.depth_b / 16777216;
        rows.push_back({exact_text(z), exact_text(m.depth_a + m.depth_b / z), exact_text(d24_step)});
    }
    book.table({"z", "ndc depth", "one step of D24 is, in units of z"}, rows);
    buffers_hold(book, gbuffer, ndc, m);
    const float shortest = shortest_mean(sphere_mesh(0.5, 20, 20));
    book.check("interpolated normals are too short: normalise", shortest < 0.99f, exact_text(shortest));

    normal_matrices(book, m.view_from_world);
    ScreenGeometry geometry = screen_geometry(scene, camera, book.size());
    for (std::size_t i = 0; i < scene.instances.size(); ++i) {
        const Instance& instance = scene.instances[i];
        const Mesh& mesh = scene.meshes[static_cast<std::size_t>(instance.mesh)];
        for (std::size_t v = 0; v < mesh.normals.size(); ++v) {
            geometry.vertices.n_view[geometry.vertices.first_vertex[i] + v] =
                glm::normalize(naive_normal(m.view_from_world, instance.world_from_object, mesh.normals[v]));
        }
    }
    const GBuffer naive = normal_depth(geometry, false, {});
    book.show("naive_normal", normal_picture(naive.normal), "By seed 003: what is blue looks away.");
    book.try_it({
        "Set `near_plane` to 0.1: everything moves beyond ndc depth 0.98, steps get ten times coarser.",
        "Use `sphere_mesh(0.5, 8, 8)`: the fewer the slices, the shorter interpolated normals get.",
        "Set `eye` to 0, `target` to `{0, 0, 1}`: no translation in V, and seed 003 is right.",
    });
    book.errata({
        "*Seed 003:* multiplies float4(n, 0) by all of (W^-1)^T V. The 0 does not keep V's translation out.",
        "*Seed 000, prose:* alpha is the depth in screen space. The shader writes view-space z.",
        "*Seed 002, shader comment:* W will do for normals under nonuniform scaling. Only under uniform.",
        "*Seed 000:* a border depth of 1e5 in a 16-bit float, whose largest value is 65504.",
    });
}

const Chapter kChapter("03", "normals_and_depth", "Normals and depth", normals_and_depth);

}  // namespace
}  // namespace crevice
