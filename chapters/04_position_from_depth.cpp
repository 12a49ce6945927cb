// Question: how does a pixel get back its position from nothing but a depth, and how exact is that?
//
// The one idea: p lies on the eye's ray v through the pixel, so p = (p_z / v_z) v for any v on it. Its error
// is that of p_z, and a depth buffer's grows with z^2.
//
// Source: seed 000, "Reconstructing the position"; seed 002, Ssao.hlsl, NdcDepthToViewDepth; seed 003,
//         SSAOVS.
// Look for: unit cubes, whose edges must follow walls and floor; dots below their lines; stripes on bare
//           walls.
// Run: crevice chapter 04
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "chapters/chapter.h"
#include "chapters/depth_error_plot.h"
#include "chapters/position_picture.h"
#include "scenes/builtin_scenes.h"
#include "scenes/composing.h"
#include "scenes/shapes.h"
#include "ssao/bilateral_blur.h"
#include "ssao/luna_ssao.h"
#include "ssao/xjun_ssao.h"

namespace crevice {
namespace {

using Vector = Vec3<float>;

std::string text(double value, int digits = 2) {
    char characters[32];
    std::snprintf(characters, sizeof characters, "%.*g", digits, value);
    return characters;
}

// ---- the ray, as the tutorials do it and as one should not

Vector unit_of(Vector a) { return normalize_or<float>(a, {0, 0, 1}); }
Vector far_corner(const ViewRays& rays, float x, float y) {
    return 1000.0f * Vector{x * rays.ray_scale.x, y * rays.ray_scale.y, 1};
}
// What a pixel gets of four corners.
Vector interpolated(const ViewRays& rays, float u, float v) {
    const Vector left = far_corner(rays, -1, 1), right = far_corner(rays, 1, 1),
                 below = far_corner(rays, -1, -1);
    return left + u * (right - left) + v * (below - left);
}
Vector far_plane(const ViewRays& rays, float u, float v, float z) {
    const Vector ray = interpolated(rays, u, v);
    return (z / ray.z) * ray;
}
// Naive: a unit ray, and depth taken for distance.
Vector unit_ray(const ViewRays& rays, float u, float v, float z) {
    return z * unit_of(interpolated(rays, u, v));
}
// Naive: one triangle over the screen, whose corners are normalised before they are interpolated.
Vector unit_corners(const ViewRays& rays, float u, float v, float z) {
    const Vector a = unit_of(far_corner(rays, -1, 1)), b = unit_of(far_corner(rays, 3, 1)),
                 c = unit_of(far_corner(rays, -1, -3));
    const Vector ray = a + (u / 2) * (b - a) + (v / 2) * (c - a);
    return (z / ray.z) * ray;
}
// Naive, seed 003: the far plane's size where x and y in -1 to 1 need half of it.
Vector full_size(const ViewRays& rays, float u, float v, float z) {
    const Vector p = far_plane(rays, u, v, z);
    return {2 * p.x, 2 * p.y, p.z};
}
// Naive, seed 002: (p.z/v/z) v, as printed.
Vector misprint(const ViewRays& rays, float u, float v, float z) {
    const Vector ray = interpolated(rays, u, v);
    return {z / ray.x / z * ray.x, z / ray.y / z * ray.y, z / ray.z / z * ray.z};
}

void compare_positions(Notebook& book, const Scene& scene) {
    const GBuffer gbuffer = normal_depth(scene, scene.camera, book.size());
    const AoInputs inputs = ao_inputs(gbuffer, scene.camera, xjun_fetch(kXjunSettings));
    constexpr std::pair<const char*, Position> kWays[] = {{"far_plane", far_plane},
                                                          {"unit_ray", unit_ray},
                                                          {"unit_corners", unit_corners},
                                                          {"full_size", full_size},
                                                          {"misprint", misprint}};
    std::vector<Notebook::Named> cubes, occlusion;
    std::vector<std::vector<std::string>> rows;
    std::vector<double> worst;
    for (const auto& [name, position] : kWays) {
        const PositionError error = position_error(inputs, position);
        rows.push_back({name, text(error.mean), text(error.most)});
        worst.push_back(error.most);
        if (position == &misprint) continue;
        cubes.push_back({std::string("cubes_") + name, unit_cubes(gbuffer, scene.camera, position)});
        occlusion.push_back({std::string("ao_") + name, ao_picture(ao_at(inputs, position))});
    }
    book.show_row("Unit cubes by `far_plane`, which is right; `unit_ray`; `unit_corners`; `full_size`.",
                  cubes);
    book.show_row("Seed 000's AO of each: shade leaves its place, or comes where nothing is near.",
                  occlusion);
    book.table({"p by", "off by, units, mean", "at most"}, rows);
    book.check("the far-plane ray gives p to the last bits", worst[0] < 1e-4, text(worst[0]));
    book.check("each other way is off by units", *std::min_element(worst.begin() + 1, worst.end()) > 0.5);
    const Vector p = misprint(inputs.rays, 0.3f, 0.8f, 7);
    book.check("`(p.z/v/z) v` is (1, 1, 1) for every pixel",
               std::fabs(p.x - 1) + std::fabs(p.y - 1) + std::fabs(p.z - 1) < 1e-5f);
}

// ---- where the depth is too coarse

// Enough pixels for the stripes, whatever the size of this notebook.
constexpr Size kWallsSize = {640, 360};

// Five bare walls side by side, 20 units behind each other, turned a little so that each crosses some steps.
Scene walls() {
    Scene scene = empty_scene();
    scene.camera.eye = {0, 0, 0}, scene.camera.target = {0, 0, 1}, scene.camera.fov_y_rad = 0.35;
    const int box = add_mesh(scene, box_mesh({1, 1, 0.1}));
    for (int i = 0; i < 5; ++i) {
        const float z = 25 + 20 * static_cast<float>(i), x = 0.125f * z * static_cast<float>(i - 2);
        const glm::mat4 turned =
            glm::rotate(glm::translate(glm::mat4(1.0f), {x, 0, z}), 0.06f, glm::vec3(0, 1, 0));
        scene.instances.push_back({box, glm::scale(turned, {0.12f * z, 0.3f * z, 1})});
    }
    return scene;
}

void false_occlusion(Notebook& book) {
    Scene scene = walls();
    const double epsilon = double(kLunaSettings.epsilon);
    const double from_d16 = depth_of_step(scene.camera, DepthFormat::d16, epsilon),
                 from_d24 = depth_of_step(scene.camera, DepthFormat::d24, epsilon);
    book.check("between 1 and 1000 a step exceeds epsilon from z = 57 (D16) and 916 (D24) on",
               std::fabs(from_d16 - 57.3) < 0.1 && std::fabs(from_d24 - 916.4) < 1,
               text(from_d16, 3) + " and " + text(from_d24, 3));
    std::vector<std::vector<std::string>> rows;
    std::vector<Notebook::Named> pictures;
    std::vector<double> means;
    for (const int kind : {0, 1, 3}) {
        scene.camera.reversed_z = kDepthKinds[kind].reversed_z;
        const GBuffer gbuffer =
            normal_depth(scene, scene.camera, kWallsSize, {.depth_format = kDepthKinds[kind].format});
        const Image<float> ao = luna_ssao(gbuffer, scene.camera);
        pictures.push_back({"walls_" + std::to_string(kind), ao_picture(ao)});
        rows.push_back({kDepthKinds[kind].name});
        for (int i = 0; i < 5; ++i) {  // the middle row, within each wall
            double sum = 0, count = 0;
            for (int x = ao.size.width * (4 * i + 1) / 20; x < ao.size.width * (4 * i + 3) / 20; ++x, ++count)
                sum += double(ao.at(x, ao.size.height / 2));
            means.push_back(sum / count);
            rows.back().push_back(text(means.back(), 3));
        }
    }
    book.show_row("AO of bare walls 25, 45, 65, 85 and 105 away with D16, D24, reversed D32F.", pictures);
    book.table({"mean AO of the wall at z =", "25", "45", "65", "85", "105"}, rows);
    book.check("D16: open at 25 and 45, striped at 85 and 105",
               std::min(means[0], means[1]) > 0.99 && std::max(means[3], means[4]) < 0.97);
    book.check("D24 and reversed D32F: open", *std::min_element(means.begin() + 5, means.end()) > 0.999);
}

// ---- 1e5 in a half

// Naive: seed 000's loop in C++, whose std::max(NaN, 0) is NaN. HLSL's is 0.
Image<float> with_std_max(const AoInputs& in) {
    const LunaKernel kernel(in, kXjunSettings);
    const RandomMap map = random_map(kXjunSettings.seed);
    Image<float> ao(in.size(), 1.0f);
    for (int i = 0; i < in.size().width * in.size().height; ++i) {
        const int x = i % in.size().width, y = i / in.size().width;
        const float u = (float(x) + 0.5f) / float(in.size().width),
                    v = (float(y) + 0.5f) / float(in.size().height);
        const Vector p = in.rays.p_view(u, v, in.view_depth.at(x, y)), n = spread<float>(in.normal.at(x, y));
        float sum = 0;
        for (const glm::vec3& offset : kernel.offsets) {
            const Vector q = kernel.sample_point(p, n, kernel.random_vector(map, u, v), offset);
            const float r_z = kernel.depth_at(in.rays.p_screen(q, 1 / q.z));
            const Vector to_r = (r_z / q.z) * q - p;
            sum += std::max(dot(n, to_r) / std::sqrt(dot(to_r, to_r)), 0.0f) * kernel.occlusion(p.z - r_z);
        }
        ao.at(x, y) = 1 - sum / kCubeVectors;
    }
    return ao;
}

std::string number(float value) { return std::isnan(value) ? "NaN" : exact_text(value); }

void half_floats(Notebook& book, const Scene& scene) {
    std::vector<Notebook::Named> pictures;
    std::vector<std::vector<std::string>> rows;
    std::vector<double> nan;
    for (const BufferFormat format :
         {BufferFormat::float16_toward_zero, BufferFormat::float16_nearest_even}) {
        const float sky = stored_as(1e5f, format);
        const GBuffer gbuffer = normal_depth(scene, scene.camera, book.size(), {.buffer_format = format});
        const AoInputs inputs = ao_inputs(gbuffer, scene.camera, xjun_fetch({.as_published = true}));
        const Image<float> ao = with_std_max(inputs), blurred = bilateral_blur(ao, inputs);
        const double texels = double(ao.size.width) * ao.size.height / 100;
        nan.push_back(double(buffer_statistics(ao).nan) / texels);
        const std::string name = pictures.empty() ? "toward_zero" : "nearest";
        rows.push_back({name, exact_text(sky), number(sky - sky), number(10 + 0 * (sky - 10)),
                        text(nan.back(), 3), text(double(buffer_statistics(blurred).nan) / texels, 3)});
        pictures.push_back({name, ao_picture(ao)});
    }
    book.table({"rounding", "1e5 is", "minus itself", "10 + 0 (it - 10)", "% NaN", "% NaN, blurred"}, rows);
    book.show_row("The sky at 1e5 in 16 bits: D3D rounds toward zero; to nearest, NaN (magenta).", pictures);
    book.check("toward zero next to nothing is NaN (only where r = p), to nearest the sky and every outline",
               nan[0] < 0.1 && nan[1] > 5, text(nan[0]) + " and " + text(nan[1], 3) + " %");
}

void position_from_depth(Notebook& book) {
    book.text(R"(
        # 04 Position from depth

        A ray through the pixel and a view depth: `p = (p_z / v_z) v`. Seed 000 stores `p_z`; seed 002 rebuilds
        it from ndc depth, `p_z = B / (d - A)`. An error e of d is then one of `e z^2 / |B|` in `p_z`.
    )");
    const Scene scene = find_builtin_scene("columns")->make();
    compare_positions(book, scene);
    const DepthErrorTable errors = depth_error_table();
    book.text("The largest relative error of a view depth, stored and rebuilt:");
    book.table(errors.header, errors.rows);
    book.check("all are inside the bound", errors.most_of_bound <= 1, text(errors.most_of_bound) + " of it");
    book.check("reversed floats: below 2e-7 everywhere", errors.worst_reversed < 2e-7,
               text(errors.worst_reversed));
    book.show(
        "depth_error", depth_error_plot(),
        "Relative error over z, planes at 1 and 1000: measured (dots) below the bound (lines). D16 orange, "
        "D24 blue, reversed D32F green.");
    false_occlusion(book);
    half_floats(book, scene);
    book.try_it({
        "In `unit_corners` use `interpolated`'s corners: all are equally long, and normalising them does no "
        "harm.",
        "Set `scene.camera.near_plane = 4` in `walls`: D16's stripes begin at 115, behind the last wall.",
        "Add `BufferFormat::float32` to the loop of `half_floats`: 1e5 fits, and no texel of the sky is NaN.",
    });
    book.errata({
        "*Seed 002:* `p=(p.z/v/z)v` is printed for `p = (p.z / v.z) v`: see the check.",
        "*Seed 003:* multiplies x and y in -1 to 1 by the size of the far plane. Half of it is meant: "
        "`full_size`.",
        "*Seed 000:* calls the depth it keeps in alpha screen depth. It is view-space z, not distance: "
        "`unit_ray`.",
        "*Seeds 000, 003:* border and clear depth are 1e5, which 16 bits cannot hold; only D3D's rounding "
        "helps.",
    });
}

const Chapter kChapter("04", "position_from_depth", "Position from depth", position_from_depth);

}  // namespace
}  // namespace crevice
