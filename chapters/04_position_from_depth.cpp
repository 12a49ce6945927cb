// Question: how does a pixel get back its position from nothing but a depth, and how exact is that?
//
// The one idea: p lies on the eye's ray v through the pixel, so p = (p_z / v_z) v for any v on it. Its error
// is that of p_z, and a depth buffer's grows with z^2.
//
// Source: X_Jun, "Reconstructing the position"; Luna, Ssao.hlsl, NdcDepthToViewDepth; SSAO explored,
//         SSAOVS.
// Look for: unit cubes, whose edges must follow walls and floor; dots below their lines; stripes on bare
//           walls.
// Run: crevice chapter 04
#include <algorithm>
#include <cmath>

#include "chapters/notebook/chapter.h"
#include "chapters/props/depth_error_plot.h"
#include "chapters/props/position_ways.h"
#include "chapters/props/stored_depth.h"
#include "chapters/terminal/number_text.h"
#include "scenes/builtin_scenes.h"
#include "ssao/blur/bilateral_blur.h"
#include "ssao/methods/luna_ssao.h"
#include "ssao/methods/xjun_ssao.h"

namespace crevice {
namespace {

void compare_positions(Notebook& book, const Scene& scene) {
    const GBuffer gbuffer = normal_depth(scene, scene.camera, book.size());
    const AoInputs inputs = ao_inputs(gbuffer, scene.camera, xjun_fetch(kXjunSettings));
    constexpr std::pair<const char*, Position> kWays[] = {
        {"far_plane", by_far_plane},       {"near_plane", by_near_plane}, {"unit_ray", by_unit_ray},
        {"unit_corners", by_unit_corners}, {"full_size", by_full_size},   {"misprint", as_misprinted}};
    std::vector<Notebook::Named> cubes, occlusion;
    std::vector<std::vector<std::string>> rows;
    std::vector<double> worst;
    for (const auto& [name, position] : kWays) {
        const PositionError error = position_error(inputs, position);
        rows.push_back({name, significant_text(error.mean, 2), significant_text(error.most, 2)});
        worst.push_back(error.most);
        if (position == &by_near_plane || position == &as_misprinted) continue;
        cubes.push_back({std::string("cubes_") + name, unit_cubes(gbuffer, scene.camera, position)});
        occlusion.push_back({std::string("ao_") + name, ao_picture(ao_at(inputs, position))});
    }
    book.show_row("Unit cubes by `far_plane`, which is right; `unit_ray`; `unit_corners`; `full_size`.",
                  cubes);
    book.show_row("X_Jun's AO of each: shade leaves its place, or comes where nothing is near.", occlusion);
    book.table({"p by", "off by, units, mean", "at most"}, rows);
    book.check("rays to the far and to the near plane give p to the last bits",
               std::max(worst[0], worst[1]) < 1e-4,
               significant_text(worst[0], 2) + " and " + significant_text(worst[1], 2));
    book.check("each other way is off by units", *std::min_element(worst.begin() + 2, worst.end()) > 0.5);
    const Vec3<float> p = as_misprinted(inputs.rays, 0.3f, 0.8f, 7);
    book.check("`(p.z/v/z) v` is (1, 1, 1) for every pixel",
               std::fabs(p.x - 1) + std::fabs(p.y - 1) + std::fabs(p.z - 1) < 1e-5f);
}

// So the ray does not matter. What matters is the number that p_z is made of.
void compare_storages(Notebook& book, const Scene& scene) {
    std::vector<Notebook::Named> pictures;
    std::vector<std::vector<std::string>> rows;
    std::vector<StoredDepthError> errors;
    for (const DepthStorage& storage : kDepthStorages) {
        errors.push_back(stored_depth_error(scene, book.size(), storage));
        const StoredDepthError& e = errors.back();
        rows.push_back({storage.name, significant_text(e.most, 2), significant_text(e.most_of_z, 2),
                        significant_text(e.most_of_z2, 2)});
        if (errors.size() <= 3)
            pictures.push_back({"stored_" + std::to_string(errors.size()), difference_picture(e.off, 0.01f)});
    }
    book.show_row(
        "Rebuilt minus drawn view depth, 0.01 too near blue, too far red: a 16-bit float of z (X_Jun), "
        "D16, D24 (Luna).",
        pictures);
    book.table({"stored", "off by at most, units", "over z", "over z^2"}, rows);
    book.check(
        "16 bits of z: off by less than z / 1024; 16 bits of z / w: by about half a step, z^2 / |B| / 2^17",
        errors[0].most_of_z < 1.0 / 1024 && errors[1].most_of_z2 < 1.05 / (1.001 * 131072),
        significant_text(1024 * errors[0].most_of_z, 4) + " and " +
            significant_text(1.001 * 131072 * errors[1].most_of_z2, 4) + " of it");
    book.check(
        "in this scene a 16-bit float of z is the coarser of the two; D24 is fifty times better than both",
        errors[1].most < errors[0].most && 50 * errors[2].most < errors[1].most);
}

void bounds(Notebook& book) {
    const DepthErrorTable errors = depth_error_table();
    book.text("The largest relative error of a view depth, stored and rebuilt:");
    book.table(errors.header, errors.rows);
    book.check("all are inside the bound", errors.most_of_bound <= 1,
               significant_text(errors.most_of_bound, 2) + " of it");
    book.check("reversed floats: below 2e-7 everywhere", errors.worst_reversed < 2e-7,
               significant_text(errors.worst_reversed, 2));
    book.show("depth_error", depth_error_plot(),
              "Relative error over z, planes at 1 and 1000: measured (dots) below the bound (lines). D16 "
              "orange, D24 blue, reversed D32F green.");
}

void false_occlusion(Notebook& book) {
    const Scene scene = bare_walls();
    const double epsilon = double(kLunaSettings.epsilon);
    const double from_d16 = depth_of_step(scene.camera, DepthFormat::d16, epsilon),
                 from_d24 = depth_of_step(scene.camera, DepthFormat::d24, epsilon);
    book.check("between 1 and 1000 a step exceeds epsilon from z = 57 (D16) and 916 (D24) on",
               std::fabs(from_d16 - 57.3) < 0.1 && std::fabs(from_d24 - 916.4) < 1,
               significant_text(from_d16, 3) + " and " + significant_text(from_d24, 3));
    std::vector<std::vector<std::string>> rows;
    std::vector<Notebook::Named> pictures;
    std::vector<double> means;
    for (const int kind : {0, 1, 3}) {
        const WallAo walls = wall_ao(kDepthKinds[kind]);
        pictures.push_back({"walls_" + std::to_string(kind), ao_picture(walls.ao)});
        rows.push_back({kDepthKinds[kind].name});
        for (const double mean : walls.means)
            means.push_back(mean), rows.back().push_back(significant_text(mean, 3));
    }
    book.show_row("AO of bare walls 25, 45, 65, 85 and 105 away with D16, D24, reversed D32F.", pictures);
    book.table({"mean AO of the wall at z =", "25", "45", "65", "85", "105"}, rows);
    book.check("D16: open at 25 and 45, striped at 85 and 105",
               std::min(means[0], means[1]) > 0.99 && std::max(means[3], means[4]) < 0.97);
    book.check("D24 and reversed D32F: open", *std::min_element(means.begin() + 5, means.end()) > 0.999);
}

void half_floats(Notebook& book, const Scene& scene) {
    std::vector<Notebook::Named> pictures;
    std::vector<std::vector<std::string>> rows;
    std::vector<double> nan;
    for (const BufferFormat format :
         {BufferFormat::float16_toward_zero, BufferFormat::float16_nearest_even}) {
        const float sky = stored_as(1e5f, format);
        const GBuffer gbuffer = normal_depth(scene, scene.camera, book.size(), {.buffer_format = format});
        const AoInputs inputs = ao_inputs(gbuffer, scene.camera, xjun_fetch({.as_published = true}));
        const Image<float> ao = ao_with_std_max(inputs), blurred = bilateral_blur(ao, inputs).ao;
        const double texels = double(ao.size.width) * ao.size.height / 100;
        nan.push_back(double(buffer_statistics(ao).nan) / texels);
        const std::string name = pictures.empty() ? "toward_zero" : "nearest";
        rows.push_back({name, exact_text(sky), exact_text(sky - sky), exact_text(10 + 0 * (sky - 10)),
                        significant_text(nan.back(), 3),
                        significant_text(double(buffer_statistics(blurred).nan) / texels, 3)});
        pictures.push_back({name, ao_picture(ao)});
    }
    book.table({"rounding", "1e5 is", "minus itself", "10 + 0 (it - 10)", "% NaN", "% NaN, blurred"}, rows);
    book.show_row("The sky at 1e5 in 16 bits: D3D rounds toward zero; to nearest, NaN (magenta).", pictures);
    book.check("toward zero next to nothing is NaN (only where r = p), to nearest the sky and every outline",
               nan[0] < 0.1 && nan[1] > 5,
               significant_text(nan[0], 2) + " and " + significant_text(nan[1], 3) + " %");
}

void position_from_depth(Notebook& book) {
    book.text(R"(
        # 04 Position from depth

        A ray through the pixel and a view depth: `p = (p_z / v_z) v`. X_Jun takes a ray to the far plane
        and stores `p_z`; Luna takes one to the near plane and rebuilds `p_z = B / (d - A)` from ndc depth
        d. An error e of d is then one of `e z^2 / |B|` in `p_z`.

            crevice render columns --param depth_format=d16 --param buffer_format=float16
    )");
    const Scene scene = find_builtin_scene("columns")->make();
    compare_positions(book, scene);
    compare_storages(book, scene);
    bounds(book);
    false_occlusion(book);
    half_floats(book, scene);
    book.try_it({
        "In `by_unit_corners` use `interpolated`'s corners: all are equally long, and normalising them does "
        "no "
        "harm.",
        "Set `scene.camera.near_plane = 4` in `bare_walls`: D16's stripes begin at 115, behind the last "
        "wall.",
        "Add `BufferFormat::float32` to the loop of `half_floats`: 1e5 fits, and no texel of the sky is NaN.",
    });
    book.errata({
        "*Luna:* `p=(p.z/v/z)v` is printed for `p = (p.z / v.z) v`: see the check.",
        "*SSAO explored:* multiplies x and y in -1 to 1 by the size of the far plane. Half of it is meant: "
        "`full_size`.",
        "*X_Jun:* calls the depth it keeps in alpha screen depth. It is view-space z, not distance: "
        "`unit_ray`.",
        "*X_Jun and SSAO explored:* border and clear depth are 1e5, which 16 bits cannot hold; only D3D's "
        "rounding helps.",
    });
}

const Chapter kChapter("04", "position_from_depth", "Position from depth", position_from_depth);

}  // namespace
}  // namespace crevice
