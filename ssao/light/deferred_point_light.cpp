#include "ssao/light/deferred_point_light.h"

#include <limits>
#include <vector>

#include "rasterizer/base/error.h"
#include "rasterizer/base/parallel.h"
#include "rasterizer/lanes/approx_math.h"
#include "rasterizer/spaces.h"
#include "ssao/light/multi_bounce.h"
#include "ssao/light/widened_ao.h"

namespace crevice {

namespace {

// The diffuse colours of all materials, to be gathered.
struct Albedos {
    std::vector<float> red, green, blue;

    explicit Albedos(const Scene& scene) {
        for (const Material& material : scene.materials) {
            red.push_back(material.diffuse.x);
            green.push_back(material.diffuse.y);
            blue.push_back(material.diffuse.z);
        }
    }

    template <class F>
    CREVICE_INLINE Vec3<F> of(Int<F> material) const {
        return {gather(red.data(), material), gather(green.data(), material), gather(blue.data(), material)};
    }
};

struct PointLit {
    const Scene& scene;
    const GBuffer& gbuffer;
    const Image<float>& accessibility;  // at picture size
    const PointLight light;
    const glm::vec3 light_view, eye_view;  // as LightSpace has them
    const ViewRays rays;
    const Albedos albedos;
    const MultiBounce bounces;

    template <class F, class Witness>
    CREVICE_INLINE Vec3<F> colour_at(int x, int y, const Witness& witness) const {
        const F depth = load<F>(gbuffer.view_depth.row(y) + x);
        const auto surface = depth < F(std::numeric_limits<float>::infinity());
        const Vec3<F> sky = spread<F>(scene.sky);
        if (!any(surface)) return sky;
        const Size size = gbuffer.view_depth.size;
        const F u = (F(to_float(lane_index<F>() + Int<F>(x))) + F(0.5f)) / F(static_cast<float>(size.width)),
                v((static_cast<float>(y) + 0.5f) / static_cast<float>(size.height));
        const Vec3<F> p = rays.p_view(u, v, select(surface, depth, F(1)));
        const Vec3<F> n = {load<F>(gbuffer.normal.x.row(y) + x), load<F>(gbuffer.normal.y.row(y) + x),
                           load<F>(gbuffer.normal.z.row(y) + x)};
        const Int<F> material = gbuffer.material.empty()
                                    ? Int<F>(0)
                                    : select(surface, load<F>(gbuffer.material.row(y) + x), Int<F>(0));
        const F ao = load<F>(accessibility.row(y) + x);
        return select<F>(surface, lit(p, n, albedos.of<F>(material), ao, witness), sky);
    }

 private:
    template <class F, class Witness>
    CREVICE_INLINE Vec3<F> lit(Vec3<F> p, Vec3<F> n, Vec3<F> albedo, F ao, const Witness& witness) const {
        const F zero(0), one(1);
        const Vec3<F> way = spread<F>(light_view) - p;
        const F distance = square_root(dot(way, way));
        const Vec3<F> to_light = normalize_or<F>(way, n),
                      to_eye = normalize_or<F>(spread<F>(eye_view) - p, n);
        const Vec3<F> half = normalize_or<F>(to_light + to_eye, n);
        const F attenuation =
            one / (one + F(light.linear) * distance + F(light.quadratic) * distance * distance);
        const F facing = max_of(dot(n, to_light), zero);
        const F highlight = power(max_of(dot(n, half), zero), F(kPointLightShininess));
        const Vec3<F> arriving = attenuation * spread<F>(light.colour);
        const Vec3<F> access = ambient_access(bounces, ao, albedo);
        const Vec3<F> ambient = access * (spread<F>(scene.ambient_light) * albedo),
                      diffuse = arriving * (facing * albedo), specular = highlight * arriving;
        witness.point(LitPoint<F>{n, to_eye, {one, one, one}, one, access, one});
        witness.light(-1, facing, attenuation);
        witness.term(LitTerm::ambient, -1, ambient);
        witness.term(LitTerm::diffuse, -1, diffuse);
        witness.term(LitTerm::specular, -1, specular);
        return ambient + diffuse + specular;
    }
};

// `accessibility` is the AO map at picture size.
PointLit point_lit(const Scene& scene, const Camera& camera, const GBuffer& gbuffer,
                   const Image<float>& accessibility, LightSpace space, MultiBounce bounces) {
    const Size size = gbuffer.view_depth.size;
    const CameraMatrices matrices = camera_matrices(camera, size);
    const PointLight& light = *scene.point_light;
    const bool in_view = space == LightSpace::view;
    const glm::vec3 from_eye(glm::dvec3(light.position) - camera.eye);
    return {scene,
            gbuffer,
            accessibility,
            light,
            in_view ? glm::mat3(matrices.view_from_relative) * from_eye : light.position,
            in_view ? glm::vec3(0) : glm::vec3(camera.eye),
            {matrices.ray_scale, size, camera.projection == Projection::perspective},
            Albedos(scene),
            bounces};
}

}  // namespace

LitExplanation explain_deferred_point_light(const Scene& scene, const Camera& camera, const GBuffer& gbuffer,
                                            const Image<float>& ao, LightSpace space, MultiBounce bounces,
                                            int x, int y) {
    const Image<float> accessibility = ao_at_picture_size(ao, gbuffer.view_depth.size);
    LitExplanation result;
    result.formula = kSumOfTerms;
    const TermList terms{result};
    result.surface = gbuffer.view_depth.at(x, y) < std::numeric_limits<float>::infinity();
    if (result.surface) {
        result.triangle = gbuffer.triangle.empty() ? kNoTriangle : gbuffer.triangle.at(x, y);
        result.material = gbuffer.material.empty() ? 0 : gbuffer.material.at(x, y);
        result.accessibility = accessibility.at(x, y);
    } else {
        terms.term(LitTerm::sky, -1, spread<float>(scene.sky));
    }
    const Vec3<float> colour =
        point_lit(scene, camera, gbuffer, accessibility, space, bounces).colour_at<float>(x, y, terms);
    result.colour = {colour.x, colour.y, colour.z};
    return result;
}

Image3 deferred_point_light(const Scene& scene, const Camera& camera, const GBuffer& gbuffer,
                            const Image<float>& ao, LightSpace space, const Run& run, MultiBounce bounces) {
    if (!scene.point_light)
        throw UsageError("deferred point light: the scene has none (" + scene.name +
                         "); set its point_light");
    const Size size = gbuffer.view_depth.size;
    const Image<float> accessibility = ao_at_picture_size(ao, size, run);
    const PointLit pass = point_lit(scene, camera, gbuffer, accessibility, space, bounces);
    Image3 picture(size);
    parallel_rows(size.height, run, [&](int first_row, int end_row) {
        run_kernel(run, [&]<class F>(Lanes<F>) {
            for (int y = first_row; y < end_row; ++y) {
                for (int x = 0; x < size.width; x += kLanes<F>) {
                    const Vec3<F> colour = pass.colour_at<F>(x, y, NoLightWitness{});
                    store(picture.x.row(y) + x, colour.x);
                    store(picture.y.row(y) + x, colour.y);
                    store(picture.z.row(y) + x, colour.z);
                }
            }
        });
    });
    return picture;
}

}  // namespace crevice
