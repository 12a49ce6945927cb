#include "chapters/study/references.h"

#include <algorithm>
#include <cstdlib>
#include <iostream>

#include "chapters/study/reference_cache.h"
#include "chapters/terminal/progress.h"
#include "chapters/terminal/stopwatch.h"
#include "rasterizer/base/error.h"
#include "ssao/rays/depth_mesh.h"

namespace crevice {

namespace {

// Names the meaning of the stored images: a new one when any of their definitions changes.
constexpr int kReferenceVersion = 2;

constexpr int kMostRays = 1 << 20;

class ReferenceMaker {
 public:
    ReferenceMaker(const ReferenceRequest& request, const SurfacePoints& points)
        : request_(request), points_(points) {}

    // Of one trace. `soft` null: not asked for.
    struct Pair {
        Reference hard, soft;
        std::size_t lifted_far = 0;
    };
    // `from`: where the rays start, one for each of the points.
    Pair traced(const char* label, const SurfacePoints& from, const RayScene& scene, const Fade& fade) {
        RayAoSettings rays = request_.rays;
        for (;;) {
            Pair pair = traced_with(label, from.points, scene, fade, rays);
            const double error = std::max(pair.hard.mean_error, pair.soft.mean_error);
            if (request_.wanted_error <= 0 || error <= request_.wanted_error || rays.rays >= kMostRays)
                return pair;
            rays.rays = std::min(2 * rays.rays, kMostRays);
        }
    }

    // At full size, whatever the settings say.
    Reference limit_of(const AoView& view) {
        const Method& method = *request_.method;
        const MethodSettings settings = with_value(method, request_.settings, "ao_scale", 1);
        const std::string name = key_of_limit(view, settings) + "-limit";
        if (auto found = find(name)) return counted(std::move(*found), request_.limit_seeds, 0, true);
        Progress progress("limit", request_.limit_seeds, request_.shows_progress);
        const Clocks before = clocks();
        ReferenceImage image = method.limit(view, settings.ao, request_.limit_seeds, request_.run,
                                            [&](long long done) { progress.advance(done); });
        const double ms = clocks().wall_ms - before.wall_ms;
        store(name, image);
        return counted(std::move(image), request_.limit_seeds, ms, false);
    }

 private:
    Pair traced_with(const char* label, std::span<const SurfacePoint> from, const RayScene& scene,
                     const Fade& fade, const RayAoSettings& rays) {
        const std::string key = key_of(from, scene, fade, rays);
        auto hard = find(key + "-hard"), soft = find(key + "-soft");
        Pair pair;
        pair.lifted_far = lifted_far(from, rays.radius);
        if (hard && soft) {
            pair.hard = counted(std::move(*hard), rays.rays, 0, true);
            pair.soft = counted(std::move(*soft), rays.rays, 0, true);
            return pair;
        }
        Progress progress(label, static_cast<long long>(from.size()), request_.shows_progress);
        const Clocks before = clocks();
        const RayAoReference traced = ray_cast_reference(scene, from, rays, &fade, request_.run,
                                                         [&](long long done) { progress.advance(done); });
        const double ms = clocks().wall_ms - before.wall_ms;
        ReferenceImage hard_image = picture_of_estimates(traced.hard),
                       soft_image = picture_of_estimates(traced.soft);
        store(key + "-hard", hard_image);
        store(key + "-soft", soft_image);
        pair.hard = counted(std::move(hard_image), rays.rays, ms, false);
        pair.soft = counted(std::move(soft_image), rays.rays, ms, false);
        return pair;
    }

    // What rays can meet: triangles, and where they have holes.
    static void add_scene(ContentKey& key, const RayScene& scene) {
        key.add_all(scene.triangles);
        if (!scene.holes.any()) return;
        key.add_all(scene.sources);
        for (const auto& of_corners : scene.holes.texcoords) {
            key.add(of_corners.has_value());
            if (of_corners) key.add_all(*of_corners);
        }
        for (const Material& material : scene.holes.materials) add_cutout(key, material);
    }

    // All that a limit can depend on: buffers, camera, and every parameter of the method but its denoiser's.
    std::string key_of_limit(const AoView& view, const MethodSettings& settings) const {
        const GBuffer& gbuffer = view.gbuffer;
        const Camera& camera = view.camera;
        ContentKey key;
        key.add(kReferenceVersion);
        key.add_all(std::string(request_.method->name));
        key.add(request_.limit_seeds);
        const Image<float> ndc = ndc_depth(gbuffer.depth);
        for (const Image<float>* image :
             {&gbuffer.normal.x, &gbuffer.normal.y, &gbuffer.normal.z, &gbuffer.view_depth, &ndc})
            key.add_image(*image);
        const CameraMatrices m = camera_matrices(camera, request_.size);
        key.add(m.ray_scale);
        for (const float value : {m.depth_a, m.depth_b}) key.add(value);
        for (const double value : {camera.near_plane, camera.far_plane}) key.add(value);
        key.add(camera.projection);
        for (const Parameter<AnySettings>& parameter : request_.method->parameters)
            key.add(parameter.get(settings.ao));
        if (view.rays != nullptr) add_scene(key, *view.rays);
        return key.hex();
    }

    std::string key_of(std::span<const SurfacePoint> from, const RayScene& scene, const Fade& fade,
                       const RayAoSettings& rays) const {
        ContentKey key;
        key.add(kReferenceVersion);
        add_scene(key, scene);
        key.add_all(from);
        key.add_all(points_.pixel);
        key.add(request_.size);
        key.add(fade);
        for (const int value : {rays.rays, static_cast<int>(rays.weight), static_cast<int>(rays.sequence),
                                static_cast<int>(rays.hemisphere)})
            key.add(value);
        key.add(rays.radius);
        key.add(rays.seed);
        return key.hex();
    }

