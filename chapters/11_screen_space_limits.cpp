// Question: what can AO in screen space not know, whatever its samples and settings?
//
// The one idea: all it has is the nearest surface of every pixel. What is behind, what is beside the picture
// and how thick things are is not in it, so the same point's AO changes with the camera, and the truth does
// not.
//
// Source: seed 000, "Flaws of SSAO" (its last picture) and "Multisampling"; seed 002, the samplers' border.
// Look for: the column's top, lighter as soon as the sphere over it leaves the picture; red rims; a plate's
//           halo.
// Run: crevice chapter 11
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "chapters/chapter.h"
#include "chapters/plot_picture.h"
#include "chapters/seen_points.h"
#include "rasterizer/approx_math.h"
#include "scenes/builtin_scenes.h"
#include "scenes/composing.h"
#include "scenes/shapes.h"
#include "ssao/depth_mesh.h"
#include "ssao/ray_cast_ao.h"
#include "ssao/shade.h"
#include "ssao/xjun_ssao.h"

namespace crevice {
namespace {

// Counts below hang on places in pixels, so they are of pictures of this size.
constexpr Size kSize = {320, 180};

std::string text(double value) {
    char characters[32];
    std::snprintf(characters, sizeof characters, "%.3f", value);
    return characters;
}

Image<float> difference(Image<float> a, const Image<float>& b) {
    for (std::size_t i = 0; i < a.pixels.size(); ++i) a.pixels[i] -= b.pixels[i];
    return a;
}

Scene on_a_floor(std::initializer_list<std::pair<Mesh, glm::vec3>> meshes) {
    Scene scene = empty_scene();
    scene.instances = {placed(add_mesh(scene, grid_mesh(40, 40, 2, 2)), {0, 0, 0})};
    for (const auto& [mesh, position] : meshes)
        scene.instances.push_back(placed(add_mesh(scene, mesh), position));
    scene.camera.near_plane = 0.1;
    return scene;
}

// The front of the top of seed 000's column at (6, 0, 0), all under the sphere.
std::vector<WorldPoint> top_of_column() {
    std::vector<WorldPoint> points;
    for (double radius = 0.30; radius < 0.46; radius += 0.02) {
        for (double angle = -0.6; angle < 0.61; angle += 0.05) {
            const SineCosine at = sine_cosine(angle);
            points.push_back({{6 + radius * at.sine, 0, -radius * at.cosine}, {0, 1, 0}});
        }
    }
    return points;
}

void look_down(Notebook& book) {
    const Scene scene = columns_scene();
    Camera camera = scene.camera;
    camera.eye = {6, 0.75, -2.2}, camera.target = {6, 0.2, 0}, camera.near_plane = 0.1;
    Camera down = camera;
    down.target = {6, -1.55, 0};
    const std::vector<WorldPoint> points = top_of_column();
    std::vector<Notebook::Named> pictures;
    for (const auto& [name, view] : {std::pair{"sphere_seen", camera}, {"sphere_not_seen", down}})
        pictures.push_back({name, ao_picture(xjun_ssao(normal_depth(scene, view, book.size()), view))});
    book.show_row("A column's top from one eye: the sphere over it in the picture, and above the picture.",
                  pictures);
    const double truth = true_ao(scene, points, 256);
    const SeenAo with = seen_ao(scene, camera, kSize, points), without = seen_ao(scene, down, kSize, points);
    book.table({"the top's front", "accessibility", "points seen"},
               {{"rays of length 0.5", text(truth), std::to_string(points.size())},
                {"sphere in the picture", text(with.mean), std::to_string(with.seen)},
                {"sphere out of it", text(without.mean), std::to_string(without.seen)}});
    book.check("the truth is dark, and without the sphere most of its shade is lost",
               truth < 0.8 && with.seen > 20 && without.seen > 20 && without.mean > with.mean + 0.1);
}

void border(Notebook& book) {
    const Scene scene = noise_wall_scene();
    Camera camera = scene.camera, wider = scene.camera;
    camera.fov_y_rad = 0.7610127542247298;  // 2 atan(0.4)
    wider.fov_y_rad = 0.9272952180016122;   // 2 atan(0.5): 5/4 as high, and so is the picture
    const Size size = {320, 176}, wider_size = {400, 220};
    const GBuffer gbuffer = normal_depth(scene, camera, size),
                  around = normal_depth(scene, wider, wider_size);
    const Image<float> ao = noiseless_ao(gbuffer, camera), whole = noiseless_ao(around, wider);
    Image<float> gained = ao;
    double rim = 0, rim_count = 0, inside = 0, inside_count = 0;
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
            gained.at(x, y) -= whole.at(x + 40, y + 22);
            const int to_edge = std::min({x, y, size.width - 1 - x, size.height - 1 - y});
            if (to_edge < 4) rim += double(gained.at(x, y)), ++rim_count;
            if (to_edge > 40) inside += std::fabs(double(gained.at(x, y))), ++inside_count;
        }
    }
    book.show_row(
        "A wall of noise, and its AO minus that of a larger picture cut to size: red is too bright.",
        {{"noise_wall", ao_picture(ao)}, {"rim", difference_picture(gained)}});
    book.check("outside counts as far: the outermost 4 pixels are too bright, the middle hardly differs",
               rim / rim_count > 0.01 && rim / rim_count > 3 * inside / inside_count,
               text(rim / rim_count) + " and " + text(inside / inside_count));
}

