#include "rasterizer/draw/vertex_colours.h"

#include <algorithm>

#include "rasterizer/draw/triangle_pixels.h"

namespace crevice {

bool has_vertex_colours(const Scene& scene) {
    return std::any_of(scene.meshes.begin(), scene.meshes.end(),
                       [](const Mesh& mesh) { return !mesh.colours.empty(); });
}

VertexColours::VertexColours(const Scene& scene, const ScreenGeometry& geometry)
    : geometry_(geometry),
      attributes_(instance_attributes(scene, geometry)),
      any_(has_vertex_colours(scene)) {}

void VertexColours::multiply(const std::int32_t* triangle, int x0, int x1, int y, float* const (&colour)[3],
                             const Run& run) const {
    run_kernel(run, [&]<class F>(Lanes<F>) {
        for (int x = x0; x < x1; x += kLanes<F>) {
            const int at = x - x0;
            for (TriangleWalk<F> walk(load<F>(triangle + at)); walk.next();) {
                const TrianglePixels<F> in(geometry_.triangle(walk.number), walk.shown, x, y);
                const InstanceAttributes& instance = attributes_[in.triangle.instance];
                const std::vector<glm::vec3>& colours = instance.mesh->colours;
                if (colours.empty()) continue;
                const auto corner = [&](std::size_t i) -> const glm::vec3& {
                    return colours[in.triangle.vertex[i] - instance.first_vertex];
                };
                const Vec3<F> here = in.here.interpolate(corner(0), corner(1), corner(2));
                const auto scale = [&](float* row, F factor) __attribute__((always_inline)) {
                    store(row + at, load<F>(row + at) * select(in.shown, factor, F(1)));
                };
                scale(colour[0], here.x);
                scale(colour[1], here.y);
                scale(colour[2], here.z);
            }
        }
    });
}

}  // namespace crevice
