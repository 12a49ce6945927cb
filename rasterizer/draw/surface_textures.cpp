#include "rasterizer/draw/surface_textures.h"

#include <algorithm>

#include "rasterizer/draw/view_ray.h"
#include "rasterizer/scene/tangents.h"

namespace crevice {

namespace {

// What the colour of a normal map means: RGB = n / 2 + 1/2 with red along +u and green along +v, which is
// down the picture (Direct3D's way); alpha multiplies the shininess (Luna). (0, 0, 1) where the filter
// has averaged all direction away.
template <class F>
CREVICE_INLINE Vec3<F> n_tangent_of(const SampledColours& map) {
    const Vec3<F> one{F(1), F(1), F(1)};
    return normalize_or<F>(F(2) * Vec3<F>{load<F>(map.r), load<F>(map.g), load<F>(map.b)} - one,
                           {F(0), F(0), F(1)});
}

// The normal that pixels show: interpolated from the vertices, bent by the normal map; view space, unit. On a back
// face whose normal was turned to the eye the bitangent stays where it was: the picture painted on a surface does
// not turn with its normal.
template <class F, bool kAlike>
CREVICE_INLINE Vec3<F> bent_normal(const ScreenGeometry& geometry, const TriangleLanes<F, kAlike>& triangles,
                                   const std::vector<InstanceAttributes>& attributes, int x, int y,
                                   Vec3<F> n_tangent) {
    const auto tangent_at = [&](std::size_t corner) __attribute__((always_inline)) {
        return triangles.each_vec3([&](const ScreenTriangle& t) {
            const InstanceAttributes& instance = attributes[t.instance];
            return instance.has_tangents() ? geometry.tangent_turns[t.instance].view_from_object *
                                                 glm::vec3(instance.tangent(t, corner))
                                           : glm::vec3(0);
        });
    };
    const auto handedness_at = [&](std::size_t corner) __attribute__((always_inline)) {
        return triangles.each([&](const ScreenTriangle& t) {
            const InstanceAttributes& instance = attributes[t.instance];
            return instance.has_tangents() ? instance.tangent(t, corner).w : 0.0f;
        });
    };
    const Vec3<F> tangent = triangles.here().interpolate(tangent_at(0), tangent_at(1), tangent_at(2));
    const F mirrored = triangles.each(
        [&](const ScreenTriangle& t) { return geometry.tangent_turns[t.instance].handedness; });
    const F handedness =
        mirrored * triangles.here().interpolate(handedness_at(0), handedness_at(1), handedness_at(2));
    const auto [n, turned] =
        triangles.interpolated_normal(geometry.vertices.n_view, view_ray_at<F>(geometry, x, y));
    const Vec3<F> zero{F(0), F(0), F(0)};
    const Vec3<F> bent = bumped_normal(normalize_or<F>(n, zero), tangent,
                                       select(turned, F(0) - handedness, handedness), n_tangent);
    // Once more, like every interpolated normal: the goldens hold these bits.
    return normalize_or<F>(bent, zero);
}

template <class F>
CREVICE_INLINE void put_where(float* at, Mask<F> where, F value) {
    if (at != nullptr) store(at, select(where, value, load<F>(at)));
}
template <class F>
CREVICE_INLINE void put_where(float* const (&row)[3], int at, Mask<F> where, Vec3<F> value) {
    if (row[0] == nullptr) return;
    put_where(row[0] + at, where, value.x);
    put_where(row[1] + at, where, value.y);
    put_where(row[2] + at, where, value.z);
}

// One group of pixels.
template <class F, bool kAlike>
struct GroupLookup {
    const Scene& scene;
    const ScreenGeometry& geometry;
    const std::vector<InstanceAttributes>& attributes;
    const TriangleLanes<F, kAlike>& triangles;
    const TextureRow& row;
    const int x, y, at;  // `at`: in the row
    const Run& run;

