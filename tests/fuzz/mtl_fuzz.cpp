// MTL files.
#include "rasterizer/obj/mtl_read.h"
#include "tests/fuzz/fuzzing.h"

using namespace crevice;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    refused_or_read([&] { read_mtl(bytes_of(data, size), "a.mtl"); });
    return 0;
}
