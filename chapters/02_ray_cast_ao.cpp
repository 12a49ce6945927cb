// %% setup tags=["setup"]
// Source: X_Jun, "ray casting"; Luna, BuildVertexAmbientOcclusion.
// Run: crevice chapter 02
#include <cmath>

#include "chapters/diagrams/ray_fan.h"
#include "chapters/notebook/chapter.h"
#include "chapters/props/closed_form_plot.h"
#include "chapters/terminal/number_text.h"
#include "rasterizer/base/hash.h"
#include "rasterizer/lanes/approx_math.h"
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

// The constant of the ambient term on everything that is seen.
Image<float> constant_light(const Scene& scene, Size size) {
    Image<float> grey(size, 1.0f);
    const Image<float> view_depth = normal_depth(scene, scene.camera, size).view_depth;
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
            if (std::isfinite(view_depth.at(x, y))) grey.at(x, y) = 0.75f;
        }
    }
    return grey;
}

// The sphere of radius 1 that rests on a floor, cut through its middle.
std::vector<SectionPoint> sphere_outline() {
    std::vector<SectionPoint> outline = {{-4, 0}, {0, 0}};
    for (int i = 1; i <= 64; ++i) {
        const SineCosine at = sine_cosine(2 * kPi * i / 64);
        outline.push_back({-at.sine, 1 - at.cosine});
    }
    outline.push_back({4, 0});
    return outline;
}
std::vector<double> random_angles(int count, std::uint32_t seed) {
    std::vector<double> angles_rad;
    for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(count); ++i)
        angles_rad.push_back(kPi * (hash_of(seed, 0xfa9u, i) >> 8) / 16777216.0);
    return angles_rad;
}

// The head as the tutorials bake it, with other rays.
Image<float> baked(const Scene& scene, const RayScene& rays, Size size, const RayAoSettings& settings) {
    return vertex_ao_picture(scene, scene.camera, size, rays,
                             vertex_ao_from_centroids(scene, rays, settings));
}

// What a ray of every 64th point is tested against in the octree, and whether all meet the same as in the tree that
// this book uses.
struct OctreeCount {
    double boxes = 0, triangles = 0;  // a ray
    bool same = false;
};
OctreeCount ask_the_octree(const RayScene& rays, const std::vector<SurfacePoint>& points) {
    const Octree octree = build_octree(rays.triangles);
    OctreeCount count;
    std::vector<Ray> cast;
    for (std::uint32_t i = 0; i < points.size(); i += 64) {
        for (const Ray& ray : hemisphere_rays(points[i], i, kTutorialRays)) {
            const OctreeWalk way = walk(octree, ray, kUnbounded);
            count.boxes += way.boxes;
            count.triangles += way.triangles;
            cast.push_back(ray);
        }
    }
    count.boxes /= static_cast<double>(cast.size());
    count.triangles /= static_cast<double>(cast.size());
    count.same = occluded(octree, cast, kUnbounded).occluded == occluded(rays, cast, kUnbounded).occluded;
    return count;
}

// The RMS error of points over their rays.
PlotCurve errors(const char* name, const RayScene& rays, const std::vector<SurfacePoint>& points,
                 RayAoSettings settings, const std::vector<float>& truth) {
    PlotCurve curve{name, {}, {}};
    for (settings.rays = 1; settings.rays <= 256; settings.rays *= 2) {
        const std::vector<float> open = ray_cast_ao(rays, points, settings);
        double squares = 0;
        for (std::size_t i = 0; i < open.size(); ++i)
            squares += (static_cast<double>(open[i]) - static_cast<double>(truth[i])) *
                       (static_cast<double>(open[i]) - static_cast<double>(truth[i]));
        curve.x.push_back(settings.rays);
        curve.y.push_back(std::sqrt(squares / static_cast<double>(open.size())));
    }
    return curve;
}

// Between the ends of a curve, both axes logarithmic.
double slope_of(const PlotCurve& curve) {
    return std::log2(curve.y.back() / curve.y.front()) / std::log2(curve.x.back() / curve.x.front());
}

