// OBJ files, with the materials of seeds/mtl beside them.
#include <fstream>

#include "rasterizer/obj/obj_load.h"
#include "tests/fuzz/fuzzing.h"
#include "tests/tools/scratch_directory.h"

using namespace crevice;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const ScratchDirectory scratch;
    static const bool has_materials = [] {
        std::ofstream(scratch / "a.mtl") << "newmtl a\nKd 1 0 0\nmap_Kd -s 2 2 none.png\nnewmtl b\nd 0\n";
        return true;
    }();
    std::ofstream(scratch / "a.obj", std::ios::binary) << bytes_of(data, size);
    refused_or_read([&] {
        const LoadedObj loaded = load_obj(scratch / "a.obj", {.crease_angle_rad = has_materials ? 1.0 : 0.0});
        validate(loaded.scene.camera);
    });
    return 0;
}
