#include "ssao/shade.h"

#include <algorithm>

#include <glm/common.hpp>

#include "rasterizer/sample_texture.h"
#include "rasterizer/spaces.h"
#include "ssao/lighting.h"
#include "ssao/linear_taps.h"

namespace crevice {

namespace {

// Lights that are off are left out: they would add zero.
ViewLights lights_in_view(const Scene& scene, const CameraMatrices& matrices) {
    ViewLights lights;
    for (DirectionalLight light : scene.lights) {
        const glm::vec3 brightest = glm::max(light.ambient, glm::max(light.diffuse, light.specular));
        if (brightest == glm::vec3(0)) continue;
        light.direction = glm::mat3(matrices.view_from_relative) * light.direction;
        lights.push_back(light);
    }
    return lights;
}

// The texture's colour at each pixel of a group, sampled pixel by pixel.
template <class F>
CREVICE_INLINE Vec3<F> texture_colour(const Texture& texture, const Mesh& mesh, std::uint32_t first_vertex,
                                      const ScreenTriangle& t, const Fragment<F>& f) {
    const auto uv_at = [&](const Barycentric<F>& b) __attribute__((always_inline)) {
        const glm::vec2 &uv0 = mesh.texcoords[t.vertex[0] - first_vertex],
                        &uv1 = mesh.texcoords[t.vertex[1] - first_vertex],
                        &uv2 = mesh.texcoords[t.vertex[2] - first_vertex];
        return Vec3<F>{b.interpolate(uv0.x, uv1.x, uv2.x), b.interpolate(uv0.y, uv1.y, uv2.y), F(0)};
    };
    const Vec3<F> uv = uv_at(f.here), right = uv_at(f.away(t, 1, 0)), below = uv_at(f.away(t, 0, 1));
    float u[3][kLanes<F>], v[3][kLanes<F>], colour[3][kLanes<F>] = {};
    const Vec3<F>* const at[3] = {&uv, &right, &below};
    for (int i = 0; i < 3; ++i) {
        store(u[i], at[i]->x);
        store(v[i], at[i]->y);
    }
    Int<F> passed = select(f.passed, Int<F>(1), Int<F>(0));
    std::int32_t wanted[kLanes<F>];
    store(wanted, passed);
    for (int lane = 0; lane < kLanes<F>; ++lane) {
        if (wanted[lane] == 0) continue;
        const glm::vec2 here(u[0][lane], v[0][lane]);
        const glm::vec3 c = sample_trilinear(texture, here, glm::vec2(u[1][lane], v[1][lane]) - here,
                                             glm::vec2(u[2][lane], v[2][lane]) - here);
        for (int k = 0; k < 3; ++k) colour[k][lane] = c[k];
    }
    return {load<F>(colour[0]), load<F>(colour[1]), load<F>(colour[2])};
}

bool any_texture(const Scene& scene) {
    return std::any_of(scene.materials.begin(), scene.materials.end(),
                       [](const Material& m) { return m.texture != nullptr; });
}

// An AO map seen at picture size, filtered linearly; all open when the map is empty.
struct AoSampler {
    const Image<float>& ao;
    LinearTaps columns, rows;

    AoSampler(const Image<float>& map, Size picture)
        : ao(map), columns(picture.width, map.size.width), rows(picture.height, map.size.height) {}

    template <class F>
    CREVICE_INLINE F at(int x, int y) const {
        if (ao.empty()) return F(1);
        const auto row = static_cast<std::size_t>(y);
        const float *above = ao.row(rows.first[row]), *below = ao.row(rows.second[row]);
        const Int<F> left = load<F>(columns.first.data() + x), right = load<F>(columns.second.data() + x);
        const F fx = load<F>(columns.weight_of_second.data() + x);
        const F top = mix(F(gather(above, left)), F(gather(above, right)), fx);
        const F bottom = mix(F(gather(below, left)), F(gather(below, right)), fx);
        return mix(top, bottom, F(rows.weight_of_second[row]));
    }
};

// Fragments only note what a pixel shows; the pixels are lit when the tile is complete, eight at a time
// whatever the size of the triangles. Until then a pixel of `lit` holds its normal.
struct LitShader {
    const Scene& scene;
    const ScreenGeometry& geometry;
    const ViewLights& lights;
    const AoSampler& accessibility;
    Image3& lit;
    Image<std::int32_t>& materials;  // index, or kSky
    Image3& textures;                // texture colours; empty when the scene has none
    static constexpr std::int32_t kSky = -1;

    void begin_tile(PixelRect tile) const {
        fill_tile(lit.x, tile, scene.sky.x);
        fill_tile(lit.y, tile, scene.sky.y);
        fill_tile(lit.z, tile, scene.sky.z);
        fill_tile(materials, tile, kSky);
    }