// Cells stand at the margin, where notebooks look for them.
// clang-format off
void ray_cast_occlusion(Notebook& book) {

// %% question [markdown]
// # Ray-cast ambient occlusion
//
// A carved head on a floor, under constant ambient light: in the first picture one can make out that something is there,
// and that is all. In the second, eye sockets, teeth and the contact with the floor appear. No lamp shines in either. How
// does a point find out how much of its surroundings it sees?

// %% start
const Scene scene = head_on_a_floor();
const RayScene rays = ray_scene(scene, scene.camera.eye);
RayAoSettings settings = kTutorialRays;
settings.seed = book.seed();

const VertexAo tutorial = vertex_ao_from_centroids(scene, rays, settings);

const Image<float> shown = vertex_ao_picture(scene, scene.camera, book.size(), rays, tutorial);
book.compare(
    {"constant", grey_picture(constant_light(scene, book.size()), 0, 1),
     "Constant ambient light: one grey for head and floor."},
    {"vertices", ao_picture(shown),
     "Accessibility alone, computed at the vertices as the tutorials do it. The mottles are "
     "explained below."});

// %% idea [markdown]
// ## The idea
//
// **Shoot rays from the point in random directions, and count how many meet something.**
//
// Of $N$ rays into the hemisphere over the point, let $h$ meet something. Then
//
// $$ \mathrm{occlusion} = \frac{h}{N}, \qquad \mathrm{access} = 1 - \frac{h}{N} $$

// %% fan
const int fan_rays = 16;
const RayScene sphere = ray_scene(sphere_on_plane_scene(), glm::dvec3(0));
const RayFan fan = ray_fan(sphere, {-1.2, 0}, random_angles(fan_rays, book.seed()), 2,
                           sphere_outline(), "Rays from a point beside a sphere");
book.numbers({{"n", fan_rays}, {"h", fan.blocked}});
book.number("open_share", 1 - static_cast<double>(fan.blocked) / fan_rays, 3);
book.draw("fan", fan.svg,
          "N = {n} random rays of length 2 from a point p beside a sphere. h = {h} of them meet it "
          "(red), so the accessibility of p is about 1 - {h} / {n} = {open_share}.");

// %% estimate [markdown]
// ## Why counting works
//
// Chapter 01 defined accessibility as an integral over all directions. A mean over random directions estimates such an
// integral: this is the *Monte Carlo* method. What exactly it estimates depends on how the directions are drawn. If all
// are equally likely, *uniform* rays, every direction counts the same:
//
// $$ 1 - \frac hN \;\to\; \frac1{2\pi} \int_\Omega V(\omega)\, d\omega $$
//
// If directions near the normal are drawn more often, in proportion to the cosine $n \cdot \omega$, the mean tends to
//
// $$ 1 - \frac hN \;\to\; \frac1\pi \int_\Omega V(\omega)\, (n \cdot \omega)\, d\omega $$
//
// which is what a white sky lights. The tutorials draw uniform rays. In both cases an occluder may be required to be
// near: X_Jun's tutorial (for Direct3D 11; the preface lists all sources) counts a hit only within a distance $d$, for a
// wall at the other end of the hall does not darken this corner.
//
// ## From triangles to vertices
//
// The program of Luna's tutorial, for Direct3D 12, keeps accessibility with the mesh. It shoots 32 rays from the middle of each triangle, about the
// triangle's normal, and gives every vertex the mean of the triangles that share it. While the scene is drawn the value
// is interpolated like a colour, which costs nothing.

// %% kernels tags=["setup"]
book.listing_part("ssao/rays/ray_cast_ao.cpp", "open_share", "std::size_t open", "casts.fade == nullptr ? 1 : soft",
                  "The count at the heart of it. `soft` is the same where near occluders count "
                  "more than far ones.");
book.listing("ssao/bakes/vertex_ao.cpp", "means_of_triangles",
             "A vertex takes the mean of its triangles.");

// %% cost_text [markdown]
// ## What it costs
//
// Every ray must find out whether any of the scene's triangles is in its way. Luna sorts them into an *octree*: a cube
// around everything, cut into eight halves as wide, and these again, until a cube holds fewer than sixty triangles. A
// ray looks only into cubes that it enters.

// %% cost
const std::vector<SurfacePoint> centroids = triangle_centroids(rays);
const OctreeCount asked = ask_the_octree(rays, centroids);
book.numbers({{"rays_cast", tutorial.rays_cast}, {"triangles", centroids.size()}, {"boxes", significant_text(asked.boxes, 3)},
              {"tested", significant_text(asked.triangles, 3)}});
book.check(
    "The octree gives every ray the same answer as the tree that this book uses, a bounding volume "
    "hierarchy. A ray is tested against {boxes} boxes and {tested} of the {triangles} triangles.",
    asked.same);

// %% static_only [markdown]
// That makes {rays_cast} rays for this head. As soon as anything moves, all of them must be cast again, and a frame has
// 16.7 ms. Hence *baking*, as it is called, is for what stands still. For the rest the later chapters look at the
// screen instead of the scene.
//
// ## How wrong
//
// One ray says "open" with the probability $a$, the true accessibility. The mean of $N$ independent ones has the
// variance $a (1 - a) / N$, so its typical error falls with $1 / \sqrt N$: four times the rays for half of the error.
// Rays that keep out of each other's way do better. *Sobol's* sequence is a way to spread them evenly.

// %% error
std::vector<SurfacePoint> points;
for (std::size_t i = 0; i < centroids.size(); i += 64) points.push_back(centroids[i]);
RayAoSettings random = kTutorialRays, sobol = kTutorialRays, many = kTutorialRays;
sobol.sequence = many.sequence = RaySequence::sobol;
random.seed = sobol.seed = book.seed();
many.seed = book.seed() + 1;
many.rays = 4096;
const std::vector<float> truth = ray_cast_ao(rays, points, many);
const PlotCurve by_random = errors("random rays", rays, points, random, truth),
                by_sobol = errors("Sobol's rays", rays, points, sobol, truth);
book.plot("error",
          {"Error of a triangle's accessibility",
           {"rays", true},
           {"RMS error", true},
           {by_random, by_sobol}},
          "RMS error against 4,096 rays, over every 64th triangle of the head. Random rays follow "
          "a straight line.");
book.numbers(3, {{"random_slope", slope_of(by_random)}, {"sobol_slope", slope_of(by_sobol)}});
book.check(
    "Four times the random rays halve the error: on these axes their line has the slope "
    "{random_slope}, and $1/\\sqrt N$ has -0.5.",
    std::fabs(slope_of(by_random) + 0.5) < 0.03);
book.check("Rays that are spread evenly do better: {sobol_slope}.",
           slope_of(by_sobol) < slope_of(by_random) - 0.1);

// %% truth_text [markdown]
// Are the rays themselves right? For two shapes the integral can be solved on paper: for a floor beside a sphere that
// rests on it, and for a floor before a long wall, with rays of length 4. Here is the first, with the cosine. Take a
// sphere of radius 1 and a point of the floor at the distance $x$ from where it rests. The middle of the sphere is 1
// above the floor and $\sqrt{1 + x^2}$ away from the point. So the point sees a disc whose half angle has the sine
// $s = 1 / \sqrt{1 + x^2}$. Such a disc, if none of it is below the horizon, takes $s^2$ times the cosine between the
// normal and the way to its middle; and that cosine is the height over the distance, $s$ again. What is left is
// $\mathrm{access} = 1 - s^3$.

// %% closed_forms
const ClosedFormPlot by_sphere = sphere_on_plane_plot(4096, book.seed()),
                     by_wall = long_wall_plot(4096, book.seed());
book.plot("sphere_on_plane", by_sphere.plot,
          "Both ways to draw rays follow their closed forms, and these differ. Close to the "
          "contact the sphere hangs overhead, where the cosine counts it more; farther off it lies "
          "low, where uniform rays count it more.");
book.plot("long_wall", by_wall.plot,
          "At the distance 4 the rays just reach the wall: from there on nothing is in the way.");
book.numbers({{"off_sphere", significant_text(by_sphere.worst, 2)}, {"off_wall", significant_text(by_wall.worst, 2)}});
book.check("With 4,096 rays the estimates are off by {off_sphere} and {off_wall} at most.",
           by_sphere.worst < 0.01 && by_wall.worst < 0.01);

// %% traps [markdown]
// ## What can go wrong
//
// **Too few rays.** Each triangle draws its own rays, so the error is a grain as coarse as the mesh.

// %% few_rays
settings.rays = 4;
book.compare(
    {"four_rays", ao_picture(baked(scene, rays, book.size(), settings)),
     "4 rays a triangle: large spots on the floor, small ones on the finer mesh of the head."},
    {"many_rays", ao_picture(shown), "32 rays, the tutorials': the same spots, fainter."});
settings.rays = kTutorialRays.rays;

// %% distance_text [markdown]
// **Rays that never end.** Indoors every ray meets something, and everything is dark. A limit keeps the shade where
// things are near.

// %% distance
settings.radius = 0.5f;
const Image<float> near_only = baked(scene, rays, book.size(), settings);
book.compare(
    {"no_limit", ao_picture(shown), "Hits count at any distance, as in Luna."},
    {"limit", ao_picture(near_only),
     "Only within half a unit: sockets and contacts stay, the wide shade on the floor goes."});
book.numbers(3, {{"mean_far", buffer_statistics(shown).mean}, {"mean_near", buffer_statistics(near_only).mean}});
book.check("The limit only opens: the mean goes from {mean_far} to {mean_near}.",
           buffer_statistics(near_only).mean > buffer_statistics(shown).mean);

// %% weight_text [markdown]
// **Uniform rays, and means over triangles.** A white sky would light the head by the cosine. And a vertex that
// averages the triangles around it takes the light from all that these reach, on both sides of a crease. Rays that
// start close to the vertex itself, drawn by the cosine, say what the sky would do.

// %% better
const RayAoSettings better_rays = {.rays = 128, .radius = kUnbounded, .seed = book.seed()};
const VertexAo corners = vertex_ao_from_corners(scene, rays, better_rays);
const Image<float> better = vertex_ao_picture(scene, scene.camera, book.size(), rays, corners);
book.compare(
    {"centroids", ao_picture(shown), "32 uniform rays a triangle, averaged at the vertices: spots on floor and skull."},
    {"corners", ao_picture(better),
     "128 cosine-weighted Sobol rays a vertex: smooth, with a darker contact below the jaw."});
book.show("corners_minus_tutorial", difference_picture(signed_difference({better}, {shown})[0]),
          "The second minus the first. Red is lighter: what is in the way lies low, and the cosine "
          "counts it less. Blue is darker: the head hangs over this part of the floor, or a crease "
          "had been washed out.");

// %% exercises [markdown]
// ## Exercises
//
// 1. In `head_on_a_floor` of this chapter place the head at `{0, 1, 0}`. What happens to the floor below it?
// 2. How many rays does it take to bring the error of 32 random rays down to a tenth?
// 3. Run `crevice bake columns --vertex` and look at the large triangles of the ground. What is missing at the feet of
//    the columns, and why?
// 4. Derive the uniform closed form of the sphere, $x / \sqrt{1 + x^2}$, from the size of a spherical cap.
// 5. (Open) Light that is blocked by a red curtain comes back red. What would a ray have to bring home besides "hit"
//    and "no hit"?
//
// <details><summary>Answers</summary>
//
// 1. It floats, and the floor below it grows lighter: the rays that leave sideways now pass under it.
// 2. A hundred times as many, 3,200.
// 3. The contact shade: a triangle of the ground is far larger than the shade, and its vertices lie elsewhere. Chapter
//    20 bakes into a texture instead.
// 4. A cap of half angle $\theta$ covers $1 - \cos\theta$ of a hemisphere, and
//    $\cos\theta = \sqrt{1 - s^2} = x / \sqrt{1 + x^2}$: what is left is $\cos\theta$ itself, as long as the whole cap
//    is above the floor.
// 5. The colour and the light of what it met: that is the first step to path tracing.
//
// </details>

// %% errata [markdown]
// <details><summary>Errata of the tutorials</summary>
//
// - *Luna:* a hit counts at any distance, as its comment admits; X_Jun asks for one below d.
// - *Luna:* rays are uniform, which is not the sky's light on p; that needs the cosine. The plots of the closed forms
//   show both.
// - *Luna:* the triangles of a vertex count the same, the smallest as much as the largest.
// - *Luna:* rays start 0.001 above the triangle: too much for a small mesh, too little for a huge one.
// - *Luna:* a vertex without triangles is divided 0 / 0. Here it is open.
// - *X_Jun:* fewer than ten tests a ray. The octree needs more, as the check above says.
//
// </details>
//
// ## Where to go on
//
// This is the truth, and it takes too long. Chapter 03 begins with what is cheap: the picture itself, and how far away
// everything in it is. Chapter 20 comes back to baking.

// %% end tags=["setup"]
}

const Chapter kChapter02("02", "ray_cast_ao", "Ray-cast ambient occlusion", ray_cast_occlusion);

}  // namespace
}  // namespace crevice
