// Question: when does a point r in front of p count as an occluder of p, and how much?
//
// The one idea: two factors. How far r is in front of p in depth, on a curve that starts at epsilon and fades
// out; and dp, the cosine between the normal and the way to r, which is 0 for a neighbour in the same plane.
//
// Source: seed 000, "Finding potential occluders", "The occlusion test" and exercise 3; seed 002, Ssao.hlsl.
// Look for: dz and dp in the table, which must both be large; the bare plane that shades itself without dp.
// Run: crevice chapter 06
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "chapters/chapter.h"
#include "scenes/builtin_scenes.h"
#include "scenes/composing.h"
#include "scenes/shapes.h"
#include "ssao/luna_ssao.h"
#include "ssao/xjun_ssao.h"

namespace crevice {
namespace {

std::string text(float value) {
    char characters[32];
    std::snprintf(characters, sizeof characters, "%.3f", static_cast<double>(value));
    return characters;
}
std::string text(Vec3<float> a) { return text(a.x) + " " + text(a.y) + " " + text(a.z); }

// Occlusion, up to 1, over dz from 0 to 2.5 scene units.
Picture curves(const LunaKernel& red, const LunaKernel& blue) {
    Image3 canvas({500, 100}, glm::vec3(1));
    for (int i = 0; i < 500 * 100; ++i) {
        const float dz = static_cast<float>(i % 500) / 200, level = 1 - static_cast<float>(i / 500) / 100;
        const float r = level <= red.occlusion(dz) ? 0.4f : 0, b = level <= blue.occlusion(dz) ? 0.4f : 0;
        canvas.set(i % 500, i / 500, {1 - b, 1 - r - b, 1 - r});
    }
    return colour_picture(canvas);
}

// Sample i of texel (x, y), step by step.
struct Sample {
    Vec3<float> p, q, r;
    float dz, dp, occlusion;
};
Sample sample_of(const LunaKernel& kernel, const RandomMap& map, int x, int y, std::size_t i) {
    const AoInputs& in = kernel.inputs;
    const float u = (static_cast<float>(x) + 0.5f) / static_cast<float>(in.size().width);
    const float v = (static_cast<float>(y) + 0.5f) / static_cast<float>(in.size().height);
    const Vec3<float> p = in.rays.p_view(u, v, in.view_depth.at(x, y));
    const Vec3<float> n = spread<float>(in.normal.at(x, y));
    const Vec3<float> o = spread<float>(kernel.offsets[i]), random = kernel.random_vector(map, u, v);
    const Vec3<float> d = o - 2 * dot(o, random) * random;
    const Vec3<float> q = p + (dot(d, n) < 0 ? -kernel.settings.radius : kernel.settings.radius) * d;
    const float r_z = kernel.depth_at(in.rays.p_screen(q, 1 / q.z));
    const Vec3<float> r = in.rays.at_depth(q, 1 / q.z, r_z), to_r = r - p;
    const float cosine = dot(n, to_r) / std::sqrt(dot(to_r, to_r));
    return {p, q, r, p.z - r_z, cosine > 0 ? cosine : 0, kernel.occlusion(p.z - r_z)};
}

// Naive, exercise 3 of seed 000: the test by depth alone.
Image<float> without_dp(const AoInputs& inputs, const LunaSettings& settings) {
    const LunaKernel kernel(inputs, settings);
    const RandomMap map = random_map(settings.seed);
    Image<float> ao(inputs.size(), 1.0f);
    for (int y = 0; y < ao.size.height; ++y) {
        for (int x = 0; x < ao.size.width; ++x) {
            if (std::isinf(inputs.view_depth.at(x, y))) continue;
            float sum = 0;
            for (std::size_t i = 0; i < kCubeVectors; ++i) sum += sample_of(kernel, map, x, y, i).occlusion;
            ao.at(x, y) = power(1 - sum / kCubeVectors, settings.exponent);
        }
    }
    return ao;
}

void tell_one_texel(Notebook& book, const LunaKernel& kernel, const Image<float>& ao) {
    const auto darkest = std::min_element(ao.pixels.begin(), ao.pixels.end()) - ao.pixels.begin();
    const int x = static_cast<int>(darkest) % ao.stride, y = static_cast<int>(darkest) / ao.stride;
    const RandomMap map = random_map(kernel.settings.seed);
    std::vector<std::vector<std::string>> rows;
    float sum = 0;
    for (std::size_t i = 0; i < kCubeVectors; ++i) {
        const Sample s = sample_of(kernel, map, x, y, i);
        sum += s.dp * s.occlusion;
        rows.push_back({text(s.q), text(s.r), text(s.dz), text(s.dp), text(s.occlusion)});
    }
    book.text("Darkest, at a column's foot, is `(" + std::to_string(x) + ", " + std::to_string(y) + ")`, " +
              "`p = " + text(sample_of(kernel, map, x, y, 0).p) + "` in view space.");
    book.table({"q (x y z)", "r (x y z)", "dz = p_z - r_z", "dp", "occlusion(dz)"}, rows);
    const float told = power(1 - sum / kCubeVectors, kernel.settings.exponent);
    book.check("1 - the mean of dp * occlusion, to the power 4, is what the pass computes",
               std::fabs(told - ao.at(x, y)) < 1e-6f, "mean " + text(sum / kCubeVectors) + ", " + text(told));
}

void look_at_a_bare_plane(Notebook& book) {
    Scene scene = empty_scene();
    scene.instances = {placed(add_mesh(scene, grid_mesh(400, 400, 2, 2)), {0, 0, 0})};
    scene.camera.eye = {0, 3, -4};
    const GBuffer gbuffer = normal_depth(scene, scene.camera, book.size());
    const AoInputs inputs = ao_inputs(gbuffer, scene.camera, luna_fetch(kLunaSettings));
    const Image<float> with = luna_occlusion(inputs, kLunaSettings, {});
    const Image<float> without = without_dp(inputs, kLunaSettings);
    book.show_row("A bare plane, looked at askew: with dp it is open; by depth alone it occludes itself.",
                  {{"plane", ao_picture(with)}, {"plane_without_dp", ao_picture(without)}});
    book.check("with dp every texel of the plane is open", buffer_statistics(with).min > 0.99f);
    const double mean = buffer_statistics(without).mean;
    book.check("without dp it is not", mean < 0.7, "mean " + text(static_cast<float>(mean)));
}

void occlusion_test(Notebook& book) {
    book.text(R"(
        # 06 The occlusion test

        q is a point near p. The depth map tells the first surface r on the eye's ray through q, and p loses

            dp * occlusion(p_z - r_z)      with  dp = max(0, n . (r - p) / |r - p|)
    )");
    const Scene scene = find_builtin_scene("columns")->make();
    Camera camera = scene.camera;
    camera.eye = {-4.6, -1.4, -2.6}, camera.target = {-6.2, -2.8, 0};
    const GBuffer gbuffer = normal_depth(scene, camera, book.size());
    const AoInputs inputs = ao_inputs(gbuffer, camera, xjun_fetch(kXjunSettings));
    const LunaKernel xjun(inputs, kXjunSettings), luna(inputs, kLunaSettings);
    book.show("curves", curves(xjun, luna), "occlusion(dz), dz to 2.5: seed 000 all, seed 002 violet only.");
    const Image<float> ao = luna_occlusion(inputs, kXjunSettings, {});
    book.show("ao", ao_picture(ao), "Seed 000's AO: dark where something near stands in front.");
    tell_one_texel(book, xjun, ao);
    look_at_a_bare_plane(book);
    book.show("ao_without_dp", ao_picture(without_dp(inputs, kXjunSettings)), "Exercise 3: without dp.");
    book.show_row("Epsilon 0, where tiny steps of one surface begin to count; and 0.5, where contacts fade.",
                  {{"epsilon_0", ao_picture(luna_occlusion(inputs, {.epsilon = 0}, {}))},
                   {"epsilon_large", ao_picture(luna_occlusion(inputs, {.epsilon = 0.5f}, {}))}});
    book.try_it({
        "Use `.fade_end = 10` for `.epsilon = 0`: what is far in front of p still counts: a halo at columns.",
        "Set the plane's `eye` to `{0, 30, -4}`: right below the eye dz stays under epsilon: no need of dp.",
        "In `without_dp`, add up `s.dp * s.occlusion`: the picture is that of the pass again.",
    });
    book.errata({
        "*Seed 000, prose:* r occludes q. It occludes **p**; q only says where to look.",
        "*Seed 000, prose:* |p_z - r_z|. The shader's is signed: what lies behind p does not occlude it.",
        "*Seed 002, prose:* |q - r| is tested against epsilon. The shader tests p_z - r_z.",
        "*Seed 000, shader comment:* depth(q) is too close to depth(p). It tests depth(r).",
    });
}

const Chapter kChapter("06", "occlusion_test", "The occlusion test", occlusion_test);

}  // namespace
}  // namespace crevice
