// Question: if nothing moves, why cast rays in every frame?
//
// The one idea: cast them once and keep the answer with the mesh, at its vertices or in a map. What the store
// is too coarse for is lost, and whatever moves leaves its shade behind.
//
// Source: Luna, BuildVertexAmbientOcclusion; the Unity notes on baked AO (lightmaps).
// Look for: the shade on walls, which four vertices cannot hold; the black foot of the sunk box; the lines
//           along edges without dilation; the shade of a box that has left.
// Run: crevice chapter 20
#include <algorithm>
#include <limits>

#include "chapters/notebook/chapter.h"
#include "chapters/terminal/number_text.h"
#include "scenes/builtin_scenes.h"
#include "scenes/composing.h"
#include "scenes/shapes.h"
#include "ssao/bakes/baked_lookup.h"
#include "ssao/bakes/lightmap_ao.h"
#include "ssao/judge/metrics.h"

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

// A box sunk into floors of ever more vertices.
void coarse_and_fine_floors(Notebook& book, const RayAoSettings& settings) {
    std::vector<Notebook::Named> pictures;
    std::vector<double> errors;
    Values baked;
    for (const int cells : {1, 8, 64}) {
        Scene scene = empty_scene();
        scene.instances = {placed(add_mesh(scene, grid_mesh(6, 6, cells + 1, cells + 1)), {0, 0, 0}),
                           placed(add_mesh(scene, box_mesh({1.2, 2, 1.2}, 8)), {0.1f, 0.4f, 0.1f})};
        scene.camera.eye = {-3, 4, -5};
        const View view(scene, book.size(), settings);
        baked = looked_up(scene, view.rays, vertex_ao_from_corners(scene, view.rays, settings), view.hits);
        errors.push_back(view.error(baked).rmse);
        pictures.push_back({"floor_" + std::to_string(cells), view.picture(baked)});
    }
    book.show_row("A box sunk into floors of 1, 64 and 4096 cells, baked to vertices.", pictures);
    book.check("one cell has twice the error of 64", errors[0] > 2 * errors[1], decimal_text(errors[0], 4));
    book.check("black vertices in the box darken its foot, truly 1/2", std::ranges::min(baked) < 0.4f);
}

// Returns the map's error.
double vertices_and_map(Notebook& book, const Scene& scene, const View& view, const LightmapCharts& charts,
                        const LightmapAo& map, const RayAoSettings& settings) {
    RayAoSettings tutorial = kTutorialRays;
    tutorial.radius = settings.radius;
    const VertexAo centroids = vertex_ao_from_centroids(scene, view.rays, tutorial);
    const VertexAo corners = vertex_ao_from_corners(scene, view.rays, settings);
    Image<float> bare = map.ao;
    for (std::size_t i = 0; i < bare.pixels.size(); ++i)
        bare.pixels[i] *= map.kind.pixels[i] == TexelKind::centre ? 1.0f : 0.0f;
    std::vector<Notebook::Named> pictures;
    std::vector<std::vector<std::string>> rows;
    std::vector<double> rmse;
    const auto add = [&](const std::string& name, auto stored, const Values& values) {
        const ImageError e = view.error(values);
        pictures.insert(pictures.end(),
                        {{name, view.picture(values)}, {name + "_error", view.difference(values)}});
        rows.push_back({name, std::to_string(stored), decimal_text(e.rmse, 4), decimal_text(e.bias, 4),
                        decimal_text(e.max_abs, 4)});
        rmse.push_back(e.rmse);
    };
    add("centroids", joined(centroids).size(), looked_up(scene, view.rays, centroids, view.hits));
    add("corners", joined(corners).size(), looked_up(scene, view.rays, corners, view.hits));
    add("map", map.rays_cast / settings.rays, looked_up(charts, map.ao, view.hits));
    add("map_without_edges", map.count(TexelKind::centre), looked_up(charts, bare, view.hits));
    book.show_row("Vertices by Luna's rule and from corners; the map; each minus truth.", pictures);
    book.table({"baked", "values", "RMSE", "bias", "largest"}, rows);
    book.check("the map errs less than a third as much", 3 * rmse[2] < std::min(rmse[0], rmse[1]));
    book.check("texels at edges and dilation take the seams away", rmse[3] > 1.5 * rmse[2]);
    return rmse[2];
}

void baked_ao(Notebook& book) {
    book.text(R"(
        # 20 Baked ambient occlusion

        Rays are cast once, and a frame looks the answer up. Luna keeps it in vertices: 32 rays start from the
        middle of each triangle, and a vertex takes its triangles' mean. Engines, as the Unity notes tell, keep
        it in a lightmap: a second set of texture coordinates, rays up to a maximum distance, static objects,
        indirect light only.
    )");
    Scene scene = cornell_scene();
    scene.instances.push_back(placed(add_mesh(scene, box_mesh({1.2, 1.2, 1.2})), {-4.4f, 0.6f, 1.1f}));
    const RayAoSettings settings{.rays = 256, .radius = 2, .seed = book.seed()};
    const View view(scene, book.size(), settings);
    book.show("truth", view.picture(view.truth), "Truth, 256 rays a pixel: the Cornell box, one more box.");
    const int side = std::clamp(book.size().width * 2 / 5, 64, 1024);
    const LightmapCharts charts = lightmap_charts(scene, view.rays, {.texels = side});
    const LightmapAo map =
        lightmap_ao(view.rays, charts, lightmap_points(scene, view.rays, charts), settings);
    book.show("lightmap", ao_picture(map.ao), "The map: every surface once, flat, apart from the others.");
    const double of_map = vertices_and_map(book, scene, view, charts, map, settings);
    coarse_and_fine_floors(book, settings);

    scene.instances[1] = placed(1, {-4.4f, 2.6f, 1.1f});
    const View moved(scene, book.size(), settings);
    const Values stale = looked_up(charts, map.ao, moved.hits);
    const Picture baked = moved.picture(stale), truth = moved.picture(moved.truth);
    book.show_row("The box has risen; its shade is still on the floor. Baked, truth, baked minus truth.",
                  {{"stale", baked}, {"moved", truth}, {"stale_error", moved.difference(stale)}});
    book.check("a bake is stale once something has moved", moved.error(stale).rmse > 2 * of_map);
    book.try_it({
        "Set `side = 64`, a quarter: lines appear at the blocks' feet, as wide as a texel.",
        "Set `tutorial.rays = 1024`: no better; it is the mean over whole triangles that errs.",
        "Set `.radius = 100`: wider, smoother shade; the vertices at corners come much nearer to it.",
    });
    book.errata({
        "*Luna:* a vertex without triangles gets 0 / 0; slivers count like large triangles.",
        "*Unity notes:* AO on direct light is, as their text says, not physically right; hence their "
        "default.",
    });
}

const Chapter kChapter("20", "baked_ao", "Baked ambient occlusion", baked_ao);

}  // namespace
}  // namespace crevice
