// Question: how does the AO map get into the picture, and what does it change there?
//
// The one idea: draw the scene a second time with all its lights, look the AO map up at each pixel, and
// multiply the ambient term by it. The first pass has left the depth of the nearest surface behind, so with
// the test EQUAL each pixel is lit exactly once, by the surface that is seen.
//
// Source: seed 000, "Using the ambient map"; seed 002, Default.hlsl; seed 003, "Applying SSAO".
// Look for: the feet of the columns, the house under its eaves, the eyes of the head; and the last picture,
//           where one wrong sign turns all of it off.
// Run: crevice chapter 09
#include <cmath>

#include "chapters/chapter.h"
#include "scenes/builtin_scenes.h"
#include "ssao/bilateral_blur.h"
#include "ssao/luna_ssao.h"
#include "ssao/shade.h"
#include "ssao/widened_ao.h"
#include "ssao/xjun_ssao.h"

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
    LunaSettings ao;
    AoFetch fetch;
    BlurSettings blur;
};

// One tutorial's pipeline, pass by pass.
void pipeline(Notebook& book, const Scene& scene, const Tutorial& tutorial) {
    const std::string name = scene.name;
    const GBuffer gbuffer = normal_depth(scene, scene.camera, book.size());
    const AoInputs inputs = ao_inputs(gbuffer, scene.camera, tutorial.fetch);
    const Image<float> ao_raw = luna_occlusion(inputs, tutorial.ao, {});
    const Image<float> ao = bilateral_blur(ao_raw, inputs, tutorial.blur);
    const Image3 without_ao = shade(scene, scene.camera, gbuffer.depth, {});
    const Image3 with_ao = shade(scene, scene.camera, gbuffer.depth, ao);

    book.show(name + "_without_ao", lit_picture(without_ao), name + ", all ambient light everywhere.");
    book.show(name + "_ao", ao_picture(ao_at_picture_size(ao, book.size())), "The blurred AO map.");
    book.show(name + "_with_ao", lit_picture(with_ao), "The ambient term times AO: things touch each other.");

    Scene marked = scene;
    marked.sky = glm::vec3(-1);  // no lit colour is negative
    const Image3 second_pass = shade(marked, scene.camera, gbuffer.depth, ao);
    const double covered = covered_share(second_pass, gbuffer.view_depth, marked.sky);
    const double darker = darkened_share(without_ao, with_ao);
    book.check(name + ": EQUAL lights every pixel that shows a surface", covered == 1,
               std::to_string(100 * covered) + " %");
    book.check(name + ": AO is a detail, it changes 1 to 16 % of the picture visibly",
               darker > 0.01 && darker < 0.16, std::to_string(100 * darker) + " %");
}

// Seed 000 looks the map up at v = (y + w) * -0.5 / w instead of (y - w) * -0.5 / w.
void wrong_sign(Notebook& book, const Scene& scene) {
    std::vector<std::vector<std::string>> rows;
    for (const float y_ndc : {1.0f, 0.5f, 0.0f, -0.5f, -1.0f}) {
        const float right = 0.5f - 0.5f * y_ndc, published = -0.5f - 0.5f * y_ndc;
        const float wrapped = published + 1;
        rows.push_back({exact_text(y_ndc), exact_text(right), exact_text(published), exact_text(wrapped)});
    }
    book.table({"y in NDC", "v, right", "v as published", "after WRAP"}, rows);
    book.text(R"(
        The tutorial's sampler wraps, so a v too small by exactly 1 finds the right row all the same. With a
        clamping sampler, as seed 002 has, every pixel would read the top row:
    )");
    const GBuffer gbuffer = normal_depth(scene, scene.camera, book.size());
    Image<float> top_row = ao_at_picture_size(xjun_ssao(gbuffer, scene.camera), book.size());
    for (int y = 1; y < top_row.size.height; ++y) {
        for (int x = 0; x < top_row.size.width; ++x) top_row.at(x, y) = top_row.at(x, 0);
    }
    const Image3 lit = shade(scene, scene.camera, gbuffer.depth, top_row);
    book.show("clamped", lit_picture(lit), "The top row is sky, all 1: AO is off, and nothing says why.");
    const double darker = darkened_share(shade(scene, scene.camera, gbuffer.depth, {}), lit);
    book.check("with CLAMP the published coordinate switches AO off", darker == 0);
}

void final_image(Notebook& book) {
    book.text(R"(
        # 09 The final image

        For each tutorial: the scene without AO, the map, the scene with it. The map is half as wide and high
        as the picture and read with a linear filter at each pixel's centre.

            colour = texture * (access * ambient + diffuse) + specular
    )");
    const Scene columns = find_builtin_scene("columns")->make();
    LunaSettings xjun = kXjunSettings, luna = kLunaSettings;
    xjun.seed = luna.seed = book.seed();
    pipeline(book, columns, {xjun, xjun_fetch(xjun), kXjunBlur});
    pipeline(book, find_builtin_scene("columns_luna")->make(), {luna, luna_fetch(luna), kLunaBlur});
    wrong_sign(book, columns);
    book.try_it({
        "Replace `kXjunBlur` by `{.iterations = 0}`: grain in the walls, crisp lines on the roof.",
        "Set `xjun.ao_scale = 1`: the lines between the roof tiles become even, at four times the cost.",
        "Multiply the whole colour by AO instead of the ambient term: lit corners look dirty.",
    });
    book.errata({
        "*Seed 000, vertex shader:* adds (w, w) to clip x, y before scaling by (0.5, -0.5), not (w, -w).",
        "*Seed 000, pixel shader:* multiplies only the ambient terms of directional lights. Those of other "
        "lights would shine into every crevice; this lab multiplies each ambient term.",
        "*Seed 002's repository:* what the mirror spheres reflect is not scaled by AO. (Here they are black: "
        "there is no environment map yet.)",
    });
}

const Chapter kChapter("09", "final_image", "The final image", final_image);

}  // namespace
}  // namespace crevice