    // One material after the other, until every lane has had its own.
    CREVICE_INLINE void look_up() const {
        SampledPixels pixels;
        find_coordinates(triangles, attributes, pixels);
        const Mask<F> has_texcoords =
            lanes_where([](const InstanceAttributes& i) { return i.has_texcoords(); });
        const Int<F> material = load<F>(row.material + at);
        Mask<F> left = triangles.shown & has_texcoords;
        while (any(left)) {
            const std::int32_t index = largest_of(select(left, material, Int<F>(kNoTriangle)));
            const Mask<F> lanes = left & (material == Int<F>(index));
            store(pixels.wanted, select(lanes, Int<F>(-1), Int<F>(0)));
            look_up_material(scene.materials[static_cast<std::size_t>(index)], lanes, pixels);
            left = left & !lanes;
        }
    }

    CREVICE_INLINE void look_up_material(const Material& material, Mask<F> lanes,
                                         const SampledPixels& pixels) const {
        const Texture* wanted[2];
        std::size_t count = 0;
        const bool coloured = material.texture != nullptr && row.colour[0] != nullptr;
        const bool mapped = material.normal_map != nullptr && row.normal[0] != nullptr;
        if (coloured) wanted[count++] = material.texture.get();
        if (mapped) wanted[count++] = material.normal_map.get();
        if (count == 0) return;
        SampledColours sampled[2];
        sample_textures(std::span(wanted, count), material.sampler, pixels, sampled, run);
        if (coloured) {
            put_where<F>(row.colour, at, lanes,
                         {load<F>(sampled[0].r), load<F>(sampled[0].g), load<F>(sampled[0].b)});
        }
        if (!mapped) return;
        const SampledColours& map = sampled[count - 1];
        const Mask<F> bent =
            lanes & lanes_where([](const InstanceAttributes& i) { return i.has_tangents(); });
        if (!any(bent)) return;
        put_where<F>(row.normal, at, bent,
                     bent_normal<F>(geometry, triangles, attributes, x, y, n_tangent_of<F>(map)));
        put_where<F>(row.gloss == nullptr ? nullptr : row.gloss + at, bent, load<F>(map.a));
    }

    template <class Holds>
    CREVICE_INLINE Mask<F> lanes_where(const Holds& holds) const {
        return triangles.each([&](const ScreenTriangle& t) { return holds(attributes[t.instance]); }) !=
               Int<F>(0);
    }
};

}  // namespace

std::vector<InstanceAttributes> instance_attributes(const Scene& scene, const ScreenGeometry& geometry) {
    std::vector<InstanceAttributes> attributes;
    for (std::size_t i = 0; i < scene.instances.size(); ++i) {
        const Mesh& mesh = scene.meshes[static_cast<std::size_t>(scene.instances[i].mesh)];
        attributes.push_back({&mesh, geometry.vertices.first_vertex[i]});
    }
    return attributes;
}

SurfaceTextures::SurfaceTextures(const Scene& scene, const ScreenGeometry& geometry)
    : scene_(scene), geometry_(geometry), attributes_(instance_attributes(scene, geometry)) {
    for (const Material& m : scene.materials)
        textured_.push_back(m.texture != nullptr || m.normal_map != nullptr);
}

bool SurfaceTextures::any() const {
    return std::find(textured_.begin(), textured_.end(), true) != textured_.end();
}

void SurfaceTextures::look_up(const std::int32_t* triangle, int x0, int x1, int y, const TextureRow& row,
                              const Run& run) const {
    const int padded = round_up(x1 - x0, kRowAlignment);
    for (float* const plane : {row.colour[0], row.colour[1], row.colour[2], row.gloss}) {
        if (plane != nullptr) std::fill(plane, plane + padded, 1.0f);
    }
    run_kernel(run, [&]<class F>(Lanes<F>) {
        for (int x = x0; x < x1; x += kLanes<F>) {
            const int at = x - x0;
            const bool textured =
                std::any_of(row.material + at, row.material + at + kLanes<F>,
                            [&](std::int32_t m) { return m >= 0 && textured_[static_cast<std::size_t>(m)]; });
            if (!textured) continue;
            with_triangles<F>(
                geometry_, load<F>(triangle + at), x, y,
                [&]<bool kAlike>(const TriangleLanes<F, kAlike>& triangles) __attribute__((always_inline)) {
                    GroupLookup<F, kAlike>{scene_, geometry_, attributes_, triangles, row, x, y, at, run}
                        .look_up();
                });
        }
    });
}

}  // namespace crevice
