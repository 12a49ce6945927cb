// Ambient occlusion of an OBJ file as a grey picture: occlusion_of_obj MESH.obj PICTURE.png
#include <cstdint>
#include <iostream>
#include <vector>

#include <crevice/rasterizer/base/error.h>
#include <crevice/rasterizer/base/image_io.h>
#include <crevice/rasterizer/draw/normal_depth.h>
#include <crevice/rasterizer/obj/obj_load.h>
#include <crevice/ssao/methods/luna_ssao.h>

int main(int argc, char** argv) try {
    if (argc != 3) throw crevice::UsageError("write occlusion_of_obj MESH.obj PICTURE.png");
    const crevice::Scene scene = crevice::load_obj(argv[1]).scene;  // framed by a camera
    crevice::LunaSettings settings = crevice::kLunaSettings;  // lengths for a scene about ten units large
    for (float* length : {&settings.radius, &settings.fade_start, &settings.fade_end, &settings.epsilon})
        *length *= scene.length_unit;

    const crevice::GBuffer gbuffer = crevice::normal_depth(scene, scene.camera, {1280, 720});
    const crevice::Image<float> ao = crevice::luna_ssao(gbuffer, scene.camera, settings).ao;

    std::vector<std::uint8_t> grey;  // 1 is open, 0 closed
    for (int y = 0; y < ao.size.height; ++y) {
        for (int x = 0; x < ao.size.width; ++x)
            grey.push_back(static_cast<std::uint8_t>(255 * ao.at(x, y) + 0.5f));
    }
    crevice::write_png(argv[2], ao.size, 1, grey);
    return 0;
} catch (const crevice::Error& error) {
    std::cerr << error.what() << "\n";
    return static_cast<int>(error.code);
}
