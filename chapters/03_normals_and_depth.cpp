// %% setup tags=["setup"]
// Source: X_Jun, "Rendering normals and depths", "Transforming normals"; Luna and SSAO explored on the same pass.
// Run: crevice chapter 03
#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "chapters/diagrams/stretched_slope.h"
#include "chapters/notebook/chapter.h"
#include "chapters/props/buffer_count.h"
#include "chapters/props/depth_steps.h"
#include "chapters/props/frame_passes.h"
#include "chapters/props/number_words.h"
#include "chapters/props/switched_ao.h"
#include "chapters/props/wrong_normals.h"
#include "chapters/terminal/number_text.h"

namespace crevice {
namespace {

// Cells stand at the margin, where notebooks look for them.
// clang-format off
void normals_and_depth(Notebook& book) {
// %% question [markdown]
// # Normals and depth
//
// Below is what a renderer leaves behind: a colour for every pixel. Take a pixel of the floor and ask what stands near
// it. The colours cannot tell. A dark pixel beside a light one may be a shadow, another material, or a column a hand's
// breadth away. The shader that made the colour knew more, where its surface lies and how it is turned, but nobody kept
// that. Ambient occlusion is a question about neighbours, so somebody must.

// %% colours
const SwitchedView view(book, "columns");
const SwitchedAo shown = view.ao();
const Image<float> open_everywhere;  // an empty map
book.show("colours",
          lit_picture(shade(view.scene(), view.camera(), shown.gbuffer.depth, open_everywhere)),
          "The colours of the scene, lit without ambient occlusion. How far is it from the house to the columns?");

// %% idea [markdown]
// ## The idea
//
// **Draw the scene once before any light falls on it, and keep two things of the nearest surface at every pixel: its
// normal, which says where it faces, and its depth, which says how far away it is.**
//
// Of the scene, the passes that compute occlusion read these two images and nothing else. They never see a triangle,
// only the screen: that is why the whole method is called *screen-space* ambient occlusion. Here is the program that
// chapters 03 to 09 build. It is that of two tutorials, which this book calls by their authors' names: X_Jun's for
// Direct3D 11 and Luna's for Direct3D 12 (the preface lists all sources). A *pass* turns images into an image, all
// pixels by the same rule.

// %% graph
const std::vector<GraphPass> passes = frame_passes(shown.inputs);
book.draw("passes", pass_graph("The passes of a frame and the images between them", passes),
          "Four passes, from top to bottom; a grey line goes from an image to a pass that reads it. Pass 2 first finds a "
          "normal and a depth for each texel of the AO maps (AO: ambient occlusion), which have half the picture's width and "
          "height, then the raw AO. Pass 3 blurs along rows from one map into another and along columns back again, several "
          "times over.");
book.table(
    {"image", "X_Jun", "Luna", "this book"},
    {{"normal, view space", "R16G16B16A16_FLOAT", "R16G16B16A16_FLOAT", "three 32-bit floats"},
     {"depth that occlusion reads", "view depth, in alpha of the normals", "the depth buffer, D24",
      "a 32-bit float"},
     {"depth buffer", "D24_UNORM_S8_UINT", "D24_UNORM_S8_UINT", "D32_FLOAT"},
     {"AO maps, raw and blurred", "R16_FLOAT, half size", "R16_UNORM, half size",
      "a 32-bit float, half size"},
     {"normal and depth that the blur reads", "pass 1's", "pass 1's", "those of the texels"},
     {"random vectors", "R8G8B8A8_UNORM, 256 x 256", "the same", "the same values"}},
    "The book computes with floats, so that no error of a format hides in its pictures; chapter 04 shows what the tutorials' "
    "formats do.");

// %% first_pass [markdown]
// The AO maps are half as wide and half as high because occlusion changes slowly along a surface, and a quarter of the
// work is a quarter of the time. A pixel of such a map is called a *texel* here, to tell it from the picture's pixels. Up
// to chapter 08 the book shows AO maps as they are, at half size, unless a caption says otherwise. Chapter 07 shows what half
// size loses, chapter 09 how a map gets back to the picture's size.
//
// ## What the first pass writes
//
// Both values are in *view space*, the space of the camera: x to the right, y up, z into the picture, the eye at the
// origin. *View depth* is the z of a point there. It is not its distance from the eye: all points of a plane that faces
// the camera have the same view depth. The pass draws as any rasterizer does. It leaves out back faces, those whose corners
// run counterclockwise on the screen. The nearest surface wins (depth test LESS: of two at the same depth, the first drawn
// stays). Vertex normals are interpolated with regard to perspective.

// %% buffers
book.show({"normal", normal_picture(shown.gbuffer.normal),
          "Normals as colours: red where they point to the right, green where they point up, blue where they point away from "
          "you. The floor is green, what faces you lacks blue, and the "
          "sky, which has no normal, is black.", view.render_command({}, "normal")});
book.show({"view_depth", view_depth_picture(shown.gbuffer.view_depth),
          "View depth: white at the nearest point, darker evenly with z down to a dark grey at the end "
          "of the floor. The sky, where nothing is seen, is black.", view.render_command({}, "view_depth")});

// %% two_depths [markdown]
// ## Two depths
//
// While triangles are drawn, the depth buffer keeps another number, the *NDC depth* $d$ (of *normalized device
// coordinates*, what is left after the division by $w$). The projection sets $w = z$ and makes the third coordinate
// $A z + B$; dividing gives
//
// $$ d = \frac{A z + B}{z} = A + \frac{B}{z} $$
//
// The near plane, at the depth $z_n$, must come to $d = 0$ and the far plane, at $z_f$, to $d = 1$. From
// $A z_n + B = 0$ follows $B = -A z_n$; put into $A z_f + B = z_f$, that is
//
// $$ A = \frac{z_f}{z_f - z_n}, \qquad B = -\frac{z_n z_f}{z_f - z_n}, \qquad\text{and back again}\quad z = \frac{B}{d - A} $$

// %% ndc
const CameraMatrices m = camera_matrices(view.camera(), book.size());
const Image<float> ndc = ndc_depth(shown.gbuffer.depth);
const double half_z = static_cast<double>(m.depth_b) / (0.5 - static_cast<double>(m.depth_a));
book.numbers(0, {{"near", view.camera().near_plane}, {"far", view.camera().far_plane}});
book.numbers({{"depth_a", exact_text(m.depth_a)}, {"depth_b", exact_text(m.depth_b)}});
book.numbers(3, {{"half_z", half_z}, {"nearest_d", buffer_statistics(ndc).min}});
book.plot("ndc_curve",
          {"NDC depth over view depth",
           {"view depth z, scene units"},
           {"NDC depth d", false, 0, 1},
           {ndc_curve(m)},
           {{half_z, "half of the range"}}},
          "With the planes of this scene at $z_n = {{near}}$ and $z_f = {{far}}$, $A$ is {depth_a} and $B$ {depth_b}. Half of "
          "the range is spent below z = {half_z}.");
book.show({"ndc_depth", ndc_depth_picture(ndc),
    "NDC depth, stretched: white is {nearest_d}, the nearest surface of the picture, and black is 1. It falls off faster than "
    "view depth: the last columns are much closer to the sky's black than in the "
    "picture of view depth.", view.render_command({}, "ndc_depth")});
book.table(
    {"z", "d", "one step of D24 is, in units of z"}, d24_rows(m),
    "A 24-bit depth buffer has $2^{24}$ steps from 0 to 1. Far away one of them spans a lot of scene.");

// %% one_pixel_text [markdown]
// ## One pixel
//
// Chapters 03 to 09 follow one texel of the AO map through all passes. It lies on the ground at the foot of a column,
// seen from nearby, and covers four pixels. These are its numbers after the first pass:

// %% one_pixel
const SwitchedView foot = column_foot(book);
const SwitchedAo near_by = foot.ao();
const Texel at = followed_texel(near_by.raw.size);
const CameraMatrices foot_m = camera_matrices(foot.camera(), book.size());
const Image<float> foot_ndc = ndc_depth(near_by.gbuffer.depth);
std::vector<std::vector<std::string>> pixel_rows;
for (int i = 0; i < 4; ++i) {
    const int x = 2 * at.x + i % 2, y = 2 * at.y + i / 2;
    pixel_rows.push_back(
        {std::to_string(x) + ", " + std::to_string(y), text(near_by.gbuffer.normal.at(x, y)),
         text(near_by.gbuffer.view_depth.at(x, y)), exact_text(foot_ndc.at(x, y))});
}
book.show_row(
    {{"foot_normal", normal_picture(near_by.gbuffer.normal),
      "Normals at the foot of a column: green on the level ground, from teal on the left of the stone to red on its right.",
      foot.render_command({}, "normal")},
     {"foot_depth", view_depth_picture(near_by.gbuffer.view_depth),
      "View depth of the same pixels: the column is nearly white, for it stands close to the eye.",
      foot.probe_command({}, at)}});
book.numbers({{"x", at.x}, {"y", at.y}});
book.table({"pixel", "normal n", "view depth z", "NDC depth d"}, pixel_rows,
           "The four pixels of texel ({x}, {y}). The ground is level, so all have the same normal, which points up and, "
           "because the camera looks down, a little towards the eye.");

// %% one_pixel_back
const float d = foot_ndc.at(2 * at.x, 2 * at.y),
            z = near_by.gbuffer.view_depth.at(2 * at.x, 2 * at.y);
const float z_back = foot_m.depth_b / (d - foot_m.depth_a);
book.numbers({{"d", exact_text(d)}, {"z", text(z)}, {"z_back", text(z_back)}});
book.check("Put the first of them to the test: $B / (d - A)$ of $d = {{d}}$ is {z_back}, and the view depth that the pass "
           "wrote is {z}.",
           std::fabs(z_back / z - 1) < 1e-4f);

// %% background_text [markdown]
// ## Where there is nothing
//
// A pixel of the sky has neither normal nor depth. The tutorials clear it to something that looks like a surface, X_Jun
// to the normal $(0, 0, -1)$ and the depth 100,000. This book writes what is true, so that a pass can ask "is there a
// surface?" instead of guessing from a large number. One image is an exception: the depth map is *filtered* in chapter
// 06, and a mean with infinity would be infinite, or not a number at all. Here is what every image says where there is
// nothing; the chapters to come refer to this table.

// %% nothing
book.number("sky", static_cast<double>(kBackgroundOverFar) * view.camera().far_plane, 0);
book.table({"image", "where it shows the sky", "asked beyond its rim", "chapter"},
           {{"normal of a pixel", "0, 0, 0", "never", "03"},
            {"view depth of a pixel", "infinite", "never", "03"},
            {"depth buffer", "1", "never", "03"},
            {"depth map that samples read", "{sky}", "{sky}", "06"},
            {"normal, view depth of a texel", "0, 0, 0; infinite", "the tap does not count", "07, 08"},
            {"AO maps", "1", "the outermost texel again", "07, 09"}},
           "Nothing, image by image. {sky} is a hundred times the far plane. A texel of which only some pixels show the sky "
           "has a surface: chapter 07 says which.");

// %% promises
const BufferCount count = count_pixels(shown.gbuffer, ndc, m);
book.numbers({{"surface", count.surface}, {"facing", count.facing}, {"background", count.background},
              {"length_error", significant_text(static_cast<double>(count.length_error), 2)},
              {"depth_error", significant_text(static_cast<double>(count.depth_error), 2)}});
book.check("Each of the {surface} normals has the length 1, within {length_error}.",
           count.length_error < 1e-6f);
book.check("{facing} of them face the eye: $n \\cdot p < 0$. The others lie on round outlines, where a mean of vertex normals "
           "may turn away although its triangle does not.",
           count.facing > 0.99 * count.surface);
book.check("View depth and $B / (d - A)$ are the same to {depth_error} of their value.",
           count.depth_error < 1e-4f);
book.check("All {background} pixels of the sky hold the normal 0, an infinite view depth and the NDC depth 1.",
           count.dirty == 0);

// %% matrix_text [markdown]
// ## The matrix for normals
//
// Positions come to the world by the object's matrix $W$ and to view space by the camera's $V$: $p$ becomes $V W p$.
// (Vectors are columns here, as in the sources of this book; the tutorials write them as rows, $p\, W V$, so each of
// their matrices is the transpose of ours.) Normals do not follow the same way. A direction $s$ *in* the surface becomes
// $W s$, because it joins two points of it. The normal is whatever stays perpendicular to all of these. We look for a
// matrix $N$ with
//
// $$ 0 = (N n) \cdot (W s) = n^\top N^\top W\, s \qquad\text{whenever}\quad n \cdot s = 0 $$
//
// $N^\top W = I$, the identity matrix, does it, so $N = (W^{-1})^\top$, the *inverse transpose* of the upper left 3 x 3 part of $W$. For a
// rotation it is the rotation itself. For a stretch it is the opposite stretch: a roof that is pulled wide gets
// flatter, and its normal steeper. The camera's $V$ only turns and moves, so its 3 x 3 part can follow as it is, and
// the normal in view space is $V (W^{-1})^\top n$.

// %% slope
book.draw("slope", stretched_slope(2),
          "A slope is stretched to twice its width (dashed before, full after). Stretched along with it, its normal leans "
          "over and is no longer perpendicular (red); the inverse transpose leaves it so (green).");

// %% the_code [markdown]
// ## The code
//
// The *lab*, the program that comes with this book and makes its pictures, computes the same matrix without a division:
// the cross products of the columns of $V W$ are the rows of its inverse but for a factor, the determinant, and the
// length of a normal does not matter before it is normalised. In HLSL, Direct3D's shader language, with rows for vectors, a program hands `M = (W^-1)^T V` to the vertex shader, which computes
// `mul(n, (float3x3) M)`.

// %% kernels tags=["setup"]
book.listing("rasterizer/scene/normal_matrix.cpp", "normal_matrix",
             "A matrix with a negative determinant mirrors; the sign keeps normals outside.");
book.listing_part("rasterizer/draw/surfaces.cpp", "find_group", "const TrianglePixels<F> pixels",
                  "const Vec3<F> n = normalize_or",
                  "Per pixel: the vertex normals are interpolated over the triangle, then normalised. The mean of two unit "
                  "vectors at an angle is shorter than they are, so this second normalisation is needed.");

// %% translation_text [markdown]
// ## What can go wrong
//
// **The translation left in.** Graphics libraries hold $W$ and $V$ as 4 x 4 matrices, $W$ with the object's position
// $t_W$ in it. Inverting and transposing all of it moves $t_W$ to the bottom row, and the product with $V$, whose own
// translation is $t_V$, mixes it into the 3 x 3 part. For an object and a camera that are only moved, not turned, one can
// see it happen (the 4 x 4 matrices are written in blocks, $I$ is the 3 x 3 identity):
//
// $$ V\, (W^{-1})^\top = \begin{pmatrix} I & t_V \\ 0 & 1 \end{pmatrix} \begin{pmatrix} I & 0 \\ -t_W^\top & 1 \end{pmatrix} = \begin{pmatrix} I - t_V\, t_W^\top & t_V \\ -t_W^\top & 1 \end{pmatrix} $$
//
// The upper left part turns $n$ into $n - (n \cdot t_W)\, t_V$. X_Jun therefore erases the translation of $W$ first.

// %% translation
const ComparedNormals moved =
    compare_normals(view.scene(), NormalMatrix::with_translation, book.size());
const Words left_in = {"normal_matrix=with_translation"};
book.compare({"translation_wrong", normal_picture(moved.wrong),
              "Left in (" + view.command(left_in) + "): only what faces the camera squarely, such as the "
              "front of the house, keeps its normal; floor and roof have turned to face away."},
             {"translation_right", normal_picture(moved.right),
              "Erased: every normal is right; floor and roof face upwards, green."});
book.compare({"translation_ao_wrong", ao_picture(moved.ao_wrong),
              "*Accessibility* from the wrong normals: white where a point is open, black where its surroundings are hidden. "
              "The shade at the columns' feet and under the balls is gone; the outer sides of the front "
              "columns have got dark lines."},
             {"translation_ao_right", ao_picture(moved.ao_right),
              "From the right normals: shade round the feet and below the balls."});
book.numbers({{"moved_share", percent_text(moved.off.share)}, {"moved_lost", percent_text(moved.shade_lost)},
              {"moved_invented", percent_text(moved.shade_invented)}});
book.number("moved_deg", moved.off.most_deg, 0);
book.check("With the translation left in, {moved_share} of the normals are off by more than a degree, one by {moved_deg} "
           "degrees.",
           moved.off.share > 0.5 && moved.off.most_deg > 120);
book.check("More shade is lost than invented: as a mean over the whole AO map, it gets lighter by {moved_lost} of its range "
           "and darker by {moved_invented}.",
           moved.shade_lost > 2 * moved.shade_invented);

// %% world_text [markdown]
// **W itself for the normals.** That is right as long as an object is only turned, or scaled alike in all directions.
// Luna does so although its box is stretched by (2, 1, 2), and sees nothing wrong, because the box's faces lie along
// the axes of the stretch: their normals get longer, not crooked. A box that was turned before it is stretched shows
// the mistake, and so does a ball.

// %% world
Scene boxes = stretched_scene();
const ComparedNormals round = compare_normals(boxes, NormalMatrix::world, book.size());
boxes.instances.resize(2);  // the floor and Luna's box
const ComparedNormals aligned = compare_normals(boxes, NormalMatrix::world, book.size());
book.compare({"stretch_wrong", normal_picture(round.wrong),
              "By W: Luna's box at the left is right, the turned box and the ball are not."},
             {"stretch_right", normal_picture(round.right),
              "By the inverse transpose: the upper sides of the turned box and of the ball face more upwards "
              "(greener). Luna's box is the same."});
book.compare({"stretch_ao_wrong", ao_picture(round.ao_wrong),
              "Occlusion from W's normals: grey grain on the top of the turned box and of the ball, which "
              "take their own surface for something in the way."},
             {"stretch_ao_right", ao_picture(round.ao_right),
              "By the inverse transpose: only the contacts with the floor are dark."});
book.numbers({{"box_deg", significant_text(aligned.off.most_deg, 2)}, {"round_lost", percent_text(round.shade_lost)},
              {"round_invented", percent_text(round.shade_invented)}});
book.number("round_deg", round.off.most_deg, 0);
book.check("W turns the normals of Luna's box by {box_deg} degrees at most, those of the others by up to {round_deg}.",
           aligned.off.most_deg < 0.01 && round.off.most_deg > 30 && round.off.share > 0.03);
book.check("This time more shade is invented than lost: {round_invented} against {round_lost}.",
           round.shade_invented > round.shade_lost);
book.table(
    {"matrix", "largest angle off, degrees", "pixels off by over 1 degree", "shade lost",
     "shade invented"},
    {normals_row("translation left in, columns", moved), normals_row("W itself, boxes and ball", round)},
    "Both mistakes, counted over the pixels of the pictures above. Shade lost and invented: by how much the AO map gets "
    "lighter and darker, as a mean over all of it.");

// %% float4_text [markdown]
// **A zero in the wrong place.** SSAO explored, a blog article on the same pass, multiplies the row `float4(n, 0)` by
// all of `M` and argues that the 0 keeps translations out. It does keep out the last row of `M`. But the translations
// have come into the upper left 3 x 3 part before that, when the two matrices were multiplied.

// %% float4
std::vector<std::vector<std::string>> products;
std::vector<double> most;
for (const bool erased : {false, true}) {
    for (const NormalProduct product : {NormalProduct::float3x3, NormalProduct::float4}) {
        most.push_back(tutorial_error_deg(view.scene(), view.camera(), product, erased));
        products.push_back(
            {product == NormalProduct::float4 ? "float4(n, 0) times M" : "n times (float3x3) M",
             erased ? "erased" : "left in", significant_text(most.back(), 3)});
    }
}
book.number("vertex_deg", significant_text(most[1], 3));
book.table({"normal by", "translation of W", "largest angle off, degrees"}, products,
           "M is the tutorials' $(W^{-1})^\\top V$. This table goes over the normals of all vertices, seen or not: the worst "
           "is off by {vertex_deg} degrees, the worst pixel of the picture by {moved_deg}.");
book.check("`float4(n, 0)` does as the 3 x 3 part does: both are right only where the translation of W was erased.",
           most[0] == most[1] && most[2] == most[3] && most[1] > 120 && most[3] < 0.1);

// %% exercises [markdown]
// ## Exercises
//
// 1. Run `crevice render columns --near 0.1 --only ndc_depth` and read the smallest value that it prints. What has
//    happened to the range, and to the steps of D24?
// 2. In `chapters/props/wrong_normals.cpp`, `stretched_scene`, stretch the ball by (2, 2, 2). What does W do to it now?
// 3. Run `crevice render columns --eye 0,0,0 --target 0,0,1 --param normal_matrix=with_translation`. Every normal is
//    right. Why?
// 4. Find A and B for *reversed* depth, where the near plane is at 1 and the far plane at 0.
// 5. (Open) A unit normal has two degrees of freedom. Find a way to keep it in two 8-bit numbers, and measure its
//    largest angular error over the sphere.
//
// <details><summary>Answers</summary>
//
// 1. Everything lies beyond 0.98: nine tenths of the range are spent on the first unit. $B$ is ten times smaller, so
//    each step is ten times coarser.
// 2. Nothing. Under a uniform scale the inverse transpose is the same matrix but for a factor.
// 3. The translation of $V$ is $t_V = 0$ for an eye at the origin, and $n - (n \cdot t_W)\, t_V = n$.
// 4. $A z_n + B = z_n$ and $A z_f + B = 0$ give $A = -z_n / (z_f - z_n)$ and $B = z_n z_f / (z_f - z_n)$. Chapter 04
//    shows what it is good for.
// 5. Octahedral maps are a good start: project the sphere to an octahedron and unfold that to a square.
//
// </details>

// %% errata [markdown]
// <details><summary>Errata of the tutorials</summary>
//
// - *SSAO explored:* `float4(n, 0)` makes the translation harmless. The last table shows that it does not.
// - *Luna, comment in the shader:* W will do for normals under nonuniform scaling. *Uniform* is meant; the aligned box
//   of the demo hides the slip, the boxes and the ball above show it.
// - *X_Jun, prose:* alpha holds the depth in screen space. The shader writes the z of view space.
//
// </details>
//
// ## Where to go on
//
// A pixel now knows how far its surface is. Chapter 04 turns that one number back into a point in space. Chapter 10
// shows why pass 4 can use the depth buffer of pass 1, and what must be equal for that.

// %% end tags=["setup"]
}

const Chapter kChapter03("03", "normals_and_depth", "Normals and depth", normals_and_depth);

}  // namespace
}  // namespace crevice
