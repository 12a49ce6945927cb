// Question: when does a point r in front of p count as an occluder of p, and how much?
//
// The one idea: two factors. How far r is in front of p in depth, on a curve that starts at epsilon and fades
// out; and dp, the cosine between the normal and the way to r, which is 0 for a neighbour in the same plane.
//
// Source: X_Jun, "Finding potential occluders", "The occlusion test" and exercise 3; Luna, Ssao.hlsl.
// Look for: dz and dp in the table, which must both be large; the bare plane that shades itself without dp.
// Run: crevice chapter 06
#include <algorithm>
#include <cmath>

#include "chapters/notebook/chapter.h"
#include "chapters/props/switched_ao.h"
#include "chapters/terminal/number_text.h"
#include "scenes/builtin_scenes.h"
#include "scenes/composing.h"
#include "scenes/shapes.h"
#include "ssao/methods/luna_ssao.h"
#include "ssao/methods/xjun_ssao.h"

namespace crevice {
namespace {

std::string text(float value) { return decimal_text(static_cast<double>(value), 3); }
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
    return {p, q, r, p.z - r_z, cosine > 0 ? cosine : 0, kernel.occlusion(p.z - r_z, p.z)};
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

// Exercise 3 of X_Jun: without dp.
void remove_dp(Notebook& book, const SwitchedView& view) {
    Scene scene = empty_scene();
    scene.instances = {placed(add_mesh(scene, grid_mesh(400, 400, 2, 2)), {0, 0, 0})};
    scene.camera.eye = {0, 3, -4};
    const GBuffer gbuffer = normal_depth(scene, scene.camera, book.size());
    LunaSettings settings = kLunaSettings;
    const AoInputs inputs = ao_inputs(gbuffer, scene.camera, luna_fetch(settings));
    const Image<float> with = luna_occlusion(inputs, settings, {}).ao;
    settings.self_occlusion_test = false;
    const Image<float> without = luna_occlusion(inputs, settings, {}).ao;
    const Words no_dp = {"self_occlusion_test=false"};
    book.show_row(
        "Exercise 3: a bare plane, with dp and without, where it occludes itself; and the columns, " +
            view.command(no_dp) + ": every slope is shaded, and the contacts drown.",
        {{"plane", ao_picture(with)},
         {"plane_without_dp", ao_picture(without)},
         {"ao_without_dp", ao_picture(view.ao(no_dp).raw)}});
    book.check("with dp every texel of the plane is open", buffer_statistics(with).min > 0.99f);
    const double mean = buffer_statistics(without).mean;
    book.check("without dp it is not", mean < 0.7, "mean " + decimal_text(mean, 4));
}

// The mean over texels that show a surface.
double mean_access(const SwitchedAo& ao) {
    double sum = 0, count = 0;
    for (int y = 0; y < ao.raw.size.height; ++y) {
        for (int x = 0; x < ao.raw.size.width; ++x) {
            if (std::isinf(ao.inputs.view_depth.at(x, y))) continue;
            sum += static_cast<double>(ao.raw.at(x, y));
            count += 1;
        }
    }
    return sum / count;
}

// One number of the occlusion function at a time, with the tutorial's in the middle.
void turn_the_numbers(Notebook& book, const SwitchedView& view) {
    const auto row = [&](const std::string& caption, const std::vector<Words>& variants) {
        std::vector<Notebook::Named> pictures;
        std::vector<double> means;
        for (const Words& words : variants) {
            const SwitchedAo ao = view.ao(words);
            std::string name = words.front();
            for (char& c : name) c = c == '=' || c == '.' ? '_' : c;
            pictures.push_back({name, ao_picture(ao.raw)});
            means.push_back(mean_access(ao));
        }
        book.show_row(caption + " (" + view.command(variants.front()) + " and so on)", pictures);
        return means;
    };
    const auto epsilon = row("Epsilon 0, .05 and .5: noise on level stone, contact shade, none left.",
                             {{"epsilon=0"}, {"epsilon=0.05"}, {"epsilon=0.5"}});
    book.check("a larger epsilon only ever opens", epsilon[0] < epsilon[1] && epsilon[1] < epsilon[2],
               "means " + decimal_text(epsilon[0], 4) + ", " + decimal_text(epsilon[1], 4) + ", " +
                   decimal_text(epsilon[2], 4));
    const auto fade = row("Fade end 1 (Luna), 2 (X_Jun), and no range check: halos grow.",
                          {{"fade_end=1"}, {"fade_end=2"}, {"fade_end=1e30"}});
    book.check("a wider range only ever closes; without one, columns shade the ground far behind them",
               fade[0] > fade[1] && fade[1] > fade[2],
               "means " + decimal_text(fade[0], 4) + ", " + decimal_text(fade[1], 4) + ", " +
                   decimal_text(fade[2], 4));
}

// HLSL's sign(0) is 0. It takes a normal along an axis and vectors that stay where they are.
void look_along_the_surface(Notebook& book, const AoInputs& inputs) {
    const Vec3<float> p = {0, 0, 10}, n = {0, 0, -1};
    const auto moved = [&](SignOfZero sign, std::size_t i) {
        const LunaKernel kernel(inputs, {.random_vectors = RandomVectors::none, .sign_of_zero = sign});
        const Vec3<float> way = kernel.sample_point(p, n, Vec3<float>{0, 0, 0}, kernel.offsets[i]) - p;
        return dot(way, way) > 0;
    };
    int plus = 0, zero = 0;
    for (std::size_t i = 0; i < kCubeVectors; ++i) {
        plus += moved(SignOfZero::plus, i);
        zero += moved(SignOfZero::zero, i);
    }
    book.check("facing a wall, 4 of 14 unmirrored samples have sign 0 and fall onto their own texel",
               plus == kCubeVectors && zero == kCubeVectors - 4,
               std::to_string(plus) + " and " + std::to_string(zero) + " of 14 move");
    const SwitchedView wall("cornell", book.size());
    const Words plain = {"random_vectors=none"}, trap = {plain[0], "sign_of_zero=zero"};
    const Image<float> cured = wall.ao(plain).raw, trapped = wall.ao(trap).raw;
    book.show_row("Without random vectors: sign(0) = 1; sign(0) = 0, " + wall.command(trap) + "; 0 minus 1.",
                  {{"sign_plus", ao_picture(cured)},
                   {"sign_zero", ao_picture(trapped)},
                   {"sign_difference", difference_picture(difference_of(trapped, cured))}});
}

void occlusion_test(Notebook& book) {
    book.text(R"(
        # 06 The occlusion test

        q is a point near p. The depth map tells the first surface r on the eye's ray through q, and p loses

            dp * occlusion(p_z - r_z)      with  dp = max(0, n . (r - p) / |r - p|)
    )");
    const SwitchedView view = column_foot(book.size());
    const SwitchedAo shown = view.ao();
    const LunaKernel xjun(shown.inputs, kXjunSettings), luna(shown.inputs, kLunaSettings);
    book.show("curves", curves(xjun, luna), "occlusion(dz), dz to 2.5: X_Jun all, Luna violet only.");
    book.show("ao", ao_picture(shown.raw), "X_Jun's AO: dark where something near stands in front.");
    tell_one_texel(book, xjun, shown.raw);
    remove_dp(book, view);
    turn_the_numbers(book, view);
    look_along_the_surface(book, shown.inputs);
    book.try_it({
        "Add `\"radius=2\"` to `fade_end=1e30`: the halos are as wide as the radius.",
        "Set the plane's `eye` to `{0, 30, -4}`: right below the eye dz stays under epsilon: no need of dp.",
        "In `tell_one_texel`, add up `s.occlusion` alone: the texel of exercise 3.",
    });
    book.errata({
        "*X_Jun, prose:* r occludes q. It occludes **p**; q only says where to look (table).",
        "*X_Jun, prose:* p is the intersection with the eye's ray. r is; the ray goes through **q**.",
        "*X_Jun, prose:* |p_z - r_z|. The shader's is signed: what lies behind p does not occlude it.",
        "*Luna, prose:* |q - r| is tested against epsilon. The shader tests p_z - r_z.",
        "*X_Jun:* fade start may equal fade end in its demo: 0 / 0. Here that is a step.",
        "*X_Jun, shader comment:* depth(q) is too close to depth(p). It tests depth(r).",
    });
}

const Chapter kChapter("06", "occlusion_test", "The occlusion test", occlusion_test);

}  // namespace
}  // namespace crevice
