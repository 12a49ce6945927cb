// The references that a method's picture is judged by, made from one scene, camera and size:
//   hard    T: ray-cast truth, what lies within the radius occludes fully
//   soft    T: ray-cast truth with the method's radius and fade
//   screen  S: the rays of `soft` against the depth buffer: the best that a screen-space method could know
//   limit   C: the method itself with ever more samples, full resolution, no blur
// They are kept on disk under a hash of all that they are made from, and found there again.
#pragma once

#include <filesystem>
#include <optional>

#include "ssao/ao_methods.h"
#include "ssao/judge/reference_image.h"
#include "ssao/rays/ray_cast_ao.h"

namespace crevice {

struct ReferenceRequest {
    Size size{1280, 720};            // of the picture, and of every reference
    const Method* method = nullptr;  // one that computes AO
    MethodSettings settings;         // scene units; what the question follows from, and `limit`
    // Of all rays, rounded up to kReplicates; the fade of `soft` and `screen` is the question's.
    RayAoSettings rays;
    double wanted_error = 0;  // > 0: rays are doubled until the mean standard error is at most this
    int limit_seeds = 256;    // rounded up to kReplicates; 0: no `limit`
    bool wants_screen = true;
    bool shows_progress = true;                  // a bar for each image that is made
    std::optional<std::filesystem::path> cache;  // the directory; none: nothing is kept or looked up
    Run run;
};

// Rays that ask what a method asks: its radius, weight and fade.
RayAoSettings rays_asking(const AoQuestion& question);

// $XDG_CACHE_HOME/crevice, else ~/.cache/crevice, else none.
std::optional<std::filesystem::path> default_cache();

struct Reference {
    ReferenceImage image;
    double mean = 1;        // over the pixels that show a surface; 1 when there is none
    double mean_error = 0;  // mean standard error of a pixel, over the same; not the error of `mean`
    double max_error = 0;
    long long rays = 0;  // a pixel, those that were cast; of `limit`: seeds
    double wall_ms = 0;  // to make it, 0 when it was found
    bool from_cache = false;
};

struct References {
    GBuffer gbuffer;  // with reversed depths, the most precise there are; `limit` has the camera's own
    SurfacePoints points;
    Reference hard, soft, screen;       // `hard` and `soft` are one trace: each says its time
    Reference limit;                    // this and `screen`: empty images when not asked for
    std::size_t lifted_far = 0;         // points whose rays start further than radius / 100 off their surface
    std::size_t dropped_triangles = 0;  // with corners that are not finite numbers
    double points_ms = 0, build_ms = 0;  // G-buffer and points; both trees
};

// Throws UsageError for requests out of range. A cache that cannot be written is told on stderr, once.
References make_references(const Scene& scene, const Camera& camera, const ReferenceRequest& request);

// `limit` alone, of a view whose points are known; request.limit_seeds > 0. Throws likewise.
Reference make_limit(const AoView& view, const SurfacePoints& points, const ReferenceRequest& request);

}  // namespace crevice