    template <class F>
    CREVICE_INLINE void fragment(const ScreenTriangle& t, const Fragment<F>& f) const {
        store_where_passed(lit, f, interpolated_normal(geometry, t, f));
        crevice::store_where_passed(materials.row(f.y), f, Int<F>(t.material));
        if (textures.empty()) return;
        const Material& material = scene.materials[static_cast<std::size_t>(t.material)];
        const Mesh& mesh = scene.meshes[static_cast<std::size_t>(scene.instances[t.instance].mesh)];
        Vec3<F> colour{F(1), F(1), F(1)};
        if (material.texture != nullptr && !mesh.texcoords.empty()) {
            colour =
                texture_colour(*material.texture, mesh, geometry.vertices.first_vertex[t.instance], t, f);
        }
        store_where_passed(textures, f, colour);
    }

    template <class F>
    CREVICE_INLINE void finish_tile(PixelRect tile) const {
        for (int y = tile.y0; y < tile.y1; ++y) {
            for (int x = tile.x0; x < tile.x1; x += kLanes<F>) light_pixels<F>(x, y);
        }
    }

    // One material after the other, until every lane has had its own.
    template <class F>
    CREVICE_INLINE void light_pixels(int x, int y) const {
        const Int<F> material_index = load<F>(materials.row(y) + x);
        auto left = material_index != Int<F>(kSky);
        while (any(left)) {
            const std::int32_t index = largest_of(select(left, material_index, Int<F>(kSky)));
            const auto lanes = material_index == Int<F>(index);
            const Vec3<F> now = load_vec3<F>(lit, x, y);
            const Vec3<F> colour =
                lit_colour<F>(scene.materials[static_cast<std::size_t>(index)], unit_normal(now), x, y);
            store(lit.x.row(y) + x, select(lanes, colour.x, now.x));
            store(lit.y.row(y) + x, select(lanes, colour.y, now.y));
            store(lit.z.row(y) + x, select(lanes, colour.z, now.z));
            left = left & (material_index != Int<F>(index));
        }
    }

    template <class F>
    CREVICE_INLINE Vec3<F> lit_colour(const Material& material, Vec3<F> n_view, int x, int y) const {
        const F zero = F(0), one = F(1);
        const Vec3<F> ray = view_ray_at<F>(geometry, x, y);
        const Vec3<F> to_eye = normalize_or<F>({zero - ray.x, zero - ray.y, zero - ray.z}, ray);
        const Vec3<F> texture = textures.empty() ? Vec3<F>{one, one, one} : load_vec3<F>(textures, x, y);
        const SurfacePoint<F> s{n_view, to_eye, texture, accessibility.at<F>(x, y)};
        return scene.lighting == LightingModel::phong
                   ? phong(s, material, lights)
                   : blinn_schlick(s, material, lights, scene.ambient_light);
    }

    template <class F>
    CREVICE_INLINE static Vec3<F> load_vec3(const Image3& image, int x, int y) {
        return {load<F>(image.x.row(y) + x), load<F>(image.y.row(y) + x), load<F>(image.z.row(y) + x)};
    }
    template <class F>
    CREVICE_INLINE static void store_where_passed(Image3& image, const Fragment<F>& f, Vec3<F> value) {
        crevice::store_where_passed(image.x.row(f.y), f, value.x);
        crevice::store_where_passed(image.y.row(f.y), f, value.y);
        crevice::store_where_passed(image.z.row(f.y), f, value.z);
    }
};

}  // namespace

Image<float> ao_at_picture_size(const Image<float>& ao, Size picture, const Run& run) {
    Image<float> result(picture, 1.0f);
    const AoSampler sampler(ao, picture);
    parallel_rows(picture.height, run, [&](int first_row, int end_row) {
        run_kernel(
            run, [&](auto tag) __attribute__((always_inline)) {
                using F = typename decltype(tag)::type;
                for (int y = first_row; y < end_row; ++y) {
                    for (int x = 0; x < picture.width; x += kLanes<F>) {
                        store(result.row(y) + x, sampler.at<F>(x, y));
                    }
                }
            });
    });
    return result;
}

Image3 shade(const Scene& scene, const Camera& camera, const ScreenGeometry& geometry,
             const DepthBuffer& depth, const Image<float>& ao, const ShadeSettings& settings,
             const Run& run) {
    const Size size = depth.size();
    const CameraMatrices matrices = camera_matrices(camera, size);
    const ViewLights lights = lights_in_view(scene, matrices);
    const AoSampler accessibility(ao, size);

    Image3 lit(size);
    Image<std::int32_t> materials(size);
    const bool textured = any_texture(scene);
    Image3 textures = textured ? Image3(size) : Image3();
    const LitShader shader{scene, geometry, lights, accessibility, lit, materials, textures};
    rasterize(geometry, settings.depth_function, depth, shader, run);
    return lit;
}

Image3 shade(const Scene& scene, const Camera& camera, const DepthBuffer& depth, const Image<float>& ao,
             const ShadeSettings& settings, const Run& run) {
    const GeometrySettings geometry{settings.position_order, true, depth.format, settings.depth_bias};
    return shade(scene, camera, screen_geometry(scene, camera, depth.size(), geometry, run), depth, ao,
                 settings, run);
}

Image3 shade(const Scene& scene, const Camera& camera, const DepthBuffer& depth, const Image<float>& ao,
             const Run& run) {
    return shade(scene, camera, depth, ao, ShadeSettings{}, run);
}

}  // namespace crevice