void thin_plate(Notebook& book) {
    Scene scene =
        on_a_floor({{box_mesh({0.8, 2, 0.05}), {0, 1.2f, -1.4f}}, {box_mesh({8, 4, 0.1}), {0, 2, 0.05f}}});
    scene.camera.eye = {0, 1.2, -5}, scene.camera.target = {0, 1.2, 0};
    const GBuffer gbuffer = normal_depth(scene, scene.camera, {640, 360});
    std::vector<Notebook::Named> pictures;
    std::vector<double> means;
    std::vector<WorldPoint> beside;  // on the wall, next to where the plate hides it
    for (double y = 0.8; y < 1.6; y += 0.02) beside.push_back({{0.62, y, 0}, {0, 0, -1}});
    for (const float fade_end : {2.0f, 1.0f}) {
        const AoInputs inputs = ao_inputs(gbuffer, scene.camera, xjun_fetch(kXjunSettings));
        const Image<float> ao = luna_occlusion(inputs, {.fade_end = fade_end}, {});
        pictures.push_back({"fade_end_" + std::to_string(int(fade_end)), ao_picture(ao)});
        double least = 1;  // of the columns' means over the wall's middle rows
        for (int x = 0; x < ao.size.width; ++x) {
            double sum = 0, count = 0;
            for (int y = ao.size.height * 4 / 10; y < ao.size.height * 6 / 10; ++y, ++count)
                sum += double(ao.at(x, y));
            least = std::min(least, sum / count);
        }
        means.push_back(least);
    }
    book.show_row("A thin plate 1.4 in front of a wall: fade end 2.0 (seed 000) and 1.0 (seed 002).",
                  pictures);
    const double truth = true_ao(scene, beside, 64);
    book.check(
        "fade end 2.0 gives it a halo, 1.0 next to none (where filtering mixes plate and wall); the wall is "
        "open",
        means[0] < 0.7 && means[1] > 0.95 && truth > 0.99,
        text(means[0]) + ", " + text(means[1]) + ", truth " + text(truth));
}

void turntable(Notebook& book) {
    // A shelf over the point, open to one side.
    const Scene scene = on_a_floor(
        {{box_mesh({0.5, 0.3, 1.2}), {0.4f, 0.15f, 0}}, {box_mesh({0.3, 0.06, 1.2}), {0.25f, 0.3f, 0}}});
    const WorldPoint point{{0, 0, 0}, {0, 1, 0}};
    Camera camera = scene.camera;
    camera.target = {0, 0.1, 0};
    const double truth = true_ao(scene, {&point, 1}, 4096);
    PlotSeries seen{{}, {}, PlotMark::dots, kPlotBlue},
        line{{0, 360}, {truth, truth}, PlotMark::line, kPlotGreen};
    std::vector<Notebook::Named> pictures;
    for (int i = 0; i < 16; ++i) {
        const SineCosine at = sine_cosine(i * kPi / 8);
        camera.eye = {-1.5 * at.cosine, 4, 1.5 * at.sine};
        const SeenAo ao = seen_ao(scene, camera, kSize, {&point, 1});
        if (ao.seen == 1) seen.x.push_back(22.5 * i), seen.y.push_back(ao.mean);
        if (i % 8 == 0)
            pictures.push_back({"turned_" + std::to_string(i),
                                ao_picture(xjun_ssao(normal_depth(scene, camera, book.size()), camera))});
    }
    book.show_row("A point before a shelf, in the middle of the picture, from the open side and from behind.",
                  pictures);
    const PlotSeries both[] = {line, seen};
    book.show("turntable", plot_picture({420, 240}, {0, 360, 0, 1}, both),
              "Its accessibility from 16 directions (blue) and what is true (green).");
    const auto [least, most] = std::minmax_element(seen.y.begin(), seen.y.end());
    book.check("the point stays as it is, its AO does not", seen.y.size() > 12 && *most - *least > 0.05,
               text(*least) + " .. " + text(*most) + " from " + std::to_string(seen.y.size()) +
                   " views, truth " + text(truth));
}

void hidden_layers(Notebook& book) {
    const Scene scene = columns_scene();
    Camera camera = scene.camera;
    camera.eye = {3, 2.4, -4}, camera.target = {6, -1, 0}, camera.near_plane = 0.1;
    const GBuffer gbuffer = normal_depth(scene, camera, kSize);
    const SurfacePoints points = surface_points(scene, camera, gbuffer);
    const RayAoSettings settings{.rays = 64, .radius = 1.5f};
    const Image<float> truth =
        picture_of(points, ray_cast_ao(ray_scene(scene, camera.eye), points.points, settings));
    const Image<float> layer =
        picture_of(points, ray_cast_ao(depth_mesh(gbuffer, camera, settings.radius),
                                       points_on_depth_mesh(points, gbuffer, camera).points, settings));
    const Image<float> lost = difference(layer, truth);
    book.show_row(
        "Rays through the scene; rays against the depth buffer alone, minus these: red: shade lost, blue: "
        "invented.",
        {{"all_layers", ao_picture(truth)}, {"one_layer_minus_all", difference_picture(lost)}});
    book.check("where layers are hidden shade is lost; where near and far are joined it is invented",
               buffer_statistics(lost).max > 0.3f && buffer_statistics(lost).min < -0.3f,
               "mean " + text(buffer_statistics(lost).mean));
}

