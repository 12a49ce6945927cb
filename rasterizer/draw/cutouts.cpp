#include "rasterizer/draw/cutouts.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "rasterizer/draw/texture_coordinates.h"

namespace crevice {

namespace {

void cut_out(const FragmentGroup& group, const Material& material, const InstanceAttributes& instance,
             const Run& run) {
    SampledPixels pixels = {};
    run_narrow_kernel(run, [&]<class F>(Lanes<F>) {
        const Int<F> kept = load<F>(group.kept);
        const Mask<F> asked = kept != Int<F>(0);
        const TrianglePixels<F> in_triangle({&group.triangle, group.block.corners_of(group.triangle)}, asked,
                                            group.x, group.y);
        put_where(asked, texture_pixels(in_triangle, instance), pixels);
        store(pixels.wanted, kept);
    });
    SampledColours sampled;
    const Texture* const texture = material.texture.get();
    sample_textures(std::span(&texture, 1), material.sampler, pixels, &sampled, run);
    for (int i = 0; i < group.lanes; ++i) {
        if (!(sampled.a[i] >= material.alpha_cutoff)) group.kept[i] = 0;
    }
}

}  // namespace

bool has_cutouts(const Material& material) {
    return material.alpha_cutoff > 0 && material.texture != nullptr && material.texture->has_alpha();
}

bool has_cutouts(const Scene& scene) {
    return std::any_of(scene.materials.begin(), scene.materials.end(),
                       [](const Material& m) { return has_cutouts(m); });
}

Holes alpha_holes(const Scene& scene, const ScreenGeometry& geometry, const Run& run) {
    if (!has_cutouts(scene)) return {};
    std::vector<bool> whole;
    for (const Material& material : scene.materials) whole.push_back(!has_cutouts(material));
    // The raster asks for rows of at most eight pixels.
    const auto cut = [&scene, attributes = instance_attributes(scene, geometry),
                      run = narrow(run)](const FragmentGroup& group) {
        const Material& material = scene.materials[static_cast<std::size_t>(group.triangle.material)];
        const InstanceAttributes& instance = attributes[group.triangle.instance];
        if (instance.has_texcoords()) cut_out(group, material, instance, run);
    };
    return {cut, std::move(whole)};
}

}  // namespace crevice
