// %% setup tags=["setup"]
// Source: X_Jun, "Flaws of SSAO" (its last picture), "Multisampling", "Using the ambient map"; Luna on the samplers' border.
// Run: crevice chapter 11
#include <algorithm>
#include <array>
#include <cmath>

#include "chapters/diagrams/depth_section.h"
#include "chapters/notebook/chapter.h"
#include "chapters/props/crops.h"
#include "chapters/props/limit_lookups.h"
#include "chapters/props/limit_scenes.h"
#include "chapters/props/marked_picture.h"
#include "chapters/study/supersampled.h"
#include "chapters/terminal/number_text.h"
#include "scenes/builtin_scenes.h"
#include "ssao/ao_methods.h"
#include "ssao/judge/luna_limit.h"
#include "ssao/methods/xjun_ssao.h"

namespace crevice {
namespace {

// Counts below hang on places in pixels, so they are of pictures of this size.
constexpr Size kSize = {320, 180};

std::vector<std::string> row_of(const char* name, double accessibility, int seen) {
    return {name, decimal_text(accessibility, 3), std::to_string(seen)};
}

// A view of a scene: its AO without noise, with a ring around a point, and what rays say.
struct MarkedView {
    Picture ao, rays;
};
MarkedView marked_view(const Scene& scene, const Camera& camera, const WorldPoint& point) {
    const GBuffer gbuffer = normal_depth(scene, camera, kSize);
    const std::optional<glm::ivec2> pixel = pixel_that_shows(point, gbuffer, camera);
    return {marked_picture(noiseless_ao(gbuffer, camera), pixel),
            marked_picture(ray_picture(scene, camera, gbuffer, {.rays = 64}), pixel)};
}

// A texel of the wall beside the plate, at full size, and the strongest of its samples that meet the plate's front.
struct WallTexel {
    AoInputs inputs;
    Explanation texel;
    int x = 0, y = 0;
    std::size_t strongest = 0;  // sample
    float radius = 0;
};
WallTexel wall_texel(float distance) {
    const Scene scene = plate_scene(distance);
    const Method& xjun = find_method("xjun");
    LunaSettings settings = kXjunSettings;
    settings.ao_scale = 1;
    const GBuffer gbuffer = normal_depth(scene, scene.camera, kSize);
    const AoView view = {scene, scene.camera, gbuffer};
    const RawAo raw = xjun.ao(view, AnySettings::of(settings), {});
    WallTexel found{raw.inputs, {}, 0, kSize.height / 2, 0, settings.radius};
    float most = 0;
    for (int x = kSize.width / 2; x < kSize.width * 3 / 4; ++x) {
        const Explanation texel = xjun.explain(view, raw, AnySettings::of(settings), x, found.y);
        for (std::size_t i = 0; i < texel.samples.size(); ++i) {
            const bool on_plate = std::fabs(texel.samples[i].dz - distance) < 0.05f;
            if (!on_plate || texel.samples[i].contribution <= most) continue;
            most = texel.samples[i].contribution;
            found.x = x, found.strongest = i, found.texel = texel;
        }
    }
    return found;
}

// A plate in front of a wall, by two fade ends and by rays.
struct PlateAo {
    Image<float> fade_2, fade_1, rays;
    std::array<double, 3> darkest;  // column of each
};
PlateAo plate_ao(float distance) {
    const Scene scene = plate_scene(distance);
    const GBuffer gbuffer = normal_depth(scene, scene.camera, kSize);
    const AoInputs inputs = ao_inputs(gbuffer, scene.camera, xjun_fetch({.ao_scale = 1}));
    const auto by_fade_end = [&](float fade_end) {
        return luna_limit(inputs, {.fade_end = fade_end, .exponent = 1, .ao_scale = 1}, 8).mean;
    };
    PlateAo plate{by_fade_end(2), by_fade_end(1), ray_picture(scene, scene.camera, gbuffer, {.rays = 32}), {}};
    plate.darkest = {darkest_column(plate.fade_2), darkest_column(plate.fade_1), darkest_column(plate.rays)};
    return plate;
}

// Cells stand at the margin, where notebooks look for them.
// clang-format off
void screen_space_limits(Notebook& book) {

// %% question [markdown]
// # The limits of screen space
//
// A sphere rests on a column. In the first picture we see both, and the stone under the sphere is dark. Then we look down a
// little, until only the foot of the sphere is left in the picture. The stone has not changed, the sphere is still there, and the
// shade is almost gone. This is the flaw that the last picture of X_Jun's tutorial, for Direct3D 11, shows.

// %% look_down
const Scene columns = find_builtin_scene("columns")->make();
const DownwardViews views = downward_views();
const WorldPoint stone = views.top[views.top.size() / 2];
const MarkedView seen = marked_view(columns, views.with_sphere, stone), not_seen = marked_view(columns, views.without_sphere, stone);
book.show_row({{"sphere_seen", seen.ao, "The sphere in the picture. The ring marks a point of the stone under it."},
               {"sphere_not_seen", not_seen.ao, "From the same place, looking down: the same point, much lighter."},
               {"sphere_not_seen_rays", not_seen.rays, "The second view by rays, which ask the scene and not the picture."}});
const double truth_of_top = true_ao(columns, views.top, 256);
const SeenAo with = seen_ao(columns, views.with_sphere, kSize, views.top);
const SeenAo without = seen_ao(columns, views.without_sphere, kSize, views.top);
const SeenAo larger = seen_ao(columns, views.larger, {2 * kSize.width, 2 * kSize.height}, views.top);
book.table({"the stone in front of the sphere", "accessibility", "points seen"},
           {row_of("rays of length 0.5", truth_of_top, static_cast<int>(views.top.size())),
            row_of("the sphere in the picture", with.mean, with.seen),
            row_of("the sphere above the picture", without.mean, without.seen),
            row_of("the same, cut from a larger picture", larger.mean, larger.seen)},
           "The mean over many points of the stone around the ring.");
book.numbers(3, {{"with", with.mean}, {"without", without.mean}, {"larger", larger.mean}});
book.check("With the sphere out of the picture accessibility rises from {with} to {without}; more than half of the shade is lost.",
           truth_of_top < with.mean && with.seen > 20 && without.seen > 20 && 1 - without.mean < 0.5 * (1 - with.mean));
book.check("Computed in a larger picture, of which this one is the middle, it is {larger}: the shade is back.", larger.mean < without.mean - 0.1);

// %% idea [markdown]
// ## The idea
//
// **All that AO in screen space has is the nearest surface at every pixel. What is behind it, what is beside the picture, and how
// thick things are, it cannot know.**
//
// So the AO of one and the same point changes with the camera, while the truth does not. Each section of this chapter takes one of
// these three unknowns, and two more that come from having one sample a pixel. (To see the sphere's flaw in your own window, run
// `crevice render columns --eye 6,0.75,-2.2 --target 6,-1.55,0 --near 0.1`.)

// %% plate_section
const WallTexel wall = wall_texel(0.8f);
book.draw("plate_section", sample_diagram(wall.inputs, wall.x, wall.y, wall.texel, wall.strongest, static_cast<double>(wall.radius),
                                          "A plate in front of a wall, as the depth buffer knows it"),
          "A cut through the depth buffer: a thin plate, and 0.8 units behind it the wall with the point p. The sample at q meets the plate at r and counts "
          "it as an occluder. Nobody knows that the plate ends right behind its surface and that the light passes there: to the "
          "depth buffer all that is hatched may be solid.");

// %% beside_text [markdown]
// ## Beside the picture
//
// A sample that leaves the picture finds no depth. The tutorials' sampler then returns a far one, so it occludes nothing. Around the whole
// picture runs a rim, as wide as the radius on the screen, that is too bright. To see it, take a wall of noise, compute its AO, and
// compare with the middle of a larger picture of the same wall.

// %% beside
const BorderGain gain = border_gain();
book.show_row({{"noise_wall", ao_picture(gain.ao), "AO of a wall with random dents: soft grey all over, up to the rim."},
               {"rim", difference_picture(gain.gained), "Its AO minus that of the larger picture, cut to size: red is too bright."}});
book.numbers(3, {{"rim", gain.rim}, {"inside", gain.inside}});
book.check("The outermost four pixels are too bright by {rim} on average; in the middle the two differ by {inside}.",
           gain.rim > 0.01 && gain.rim > 3 * gain.inside);

// %% beside_code tags=["setup"]
book.listing("ssao/inputs/ao_inputs.cpp", "seen_beyond", "What the depth map shows beyond the picture. `far`: nothing, the tutorials'. "
             "`edge`: the border pixel again, so that a wall goes on. `wrap`: the opposite side, which belongs to other things. Try "
             "`crevice render noise_wall --param border=edge`.");

// %% beside_cure [markdown]
// There is one cure: render a larger picture, compute AO in all of it, and show its middle. Games call the strip around it a *guard
// band*. It costs what its pixels cost.

// %% thick_text [markdown]
// ## How thick things are
//
// In the figure the plate is 0.05 units thick. The only thing that the method knows of thickness is the fade: what is more than *fade
// end* in front of a point does not count. Too long, and thin things have halos on what lies behind them; too short, and thick ones cast
// too little shade.

// %% thick
const PlateAo at_03 = plate_ao(0.3f), at_08 = plate_ao(0.8f), at_14 = plate_ao(1.4f);
book.show_row({{"fade_end_2", ao_picture(at_14.fade_2), "The plate 1.4 units before the wall, fade end 2 (X_Jun): a halo on the wall."},
               {"fade_end_1", ao_picture(at_14.fade_1), "Fade end 1 (Luna's tutorial, for Direct3D 12): next to none."},
               {"plate_rays", ao_picture(at_14.rays), "By rays: the wall is open; only where wall and plate meet the floor is shade."}});
const auto plate_row = [](const char* distance, const PlateAo& plate) -> std::vector<std::string> {
    return {distance, decimal_text(plate.darkest[0], 3), decimal_text(plate.darkest[1], 3), decimal_text(plate.darkest[2], 3)};
};
book.table({"plate before the wall by", "fade end 2.0", "fade end 1.0", "rays"},
           {plate_row("0.3", at_03), plate_row("0.8", at_08), plate_row("1.4", at_14)},
           "Accessibility of the darkest column of pixels.");
book.check("1.4 units away the plate shades nothing. With fade end 2 it has a halo, with 1 it has none.",
           at_14.darkest[0] < at_14.darkest[2] - 0.05 && at_14.darkest[1] > at_14.darkest[2] - 0.02);
book.check("0.8 units away it still should shade next to nothing, and both give it a halo.",
           std::max(at_08.darkest[0], at_08.darkest[1]) < at_08.darkest[2] - 0.02);

// %% thick_try [markdown]
// `crevice render columns --param fade_end=1` and `--param fade_end=2` show the same on the columns.

// %% turn_text [markdown]
// ## From where one looks
//
// Let us walk around one point. It lies on a floor in front of a shelf, and we look at it from 16 directions, all of the same height and
// distance. Rays give one number. SSAO gives another from every side, since each side shows it other parts of the shelf.

// %% turn
const Scene shelf = shelf_scene();
const WorldPoint point{{0, 0, 0}, {0, 1, 0}};
const double truth = true_ao(shelf, {&point, 1}, 4096);
PlotCurve by_direction{"SSAO", {}, {}, {}, {}, PlotStyle::dots}, by_rays{"rays", {0, 360}, {truth, truth}, {}, {}, PlotStyle::smooth};
std::vector<Notebook::Named> around;
for (int i = 0; i < kDirections; ++i) {
    const Camera camera = seen_from(shelf, i);
    const double degrees = 360.0 * i / kDirections;
    const SeenAo ao = seen_ao(shelf, camera, kSize, {&point, 1});
    if (ao.seen == 1) by_direction.x.push_back(degrees), by_direction.y.push_back(ao.mean);
    if (i == 0 || i == 4 || i == 8) {
        const Image<float> map = noiseless_ao(normal_depth(shelf, camera, kSize), camera);
        const PixelRect part = part_around(kSize, kSize.width / 2, kSize.height / 2, {160, 90});
        const std::optional<glm::ivec2> pixel = pixel_that_shows(point, normal_depth(shelf, camera, kSize), camera);
        if (pixel) {
            around.push_back({"turned_" + std::to_string(i), marked_picture(cropped(map, part), glm::ivec2(pixel->x - part.x0, pixel->y - part.y0)),
                              "From " + decimal_text(degrees, 0) + " degrees. The ring marks the point."});
        } else {
            around.push_back({"turned_" + std::to_string(i), ao_picture(cropped(map, part)),
                              "From " + decimal_text(degrees, 0) + " degrees: the shelf hides the point."});
        }
    }
}
const auto [least, most] = std::minmax_element(by_direction.y.begin(), by_direction.y.end());
book.show_row(around);
book.numbers({{"views", by_direction.x.size()}, {"hidden", kDirections - static_cast<int>(by_direction.x.size())}});
book.numbers(3, {{"least", *least}, {"most", *most}, {"truth", truth}});
book.plot("turntable", {"One point from all sides", {"direction of the eye, degrees", false, 0, 360}, {"accessibility", false, 0, 1},
                        {by_direction, by_rays}},
          "{views} of 16 directions have a dot. From the other {hidden} the shelf hides the point, so no pixel shows it and there is nothing to "
          "plot.");
book.check("The point stays as it is, at {truth}; its AO goes from {least} to {most}.", by_direction.x.size() > 12 && *most - *least > 0.05);

// %% turn_try [markdown]
// `crevice render columns --only ao_blurred --frames 0-35` turns the whole scene and writes a picture for each step.

// %% layers_text [markdown]
// ## Behind the first surface
//
// How much of this is the fault of the method, how much of the depth buffer? Let rays decide that, too. We shoot the same rays twice: once through the
// scene, and once through all that the depth buffer knows of it, a single sheet of cloth that is drawn from each pixel's surface to its neighbours'.

// %% layers
Camera above = columns.camera;
above.eye = {3, 2.4, -4}, above.target = {6, -1, 0}, above.near_plane = 0.1;
const GBuffer layers = normal_depth(columns, above, kSize);
const RayAoSettings long_rays{.rays = 64, .radius = 1.5f};
const Image<float> all_layers = ray_picture(columns, above, layers, long_rays);
const Image<float> one_layer = depth_buffer_picture(columns, above, layers, long_rays);
const Image<float> lost = difference(one_layer, all_layers);
book.compare({"one_layer", ao_picture(one_layer), "Rays against the sheet that the depth buffer knows."}, {"all_layers", ao_picture(all_layers), "The same rays through the scene: the shade beside the "
             "house and behind the columns differs."});
book.show("one_layer_minus_all", difference_picture(lost),
          "Depth buffer minus scene. Red: shade is lost, because what casts it is hidden from the eye. Blue: shade is invented, because the sheet closes "
          "the gap between a near thing and the far one beside it.");
book.numbers(3, {{"lost", static_cast<double>(buffer_statistics(lost).max)},
                 {"invented", -static_cast<double>(buffer_statistics(lost).min)}});
book.check("Single pixels come out too light by up to {lost}, where the occluder is hidden, and too dark by up to {invented}, where the sheet closes a "
           "gap. A method that reads only this buffer cannot know better there.",
           buffer_statistics(lost).max > 0.3f && buffer_statistics(lost).min < -0.3f);

// %% half_text [markdown]
// ## One sample a texel
//
// Two limits are not about what is hidden, but about having one sample where there should be several.
//
// **Half size.** A texel lies between four pixels (chapter 07). With the depth of one of them, half a texel off, even a bare floor occludes itself
// when it is seen at a slant.

// %% half
const MisplacedFloor bare = misplaced_floor();
book.compare({"floor_misplaced", grey_picture(bare.misplaced, 0.85f, 1), "A bare floor with depths half a texel off, black is 0.85: it shades itself in speckles."},
             {"floor", grey_picture(bare.exact, 0.85f, 1), "With the depth at the texel's centre: open."});
book.numbers(3, {{"floor_least", static_cast<double>(buffer_statistics(bare.exact).min)},
                 {"misplaced_least", static_cast<double>(buffer_statistics(bare.misplaced).min)}});
book.check("The darkest texel of the floor is {misplaced_least} when misplaced, {floor_least} otherwise.",
           buffer_statistics(bare.exact).min > 0.99f && buffer_statistics(bare.misplaced).min < 0.9f);

// %% multisampling_text [markdown]
// **Multisampling.** With MSAA a pixel at an edge is lit by four samples of two surfaces. X_Jun turns it off, as the normal and depth targets have one
// sample a pixel. Left on, all four samples get the AO of whichever surface that one sample shows.

// %% multisampling
Camera near_column = columns.camera;
near_column.eye = {3, 0.4, -3}, near_column.target = {6, -0.6, 0}, near_column.near_plane = 0.1;
const Supersampled s = supersample(columns, near_column, kSize);
book.compare({"plain", lit_picture(s.plain), "One sample a pixel: jagged edges."},
             {"supersampled", lit_picture(s.four), "Four, each with light and AO of its own, their mean in linear light."});
book.show_row({{"multisampled", lit_picture(s.four_with_one), "Four lit samples with the AO of one: at this size as good as the correct picture."},
               {"mismatch", difference_picture(s.off, 0.1f), "That minus the correct one, 0.1 is full red: the error sits on the edges."},
               {"edges", mask_picture(s.edge), "The pixels whose samples differ."}});
book.table({"pixels", "share", "mean difference"}, {{"edges", decimal_text(s.edge_share, 3), decimal_text(s.off_at_edges, 3)},
                                                    {"elsewhere", decimal_text(1 - s.edge_share, 3), decimal_text(s.off_elsewhere, 3)}});
book.check("The AO of one sample is at least five times as wrong at edges as elsewhere.", s.off_at_edges > 5 * s.off_elsewhere);

// %% rows_text [markdown]
// ## A slip that nobody saw
//
// The last flaw is no limit of screen space but a mistake in a shader. When X_Jun's scene is lit, each pixel looks up the AO map at its place on the screen, $v$ from 0 at
// the top to 1 at the bottom. From the y and w of its clip space that is $v = -\tfrac12 (y - w)/w$. The vertex shader has $-\tfrac12 (y + w)/w$ instead,
// which is less by exactly 1. A sampler that *wraps* repeats the map above and below, so it finds the right row all the same. One that *clamps* answers with
// the top row for all that lies above the map: everywhere.

// %% rows
const ShiftedRows rows = shifted_rows(columns);
book.show_row({{"wrap", ao_picture(rows.wrap), "The AO map at v."},
               {"wrap_off_by_one", ao_picture(rows.wrap_off), "At v - 1, as X_Jun has it, with WRAP: the same."},
               {"clamp_off_by_one", ao_picture(rows.clamp_off), "At v - 1 with CLAMP: the top row down the whole picture."}});
book.number("apart", exact_text(rows.apart));
book.number("mixed", static_cast<double>(rows.mixed_rim), 3);
book.check("With WRAP the slip is hidden: the same bits where v - 1 is exact, otherwise {apart} at most.",
           rows.apart_if_exact == 0 && rows.apart < 2e-5f);
book.check("With CLAMP each row is the top one.", rows.from_top_row == 0);
book.check("WRAP is no cure, either: it mixes the lowest row into the top one, by {mixed}, and the left column into the right.",
           rows.mixed_rim > 0.01f && rows.mixed_inside == 0);

// %% exercises [markdown]
// ## Exercises
//
// 1. In `downward_views` of `chapters/props/limit_scenes.cpp`, lower the target of `without_sphere`, so that the camera looks further down. What happens
//    to the stone, and what to its shade?
// 2. In `chapters/11_screen_space_limits.cpp`, add the plate at 2.2 units, `plate_ao(2.2f)`, to the table. What are its three values, and why?
// 3. In `seen_from` of `chapters/props/limit_scenes.cpp`, set the height of the eye to 2. How many dots does the plot keep?
// 4. Where would you take the depth from, if not from the nearest surface, to lose less shade?
// 5. How wide must a guard band be so that nothing within the picture misses an occluder beside it?
//
// <details><summary>Answers</summary>
//
// 1. Its shade gets lighter still, until the stone has left the picture at the top like the sphere before it, and no pixel is left that could be wrong.
// 2. The rays have 1, both methods are within a few hundredths of it: the plate is further in front of the wall than either fade end, so it does not
//    count any more, and the halo is gone.
// 3. Fewer, because a flatter view has the shelf in front of the point more often.
// 4. From a second layer: *depth peeling* keeps the second surface of each pixel, or the depths of back faces, which also tell how thick
//    things are. Both cost a further drawing.
// 5. As wide as the radius is on the screen for the nearest surface, focal length times radius over depth; for things near the eye that may be
//    more than the picture.
//
// </details>

// %% errata [markdown]
// <details><summary>Errata of the tutorials</summary>
//
// - *X_Jun:* half size hardly matters. On planes seen at a slant it does, unless depth and ray are of one place, as shown above.
// - *X_Jun:* blames odd places and angles for the flaw. Rims, halos and hidden layers are in every picture, as the sections above show.
// - *X_Jun:* turns MSAA off because all targets must have equally many samples. They could have; one AO for four samples is what goes wrong.
// - *X_Jun, vertex shader:* adds $(w, w)$ to the clip position where $(w, -w)$ is meant, so $v$ is too small by 1; a sampler that wraps hides it.
// - *Luna:* its border depth is the far plane: nothing outside occludes, hence the rim.
//
// </details>
//
// ## Where to go on
//
// Part II meets these limits again with other methods: chapter 19 lets light pass behind thin things, chapter 20 leaves the screen. First,
// chapter 12 makes the same picture in another way: as a compute shader.

// %% end tags=["setup"]
}

const Chapter kChapter11("11", "screen_space_limits", "The limits of screen space", screen_space_limits);

}  // namespace
}  // namespace crevice
