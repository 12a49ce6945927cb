// %% setup tags=["setup"]
// Source: X_Jun, "Reconstructing the position"; Luna, Ssao.hlsl, NdcDepthToViewDepth; SSAO explored, SSAOVS.
// Run: crevice chapter 04
#include <algorithm>
#include <cmath>

#include "chapters/diagrams/eye_ray.h"
#include "chapters/notebook/chapter.h"
#include "chapters/props/depth_error_plot.h"
#include "chapters/props/number_words.h"
#include "chapters/props/position_ways.h"
#include "chapters/props/sky_in_half.h"
#include "chapters/props/stored_depth.h"
#include "chapters/props/switched_ao.h"
#include "chapters/props/wrong_positions.h"
#include "chapters/terminal/number_text.h"
#include "ssao/methods/luna_ssao.h"
#include "ssao/methods/xjun_ssao.h"

namespace crevice {
namespace {

// Cells stand at the margin, where notebooks look for them.
// clang-format off
void position_from_depth(Notebook& book) {
// %% question [markdown]
// # Position from depth
//
// The picture below cuts the world into cubes of one unit, dark and light in turn, and paints every pixel with the cube
// that its surface lies in. Where the positions are right, the edges of the cubes are straight and run along the floor
// and the walls. Here they are bent: somebody has rebuilt the positions wrongly, and every later pass would measure its
// distances in this crooked space.

// %% start
const SwitchedView view(book, "columns");
const SwitchedAo shown = view.ao();
book.show("cubes_bent", unit_cubes(shown.gbuffer, view.camera(), by_unit_ray),
          "Unit cubes at wrongly rebuilt positions. The farther from the middle of the picture, the more they bend.");

// %% idea [markdown]
// ## The idea
//
// The first pass has kept one number a pixel, the view depth $p_z$. We want the whole point $p$ back. It would be easy
// to store x and y as well, but there is no need:
//
// **A pixel fixes a ray from the eye, and the depth says how far along that ray the surface lies.**

// %% one_texel
const SwitchedView foot = column_foot(book);
const SwitchedAo near_by = foot.ao();
const AoInputs& inputs = near_by.inputs;
const Texel at = followed_texel(inputs.size());
const float u = (static_cast<float>(at.x) + 0.5f) / static_cast<float>(inputs.size().width);
const float v = (static_cast<float>(at.y) + 0.5f) / static_cast<float>(inputs.size().height);
const float p_z = inputs.view_depth.at(at.x, at.y),
            far = static_cast<float>(foot.camera().far_plane);
const Vec3<float> far_point = interpolated(inputs.rays, u, v, far),
                  p = (p_z / far_point.z) * far_point;
book.numbers({{"x", at.x}, {"y", at.y}});
book.number("fov_y", 57.29577951308232 * foot.camera().fov_y_rad, 0);
book.draw("eye_ray", eye_ray(inputs, at.x, at.y, p),
          "A vertical cut through the depth buffer at texel ({x}, {y}), which chapter 03 began to follow. The ray that leaves "
          "the eye through the texel meets the ground at p; e is another point of it, here the one on the near plane. The "
          "dashed lines are the upper and the lower rim of the view; what is hatched, the depth buffer does not know.");

// %% derivation [markdown]
// ## Along the ray
//
// In view space the eye is the origin, so the points of a ray through it are the multiples of any one of them:
// $p = t\, e$. Read this for z alone, $p_z = t\, e_z$; now $t$ is known, and
//
// $$ p = \frac{p_z}{e_z}\, e $$
//
// Any point $e$ of the ray will do, because $t$ shrinks as $e$ grows. Of the two tutorials that we follow, X_Jun's
// (for Direct3D 11) takes the one on the far plane, Luna's (for Direct3D 12) the one on the near plane; both call it
// $v$, a letter that we need for the texture coordinate.
//
// ## Which ray
//
// The view is a pyramid with the angle $\text{fov}_y$ from its lower to its upper side, {fov_y} degrees in all scenes of
// this part, and the aspect ratio $a$, width over height. The far plane, at the depth $z_f$, cuts it in a rectangle. Half of its height is the side across from half the
// angle, so
//
// $$ y_f = z_f \tan\frac{\text{fov}_y}{2}, \qquad x_f = a\, y_f, \qquad\text{corners}\quad (\pm x_f, \pm y_f, z_f) $$
//
// These are *half* sizes: the rectangle reaches from $-x_f$ to $x_f$. The tutorials draw it as two triangles that cover
// the screen, give each vertex its corner, and let the rasterizer interpolate. What a texel $(i, j)$ of a map of $w$ by
// $h$ texels gets belongs to its centre:
//
// $$ u = \frac{i + 1/2}{w}, \quad v = \frac{j + 1/2}{h}, \qquad e = \big((2u - 1)\, x_f,\; (1 - 2v)\, y_f,\; z_f\big) $$
//
// It is $1 - 2v$, not $2v - 1$, because rows count downwards and y goes up. The corners may be
// interpolated because they lie in one plane: whatever lies between them has the same depth $z_f$, so it is the point of
// that plane which the texel shows.

// %% numbers_of_one_texel
const double tangent = static_cast<double>(inputs.rays.ray_scale.y);
book.numbers({{"map", size_text(inputs.size())}, {"u", decimal_text(static_cast<double>(u), 4)},
              {"v", decimal_text(static_cast<double>(v), 4)}, {"far", exact_text(far)}, {"far_point", text(far_point)},
              {"p_z", text(p_z)}, {"p", text(p)}});
book.numbers(2, {{"half_height", static_cast<double>(far) * tangent},
                 {"half_width", static_cast<double>(far * inputs.rays.ray_scale.x)}});
const Vec3<float> off = p - inputs.rays.p_view(u, v, p_z);
book.check("Texel ({x}, {y}) of the {map} map has the centre u = {u}, v = {v}. The far plane, {far} away, reaches "
           "{half_width} to each side and {half_height} up and down, so the ray ends at ({far_point}). With the depth {p_z} "
           "of the texel, p = ({p}): the position that the kernel uses.",
           dot(off, off) < 1e-10f);

// %% half_size [markdown]
// The centre of a texel of the half-size map is the corner where four pixels of the picture meet. Its depth must belong
// to the same place as its ray, and no pixel has a depth there. Chapter 07 makes it of the four pixels in six steps. A
// first program may take an AO map as large as the picture (`--ao-scale 1`): then a texel is a pixel, and has its normal
// and its depth.
//
// ## From the depth buffer
//
// Luna keeps no view depth. It reads NDC depth $d$ from the depth buffer and turns it back first, as chapter 03 has
// derived: $p_z = B / (d - A)$. How does an error of $d$ come out? The slope of $B/(d - A)$ is
// $-B / (d - A)^2 = -z^2 / B$, and $B$ is negative, so
//
// $$ \Delta z \approx \frac{z^2}{|B|}\, \Delta d $$
//
// Twice as far away, the same step of the depth buffer is four times as long.

// %% code_text [markdown]
// ## The code
//
// The lab does not interpolate corners. Its *kernel*, the code that runs for every texel, computes the same ray from $u$
// and $v$, with z = 1: `ray_scale` is $(a \tan(\text{fov}_y/2), \tan(\text{fov}_y/2))$, the half size of the plane one
// unit away. In HLSL, Direct3D's shader language, the pixel shader has one line, `p = (pz / ray.z) * ray`, and the vertex shader hands out the corners. `F` is a `float`, or several side by side.

// %% kernels tags=["setup"]
book.listing("rasterizer/spaces.h", "p_view",
             "A position from u, v and a view depth, as every method of this book calls it.");
book.listing("chapters/props/position_ways.h", "by_far_plane", "X_Jun's way, for comparison.");
book.listing("chapters/props/position_ways.h", "interpolated",
             "What a rasterizer makes of the corners: `on_plane` is the corner (x, y) of the rectangle at that depth.");

// %% picture
const AoInputs whole = ao_inputs(shown.gbuffer, view.camera(), xjun_fetch(kXjunSettings));
book.show("cubes", unit_cubes(shown.gbuffer, view.camera(), by_far_plane),
          "Unit cubes at the right positions: straight edges, along the floor and the walls.");

// %% how_wrong [markdown]
// ## How wrong
//
// Six ways to a position, all of which somebody has written down, measured over every texel that shows a surface:

// %% table_of_ways
std::vector<std::vector<std::string>> rows;
std::vector<double> worst;
for (const Way& way : kWays) {
    const PositionError error = position_error(whole, way.position);
    rows.push_back({way.words, significant_text(error.mean, 2), significant_text(error.most, 2)});
    worst.push_back(error.most);
}
book.table({"p by", "off by, scene units, mean", "at most"}, rows);
book.numbers({{"exact", significant_text(std::max(worst[0], worst[1]), 2)},
              {"least", significant_text(*std::min_element(worst.begin() + 2, worst.end()), 2)}});
book.check("Rays to the far and to the near plane give p to within {exact} units, the last bits of a float.",
           std::max(worst[0], worst[1]) < 1e-4);
book.check("Each of the others is off by {least} units or more somewhere. Chapter 05 looks for occluders within half a unit.",
           *std::min_element(worst.begin() + 2, worst.end()) > 0.5);

// %% traps [markdown]
// ## What can go wrong
//
// **A ray of length 1.** Normalising $e$ and multiplying it with the view depth takes z for the distance to the
// eye. Only in the middle of the picture are they the same; towards the rim every point comes too near.

// %% unit_ray
const WrongWay unit_ray =
    wrong_way(view, shown, kWays[2], "The ray normalised, the depth taken for a distance: the rows of the floor are bent.",
              "With the ray to the far plane: the rows run straight across.");
book.compare(unit_ray.wrong, unit_ray.right);

// %% corners_text [markdown]
// **Corner rays of length 1.** Dividing by $e_z$ afterwards mends the length of a ray, so one would think that the
// corners may be normalised. But a normalised corner no longer lies in the plane, and what the rasterizer interpolates
// between corners of unequal depth points elsewhere. On a quad nobody notices: its four corner rays are equally long, so
// all are shortened alike. A single large triangle over the whole screen has corners outside of the picture, with rays
// of different lengths, and bends everything.

// %% unit_corners
const WrongWay corners =
    wrong_way(view, shown, kWays[3], "Rays of a single triangle, normalised at its corners: the cubes lean, and are cut at a slant.",
              "With the ray to the far plane: floor, columns and house are cut straight.");
book.compare(corners.wrong, corners.right);

// %% full_text [markdown]
// **The full size for the half.** SSAO explored, a blog article on the same method, takes screen coordinates from -1 to
// 1 and multiplies them with the width and the height of the far plane. Half of both is meant. Everything comes out
// twice as far from the axis.

// %% full_size
const WrongWay full =
    wrong_way(view, shown, kWays[4], "The whole width and height: on the screen every cube is half as wide and half as high.",
              "Half of the width and height, to the same far plane: cubes of one unit.");
book.compare(full.wrong, full.right);

// %% ao_of_ways
std::vector<Notebook::Named> occlusion;
const char* const kCaptions[] = {"The right positions: shade at the feet, under the eaves, round the door.", nullptr,
                                 "Rays of length 1: shade is lost, the more the nearer to the rim.",
                                 "Normalised corners: the open floor and a whole column shade themselves.",
                                 "Full size: a band across the open roof and the front of the house are black, and the feet of the columns are white."};
for (const std::size_t i : {0u, 2u, 3u, 4u})
    occlusion.push_back({std::string("ao_") + kWays[i].name,
                         ao_picture(ao_at(whole, kWays[i].position)), kCaptions[i]});
book.show_row(occlusion);
const Vec3<float> misprint = as_misprinted(inputs.rays, 0.3f, 0.8f, 7);
book.check("Luna's formula as it is printed, `(p.z / v / z) v` (the point e is called v there), is (1, 1, 1) for every pixel.",
           std::fabs(misprint.x - 1) + std::fabs(misprint.y - 1) + std::fabs(misprint.z - 1) < 1e-5f);

// %% formats_text [markdown]
// ## What a stored depth is worth
//
// All right rays give the same $p$. What can still differ is $p_z$, the number that was kept. X_Jun stores view depth in
// a 16-bit float, whose steps grow with z; Luna reads a depth buffer, whose steps grow with $z^2$.

// %% formats
std::vector<StoredDepthError> errors;
std::vector<std::vector<std::string>> stored_rows;
for (const DepthStorage& storage : kDepthStorages) {
    errors.push_back(stored_depth_error(view.scene(), book.size(), storage));
    const StoredDepthError& e = errors.back();
    stored_rows.push_back({storage.name, significant_text(e.most, 2),
                           significant_text(e.most_of_z, 2), significant_text(e.most_of_z2, 2)});
}
book.show_row(
    {{"stored_half", difference_picture(errors[0].off, 0.01f),
      "View depth in 16-bit floats: always too near (blue), in stripes of one step each."},
     {"stored_d16", difference_picture(errors[1].off, 0.01f),
      "NDC depth in 16 bits: too near or too far (red), the more the farther."}},
    "The rebuilt minus the true view depth, from -0.01 to 0.01 units. With 24 bits the picture would be white.");
book.table({"stored", "off by at most, units", "over z", "over z²"}, stored_rows,
           "D24 and the 32-bit float D32F come out alike: from twice the near plane on $d$ is above 1/2, and there the steps "
           "of a float are $2^{-24}$, exactly those of D24.");
book.numbers({{"half_share", significant_text(1024 * errors[0].most_of_z, 4)},
              {"d16_share", significant_text(1.001 * 131072 * errors[1].most_of_z2, 4)}});
book.check("A 16-bit float of z is off by less than z / 1024: the largest error is {half_share} of that.",
           errors[0].most_of_z < 1.0 / 1024);
book.check("A 16-bit NDC depth is off by about half a step, $z^2 / |B| / 2^{17}$: the largest error is {d16_share} of that.",
           errors[1].most_of_z2 < 1.05 / (1.001 * 131072));
book.check("In this scene the 16-bit float of z is the coarser of the two, and 24 bits are at least fifty times better than "
           "both.",
           errors[1].most < errors[0].most && 50 * errors[2].most < errors[1].most);

// %% bounds_text [markdown]
// How large may the error get in other scenes? The next table takes eight pairs of near and far planes and the largest
// *relative* error of a view depth between them. One column has a cure. *Reversed* depth puts the near plane at 1 and
// the far plane at 0. Then $d$ falls like $1/z$, and two effects meet: an error of $d$ counts $z^2$ times as much far
// away, but a float that holds a small $d$ has fine steps, in proportion to $d$ itself. Together they make the relative
// error of $z$ the same everywhere.

// %% bounds
const DepthErrorTable table = depth_error_table();
book.table(table.header, table.rows,
           "Largest relative error of a view depth. Where it is above 1, the depth is lost. The last column computes B / (d - "
           "A) in floats, as a shader does, the others without rounding; where it is infinite, d comes to A itself, and the "
           "division is by 0.");
book.numbers({{"of_bound", percent_text(table.most_of_bound)}, {"reversed", significant_text(table.worst_reversed, 2)}});
book.check("No error exceeds the bound that follows from the formula above, and the largest comes to {of_bound} of it.",
           table.most_of_bound <= 1);
book.check("Reversed floats are off by no more than {reversed} of z, whatever the planes.",
           table.worst_reversed < 2e-7);
book.plot("depth_error", depth_error_plot(),
          "The relative error over z with planes at 1 and 1000. Dots are measured, lines are bounds. Bits that run out grow "
          "with z; reversed floats stay level.");

// %% walls_text [markdown]
// **A step of the depth buffer looks like an occluder.** When two neighbours on a slanted wall fall on two steps, and
// the steps are farther apart than *epsilon*, the smallest depth difference that counts (chapter 06), the wall shades
// itself in stripes.

// %% walls
std::vector<std::vector<std::string>> wall_rows;
std::vector<WallAo> walls;
for (const int kind : {0, 1, 3}) {
    walls.push_back(wall_ao(kDepthKinds[kind]));
    wall_rows.push_back({kDepthKinds[kind].name});
    for (const double mean : walls.back().means)
        wall_rows.back().push_back(significant_text(mean, 3));
}
book.compare(
    {"walls_d24", ao_picture(walls[1].ao),
     "Occlusion of five bare walls side by side, 25, 45, 65, 85 and 105 away, from a 24-bit depth buffer: "
     "none but a few specks where one wall ends in front of the next."},
    {"walls_d16", ao_picture(walls[0].ao), "From a 16-bit one: the three farthest walls, on the right, are striped."});
book.table({"mean AO of the wall at z =", "25", "45", "65", "85", "105"}, wall_rows);
const Scene wall_scene = bare_walls();
const double epsilon = static_cast<double>(kLunaSettings.epsilon);
// The formula above with a whole step for the error of d: of 16 bits, of 24.
const double epsilon_b = epsilon * -static_cast<double>(camera_matrices(wall_scene.camera, book.size()).depth_b);
const double from_d16 = std::sqrt(epsilon_b * 65535), from_d24 = std::sqrt(epsilon_b * 16777215);
const auto as_searched = [&](DepthFormat format, double z) {
    return std::fabs(depth_of_step(wall_scene.camera, format, epsilon) / z - 1) < 1e-3;
};
book.numbers(0, {{"from_d16", from_d16}, {"from_d24", from_d24}});
book.number("epsilon", epsilon, 2);
book.check("Between planes at 1 and 1000, a step is longer than an epsilon of {epsilon} from z = {from_d16} on with 16 bits, "
           "from z = {from_d24} on with 24.",
           as_searched(DepthFormat::d16, from_d16) && as_searched(DepthFormat::d24, from_d24));
book.check("With 16 bits the walls at 25 and 45 are open, those at 65, 85 and 105 striped.",
           std::min(walls[0].means[0], walls[0].means[1]) > 0.99 &&
               std::max({walls[0].means[2], walls[0].means[3], walls[0].means[4]}) < 0.97);
book.check("With 24 bits or reversed floats all are open.",
           std::min(*std::min_element(walls[1].means.begin(), walls[1].means.end()),
                    *std::min_element(walls[2].means.begin(), walls[2].means.end())) > 0.999);

// %% half_text [markdown]
// **The sky in a 16-bit float.** X_Jun's depth for the sky, 100,000, is more than such a float can hold: the largest is
// 65,504. What becomes of it depends on the rounding. Direct3D rounds toward zero, so the largest number is kept. Most
// C++ libraries round to nearest, which is infinity. Now the occlusion pass reads this map with a *linear filter*, a
// weighted mean of four neighbouring pixels. A weight of 0 times infinity, or infinity minus itself, is *NaN*, not a
// number, and spreads to whatever touches it. HLSL's `max(x, 0)` would turn a NaN to 0; C++'s `std::max(x, 0)`, with
// which these pictures are made, keeps it. This lab's kernel asks `x > 0`, which is false for a NaN; chapter 07 shows
// what infinity costs then.

// %% half_floats
const SkyInHalf cut = sky_in_half(view, book.size(), BufferFormat::float16_toward_zero);
const SkyInHalf nearest = sky_in_half(view, book.size(), BufferFormat::float16_nearest_even);
book.compare({"sky_nearest", ao_picture(nearest.ao),
              "Rounded to nearest: the sky, all outlines against it and the rim of the picture are "
              "NaN (magenta)."},
             {"sky_toward_zero", ao_picture(cut.ao),
              "Rounded toward zero, as Direct3D does: white sky, and the shade of the house up to its outline. (Paler "
              "than elsewhere: both are without the power to which chapter 07 raises accessibility for contrast.)"});
book.table({"rounding", "1e5 becomes", "minus itself", "10 + 0 (it - 10)", "NaN, % of texels",
            "after the blur"},
           {sky_row("toward zero", cut), sky_row("to nearest", nearest)},
           "The blur carries a NaN to all texels around it.");
book.numbers({{"nan_cut", significant_text(cut.nan, 2)}, {"nan_nearest", significant_text(nearest.nan, 3)}});
book.check("Toward zero {nan_cut} % of the texels are NaN, and only where a sample comes back to the point itself, the 0/0 of "
           "chapter 06; to nearest it is {nan_nearest} %.",
           cut.nan < 0.1 && nearest.nan > 5);

// %% exercises [markdown]
// ## Exercises
//
// 1. The view angle is 60 degrees, the picture 16 by 9, the far plane at 1000. Where are its corners?
// 2. Run `crevice render columns --only ao_blurred --out a`, then the same with `--param buffer_format=float16 --out b`
//    and with `--param depth_format=d16 --out c`. Now `crevice compare a/ao_blurred.npy b/ao_blurred.npy`, and likewise
//    for c. Which of the two formats does X_Jun's AO depend on? Why does the other one change it at all?
// 3. In `chapters/props/position_ways.h`, `by_unit_corners`, take the corners of `interpolated` instead of the large
//    triangle's. Why is nothing wrong any more?
// 4. Set `scene.camera.near_plane = 4` in `bare_walls()` of `chapters/props/stored_depth.cpp`. From which depth on does
//    D16 show stripes now?
// 5. In the cell `half_floats` call `sky_in_half` with `BufferFormat::float32`, too. How much of the sky is NaN?
// 6. (Open) An orthographic camera has no pyramid. What is $p$ there, and which of the traps above are left?
//
// <details><summary>Answers</summary>
//
// 1. At $(\pm 1026.4, \pm 577.4, 1000)$.
// 2. On the 16-bit float, which holds its view depth. The depth buffer only decides which surface is nearest; where two
//    lie closer together than a step of D16, another one may win.
// 3. All four have the same length, so normalising shrinks them alike, and the division by $e_z$ cancels it.
// 4. From about 115, behind the last wall. $|B|$ is about $z_n$, so a step of given length moves out with $\sqrt{z_n}$:
//    twice 57.
// 5. None of it: 100,000 fits.
// 6. All rays are parallel to the z axis: $p = ((2u - 1)\, x_f, (1 - 2v)\, y_f, p_z)$ with half the width $x_f$ and half
//    the height $y_f$ of the box that the camera sees. So nothing can be wrong with the length of a ray, and NDC depth is
//    linear in z, so its steps do not grow. The whole size for the half is as wrong as before.
//
// </details>

// %% errata [markdown]
// <details><summary>Errata of the tutorials</summary>
//
// - *Luna, prose:* `p=(p.z/v/z)v` is printed where `p = (p.z / v.z) v` is meant. The check above computes it as
//   printed.
// - *SSAO explored:* multiplies x and y in -1 to 1 by the size of the far plane. Half of it is meant; the pair of
//   pictures above shows the cubes that come of it.
// - *X_Jun, prose:* calls what it keeps in alpha a depth in screen space. It is the z of view space, and no distance:
//   the bent rows above are what a distance makes of it.
// - *X_Jun and SSAO explored:* border and clear depth are 1e5, which 16 bits cannot hold. Only Direct3D's rounding
//   saves them.
//
// </details>
//
// ## Where to go on
//
// We have a point and its normal at every texel. Chapter 05 finds fourteen places around it to ask about. Chapter 22
// asks what positions are worth in extreme scenes, kilometres away from the eye or a hair's breadth.

// %% end tags=["setup"]
}

const Chapter kChapter04("04", "position_from_depth", "Position from depth", position_from_depth);

}  // namespace
}  // namespace crevice
