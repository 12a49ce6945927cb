// Question: when does a point r in front of p count as an occluder of p, and how much?
//
// The one idea: two factors. How far r is in front of p in depth, on a curve that starts at epsilon and fades
// out; and dp, the cosine between the normal and the way to r, which is 0 for a neighbour in the same plane.
//
// Source: seed 000, "Finding potential occluders", "The occlusion test" and exercise 3; seed 002, Ssao.hlsl.
// Look for: the step at epsilon in the curves; dz and dp in the table, which must both be large for a sample
//           to count; how a bare tilted plane shades itself as soon as dp is left out.
// Run: crevice chapter 06
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

// Occlusion, up to 1, over dz from 0 to 2.5 scene units: red under one curve, blue under the other.
Picture curves(const LunaKernel& red, const LunaKernel& blue) {
    Image3 canvas({500, 100}, glm::vec3(1));
    for (int y = 0; y < 100; ++y) {
        for (int x = 0; x < 500; ++x) {
            const float dz = static_cast<float>(x) / 200, level = 1 - static_cast<float>(y) / 100;
            const float is_red = level <= red.occlusion(dz) ? 0.4f : 0, is_blue = level <= blue.occlusion(dz) ? 0.4f : 0;
            canvas.set(x, y, {1 - is_blue, 1 - is_red - is_blue, 1 - is_red});
        }
    }
    return colour_picture(canvas);
}

// What the kernel is given at a texel of the AO map.
struct Texel {
    Vec3<float> p, n, random;
};
Texel texel_at(const LunaKernel& kernel, const RandomMap& map, int x, int y) {
    const AoInputs& in = kernel.inputs;
    const float u = (static_cast<float>(x) + 0.5f) / static_cast<float>(in.size().width);
    const float v = (static_cast<float>(y) + 0.5f) / static_cast<float>(in.size().height);
    const Vec3<float> p = in.rays.p_view(u, v, in.view_depth.at(x, y));
    return {p, spread<float>(in.normal.at(x, y)), kernel.random_vector(map, u, v)};
}

// One sample, step by step.
struct Sample {
    Vec3<float> q, r;
    float dz, dp, occlusion;
};
Sample sample_of(const LunaKernel& kernel, const Texel& at, const glm::vec3& offset) {
    const Vec3<float> o = spread<float>(offset), d = o - 2 * dot(o, at.random) * at.random;
    const Vec3<float> q = at.p + (dot(d, at.n) < 0 ? -kernel.settings.radius : kernel.settings.radius) * d;
    const ViewRays& rays = kernel.inputs.rays;
    const float r_z = kernel.depth_at(rays.p_screen(q, 1 / q.z)), dz = at.p.z - r_z;
    const Vec3<float> r = rays.at_depth(q, 1 / q.z, r_z), to_r = r - at.p;
    const float cosine = dot(at.n, to_r) / std::sqrt(dot(to_r, to_r));
    return {q, r, dz, cosine > 0 ? cosine : 0, kernel.occlusion(dz)};
}

// Naive, exercise 3 of seed 000: the test by depth alone.
Image<float> without_dp(const AoInputs& inputs, const LunaSettings& settings) {
    const LunaKernel kernel(inputs, settings);
    const RandomMap map = random_map(settings.seed);
    Image<float> ao(inputs.size(), 1.0f);
    for (int y = 0; y < ao.size.height; ++y) {
        for (int x = 0; x < ao.size.width; ++x) {
            if (std::isinf(inputs.view_depth.at(x, y))) continue;
            const Texel at = texel_at(kernel, map, x, y);
            float sum = 0;
            for (const glm::vec3& offset : kernel.offsets) sum += sample_of(kernel, at, offset).occlusion;
            ao.at(x, y) = power(1 - sum / kCubeVectors, settings.exponent);
        }
    }
    return ao;
}