void half_resolution(Notebook& book) {
    Scene scene = on_a_floor({});
    scene.camera.eye = {0, 0.6, -8}, scene.camera.target = {0, 0, 2};
    const GBuffer gbuffer = normal_depth(scene, scene.camera, kSize);
    const AoInputs inputs = ao_inputs(gbuffer, scene.camera, xjun_fetch(kXjunSettings));
    AoInputs misplaced = inputs;  // the upper left pixel's depth at the middle of four
    for (int y = 0; y < inputs.size().height; ++y)
        for (int x = 0; x < inputs.size().width; ++x)
            misplaced.view_depth.at(x, y) = gbuffer.view_depth.at(2 * x, 2 * y);
    const Image<float> ao = luna_occlusion(inputs, kXjunSettings, {}),
                       moved = luna_occlusion(misplaced, kXjunSettings, {});
    book.show_row(
        "A bare floor at half size: depth at the texel's middle; depth half a texel off (black is 0.85).",
        {{"floor", grey_picture(ao, 0.85f, 1)}, {"floor_misplaced", grey_picture(moved, 0.85f, 1)}});
    book.check("half a texel is enough for a floor to occlude itself",
               buffer_statistics(ao).min > 0.99f && buffer_statistics(moved).min < 0.9f,
               "least " + text(double(buffer_statistics(ao).min)) + " and " +
                   text(double(buffer_statistics(moved).min)));
}

void supersampling(Notebook& book) {
    const Scene scene = columns_scene();
    Camera camera = scene.camera;
    camera.eye = {3, 0.4, -3}, camera.target = {6, -0.6, 0}, camera.near_plane = 0.1;
    constexpr int kSide = 2;
    const Size fine = {kSide * kSize.width, kSide * kSize.height};
    const GBuffer gbuffer = normal_depth(scene, camera, fine);
    const Image<float> coarse = noiseless_ao(normal_depth(scene, camera, kSize), camera);
    const auto resolved = [&](Image<float> ao) {
        for (float& a : ao.pixels) a = a * a * a * a;  // seed 000's exponent
        const Image3 lit = shade(scene, camera, gbuffer.depth, ao);
        Image3 mean(kSize, glm::vec3(0));
        for (int i = 0; i < fine.width * fine.height; ++i) {
            const int x = i % fine.width, y = i / fine.width;
            mean.set(x / kSide, y / kSide,
                     mean.at(x / kSide, y / kSide) + lit.at(x, y) * (1.0f / (kSide * kSide)));
        }
        return mean;
    };
    const Image3 once = resolved(coarse), each = resolved(noiseless_ao(gbuffer, camera));
    const Image<float> off = difference(once.y, each.y);
    book.text(
        "Seed 000 turns MSAA off, as its normals have one sample a pixel. Lit with four, AO from one: "
        "at an edge all four get the AO of whichever surface that one shows.");
    book.show_row("Four samples a pixel, AO of one; minus AO of each.",
                  {{"lit", lit_picture(once)}, {"mismatch", difference_picture(off, 0.1f)}});
    book.check(
        "most of the picture does not care, edges do",
        std::fabs(buffer_statistics(off).mean) < 0.01 &&
            std::max(buffer_statistics(off).max, -buffer_statistics(off).min) > 0.03f,
        "up to " + text(std::max(double(buffer_statistics(off).max), -double(buffer_statistics(off).min))));
}

void screen_space_limits(Notebook& book) {
    book.text(R"(
        # 11 The limits of screen space

        What the normals and depths of one view do not tell, one picture each, beside the truth.
    )");
    look_down(book);
    border(book);
    thin_plate(book);
    turntable(book);
    hidden_layers(book);
    half_resolution(book);
    supersampling(book);
    book.try_it({
        "Lower `down.target` further: the column's top leaves the picture as well.",
        "Move the plate to `-0.8f`: now both fade ends give it a halo.",
        "Set the eye's height in `turntable` to 2: the shelf hides the point from more sides.",
    });
    book.errata({
        "*Seed 000:* half size hardly matters. On grazing planes it does, unless depth and ray are of one "
        "place.",
        "*Seed 000:* blames odd places and angles. Rims, halos and hidden layers are in every picture.",
        "*Seed 002:* its depth border is the far plane: nothing outside occludes, hence the rim.",
    });
}

const Chapter kChapter("11", "screen_space_limits", "The limits of screen space", screen_space_limits);

}  // namespace
}  // namespace crevice
