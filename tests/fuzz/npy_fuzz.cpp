// NumPy arrays.
#include "rasterizer/base/image_io.h"
#include "tests/fuzz/fuzzing.h"

using namespace crevice;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    refused_or_read([&] { npy_image(bytes_of(data, size), "a.npy"); });
    return 0;
}
