// Question: how much of the sky does a point see, and how is that kept with a mesh?
//
// The one idea: of N random rays into the hemisphere over p, h meet something; accessibility is 1 - h / N.
//
// Source: X_Jun, "ray casting"; Luna, BuildVertexAmbientOcclusion.
// Look for: sockets and teeth that are dark though no light shines; the slope of -1/2; dots on the curves.
// Run: crevice chapter 02
#include <cmath>

#include "chapters/notebook/chapter.h"
#include "chapters/notebook/plot_picture.h"
#include "chapters/props/closed_form_plot.h"
#include "chapters/terminal/number_text.h"
#include "chapters/terminal/stopwatch.h"
#include "scenes/builtin_scenes.h"
#include "scenes/carved_head.h"
#include "scenes/composing.h"
#include "scenes/shapes.h"
#include "ssao/bakes/vertex_ao_picture.h"
#include "ssao/judge/metrics.h"
#include "ssao/rays/octree.h"

namespace crevice {
namespace {

constexpr float kUnbounded = kTutorialRays.radius;

Scene head_on_a_floor() {
    Scene scene = empty_scene();
    scene.instances = {placed(add_mesh(scene, carved_head_mesh()), {0, 0, 0}),
                       placed(add_mesh(scene, grid_mesh(24, 24, 49, 49)), {0, 0, 0})};
    scene.camera.eye = {-6, 6, -13}, scene.camera.target = {0, 3.2, 0};
    return scene;
}

void ask_the_octree(Notebook& book, const RayScene& rays, const std::vector<SurfacePoint>& points) {
    const Octree octree = build_octree(rays.triangles);
    std::vector<Ray> cast;
    double boxes = 0, triangles = 0;  // tested
    for (std::uint32_t i = 0; i < points.size(); i += 16) {
        for (const Ray& ray : hemisphere_rays(points[i], i, kTutorialRays)) {
            const OctreeWalk way = walk(octree, ray, kUnbounded);
            boxes += way.boxes, triangles += way.triangles;
            cast.push_back(ray);
        }
    }
    const bool same =
        occluded(octree, cast, kUnbounded).occluded == occluded(rays, cast, kUnbounded).occluded;
    const double count = double(cast.size());
    book.check("the tutorial's octree gives every ray the BVH's answer", same,
               "each is tested against " + significant_text(boxes / count, 3) + " boxes and " +
                   significant_text(triangles / count, 3) + " of " + std::to_string(points.size()) +
                   " triangles");
}

// The RMS error of points over their rays.
PlotSeries errors(const RayScene& rays, const std::vector<SurfacePoint>& points, RayAoSettings settings,
                  const std::vector<float>& truth, glm::vec3 colour) {
    PlotSeries curve{{}, {}, PlotMark::line, colour};
    for (settings.rays = 1; settings.rays <= 256; settings.rays *= 2) {
        const std::vector<float> open = ray_cast_ao(rays, points, settings);
        double squares = 0;
        for (std::size_t i = 0; i < open.size(); ++i)
            squares += double(open[i] - truth[i]) * double(open[i] - truth[i]);
        curve.x.push_back(settings.rays);
        curve.y.push_back(std::sqrt(squares / double(open.size())));
    }
    return curve;
}

void count_the_rays(Notebook& book, const RayScene& rays, const std::vector<SurfacePoint>& all) {
    std::vector<SurfacePoint> points;
    for (std::size_t i = 0; i < all.size(); i += 64) points.push_back(all[i]);
    RayAoSettings random = kTutorialRays, sobol = kTutorialRays, many = kTutorialRays;
    sobol.sequence = many.sequence = RaySequence::sobol;
    random.seed = sobol.seed = book.seed();
    many.seed = book.seed() + 1, many.rays = 4096;
    const std::vector<float> truth = ray_cast_ao(rays, points, many);
    const PlotSeries curves[] = {errors(rays, points, random, truth, kPlotOrange),
                                 errors(rays, points, sobol, truth, kPlotBlue)};
    book.show("error", plot_picture({420, 240}, {1, 256, 0.004, 0.5, true}, curves),
              "RMS error of a triangle over its rays: random ones (orange) and Sobol's (blue).");
    double slope[2];  // on these axes
    for (int i = 0; i < 2; ++i) slope[i] = std::log2(curves[i].y.back() / curves[i].y.front()) / 8;
    book.check("four times the random rays halve the error", std::fabs(slope[0] + 0.5) < 0.03,
               "slope " + significant_text(slope[0], 3));
    book.check("rays spread evenly do better", slope[1] < slope[0] - 0.1,
               "slope " + significant_text(slope[1], 3));
}

void ray_cast_occlusion(Notebook& book) {
    book.text(R"(
        # 02 Ray-cast ambient occlusion

        Of N random rays into the hemisphere over p, h meet something: accessibility is `1 - h / N`.
        The tutorials cast 32 from each triangle's middle; a vertex takes the mean of its triangles.
    )");
    const Scene scene = head_on_a_floor();
    const RayScene rays = ray_scene(scene, scene.camera.eye);
    RayAoSettings settings = kTutorialRays;
    settings.seed = book.seed();
    const double start_ms = clocks().wall_ms;
    const VertexAo tutorial = vertex_ao_from_centroids(scene, rays, settings);
    const double wall_ms = clocks().wall_ms - start_ms;
    const Image<float> baked = vertex_ao_picture(scene, scene.camera, book.size(), rays, tutorial);
    book.show("vertices", ao_picture(baked), "No light, no texture: accessibility alone.", wall_ms);
    book.text("All " + std::to_string(tutorial.rays_cast) +
              " rays again when anything moves, and a frame has 16.7 ms: bakes are for what stands still.");
    const std::vector<SurfacePoint> centroids = triangle_centroids(rays);
    ask_the_octree(book, rays, centroids);
    count_the_rays(book, rays, centroids);

    const RayAoSettings better_rays = {.rays = 128, .radius = kUnbounded, .seed = book.seed()};
    const VertexAo corners = vertex_ao_from_corners(scene, rays, better_rays);
    const Image<float> better = vertex_ao_picture(scene, scene.camera, book.size(), rays, corners);
    book.show_row("As a white sky lights it: 128 cosine-weighted Sobol rays a vertex; minus the tutorials'.",
                  {{"corners", ao_picture(better)},
                   {"corners_minus_tutorial", difference_picture(signed_difference({better}, {baked})[0])}});

    const ClosedFormPlot sphere = sphere_on_plane_plot(4096, book.seed()),
                         wall = long_wall_plot(4096, book.seed());
    book.show_row(
        "Over the distance from a unit sphere, and from a wall for rays of length 4: closed forms (lines), "
        "cosine-weighted rays (blue) and uniform ones (orange).",
        {{"sphere_on_plane", sphere.picture}, {"long_wall", wall.picture}});
    book.check("rays give the closed forms", sphere.worst < 0.01 && wall.worst < 0.01,
               "off by " + significant_text(sphere.worst, 3) + " and " + significant_text(wall.worst, 3) +
                   " at most");
    book.try_it({
        "Set `settings.rays = 4` before the clock: grain in every shade, of triangles' size.",
        "Set `settings.radius = 0.5f` there: sockets and contacts stay, the shade of the floor goes.",
        "Give `placed` of the head `{0, 1, 0}`: it floats, and the floor below it grows lighter.",
    });
    book.errata({
        "*Luna:* a hit counts at any distance, as its comment admits; X_Jun asks for one below d.",
        "*Luna:* rays are uniform: not the sky's light on p, which needs the cosine. See the plots.",
        "*Luna:* the triangles of a vertex count the same, the smallest as much as the largest.",
        "*Luna:* rays start .001 above: too much for a small mesh, too little for a huge one.",
        "*Luna:* a vertex without triangles is divided 0 / 0. Here it is open.",
        "*X_Jun:* fewer than 10 tests a ray. The octree needs more, as the check above says.",
    });
}

const Chapter kChapter("02", "ray_cast_ao", "Ray-cast ambient occlusion", ray_cast_occlusion);

}  // namespace
}  // namespace crevice
