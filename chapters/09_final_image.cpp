// Question: how does the AO map get into the picture, and what does it change there?
//
// The one idea: draw the scene a second time with all its lights, look the AO map up at each pixel, and
// multiply the ambient term by it. The first pass has left the depth of the nearest surface behind, so with
// the test EQUAL each pixel is lit exactly once, by the surface that is seen.
//
// Source: X_Jun, "Using the ambient map"; Luna, Default.hlsl; SSAO explored, "Applying SSAO".
// Look for: the feet of the columns, the house under its eaves, the eyes of the head; the joints between the
//           bricks, which the tutorials' AO does not see.
// Run: crevice chapter 09
#include <cmath>

#include "chapters/notebook/chapter.h"
#include "chapters/terminal/number_text.h"
#include "scenes/builtin_scenes.h"
#include "ssao/blur/bilateral_blur.h"
#include "ssao/light/scene_shadow.h"
#include "ssao/light/shade.h"
#include "ssao/light/sky.h"
#include "ssao/light/widened_ao.h"
#include "ssao/methods/luna_ssao.h"
#include "ssao/methods/xjun_ssao.h"

namespace crevice {
namespace {

// The share of the pixels that show a surface, and are not `left_out` of the second pass.
double covered_share(const Image3& lit, const Image<float>& view_depth, glm::vec3 left_out) {
    double surface = 0, covered = 0;
    for (int y = 0; y < view_depth.size.height; ++y) {
        for (int x = 0; x < view_depth.size.width; ++x) {
            if (std::isinf(view_depth.at(x, y))) continue;
            surface += 1;
            if (lit.at(x, y) != left_out) covered += 1;
        }
    }
    return covered / surface;
}

// The share of all pixels that b shows more than a twentieth darker than a.
double darkened_share(const Image3& a, const Image3& b) {
    double darker = 0;
    for (int y = 0; y < a.size().height; ++y) {
        for (int x = 0; x < a.size().width; ++x) {
            if (b.y.at(x, y) < 0.95f * a.y.at(x, y)) darker += 1;
        }
    }
    return darker / (a.size().width * a.size().height);
}

struct Tutorial {
    const char* scene;
    LunaSettings ao;
    AoFetch fetch;
    BlurSettings blur;
};

// Everything that one tutorial's last pass reads.
struct Drawn {
    Scene scene;
    GBuffer gbuffer;
    Image<float> ao;
    ShadowMap shadow;

