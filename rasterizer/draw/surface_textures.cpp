#include "rasterizer/draw/surface_textures.h"

#include <algorithm>

#include "rasterizer/base/image.h"
#include "rasterizer/draw/triangle_pixels.h"
#include "rasterizer/scene/tangents.h"

namespace crevice {

namespace {

// What a normal map's values are measured along, as the vertices of the triangles say. View space.
template <class F>
struct NormalMapFrame {
    Vec3<F> n, tangent;  // of any length
    F handedness;        // of which the sign counts
};
// On a back face, whose normal is turned, the bitangent stays where it was: the picture painted on a surface does not
// turn with its normal.
template <class F>
CREVICE_INLINE NormalMapFrame<F> normal_map_frame(const ScreenGeometry& geometry,
                                                  const TrianglePixels<F>& pixels,
                                                  const InstanceAttributes& instance) {
    const ScreenTriangle& t = pixels.triangle;
    const TangentTurn& turn = geometry.tangent_turns[t.instance];
    const glm::vec4 &t0 = instance.tangent(t, 0), &t1 = instance.tangent(t, 1), &t2 = instance.tangent(t, 2);
    const glm::mat3& m = turn.view_from_object;
    const float side = t.shows_back ? -turn.handedness : turn.handedness;
    return {pixels.interpolated_normal(geometry),
            pixels.here.interpolate(m * glm::vec3(t0), m * glm::vec3(t1), m * glm::vec3(t2)),
            F(side) * pixels.here.interpolate(t0.w, t1.w, t2.w)};
}
template <class F>
CREVICE_INLINE NormalMapFrame<F> either(Mask<F> m, const NormalMapFrame<F>& a, const NormalMapFrame<F>& b) {
    return {select<F>(m, a.n, b.n), select<F>(m, a.tangent, b.tangent),
            select(m, a.handedness, b.handedness)};
}

// The normal that pixels show: of the frame, bent by the normal map; view space, unit.
template <class F>
CREVICE_INLINE Vec3<F> bent_normal(const NormalMapFrame<F>& frame, Vec3<F> n_tangent) {
    const Vec3<F> zero{F(0), F(0), F(0)};
    const Vec3<F> bent =
        bumped_normal(normalize_or<F>(frame.n, zero), frame.tangent, frame.handedness, n_tangent);
    // Once more, like every interpolated normal: the goldens hold these bits.
    return normalize_or<F>(bent, zero);
}

template <class F>
CREVICE_INLINE void put_where(float* at, Mask<F> where, F value) {
    store(at, select(where, value, load<F>(at)));
}
template <class F>
CREVICE_INLINE void put_where(float* const (&row)[3], int at, Mask<F> where, Vec3<F> value) {
    put_where(row[0] + at, where, value.x);
    put_where(row[1] + at, where, value.y);
    put_where(row[2] + at, where, value.z);
}

// One group of pixels.
template <class F>
struct GroupLookup {
    const Scene& scene;
    const ScreenGeometry& geometry;
    const std::vector<InstanceAttributes>& attributes;
    const TextureRow& row;
    const Int<F> numbers;
    const int x, y, at;  // `at`: in the row
    const Run& run;

    // What the triangles of the group say: each is looked at once.
    struct Found {
        SampledPixels pixels = {};
        Mask<F> has_texcoords, has_frame;
        NormalMapFrame<F> frame;
    };

    // One material after the other, until every pixel that has texture coordinates has had its own.
    CREVICE_INLINE void look_up() const {
        const Int<F> material = load<F>(row.material + at);
        Found found;
        find(found);
        for (Mask<F> left = found.has_texcoords; any(left);) {
            const std::int32_t index = largest_of(select(left, material, Int<F>(kNoTriangle)));
            const Mask<F> lanes = left & (material == Int<F>(index));
            store(found.pixels.wanted, select(lanes, Int<F>(-1), Int<F>(0)));
            look_up_material(scene.materials[static_cast<std::size_t>(index)], lanes, found);
            left = left & !lanes;
        }
    }

    CREVICE_INLINE bool is_mapped(const Material& material) const {
        return material.normal_map != nullptr && row.normal[0] != nullptr;
    }

    CREVICE_INLINE void find(Found& found) const {
        const F zero(0);
        found.has_texcoords = found.has_frame = zero > zero;
        found.frame = {{zero, zero, zero}, {zero, zero, zero}, zero};
        for (TriangleWalk<F> walk(numbers); walk.next();) {
            const TrianglePixels<F> in(geometry.triangle(walk.number), walk.shown, x, y);
            const InstanceAttributes& instance = attributes[in.triangle.instance];
            if (!instance.has_texcoords()) continue;
            put_where(in.shown, texture_pixels(in, instance), found.pixels);
            found.has_texcoords = found.has_texcoords | in.shown;
            const Material& material = scene.materials[static_cast<std::size_t>(in.triangle.material)];
            if (!instance.has_tangents() || !is_mapped(material)) continue;
            found.frame = either<F>(in.shown, normal_map_frame(geometry, in, instance), found.frame);
            found.has_frame = found.has_frame | in.shown;
        }
    }

    CREVICE_INLINE void look_up_material(const Material& material, Mask<F> lanes, const Found& found) const {
        const Texture* wanted[2];
        std::size_t count = 0;
        const bool coloured = material.texture != nullptr && row.colour[0] != nullptr;
        const bool mapped = is_mapped(material);
        if (coloured) wanted[count++] = material.texture.get();
        if (mapped) wanted[count++] = material.normal_map.get();
        if (count == 0) return;
        SampledColours sampled[2];
        sample_textures(std::span(wanted, count), material.sampler, found.pixels, sampled, run);
        if (coloured) {
            put_where<F>(row.colour, at, lanes,
                         {load<F>(sampled[0].r), load<F>(sampled[0].g), load<F>(sampled[0].b)});
        }
        if (!mapped) return;
        const SampledColours& map = sampled[count - 1];
        const Vec3<F> n_tangent = mapped_normal<F>({load<F>(map.r), load<F>(map.g), load<F>(map.b)});
        const Mask<F> bent = lanes & found.has_frame;
        put_where<F>(row.normal, at, bent, bent_normal(found.frame, n_tangent));
        if (row.gloss != nullptr) put_where<F>(row.gloss + at, bent, load<F>(map.a));
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
        if (plane != nullptr) fill_groups(plane, plane + padded, 1.0f);
    }
    run_kernel(run, [&]<class F>(Lanes<F>) {
        for (int x = x0; x < x1; x += kLanes<F>) {
            const int at = x - x0;
            const bool textured =
                std::any_of(row.material + at, row.material + at + kLanes<F>,
                            [&](std::int32_t m) { return m >= 0 && textured_[static_cast<std::size_t>(m)]; });
            if (!textured) continue;
            GroupLookup<F>{scene_, geometry_, attributes_, row, load<F>(triangle + at), x, y, at, run}
                .look_up();
        }
    });
}

}  // namespace crevice
