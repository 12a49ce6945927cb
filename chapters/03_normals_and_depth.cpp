// Question: what does the first pass leave behind for AO, and what can go wrong with it?
//
// The one idea: for each pixel, the normal and the depth of the nearest surface are enough to rebuild the
// visible side of the scene. Both are in view space: x right, y up, z into the picture.
//
// Source: X_Jun, "Rendering normals and depths", "Transforming normals"; Luna and SSAO explored on
//         the same pass.
// Look for: how little of the range of ndc depth the scene uses; a floor that faces away from you because a
//           translation has crept into its direction; a slanted box shaded as if it stood straight.
// Run: crevice chapter 03
#include <algorithm>
#include <cmath>

#include "chapters/notebook/chapter.h"
#include "chapters/notebook/plot_picture.h"
#include "chapters/props/wrong_normals.h"
#include "chapters/terminal/number_text.h"
#include "scenes/builtin_scenes.h"

namespace crevice {
namespace {

// Ndc depth over view depth.
Picture ndc_curve(const CameraMatrices& m) {
    PlotSeries curve{{}, {}, PlotMark::line, kPlotBlue};
    for (double z = 1; z <= 20; z += 0.125)
        curve.x.push_back(z), curve.y.push_back(double(m.depth_a) + double(m.depth_b) / z);
    return plot_picture({400, 160}, {0, 20, 0, 1}, {&curve, 1});
}

// What the comments in normal_depth.h promise, pixel by pixel.
void buffers_hold(Notebook& book, const GBuffer& gbuffer, const Image<float>& ndc, const CameraMatrices& m) {
    const ViewRays rays{m.ray_scale, ndc.size, true};
    float length_error = 0, depth_error = 0;
    int surface = 0, facing = 0, dirty = 0;
    for (int i = 0; i < ndc.size.width * ndc.size.height; ++i) {
        const int x = i % ndc.size.width, y = i / ndc.size.width;
        const float z = gbuffer.view_depth.at(x, y), d = ndc.at(x, y);
        const glm::vec3 n = gbuffer.normal.at(x, y);
        if (std::isinf(z)) {
            dirty += d == 1 && n == glm::vec3(0) ? 0 : 1;
            continue;
        }
        const float u = (static_cast<float>(x) + 0.5f) / static_cast<float>(ndc.size.width);
        const float v = (static_cast<float>(y) + 0.5f) / static_cast<float>(ndc.size.height);
        ++surface;
        facing += dot(rays.p_view(u, v, z), spread<float>(n)) < 0 ? 1 : 0;
        length_error = std::max(length_error, std::fabs(glm::length(n) - 1));
        depth_error = std::max(depth_error, std::fabs(m.depth_b / (d - m.depth_a) / z - 1));
    }
    book.check("normals are unit", length_error < 1e-6f, exact_text(length_error));
    book.check("nearly all face the eye, n . p < 0", facing > 0.99 * surface,
               std::to_string(facing) + " of " + std::to_string(surface));
    book.check("view depth = B / (ndc depth - A), relatively", depth_error < 1e-4f, exact_text(depth_error));
    book.check("background: normal 0, view depth infinite, ndc depth 1", dirty == 0);
}

// The right matrix beside the wrong one: normals, AO, numbers.
ComparedNormals side_by_side(Notebook& book, const std::string& name, const Scene& scene, NormalMatrix matrix,
                             const char* caption) {
    const ComparedNormals both = compare_normals(scene, matrix, book.size());
    book.show_row(caption, {{name + "_right", normal_picture(both.right)},
                            {name + "_wrong", normal_picture(both.wrong)}});
    book.show_row("X_Jun's AO from the normals above.", {{name + "_ao_right", ao_picture(both.ao_right)},
                                                         {name + "_ao_wrong", ao_picture(both.ao_wrong)}});
    book.table({name, "largest angle off, degrees", "pixels off by over 1 degree", "shade lost", "invented"},
               {{"wrong", significant_text(both.off.most_deg, 3), percent_text(both.off.share),
                 percent_text(both.shade_lost), percent_text(both.shade_invented)}});
    return both;
}

void wrong_matrices(Notebook& book, const Scene& columns) {
    book.text(R"(
        Normals stay perpendicular under the inverse transpose of W, then turn with the view V. X_Jun
        warns: W's translation must be erased first, or the 4x4 product mixes V's into the 3x3 part. Where W
        only moves by t, and V by v, the normal becomes `n - (n . t) v`.

            crevice render columns --param normal_matrix=with_translation
    )");
    const ComparedNormals moved =
        side_by_side(book, "translation", columns, NormalMatrix::with_translation,
                     "Translation erased; left in: only the house's front is right.");
    book.check("left in, most normals are off, some point the other way",
               moved.off.share > 0.5 && moved.off.most_deg > 120);
    book.check("the shade at the columns' feet is lost", moved.shade_lost > 2 * moved.shade_invented);
    book.text(R"(
        Luna uses W itself, and its box, stretched by (2, 1, 2), looks right: its faces lie along the axes
        of the stretch. What is turned before it is stretched, or round, does not:

            crevice render field --param normal_matrix=world
    )");
    Scene boxes = stretched_scene();
    const ComparedNormals shown =
        side_by_side(book, "stretch", boxes, NormalMatrix::world,
                     "By the inverse transpose; by W: Luna's box, one turned before, a ball.");
    boxes.instances.resize(2);
    const ComparedNormals hidden = compare_normals(boxes, NormalMatrix::world, book.size());
    book.check("W is right for Luna's box, not for the others",
               hidden.off.most_deg < 0.01 && shown.off.most_deg > 30 && shown.off.share > 0.03);
    book.check("their tops take themselves for something in the way",
               shown.shade_invented > shown.shade_lost);
}

// SSAO explored multiplies float4(n, 0), so that no translation should matter.
void float4_claim(Notebook& book, const Scene& scene) {
    std::vector<std::vector<std::string>> rows;
    std::vector<double> most;
    for (const bool erased : {false, true}) {
        for (const NormalProduct product : {NormalProduct::float3x3, NormalProduct::float4}) {
            const double off_deg = tutorial_error_deg(scene, scene.camera, product, erased);
            most.push_back(off_deg);
            rows.push_back({product == NormalProduct::float4 ? "float4(n, 0) M" : "n (float3x3) M",
                            erased ? "erased" : "left in", significant_text(off_deg, 3)});
        }
    }
    book.table({"M = (W^-1)^T V, normal by", "W's translation", "largest angle off, degrees"}, rows);
    book.check("float4(n, 0) keeps nothing out: it does as the 3x3 part does, right only where W's is erased",
               most[0] == most[1] && most[2] == most[3] && most[1] > 120 && most[3] < 0.1);
}

void normals_and_depth(Notebook& book) {
    const Scene scene = find_builtin_scene("columns")->make();
    const Camera camera = scene.camera;
    const GBuffer gbuffer = normal_depth(scene, camera, book.size());
    const Image<float> ndc = ndc_depth(gbuffer.depth);
    const CameraMatrices m = camera_matrices(camera, book.size());
    book.text(R"(
        # 03 Normals and depth

        Drawn before any light: for each pixel, the nearest surface's normal and depth. Interpolated normals
        are too short; they are normalised again.
    )");
    book.show("normal", normal_picture(gbuffer.normal), "Normals: red right, green up, blue away from you.");
    book.show("view_depth", view_depth_picture(gbuffer.view_depth), "View depth, linear in distance.");
    book.show("ndc_depth", ndc_depth_picture(ndc), "Ndc depth z / w, as the depth buffer keeps it.");
    book.text("It is `A + B / z`, `A = " + exact_text(m.depth_a) + ", B = " + exact_text(m.depth_b) + "`:");
    book.show("ndc_curve", ndc_curve(m), "Ndc depth over z from 0 to 20: half of it is spent below z = 2.");
    std::vector<std::vector<std::string>> rows;
    for (const float z : {1.0f, 2.0f, 10.0f, 100.0f, 1000.0f}) {
        const float d24_step = z * z / -m.depth_b / 16777216;
        rows.push_back({exact_text(z), exact_text(m.depth_a + m.depth_b / z), exact_text(d24_step)});
    }
    book.table({"z", "ndc depth", "one step of D24 is, in units of z"}, rows);
    buffers_hold(book, gbuffer, ndc, m);
    wrong_matrices(book, scene);
    float4_claim(book, scene);
    book.try_it({
        "Set `near_plane` to 0.1: everything moves beyond ndc depth 0.98, steps get ten times coarser.",
        "Make the ball's stretch (2, 2, 2): W is right again, as under any uniform scale.",
        "Give `wrong_matrices` a scene whose `camera.eye` is 0: V moves nothing, and the leak is gone.",
    });
    book.errata({
        "*SSAO explored:* float4(n, 0) times all of (W^-1)^T V. The 0 skips the product's last row, but V's "
        "translation is in its first three by then: last table.",
        "*Luna, shader comment:* takes nonuniform scaling as the case where W will do. Uniform is meant; "
        "its box hides the slip: `stretch`.",
        "*X_Jun, prose:* alpha is the depth in screen space. The shader writes view-space z.",
    });
}

const Chapter kChapter("03", "normals_and_depth", "Normals and depth", normals_and_depth);

}  // namespace
}  // namespace crevice