    Image3 lit(const Scene& shown, bool with_shadow, bool with_ao) const {
        return shade(shown, shown.camera, gbuffer.depth, with_ao ? ao : Image<float>(), ShadeSettings{}, {},
                     with_shadow ? &shadow : nullptr);
    }
};

Drawn drawn(const Tutorial& tutorial, Size size) {
    Drawn d{find_builtin_scene(tutorial.scene)->make(SceneDetail::surfaces), {}, {}, {}};
    d.gbuffer = normal_depth(d.scene, d.scene.camera, size);
    const AoInputs inputs = ao_inputs(d.gbuffer, d.scene.camera, tutorial.fetch);
    d.ao = bilateral_blur(luna_occlusion(inputs, tutorial.ao, {}).ao, inputs, tutorial.blur).ao;
    d.shadow = scene_shadow(d.scene);
    return d;
}

Image<float> every_fourth(const Image<float>& map) {
    Image<float> small({map.size.width / 4, map.size.height / 4});
    for (int y = 0; y < small.size.height; ++y) {
        for (int x = 0; x < small.size.width; ++x) small.at(x, y) = map.at(4 * x, 4 * y);
    }
    return small;
}

// One tutorial's picture, built up piece by piece.
void pipeline(Notebook& book, const Tutorial& tutorial) {
    const Drawn d = drawn(tutorial, book.size());
    const std::string name = tutorial.scene;
    Scene textured = d.scene;
    textured.sky_cube = nullptr;
    for (Material& material : textured.materials) material.normal_map = nullptr;
    Scene bumpy = d.scene;
    bumpy.sky_cube = nullptr;
    const Image3 shadowed = d.lit(d.scene, true, false), with_ao = d.lit(d.scene, true, true);
    const Image3 finished = with_sky(with_ao, d.gbuffer.depth, d.scene.camera, *d.scene.sky_cube);
    book.show_row(name + ": textures; their normal maps; the light's shadow.",
                  {{name + "_textures", lit_picture(d.lit(textured, false, false))},
                   {name + "_normal_maps", lit_picture(d.lit(bumpy, false, false))},
                   {name + "_shadow", lit_picture(d.lit(bumpy, true, false))}});
    std::vector<Notebook::Named> last = {{name + "_with_ao", lit_picture(with_ao)},
                                         {name, lit_picture(finished)}};
    const bool mirrors = d.scene.lighting == LightingModel::blinn_schlick;  // X_Jun has none
    if (mirrors) last.insert(last.begin(), {name + "_mirrored", lit_picture(shadowed)});
    book.show_row(mirrors ? "What is mirrored; the ambient term times AO; the sky."
                          : "The ambient term times AO; the sky.",
                  last);
    book.show_row("The blurred AO map; what the light sees, white the farthest.",
                  {{name + "_ao", ao_picture(ao_at_picture_size(d.ao, book.size()))},
                   {name + "_shadow_map", ndc_depth_picture(every_fourth(ndc_depth(d.shadow.depth)))}});

    Scene marked = d.scene;
    marked.sky = glm::vec3(-1);  // no lit colour is negative
    const double covered = covered_share(d.lit(marked, true, true), d.gbuffer.view_depth, marked.sky);
    const double dark = darkened_share(d.lit(bumpy, false, false), d.lit(bumpy, true, false));
    const double ao_dark = darkened_share(shadowed, with_ao);
    book.check(name + ": EQUAL lights every pixel that shows a surface", covered == 1,
               std::to_string(100 * covered) + " %");
    book.check(name + ": the shadow darkens between 1 and 30 % of the picture", dark > 0.01 && dark < 0.3,
               std::to_string(100 * dark) + " %");
    book.check(name + ": AO is a detail, it changes 0.5 to 16 % of the picture visibly",
               ao_dark > 0.005 && ao_dark < 0.16, std::to_string(100 * ao_dark) + " %");
}

// The tutorials' AO knows the vertices' normals only; from the normal maps' it finds shade in every joint.
void mapped_normals(Notebook& book, const Tutorial& tutorial) {
    const Scene scene = find_builtin_scene(tutorial.scene)->make(SceneDetail::surfaces);
    const auto ao_with = [&](bool mapped) {
        NormalDepthSettings buffers;
        buffers.mapped_normals = mapped;
        const GBuffer g = normal_depth(scene, scene.camera, book.size(), buffers);
        return luna_occlusion(ao_inputs(g, scene.camera, tutorial.fetch), tutorial.ao, {}).ao;
    };
    const Image<float> plain = ao_with(false);
    Image<float> more = ao_with(true);
    for (std::size_t i = 0; i < more.pixels.size(); ++i) more.pixels[i] -= plain.pixels[i];
    book.show("mapped_minus_plain", difference_picture(more),
              "Raw AO from mapped normals minus that from vertex normals: blue is darker. `crevice render "
              "columns_luna --param ao_normals=mapped`");
    const BufferStatistics change = buffer_statistics(more);
    book.check("mapped normals change AO, here and there by a lot, on the whole by little",
               change.min < -0.1f && std::fabs(change.mean) < 0.05, exact_text(change.min) + " at most");
}

void final_image(Notebook& book) {
    book.text(R"(
        # 09 The final image

        For each tutorial, what its last pass puts together. The AO map is half as wide and high as the
        picture and read with a linear filter at each pixel's centre.

            colour = texture * (access * ambient + shadow * diffuse) + shadow * specular
    )");
    LunaSettings xjun = kXjunSettings, luna = kLunaSettings;
    xjun.seed = luna.seed = book.seed();
    const Tutorial xjun_tutorial{"columns_2022", xjun, xjun_fetch(xjun), kXjunBlur},
        luna_book{"columns_luna", luna, luna_fetch(luna), kLunaBlur};
    pipeline(book, xjun_tutorial);
    pipeline(book, luna_book);
    mapped_normals(book, luna_book);
    book.try_it({
        "Replace `kXjunBlur` by `{.iterations = 0}`: grain in the walls, crisp lines on the roof.",
        "Set `xjun.ao_scale = 1`: the lines between the roof tiles become even, at four times the cost.",
        "Multiply the whole colour by AO instead of the ambient term: lit corners look dirty.",
    });
    book.errata({
        "*X_Jun, vertex shader:* adds (w, w) to clip x, y before scaling by (0.5, -0.5), not (w, -w): v "
        "is too small by 1, which WRAP hides. Chapter 11 shows it, and `--param ao_lookup=slip_clamp`.",
        "*X_Jun, pixel shader:* multiplies only the ambient terms of directional lights. Those of other "
        "lights would shine into every crevice; this lab multiplies each ambient term.",
        "*Luna, repository:* AO does not scale what the mirror spheres reflect, and neither does this lab: "
        "a mirror in a niche shows a sky that it cannot see.",
    });
}

const Chapter kChapter("09", "final_image", "The final image", final_image);

}  // namespace
}  // namespace crevice
