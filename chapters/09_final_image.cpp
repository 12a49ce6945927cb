// %% setup tags=["setup"]
// Source: X_Jun, "Using the ambient map"; Luna, Default.hlsl; SSAO explored, "Applying SSAO".
// Run: crevice chapter 09
#include <cmath>

#include "chapters/diagrams/lookup_weights.h"
#include "chapters/notebook/chapter.h"
#include "chapters/props/crops.h"
#include "chapters/props/limit_scenes.h"
#include "chapters/props/number_words.h"
#include "chapters/props/switched_ao.h"
#include "chapters/props/tutorial_picture.h"
#include "chapters/terminal/number_text.h"
#include "scenes/builtin_scenes.h"
#include "ssao/judge/metrics.h"
#include "ssao/light/ao_lookup.h"
#include "ssao/light/shade.h"
#include "ssao/light/widened_ao.h"
#include "ssao/methods/luna_ssao.h"

namespace crevice {
namespace {

// Cells stand at the margin, where notebooks look for them.
// clang-format off
void final_image(Notebook& book) {

// %% question [markdown]
// # The final image
//
// Here is the scene of X_Jun's tutorial (for Direct3D 11), as its text of 2020 shows it: textured, with a strong *ambient
// light*, the constant that stands for all light which has been reflected before it arrives. In the first picture, without
// occlusion, the columns seem to float, and the house is flat under its eaves. In the second only the ambient light has
// changed.

// %% headline
const Words seed = {"seed=" + std::to_string(book.seed())};
const TutorialPicture headline(book, "columns", "xjun", seed);
const Image3 ao_off = headline.finished({}), ao_on = headline.finished(headline.ao.blurred);
book.compare({"ao_off", lit_picture(ao_off), "AO off: all ambient light arrives everywhere (`crevice render --preset xjun2020 --ao none`)."},
             {"ao_on", lit_picture(ao_on), "AO on (`--preset xjun2020`): look at the feet of the columns, below the spheres, and under the eaves.", headline.command()});

// %% idea [markdown]
// ## The idea
//
// **Draw the scene a second time, now with all its lights, look the AO map up at each pixel, and multiply the ambient light by
// what you find there.**
//
// The light of X_Jun's shader is a sum of three terms for each lamp: *ambient* $A$, *diffuse* $D$ and *specular* $S$. The texture
// multiplies the first two. Accessibility and shadow each have their own place in it:
//
// $$ colour = texture \cdot (access \cdot A + shadow \cdot D) + shadow \cdot S $$
//
// Why does AO not multiply everything? It answers how much light arrives *from all around*, the mean over a hemisphere. A lamp
// stands in one direction. Whether its light arrives is what the shadow map knows, and a corner can be in full sun.

// %% one_pixel
const SwitchedView foot = column_foot(book);
const SwitchedAo near = foot.ao(seed);
const Texel at = followed_texel(near.inputs.size());
const int x = 2 * at.x, y = 2 * at.y;
const Image<float> at_pixels = ao_at_picture_size(near.blurred, book.size());
const Image3 near_off = shade(foot.scene(), foot.camera(), near.gbuffer.depth, {});
const Image3 near_on = shade(foot.scene(), foot.camera(), near.gbuffer.depth, near.blurred);
const Image3 near_dark = shade(foot.scene(), foot.camera(), near.gbuffer.depth, Image<float>({1, 1}, 0.0f));
book.numbers({{"texel_x", at.x}, {"texel_y", at.y}, {"x", x}, {"y", y}, {"access", text(at_pixels.at(x, y))},
              {"direct", text(near_dark.at(x, y))}, {"ambient", text(near_off.at(x, y) - near_dark.at(x, y))},
              {"colour_off", text(near_off.at(x, y))}, {"colour_on", text(near_on.at(x, y))}});
book.draw("lookup", lookup_diagram(near.blurred, book.size(), x, y, "One pixel and the four texels around it"),
          "Texels are drawn black, pixels grey. The centre of pixel ({x}, {y}), green, lies a quarter of a texel from the "
          "nearest texel's centre in each direction; the blue lines carry the weights w.");

// %% from_half_size [markdown]
// ## From half size to full size
//
// The map has half the picture's width and height, so no pixel lies on the centre of a texel. A linear sampler takes the
// four texels around it, weighted by how near they are: $\frac34 \cdot \frac34$, twice $\frac34 \cdot \frac14$, and $\frac14 \cdot \frac14$.
//
// Our texel $({{texel_x}}, {{texel_y}})$ is the nearest to the pixel $({{x}}, {{y}})$, whose accessibility comes out as {access}. The
// ambient light reflected there is $({{ambient}})$ in red, green and blue, all other light $({{direct}})$. Without AO the pixel has their
// sum, $({{colour_off}})$; with it $({{colour_on}})$.

// %% sum_of_terms
const glm::vec3 expected = near_dark.at(x, y) + at_pixels.at(x, y) * (near_off.at(x, y) - near_dark.at(x, y));
const glm::vec3 error = expected - near_on.at(x, y);
book.check("Direct light plus {access} times the ambient light is the lit pixel's colour.",
           std::fabs(error.x) + std::fabs(error.y) + std::fabs(error.z) < 1e-5f);

// %% second_drawing_text [markdown]
// ## The second drawing
//
// The first pass has drawn the same triangles from the same eye, and has left the depth of the nearest surface at every
// pixel in the depth buffer. The second one uses that. Its depth state differs in three ways from the usual one.
//
// - **The test is EQUAL.** Only the surface whose depth is in the buffer passes, so each pixel is lit exactly once, however many
//   surfaces lie behind each other. The expensive shader never runs for what is hidden.
// - **No depth is written.** The value that would be written is there already.
// - **Depth is not cleared in between.** The colours are; but in a depth buffer cleared to 1 no surface would be found
//   equal, and the picture would be sky.
//
// EQUAL compares bits. Both passes must compute the depth by the same operations in the same order; chapter 10 shows what
// happens otherwise. The sky is drawn last, at depth 1 with LESS_EQUAL, where nothing else is.

// %% second_drawing
const TutorialPicture luna(book, "columns_luna", "luna", seed);
const auto second_drawing = [&](DepthFunction function, const DepthBuffer& depth) {
    return shade(luna.scene, luna.scene.camera, depth, luna.ao.blurred, ShadeSettings{function, PositionOrder::relative, {}});
};
DepthBuffer cleared = luna.ao.gbuffer.depth;
cleared.codes = Image<std::int32_t>(book.size(), depth_code(cleared.format, 1.0f, 0.0));
const Image3 always = second_drawing(DepthFunction::always, luna.ao.gbuffer.depth);
const Image3 equal = second_drawing(DepthFunction::equal, luna.ao.gbuffer.depth);
book.compare({"test_always", lit_picture(cropped(always, middle_of(book.size()))), "Luna's head without a depth test: what was drawn "
              "last wins, so parts that lie behind others cover these."},
             {"test_equal", lit_picture(cropped(equal, middle_of(book.size()))), "EQUAL: each pixel shows the surface that is seen."});
book.check("With LESS instead of EQUAL nothing is lit at all, since no surface is nearer than the nearest; with a cleared "
           "depth buffer EQUAL lights nothing either.",
           all_sky(second_drawing(DepthFunction::less, luna.ao.gbuffer.depth), luna.scene.sky) &&
               all_sky(second_drawing(DepthFunction::equal, cleared), luna.scene.sky));

// %% the_code [markdown]
// ## The code
//
// X_Jun's pixel shader samples the map and writes `ambient += ambientAccess * A` for each of its directional lights. This
// lab's function does the same for every light of the scene.

// %% kernel_light tags=["setup"]
book.listing("ssao/light/lighting.h", "phong",
             "Ambient, diffuse and specular light of all lamps. `s.ambient` is the accessibility, one for each colour.");
book.listing("ssao/light/widened_ao.h", "at", "The lookup: two rows of the map, brought to the picture's width before, are "
             "mixed by how near they are.");

// %% picture [markdown]
// ## The picture, piece by piece
//
// X_Jun's repository of 2022 has a quarter of the ambient light and more direct light.

// %% xjun_2022
const TutorialPicture xjun(book, "columns_2022", "xjun", seed);
const LightSteps s = light_steps(xjun);
book.show_row({{"columns_2022_textures", lit_picture(s.textures), "Textures, and the lamps' light."},
               {"columns_2022_normal_maps", lit_picture(s.normal_maps), "Normal maps: joints and grain."},
               {"columns_2022_shadow", lit_picture(s.shadow), "The first lamp's shadow."}});
book.show_row({{"columns_2022_ao", ao_picture(ao_at_picture_size(xjun.ao.blurred, book.size())), "The AO map at the picture's size."},
               {"columns_2022_with_ao", lit_picture(s.with_ao), "The ambient light times that map."},
               {"columns_2022", lit_picture(s.finished), "The sky, where the depth is 1.", xjun.command()}});
book.numbers({{"dark_2022", percent_text(s.in_shadow)}, {"ao_2022", percent_text(s.in_ao)}});
book.check("EQUAL has lit every pixel that shows a surface.", s.covered == 1);
book.check("The shadow darkens {dark_2022} of the picture.", s.in_shadow > 0.01 && s.in_shadow < 0.3);
book.check("AO is a detail: it darkens {ao_2022} of the picture visibly.", s.in_ao > 0.005 && s.in_ao < 0.16);

// %% luna_text [markdown]
// Luna's light has one ambient term, $access \cdot ambient \cdot albedo$, and its smooth materials mirror the sky.

// %% luna
const LightSteps t = light_steps(luna);
book.show_row({{"columns_luna_textures", lit_picture(t.textures), "Textures."},
               {"columns_luna_normal_maps", lit_picture(t.normal_maps), "Normal maps."},
               {"columns_luna_shadow", lit_picture(t.shadow), "The shadow of the first lamp."}});
book.show_row({{"columns_luna_mirrored", lit_picture(t.mirrored), "The mirrored sky, which AO does not touch."},
               {"columns_luna_with_ao", lit_picture(t.with_ao), "The ambient term times AO."},
               {"columns_luna", lit_picture(t.finished), "The sky.", luna.command()}});
book.show_row({{"columns_luna_ao", ao_picture(ao_at_picture_size(luna.ao.blurred, book.size())), "The AO map."},
               {"columns_luna_shadow_map", ndc_depth_picture(every_fourth(ndc_depth(luna.shadow.depth))),
                "The depth map that the lamp sees, from which shadows come: white is farthest."}});
book.numbers({{"dark_luna", percent_text(t.in_shadow)}, {"ao_luna", percent_text(t.in_ao)}});
book.check("Here too EQUAL lights every pixel of a surface; the shadow darkens {dark_luna}, AO {ao_luna} of the picture.",
           t.covered == 1 && t.in_shadow > 0.01 && t.in_shadow < 0.3 && t.in_ao > 0.005 && t.in_ao < 0.16);

// %% truth_text [markdown]
// ## How wrong it is
//
// Rays tell how open a point really is (chapter 02). Cast 64 from every texel, as long as the tutorials' radius, put their share
// into the same picture, and compare.

// %% truth
const GBuffer texels = normal_depth(headline.scene, headline.scene.camera, headline.ao.inputs.size());
const Image<float> by_rays = ray_picture(headline.scene, headline.scene.camera, texels, {.rays = 64, .radius = headline.ao.settings.radius});
const Image3 true_light = headline.finished(by_rays);
const Image3 wrong_by = difference_of(ao_on, true_light);
book.compare({"lit_by_rays", lit_picture(true_light), "Accessibility by rays."},
             {"lit_by_ssao", lit_picture(ao_on), "Accessibility by SSAO."});
book.show("ssao_minus_rays", difference_picture(wrong_by), "SSAO minus rays: blue is too dark, red too bright. The walls are "
          "too dark, for the exponent exaggerates; the joints of the roof are lost at half size; and the red corners below "
          "belong to columns beside the picture, which rays meet and SSAO cannot see.");
book.numbers(4, {{"rmse", compare_images(ao_on, true_light).rmse}, {"rmse_without", compare_images(ao_off, true_light).rmse}});
book.check("With SSAO the picture is off by {rmse} (RMS, of colours between 0 and 1), without any AO by {rmse_without}.",
           compare_images(ao_on, true_light).rmse < compare_images(ao_off, true_light).rmse);

// %% published_text [markdown]
// ## As published
//
// What do the pictures look like with every number kept as the tutorials keep it: random vectors that are no unit vectors,
// normals and depths in 16-bit floats, depth buffers of 24 bits, edge texels mixed? The shade gets wider and is less even; look at the roof.

// %% as_published
const TutorialPicture xjun_published(headline, words_of("xjun2020_published", seed)), luna_published(luna, words_of("luna_published", seed));
const Image3 ao_published = xjun_published.finished(xjun_published.ao.blurred);
book.compare({"xjun_published", lit_picture(ao_published), "X_Jun as published (`crevice render --preset xjun2020_published`).", xjun_published.command()},
             {"xjun_repaired", lit_picture(ao_on), "With the cures of chapters 05 to 07 (`--preset xjun2020`).", headline.command()});
book.compare({"luna_published", lit_picture(luna_published.finished(luna_published.ao.blurred)), "Luna as published "
              "(`crevice render --preset luna_published`).", luna_published.command()},
             {"luna_repaired", lit_picture(t.finished), "Luna with the same cures (`--preset luna`).", luna.command()});
book.number("published_rmse", compare_images(ao_published, true_light).rmse, 4);

// %% published_error [markdown]
// Against the picture by rays, X_Jun's as published is off by {published_rmse}, the repaired one by {rmse}. Most of either error is
// the method's own; the cures remove dots and speckles, which such a number hardly sees and the eye does.

// %% dirty_text [markdown]
// ## What can go wrong
//
// **Multiply the whole colour by AO, and sunlit corners are dirty.** The direct light loses what it never lost on its way.

// %% dirty
const Image3 unoccluded = xjun.lit(xjun.scene, true, {});
const Image3 all_dark = times(unoccluded, ao_at_picture_size(xjun.ao.blurred, book.size()));
const PixelRect dirtiest = part_around_largest(difference_of(all_dark, s.with_ao).y, {160, 90});
book.compare({"whole_colour", lit_picture(cropped(all_dark, dirtiest)), "The whole colour times AO: dark outlines in full light."},
             {"ambient_only", lit_picture(cropped(s.with_ao, dirtiest)), "Only the ambient light times AO."});
const double whole = darkened_share(unoccluded, all_dark);
book.number("whole", percent_text(whole));
book.check("So done, AO darkens {whole} of the picture visibly instead of {ao_2022}.", whole > s.in_ao);

// %% joint_text [markdown]
// **A linear filter knows no edges.** At a silhouette two of the four texels may belong to another surface, and what the blur has kept
// apart is mixed again, over one pixel. *Joint upsampling* weighs the four texels by their likeness to the pixel as well.

// %% joint
const Image<float> linear = ao_at_picture_size(headline.ao.blurred, book.size());
const Image<float> joint = looked_up(headline.ao.blurred, headline.ao.inputs, headline.ao.gbuffer, AoLookup::joint);
const PixelRect fringe = part_around_largest(difference_of(linear, joint), {64, 40});
book.compare({"lookup_linear", ao_picture(cropped(linear, fringe)), "Linear, 64 by 40 pixels: a fringe along the edge."},
             {"lookup_joint", ao_picture(cropped(joint, fringe)), "By likeness (" + headline.view.command({"ao_lookup=joint"}) + ")."});

// %% mapped_text [markdown]
// **The AO of the tutorials does not see what normal maps draw.** Its normals are those of the vertices. Given the bent normals, it finds
// shade in every joint; but the depth map knows nothing of the joints, so this shade is a guess.

// %% mapped
const Image<float> plain_normals = luna.view.ao(seed).raw, mapped_normals = mapped_ao(luna, book.size());
const Image<float> more = difference_of(mapped_normals, plain_normals);
const BufferStatistics change = buffer_statistics(more);
book.compare({"normals_plain", ao_picture(plain_normals), "Raw AO from the vertices' normals."},
             {"normals_mapped", ao_picture(mapped_normals), "From the mapped ones (`crevice render columns_luna --param ao_normals=mapped`)."});
book.show("mapped_minus_plain", difference_picture(more), "Mapped minus plain: blue is darker.");
book.number("mapped_most", text(-change.min));
book.number("mapped_mean", change.mean, 4);
book.check("Mapped normals darken single texels by up to {mapped_most} and change the mean by {mapped_mean} only.",
           change.min < -0.1f && std::fabs(change.mean) < 0.05);

// %% exercises [markdown]
// ## Exercises
//
// 1. Run `crevice render columns_2022 --param blur_iterations=0` and look at `lit.png`. Where does the grain show, and where not?
// 2. Run `crevice render columns_2022 --ao-scale 1`. What becomes of the lines between the tiles of the roof, and what does it
//    cost (`passes.json`)?
// 3. Why is the AO map not needed where no ambient light is?
// 4. In the second drawing, would LESS_EQUAL do as well as EQUAL?
// 5. AO does not scale what the mirrors of Luna's scene reflect. What would a mirror in a niche have to know?
//
// <details><summary>Answers</summary>
//
// 1. On walls in the shadow, which only ambient light reaches. In full sun the direct light is most of the colour.
// 2. They become even, since no texel lies across them any more, at four times the cost of the AO pass.
// 3. It multiplies the ambient term only: where that is 0, so is the product.
// 4. Yes, if both passes compute the same depths. Nothing is nearer than the nearest, so LESS_EQUAL passes what EQUAL passes.
//    Where they do not, it hides half of the damage: chapter 10.
// 5. In which directions it is open, not only how much: chapters 18 and 19 compute a mean open direction, the bent normal.
//
// </details>

// %% errata [markdown]
// <details><summary>Errata of the tutorials</summary>
//
// - *X_Jun, vertex shader:* adds $(w, w)$ to clip $x, y$ before scaling by $(0.5, -0.5)$, where $(w, -w)$ is meant. $v$ is too
//   small by 1, which a sampler that wraps hides. Chapter 11 shows it, and so does `--param ao_lookup=slip_clamp`.
// - *X_Jun, pixel shader:* multiplies only the ambient terms of the directional lights. Those of other lights would shine into every
//   crevice; this lab multiplies each ambient term.
// - *Luna, repository:* AO does not scale what the mirror spheres reflect, and neither does this lab: a mirror in a niche shows a
//   sky that it cannot see.
//
// </details>
//
// ## Where to go on
//
// You have now seen every pass: normals and depth, raw AO, blur, and the lit picture. Chapter 10 breaks EQUAL; chapter 11
// shows what no AO in screen space can know. Part II, from chapter 13 on, has other methods for the same map.

// %% end tags=["setup"]
}

const Chapter kChapter09("09", "final_image", "The final image", final_image);

}  // namespace
}  // namespace crevice