void tell_one_texel(Notebook& book, const LunaKernel& kernel, const Image<float>& ao) {
    int column = ao.size.width - 1, row = 0;
    for (int y = 0; y < ao.size.height; ++y) {
        for (int x = ao.size.width * 3 / 4; x < ao.size.width; ++x) {
            if (ao.at(x, y) < ao.at(column, row)) column = x, row = y;
        }
    }
    const Texel at = texel_at(kernel, random_map(kernel.settings.seed), column, row);
    std::vector<std::vector<std::string>> rows;
    float sum = 0;
    for (const glm::vec3& offset : kernel.offsets) {
        const Sample s = sample_of(kernel, at, offset);
        sum += s.dp * s.occlusion;
        rows.push_back({text(s.q), text(s.r), text(s.dz), text(s.dp), text(s.occlusion), text(s.dp * s.occlusion)});
    }
    book.text("The darkest texel at the right column, `(" + std::to_string(column) + ", " + std::to_string(row) +
              ")`: `p = " + text(at.p) + "`, `n = " + text(at.n) + "`.");
    book.table({"q (x y z)", "r (x y z)", "dz = p_z - r_z", "dp", "occlusion(dz)", "product"}, rows);
    const float told = power(1 - sum / kCubeVectors, kernel.settings.exponent);
    book.check("1 - the mean product, to the power 4, is what the pass computes",
               std::fabs(told - ao.at(column, row)) < 1e-6f, text(sum / kCubeVectors) + " occluded, AO " + text(told));
}

void tilted_plane(Notebook& book) {
    Scene scene = empty_scene();
    scene.instances = {placed(add_mesh(scene, grid_mesh(400, 400, 2, 2)), {0, 0, 0})};
    scene.camera.eye = {0, 3, -4};
    const GBuffer gbuffer = normal_depth(scene, scene.camera, book.size());
    const Image<float> with = luna_ssao(gbuffer, scene.camera);
    const Image<float> naive = without_dp(ao_inputs(gbuffer, scene.camera, luna_fetch(kLunaSettings)), kLunaSettings);
    book.show_row("A bare plane, looked at askew: with dp it is open; by depth alone it occludes itself.",
                  {{"plane", ao_picture(with)}, {"plane_without_dp", ao_picture(naive)}});
    const float least = buffer_statistics(with).min;
    const double mean = buffer_statistics(naive).mean;
    book.check("with dp every texel of the plane is open", least > 0.99f, "least " + text(least));
    book.check("without dp it is far from open", mean < 0.7, "mean " + text(static_cast<float>(mean)));
}

void occlusion_test(Notebook& book) {
    book.text(R"(
        # 06 The occlusion test

        q is a point near p. The depth map tells the first surface r on the eye's ray through q, and p loses

            dp * occlusion(p_z - r_z)      with  dp = max(0, n . (r - p) / |r - p|)

        q itself may be in mid air or inside a wall: it only says where to look.
    )");
    const Scene scene = find_builtin_scene("columns")->make();
    const GBuffer gbuffer = normal_depth(scene, scene.camera, book.size());
    const AoInputs inputs = ao_inputs(gbuffer, scene.camera, xjun_fetch(kXjunSettings));
    const LunaKernel xjun(inputs, kXjunSettings), luna(inputs, kLunaSettings);
    book.show("curves", curves(xjun, luna), "occlusion(dz), dz from 0 to 2.5: seed 002 violet, seed 000 violet and red.");
    const Image<float> ao = luna_occlusion(inputs, kXjunSettings);
    book.show("ao", ao_picture(ao), "Seed 000's AO: dark where something near stands in front.");
    tell_one_texel(book, xjun, ao);
    tilted_plane(book);
    book.show("ao_without_dp", ao_picture(without_dp(inputs, kXjunSettings)), "Exercise 3: the columns without dp.");

    LunaSettings none = kXjunSettings, large = kXjunSettings;
    none.epsilon = 0;
    large.epsilon = 0.5f;
    book.show_row("Epsilon 0, where tiny steps of one surface begin to count; and 0.5, where contacts fade.",
                  {{"epsilon_0", ao_picture(luna_occlusion(inputs, none))},
                   {"epsilon_large", ao_picture(luna_occlusion(inputs, large))}});
}

const Chapter kChapter("06", "occlusion_test", "The occlusion test", occlusion_test);
}  // namespace
}  // namespace crevice