    ReferenceImage picture_of_estimates(const std::vector<AoEstimate>& estimates) const {
        std::vector<float> values(estimates.size());
        const auto picture = [&](auto value, float background) {
            std::transform(estimates.begin(), estimates.end(), values.begin(), value);
            return picture_of(points_, values, background);
        };
        return {picture([](const AoEstimate& e) { return e.mean; }, 1),
                picture([](const AoEstimate& e) { return e.error; }, 0),
                {picture([](const AoEstimate& e) { return e.half[0]; }, 1),
                 picture([](const AoEstimate& e) { return e.half[1]; }, 1)}};
    }

    Reference counted(ReferenceImage image, long long rays, double ms, bool from_cache) const {
        Reference reference{std::move(image), 1, 0, 0, rays, ms, from_cache};
        if (points_.pixel.empty()) return reference;
        double sum = 0, error_sum = 0;
        for (const std::int32_t pixel : points_.pixel) {
            const int x = pixel % request_.size.width, y = pixel / request_.size.width;
            const double error = reference.image.error.at(x, y);
            sum += reference.image.mean.at(x, y);
            error_sum += error;
            reference.max_error = std::max(reference.max_error, error);
        }
        reference.mean = sum / static_cast<double>(points_.pixel.size());
        reference.mean_error = error_sum / static_cast<double>(points_.pixel.size());
        return reference;
    }

    std::optional<ReferenceImage> find(const std::string& name) const {
        if (!request_.cache) return std::nullopt;
        FoundReference found = find_reference(*request_.cache, name, request_.size);
        if (!found.damage.empty()) std::cerr << "warning: " << found.damage << "\n";
        return std::move(found.image);
    }
    void store(const std::string& name, const ReferenceImage& image) {
        if (!request_.cache || cache_failed_) return;
        try {
            store_reference(*request_.cache, name, image);
        } catch (const OutputError& error) {
            // Another program may have stored the same at the same time.
            if (find(name)) return;
            std::cerr << error.what() << "\n";
            cache_failed_ = true;
        }
    }

    const ReferenceRequest& request_;
    const SurfacePoints& points_;
    bool cache_failed_ = false;
};

// What is cast and counted is a multiple of the replicates. Throws UsageError where it is out of range.
ReferenceRequest valid_request(ReferenceRequest request) {
    validate(request.run);
    validate(request.rays);
    validate(*request.method, request.settings);
    request.rays.rays = round_up(request.rays.rays, kReplicates);
    request.limit_seeds = round_up(request.limit_seeds, kReplicates);
    return request;
}

}  // namespace

std::optional<std::filesystem::path> default_cache() {
    const char* const cache = std::getenv("XDG_CACHE_HOME");
    if (cache != nullptr && *cache != 0) return std::filesystem::path(cache) / "crevice";
    const char* const home = std::getenv("HOME");
    if (home != nullptr && *home != 0) return std::filesystem::path(home) / ".cache" / "crevice";
    return std::nullopt;
}

RayAoSettings rays_asking(const AoQuestion& question) {
    RayAoSettings rays;
    rays.radius = question.radius;
    rays.weight = question.cosine_weighted ? RayWeight::cosine : RayWeight::uniform;
    rays.fade = Fade{question.fade_start, question.fade_end};
    return rays;
}

References make_references(const Scene& scene, const Camera& camera, const ReferenceRequest& asked) {
    const ReferenceRequest request = valid_request(asked);
    References references;
    const Clocks start = clocks();
    // Truth does not depend on how a frame stores its depths: the most precise way decides what is seen.
    Camera precise = camera;
    precise.reversed_z = true;
    references.gbuffer = normal_depth(scene, precise, request.size, request.run);
    references.points = surface_points(scene, precise, references.gbuffer, request.run);
    const Clocks drawn = clocks();
    const RayScene rays = ray_scene(scene, camera.eye, request.run);
    RayScene screen;
    if (request.wants_screen)
        screen = depth_mesh(references.gbuffer, precise, request.rays.radius, request.run);
    references.points_ms = drawn.wall_ms - start.wall_ms;
    references.build_ms = clocks().wall_ms - drawn.wall_ms;
    references.dropped_triangles = rays.not_finite;

    ReferenceMaker maker(request, references.points);
    const AoQuestion question = request.method->question(request.settings.ao);
    const Fade fade{question.fade_start, question.fade_end};
    ReferenceMaker::Pair truth = maker.traced("truth", references.points, rays, fade);
    references.hard = std::move(truth.hard);
    references.soft = std::move(truth.soft);
    references.lifted_far = truth.lifted_far;
    if (request.wants_screen) {
        const SurfacePoints in_buffer =
            points_on_depth_mesh(references.points, references.gbuffer, precise, request.run);
        references.screen = maker.traced("screen", in_buffer, screen, fade).soft;
    }
    if (request.limit_seeds > 0) {
        const GBuffer as_frame = normal_depth(scene, camera, request.size, request.run);
        references.limit =
            maker.limit_of({scene, camera, as_frame, request.method->casts_rays ? &rays : nullptr});
    }
    return references;
}

Reference make_limit(const AoView& view, const SurfacePoints& points, const ReferenceRequest& asked) {
    const ReferenceRequest request = valid_request(asked);
    return ReferenceMaker(request, points).limit_of(view);
}

}  // namespace crevice
