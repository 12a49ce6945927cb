// The lab's ambient occlusion of buffers that another renderer drew, to hold that renderer's own pass against:
//   ao_of_buffers NORMAL.npy VIEW_DEPTH.npy FOV_Y_DEGREES AO.npy
// Shapes (H, W, 3) and (H, W), float32, row 0 = top; view space left-handed, depth +inf where no surface is, as
// `crevice render` writes them. AO.npy has half the size: 1 is open, 0 closed.
#include <cstdlib>
#include <iostream>

#include <crevice/rasterizer/base/error.h>
#include <crevice/rasterizer/base/image_io.h>
#include <crevice/rasterizer/draw/own_buffers.h>
#include <crevice/rasterizer/lanes/approx_math.h>
#include <crevice/ssao/methods/xjun_ssao.h>

int main(int argc, char** argv) try {
    if (argc != 5)
        throw crevice::UsageError("write ao_of_buffers NORMAL.npy VIEW_DEPTH.npy FOV_Y_DEGREES AO.npy");
    const crevice::Planes components = crevice::read_npy(argv[1]), view_depth = crevice::read_npy(argv[2]);
    if (components.size() != 3 || view_depth.size() != 1)
        throw crevice::InputError(
            "normals have three components, depths have one; give files of these shapes");
    crevice::Image3 normal;
    normal.x = components[0], normal.y = components[1], normal.z = components[2];
    crevice::Camera camera;  // near 1, far 1000; where it stands does not matter
    camera.fov_y_rad = crevice::radians(std::atof(argv[3]));

    const crevice::GBuffer gbuffer = crevice::gbuffer_of(normal, view_depth[0], camera);
    const crevice::LunaSettings settings =
        crevice::kXjunSettings;  // lengths for a scene about ten units large
    crevice::write_npy(argv[4], crevice::xjun_ssao(gbuffer, camera, settings).ao);
    return 0;
} catch (const crevice::Error& error) {
    std::cerr << error.what() << "\n";
    return static_cast<int>(error.code);
}
