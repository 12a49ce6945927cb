// Question: what can AO in screen space not know, whatever its samples and settings?
//
// The one idea: all it has is the nearest surface of every pixel. What is behind, what is beside the picture
// and how thick things are is not in it, so the same point's AO changes with the camera, and the truth does
// not.
//
// Source: X_Jun, "Flaws of SSAO" (its last picture), "Multisampling", "Using the ambient map"; Luna on the
//         samplers' border.
// Look for: the column's top, lighter as soon as the sphere over it leaves the picture; red rims; a plate's
//           halo; rows that run down the whole picture.
// Run: crevice chapter 11
#include <algorithm>
#include <array>

#include "chapters/notebook/chapter.h"
#include "chapters/notebook/plot_picture.h"
#include "chapters/props/limit_scenes.h"
#include "chapters/props/limit_sections.h"
#include "chapters/terminal/number_text.h"
#include "scenes/builtin_scenes.h"
#include "ssao/judge/luna_limit.h"
#include "ssao/methods/xjun_ssao.h"

namespace crevice {
namespace {

// Counts below hang on places in pixels, so they are of pictures of this size.
constexpr Size kSize = {320, 180};

void look_down(Notebook& book, const Scene& scene) {
    const DownwardViews views = downward_views();
    std::vector<Notebook::Named> pictures;
    for (const auto& [name, view] :
         {std::pair{"sphere_seen", views.with_sphere}, {"sphere_not_seen", views.without_sphere}})
        pictures.push_back({name, ao_picture(noiseless_ao(normal_depth(scene, view, kSize), view))});
    const GBuffer gbuffer = normal_depth(scene, views.without_sphere, kSize);
    pictures.push_back({"sphere_not_seen_rays",
                        ao_picture(ray_picture(scene, views.without_sphere, gbuffer, {.rays = 64}))});
    book.show_row(
        "A column's top from one eye: the sphere on it in the picture; all but its foot above; that by rays.",
        pictures);
    const double truth = true_ao(scene, views.top, 256);
    const SeenAo with = seen_ao(scene, views.with_sphere, kSize, views.top),
                 without = seen_ao(scene, views.without_sphere, kSize, views.top),
                 larger = seen_ao(scene, views.larger, {2 * kSize.width, 2 * kSize.height}, views.top);
    const auto row = [](const char* name, const SeenAo& ao) -> std::vector<std::string> {
        return {name, decimal_text(ao.mean, 3), std::to_string(ao.seen)};
    };
    book.table({"the top's front", "accessibility", "points seen"},
               {row("rays of length 0.5", {truth, static_cast<int>(views.top.size())}),
                row("sphere in the picture", with), row("sphere above it", without),
                row("the same, cut from a larger one", larger)});
    book.check(
        "the truth is dark, and without the sphere most of its shade is lost",
        truth < with.mean && with.seen > 20 && without.seen > 20 && 1 - without.mean < 0.5 * (1 - with.mean));
    book.check("cut from a larger picture, it has its shade back", larger.mean < without.mean - 0.1);
    book.text("`crevice render columns --eye 6,0.75,-2.2 --target 6,-1.55,0 --near 0.1`");
}

void border(Notebook& book) {
    const BorderGain gain = border_gain();
    book.show_row(
        "A wall of noise, and its AO minus that of a larger picture cut to size: red is too bright.",
        {{"noise_wall", ao_picture(gain.ao)}, {"rim", difference_picture(gain.gained)}});
    book.check("outside counts as far: the outermost 4 pixels are too bright, the middle hardly differs",
               gain.rim > 0.01 && gain.rim > 3 * gain.inside,
               decimal_text(gain.rim, 3) + " and " + decimal_text(gain.inside, 3));
    book.text(R"(
        A sampler's address mode says what lies beyond: `far`, nothing (X_Jun and Luna, above); `edge`, the
        border pixel again, so that a wall goes on; `wrap`, the opposite side, which belongs to other things.

            crevice render noise_wall --param border=edge
    )");
}

void thin_plate(Notebook& book) {
    std::vector<Notebook::Named> pictures;
    std::vector<std::vector<std::string>> rows;
    std::vector<std::array<double, 3>> darkest;  // a distance: fade end 2.0, 1.0, rays
    for (const float distance : {0.3f, 0.8f, 1.4f}) {
        const Scene scene = plate_scene(distance);
        const GBuffer gbuffer = normal_depth(scene, scene.camera, kSize);
        const AoInputs inputs = ao_inputs(gbuffer, scene.camera, xjun_fetch({.ao_scale = 1}));
        const auto by_fade_end = [&](float fade_end) {
            return luna_limit(inputs, {.fade_end = fade_end, .exponent = 1, .ao_scale = 1}, 8).mean;
        };
        const Image<float> two = by_fade_end(2), one = by_fade_end(1),
                           rays = ray_picture(scene, scene.camera, gbuffer, {.rays = 32});
        darkest.push_back({darkest_column(two), darkest_column(one), darkest_column(rays)});
        rows.push_back({exact_text(distance)});
        for (const double d : darkest.back()) rows.back().push_back(decimal_text(d, 3));
        if (distance == 1.4f)
            pictures = {{"fade_end_2", ao_picture(two)},
                        {"fade_end_1", ao_picture(one)},
                        {"plate_rays", ao_picture(rays)}};
    }
    book.show_row("A plate 0.05 thin, 1.4 before a wall: fade end 2.0 (X_Jun), 1.0 (Luna), by rays of 0.5.",
                  pictures);
    book.table({"plate before the wall by", "fade end 2.0", "fade end 1.0", "rays"}, rows);
    book.check("1.4 away it shades nothing; fade end 2.0 gives it a halo, 1.0 does not",
               darkest[2][0] < darkest[2][2] - 0.05 && darkest[2][1] > darkest[2][2] - 0.02);
    book.check("0.8 away both do: fade end is all they know of thickness",
               std::max(darkest[1][0], darkest[1][1]) < darkest[1][2] - 0.02);
    book.text("`crevice render columns --param fade_end=1`");
}

void turntable(Notebook& book) {
    const Scene scene = shelf_scene();
    const WorldPoint point{{0, 0, 0}, {0, 1, 0}};
    const double truth = true_ao(scene, {&point, 1}, 4096);
    PlotSeries seen{{}, {}, PlotMark::dots, kPlotBlue},
        line{{0, 360}, {truth, truth}, PlotMark::line, kPlotGreen};
    std::vector<Notebook::Named> pictures;
    for (int i = 0; i < kDirections; ++i) {
        const Camera camera = seen_from(scene, i);
        const SeenAo ao = seen_ao(scene, camera, kSize, {&point, 1});
        if (ao.seen == 1) seen.x.push_back(22.5 * i), seen.y.push_back(ao.mean);
        if (i % 8 == 0)
            pictures.push_back({"turned_" + std::to_string(i),
                                ao_picture(xjun_ssao(normal_depth(scene, camera, book.size()), camera).ao)});
    }
    book.show_row("A point before a shelf, in the middle of the picture, from the open side and from behind.",
                  pictures);
    const PlotSeries both[] = {line, seen};
    book.show("turntable", plot_picture({420, 240}, {0, 360, 0, 1}, both),
              "Its accessibility from 16 directions (blue) and what is true (green).");
    const auto [least, most] = std::minmax_element(seen.y.begin(), seen.y.end());
    book.check("the point stays as it is, its AO does not", seen.y.size() > 12 && *most - *least > 0.05,
               decimal_text(*least, 3) + " .. " + decimal_text(*most, 3) + " from " +
                   std::to_string(seen.y.size()) + " views, truth " + decimal_text(truth, 3));
    book.text("`crevice render columns --only ao_blurred --frames 0-35` turns the whole scene.");
}

void hidden_layers(Notebook& book, const Scene& scene) {
    Camera camera = scene.camera;
    camera.eye = {3, 2.4, -4}, camera.target = {6, -1, 0}, camera.near_plane = 0.1;
    const GBuffer gbuffer = normal_depth(scene, camera, kSize);
    const RayAoSettings settings{.rays = 64, .radius = 1.5f};
    const Image<float> truth = ray_picture(scene, camera, gbuffer, settings);
    const Image<float> lost = difference(depth_buffer_picture(scene, camera, gbuffer, settings), truth);
    book.show_row(
        "Rays through the scene; rays against the depth buffer alone, minus these: red: shade lost, blue: "
        "invented.",
        {{"all_layers", ao_picture(truth)}, {"one_layer_minus_all", difference_picture(lost)}});
    book.check("where layers are hidden shade is lost; where near and far are joined it is invented",
               buffer_statistics(lost).max > 0.3f && buffer_statistics(lost).min < -0.3f,
               "mean " + decimal_text(buffer_statistics(lost).mean, 3));
}

void screen_space_limits(Notebook& book) {
    book.text(R"(
        # 11 The limits of screen space

        What the normals and depths of one view do not tell, one picture each, beside the truth.
    )");
    const Scene columns = find_builtin_scene("columns")->make();
    look_down(book, columns);
    border(book);
    thin_plate(book);
    turntable(book);
    hidden_layers(book, columns);
    half_resolution(book);
    multisampling(book, columns);
    shifted_rows(book, columns);
    book.try_it({
        "Lower `without_sphere.target` further: the column's top leaves the picture as well.",
        "Give `thin_plate` a distance of 2.2: no fade end here reaches that far, and the halo is gone.",
        "Set the eye's height in `seen_from` to 2: the shelf hides the point from more sides.",
    });
    book.errata({
        "*X_Jun:* half size hardly matters. On grazing planes it does, unless depth and ray are of one "
        "place: `floor_misplaced`.",
        "*X_Jun:* blames odd places and angles for the flaw. Rims, halos and hidden layers are in every "
        "picture: `rim`, `fade_end_2`, `one_layer_minus_all`.",
        "*X_Jun:* turns MSAA off because all targets must have equal samples. They could; one AO for four "
        "samples is what goes wrong: `mismatch`.",
        "*X_Jun, vertex shader:* adds (w, w) to the clip position where (w, -w) is meant, so v is "
        "too small by 1; a sampler that wraps hides it: `wrap_off_by_one`.",
        "*Luna:* its depth border is the far plane: nothing outside occludes, hence the rim.",
    });
}

const Chapter kChapter("11", "screen_space_limits", "The limits of screen space", screen_space_limits);

}  // namespace
}  // namespace crevice
