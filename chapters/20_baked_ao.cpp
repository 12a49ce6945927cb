// %% setup tags=["setup"]
// Source: Luna, BuildVertexAmbientOcclusion; the Unity notes on baked AO (lightmaps).
// Run: crevice chapter 20
#include <algorithm>
#include <cmath>
#include <limits>

#include "chapters/diagrams/ray_fan.h"
#include "chapters/notebook/chapter.h"
#include "chapters/props/bounced_light.h"
#include "chapters/terminal/number_text.h"
#include "rasterizer/lanes/approx_math.h"
#include "scenes/builtin_scenes.h"
#include "scenes/composing.h"
#include "scenes/shapes.h"
#include "ssao/bakes/baked_lookup.h"
#include "ssao/bakes/lightmap_ao.h"
#include "ssao/judge/metrics.h"
#include "ssao/light/shade.h"

namespace crevice {
namespace {

using Values = std::vector<float>;  // one a pixel that shows a surface

// A scene as its camera sees it: points to cast rays from, the triangle each lies on, and truth.
struct View {
    RayScene rays;
    SurfacePoints points;
    std::vector<RayHit> hits;
    Values truth;

    View(const Scene& scene, Size size, const RayAoSettings& settings)
        : rays(ray_scene(scene, scene.camera.eye)),
          points(surface_points(scene, scene.camera, normal_depth(scene, scene.camera, size))),
          hits(triangles_below(rays, points.points)),
          truth(ray_cast_ao(rays, points.points, settings)) {}

    Picture picture(const Values& values) const { return ao_picture(picture_of(points, values)); }
    Picture difference(Values values) const {
        for (std::size_t i = 0; i < values.size(); ++i) values[i] -= truth[i];
        return difference_picture(picture_of(points, values, 0));
    }
    ImageError error(const Values& values) const {
        constexpr float kSky = std::numeric_limits<float>::infinity();
        return compare_images(picture_of(points, values, kSky), picture_of(points, truth, kSky));
    }
};

// The scene of `view` in its own light, with these values in the ambient part.
Picture lit(const Scene& scene, const View& view, const Values& values, MultiBounce bounces) {
    const Image<float> ao = picture_of(view.points, values);
    AmbientUse use;
    use.settings.multi_bounce = bounces;
    const DepthBuffer depth = normal_depth(scene, scene.camera, ao.size).depth;
    return lit_picture(shade(scene, scene.camera, depth, ao, {}, {}, nullptr, use));
}

// The Cornell box with one more box on its floor.
constexpr int kLooseBox = 1;  // its instance
Scene box_in_a_room(float height) {
    Scene scene = cornell_scene();
    scene.instances.push_back(placed(add_mesh(scene, box_mesh({1.2, 1.2, 1.2})), {-4.4f, height, 1.1f}));
    return scene;
}

// A box sunk into a floor of so many cells a side.
Scene sunk_box(int cells) {
    Scene scene = empty_scene();
    scene.instances = {placed(add_mesh(scene, grid_mesh(6, 6, cells + 1, cells + 1)), {0, 0, 0}),
                       placed(add_mesh(scene, box_mesh({1.2, 2, 1.2}, 8)), {0.1f, 0.4f, 0.1f})};
    scene.camera.eye = {-3, 4, -5};
    return scene;
}

std::vector<double> half_circle(int count) {
    std::vector<double> angles_rad;
    for (int i = 0; i < count; ++i) angles_rad.push_back(kPi * (i + 0.5) / count);
    return angles_rad;
}

std::vector<std::string> baked_row(const std::string& name, std::size_t stored, const ImageError& error) {
    return {name, std::to_string(stored), decimal_text(error.rmse, 4), decimal_text(error.bias, 4),
            decimal_text(error.max_abs, 4)};
}

// Cells stand at the margin, where notebooks look for them.
// clang-format off
void baked_ao(Notebook& book) {

// %% question [markdown]
// # Baked ambient occlusion
//
// Every method so far computes its map again in each frame, sixty times a second, and each time the room below gives the same
// answer: nothing in it moves. Rays gave the picture below, so many that one frame takes far too long. If nothing moves, why cast them
// in every frame?

// %% start
const Scene scene = box_in_a_room(0.6f);
const RayAoSettings settings{.rays = 256, .radius = 2, .seed = book.seed()};
const Size size = {std::min(book.size().width, 320), std::min(book.size().height, 180)};  // rays are slow
const View view(scene, size, settings);
book.number("rays", std::to_string(settings.rays));
book.show("truth", view.picture(view.truth), "A room with three boxes. {rays} rays a pixel, two units long: the truth of this chapter.");

// %% idea [markdown]
// ## The idea
//
// **Cast the rays once, before the first frame, keep the answers with the mesh, and let each frame look them up.**
//
// This is called *baking*. What remains in a frame is a look-up: a number at each vertex, which the rasterizer mixes over the
// triangle anyway, or one texture more. The whole question is where to keep the numbers, since a mesh has room for few, and
// between two of them the truth may do anything.

// %% fans
const RayScene corner = ray_scene(wall_corner_scene(), glm::dvec3(0));
constexpr int kFan = 32;
const std::vector<SectionPoint> outline = {{-4, 0}, {0, 0}, {0, 4}};
const RayFan middle = ray_fan(corner, {-1.5, 0}, half_circle(kFan), 2, outline, "From the middle of a triangle"),
             edge = ray_fan(corner, {-0.1, 0}, half_circle(kFan), 2, outline, "From near its vertex");
book.numbers({{"fan", kFan}, {"middle_blocked", middle.blocked}, {"edge_blocked", edge.blocked}});
book.draw("from_middle", middle.svg,
          "A floor that ends at a wall, seen from the side. The floor's triangle is three units long. Of {fan} rays from its middle, "
          "{middle_blocked} meet the wall.");
book.draw("from_vertex", edge.svg, "Of as many from near its vertex at the wall, {edge_blocked} do. The vertex is where the number will be kept.");

// %% vertices_text [markdown]
// ## At the vertices
//
// The program of Luna's tutorial (for Direct3D 12) takes each triangle, casts 32 rays from its middle, and calls the share that meets nothing the
// *accessibility* of the triangle. A vertex gets the mean of the $T$ triangles that use it:
//
// $$ A_{vertex} = \frac1T \sum_{t=1}^{T} \frac{\mathrm{open}_t}{32} $$
//
// The figures show what is wrong with that. The rays start in the middle of the triangle, but the number is used at its vertices. On a head of sixty
// thousand triangles (chapter 02) the two are close together. On a wall of two triangles they are metres apart.
//
// The cure costs nothing. The rays start where the number is used: in each triangle near each of its three corners, a thirty-second of the way
// inwards. A vertex takes the mean over the corners that meet in it, each weighed by the area of its triangle. Why not from the vertex itself? Where
// two walls meet, it lies on both. A start that is lifted off one wall then lies on the other or behind it, and rays from there miss that wall.
//
// Do not expect a better picture of this room from it. A wall has vertices in the corners of the room only, where it is dark. Luna's rule gave them
// a number that was too light for the corner, but not so wrong for the middle of the wall. Now the corners are right, and between them the rasterizer mixes dark with dark
// all over the wall. Right numbers in too few places do not help. Where triangles are as small as the shade, as on the head, starting at the corners wins.

// %% the_code tags=["setup"]
book.listing("ssao/bakes/vertex_ao.cpp", "means_of_triangles", "Luna's rule: every triangle counts the same, whatever its size. `open` holds one share of rays a triangle.");
book.listing("ssao/bakes/vertex_ao.cpp", "point_of", "The lab's: where the rays of one corner start.");

// %% vertices
RayAoSettings tutorial = kTutorialRays;
tutorial.radius = settings.radius;
const VertexAo centroids = vertex_ao_from_centroids(scene, view.rays, tutorial), corners = vertex_ao_from_corners(scene, view.rays, settings);
const Values by_centroids = looked_up(scene, view.rays, centroids, view.hits), by_corners = looked_up(scene, view.rays, corners, view.hits);
book.show_row({{"centroids", view.picture(by_centroids), "Luna's rule: a few triangles decide for whole walls."},
               {"corners", view.picture(by_corners), "From corners: each vertex is right, and all of them lie in dark corners."}});
book.show_row({{"centroids_error", view.difference(by_centroids), "Luna's rule minus truth: red is too bright, blue too dark."},
               {"corners_error", view.difference(by_corners), "From corners minus truth: dark corners run out over the walls."}});

// %% map_text [markdown]
// ## In a map
//
// A wall of two triangles has four vertices and, on this screen, thousands of pixels. Engines therefore keep the answers in a texture, a
// *lightmap*, as the Unity notes tell. It needs texture coordinates of its own, since those for bricks repeat and those
// for a lightmap must not: each place of each surface has a texel to itself. The lab cuts the surfaces into nearly flat pieces, the
// *charts*, lays them side by side into a square, and casts rays from the middle of every texel that a triangle covers.
//
// A texel covers a square of side $1/d$, where $d$ is the *density* in texels a unit. Shade that changes faster than that is lost, as
// between the vertices of a mesh; but $d$ is ours to choose.

// %% map
const int side = std::clamp(book.size().width * 2 / 5, 64, 1024);
const LightmapCharts charts = lightmap_charts(scene, view.rays, {.texels = side});
const LightmapAo map = lightmap_ao(view.rays, charts, lightmap_points(scene, view.rays, charts), settings);
const Values by_map = looked_up(charts, map.ao, view.hits);
book.numbers({{"side", side}, {"density", decimal_text(charts.density, 1)}});
book.show("lightmap", ao_picture(map.ao), "The map, {side} texels a side, {density} texels a unit: every surface once, flat, apart from the others.");
book.show_row({{"by_map", view.picture(by_map), "The room with the map."},
               {"by_map_error", view.difference(by_map), "Minus truth: what is left lies within a texel of the corners."}});

// %% edges_text [markdown]
// ## The edge of a chart
//
// **Texels that no triangle's middle covers make lines along every edge.** A look-up with linear filtering mixes four texels, and at the rim
// of a chart some of them lie outside. If they are black, each edge of the room gets a black line. Two things cure it. A texel that a triangle touches
// without covering its centre gets rays from the middle of the part that is covered. Then all empty texels beside others take their mean,
// round after round, which is called *dilation*.

// %% dilation_code tags=["setup"]
book.listing("ssao/bakes/lightmap_ao.cpp", "dilated", "Dilation. `before` is what was filled when the round began, so that the order of the texels does not matter.");

// %% edges
Image<float> bare = map.ao;
for (std::size_t i = 0; i < bare.pixels.size(); ++i) bare.pixels[i] *= map.kind.pixels[i] == TexelKind::centre ? 1.0f : 0.0f;
const Values by_bare = looked_up(charts, bare, view.hits);
book.compare({"map_without_edges", view.picture(by_bare), "Only texels whose centre is covered: lines along all edges."},
             {"map_with_edges", view.picture(by_map), "With touched texels and dilation."});

// %% how_wrong [markdown]
// ## How wrong each is
//
// The table counts what is stored, and the error over the pixels that show a surface. Noise is small in all rows but the first, so what it shows is the
// price of few places.

// %% errors
const ImageError of_centroids = view.error(by_centroids), of_corners = view.error(by_corners), of_map = view.error(by_map), of_bare = view.error(by_bare);
book.table({"baked", "values", "RMS error", "mean error", "largest"},
           {baked_row("vertices, Luna's rule", joined(centroids).size(), of_centroids), baked_row("vertices, from corners", joined(corners).size(), of_corners),
            baked_row("map", static_cast<std::size_t>(map.rays_cast / settings.rays), of_map), baked_row("map without edges", map.count(TexelKind::centre), of_bare)});
book.numbers(4, {{"map_rmse", of_map.rmse}, {"vertex_rmse", std::min(of_centroids.rmse, of_corners.rmse)},
                 {"bare_rmse", of_bare.rmse}});
book.check("The map errs by {map_rmse}, less than a third of the {vertex_rmse} of the better vertices.", 3 * of_map.rmse < std::min(of_centroids.rmse, of_corners.rmse));
book.check("Without touched texels and dilation it errs by {bare_rmse}, more than half as much again.", of_bare.rmse > 1.5 * of_map.rmse);

// %% floors_text [markdown]
// ## What can go wrong
//
// **A mesh is too coarse for its shade.** A box stands on a floor, sunk into it a little. The floor's cells decide what can be kept. With one cell the shade of the
// box does not exist, as it reaches none of the four vertices. With 64 cells there is shade, in the shape of cells. With 4096 it is round.
//
// **A vertex is buried.** The box goes on below the floor, and its lowest vertices see nothing but the dark between floor and box: 0. The rasterizer mixes them
// upwards, and darkens the box where it comes out of the floor. There truth is about one half. A map has the same trouble in the texels that lie on both sides
// of the floor.

// %% floors
std::vector<Notebook::Named> floors;
std::vector<double> floor_errors;
float darkest = 1;
for (const int cells : {1, 8, 64}) {
    const Scene floor = sunk_box(cells);
    const View seen(floor, size, settings);
    const Values baked = looked_up(floor, seen.rays, vertex_ao_from_corners(floor, seen.rays, settings), seen.hits);
    floor_errors.push_back(seen.error(baked).rmse);
    darkest = std::ranges::min(baked);
    floors.push_back({"floor_" + std::to_string(cells), seen.picture(baked), std::to_string(cells * cells) + (cells == 1 ? " cell" : " cells")});
}
book.show_row(floors, "Baked to the vertices of ever finer floors. The foot of the box is too dark in all three.");
book.numbers(4, {{"floor_1", floor_errors[0]}, {"floor_8", floor_errors[1]}});
book.number("darkest", decimal_text(static_cast<double>(darkest), 2));
book.check("One cell errs by {floor_1}, more than twice the {floor_8} of 64 cells.", floor_errors[0] > 2 * floor_errors[1]);
book.check("The darkest pixel of the finest floor is {darkest}, where the truth at the foot of the box is one half.", darkest < 0.4f);

// %% stale_text [markdown]
// **Something moves.** The small box rises by two units. Its shade stays on the floor, and the box takes with it the darkness of a place where it no longer
// is. No filter cures this; the bake is about another room. Games bake what stands still, and take one of the methods of chapters 13 to 19, with a small radius, for what moves.

// %% stale
const Scene moved_scene = [&] {
    Scene moved = scene;
    moved.instances[kLooseBox] = placed(1, {-4.4f, 2.6f, 1.1f});
    return moved;
}();
const View moved(moved_scene, size, settings);
const Values stale = looked_up(charts, map.ao, moved.hits);
book.compare({"stale", moved.picture(stale), "Baked before the box rose: its shade is still on the floor."},
             {"moved", moved.picture(moved.truth), "Truth: no shade below it."});
book.show("stale_error", moved.difference(stale), "Baked minus truth. Blue is the old shade.");
book.number("stale_rmse", moved.error(stale).rmse, 4);
book.check("Once the box has moved the error is {stale_rmse}, more than twice that of the map before.", moved.error(stale).rmse > 2 * of_map.rmse);

// %% coefficients
book.numbers({{"bounce_a", linear_text(kPaperFit.a_slope, kPaperFit.a_offset)},
              {"bounce_b", linear_text(kPaperFit.b_slope, kPaperFit.b_offset)},
              {"bounce_c", linear_text(kPaperFit.c_slope, kPaperFit.c_offset)}});

// %% bounce_text [markdown]
// **White corners are too dark.** A ray that meets something counts as dark. But what it meets is lit, too, and sends light back. The
// paper of chapter 18 has a formula for that, fitted to path-traced scenes. It takes the accessibility $A$, baked or of a frame, and the
// *albedo* $\rho$, the share of light that a surface sends back, and gives, for each colour channel,
//
// $$ A' = \min\bigl(1, \max(A,\; ((aA + b)A + c)A)\bigr), $$
//
// $$ a = {{bounce_a}}, \quad b = {{bounce_b}}, \quad c = {{bounce_c}}. $$

// %% bounce
book.compare({"bounce_none", lit(scene, view, by_map, MultiBounce::none), "The lit room, its ambient light multiplied by the baked "
              "accessibility as it is: all corners are grey."},
             {"bounce_paper", lit(scene, view, by_map, MultiBounce::paper), "With the fit (`--param multi_bounce=paper` in a frame): white "
              "corners are nearly as light as the walls, the red and the green ones keep a little of their shade."});
book.plot("bounce",
          {"Accessibility with bounced light", {"accessibility A"}, {"with bounces"},
           {bounce_curve("albedo 0.2", 0.2f, kPaperFit), bounce_curve("albedo 0.5", 0.5f, kPaperFit),
            bounce_curve("albedo 0.9", 0.9f, kPaperFit), bounce_curve("albedo 0.9, rounded", 0.9f, kRoundedFit)}},
          "The fit of the paper for three albedos, and the fit with the rounded coefficients of the Unity notes.");
const float white = multi_bounce(0.5f, 0.9f, kPaperFit), dark = multi_bounce(0.5f, 0.2f, kPaperFit);
book.numbers(2, {{"white", static_cast<double>(white)}, {"dark", static_cast<double>(dark)}});
book.check("Where half is open, a white surface of albedo 0.9 gets {white} of the ambient light, a dark one of albedo 0.2 gets {dark}.",
           white > dark && dark >= 0.5f);

// %% choosing [markdown]
// ## What is gained, and what it costs
//
// Against chapter 19's two rays a pixel a bake gains everything at once: as many rays as one likes, nothing that the screen hides, no noise, and a frame that pays for a
// texture read. It costs memory for each surface, a build of seconds to minutes, texture coordinates without overlap, and the freedom to move. Use it for buildings and ground. Whatever is
// baked should multiply ambient light only, as with the maps of a frame: light that comes from a lamp is either blocked by a thing or not, and
// a shadow map answers that.

// %% exercises [markdown]
// ## Exercises
//
// 1. In `chapters/20_baked_ao.cpp`, set `side = 64`. Where do lines appear, and how wide are they?
// 2. After `tutorial.radius` of the same file, set `tutorial.rays = 1024`, too. Does Luna's rule get better?
// 3. In its `settings`, set `.radius = 100`, so that rays end nowhere in the room. Which of the ways to store gains most?
// 4. Bake a scene of your own: `crevice bake columns --vertex` and `crevice bake columns --lightmap`. Which of its meshes would you rather bake to vertices?
// 5. Why must no two surfaces share a texel of a lightmap, although they may share one of a brick texture?
// 6. (Open) A door opens and closes. What could you store so that both are right, and half open nearly?
//
// <details><summary>Answers</summary>
//
// 1. At the feet of the blocks, as wide as a texel: shade of the floor and light of the block's side fall into one.
// 2. No. It is the mean over whole triangles that errs, and not the noise of 32 rays.
// 3. The vertices whose rays start at the corners. With a long reach shade changes slowly along a wall, and what changes slowly is well
//    mixed from a few numbers.
// 4. The head, the spheres, the columns: what has many small triangles. The ground plane has too few.
// 5. The brick is the same wherever it is; the light at it is not.
// 6. Two maps, one for each, mixed by how far the door is open. It is right at both ends.
//
// </details>

// %% errata [markdown]
// <details><summary>Errata of the tutorials</summary>
//
// - *Luna:* a vertex that no triangle uses gets 0/0. Here it is 1.
// - *Luna:* slivers count like large triangles in the mean over a vertex.
// - *Luna:* the start of a ray is lifted by 0.001 units. On a large mesh that is less than the rounding of a float, on a tiny one it leads through the next wall. Here the lift follows from the size of the coordinates.
// - *Luna:* rays have no end, which the listing itself calls a shortcut: in a closed room everything is black.
// - *Unity notes:* the coefficients of the bounces are rounded to two digits. Near $A = 1$ that darkens, as the plot shows.
// - *Unity notes:* AO on direct light is, as the text says itself, not physically right; hence the engine's default of leaving it out.
//
// </details>
//
// ## Where to go on
//
// Chapter 21 sets all methods, rays and bakes against their time.

// %% end tags=["setup"]
}

const Chapter kChapter20("20", "baked_ao", "Baked ambient occlusion", baked_ao);

}  // namespace
}  // namespace crevice
