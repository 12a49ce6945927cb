#include "rasterizer/base/image_summary.h"

#include <limits>
#include <set>

#include <doctest/doctest.h>

#include "rasterizer/base/image_io.h"
#include "rasterizer/lanes/wide.h"

using namespace crevice;

namespace {

// FNV-1a 64 by its definition, over bytes.
std::uint64_t fnv1a(std::uint64_t hash, std::string_view bytes) {
    for (const char byte : bytes) hash = (hash ^ static_cast<unsigned char>(byte)) * 1099511628211u;
    return hash;
}

}  // namespace

TEST_CASE("content_hash is FNV-1a over size, components and the values of the .npy") {
    REQUIRE(fnv1a(14695981039346656037u, "a") == 0xaf63dc4c8601ec8cu);  // published test vector
    Image<float> image({3, 2}, 0.25f);
    image.at(2, 1) = -0.0f;
    std::uint64_t hash = fnv1a(14695981039346656037u, std::string_view("\3\0\0\0\2\0\0\0\1\0\0\0", 12));
    hash = fnv1a(hash, npy_bytes(image).substr(128));
    CHECK(std::stoull(content_hash(image), nullptr, 16) == hash);
    CHECK(content_hash(image).size() == 16);

    const Image3 colour({2, 1}, {1, 2, 3});
    hash = fnv1a(14695981039346656037u, std::string_view("\2\0\0\0\1\0\0\0\3\0\0\0", 12));
    hash = fnv1a(hash, npy_bytes(colour).substr(128));
    CHECK(std::stoull(content_hash(colour), nullptr, 16) == hash);
}

TEST_CASE("content_hash sees every bit and the shape, but no padding") {
    const Image<float> image({3, 4}, 0.0f);
    std::set<std::string> hashes = {content_hash(image)};
    for (const float value :
         {-0.0f, 1e-45f, 1.0f, float_from_bits(0x7fc00000), float_from_bits(0x7fc00001)}) {
        Image<float> changed = image;
        changed.at(1, 2) = value;
        CAPTURE(float_bits(value));
        CHECK(hashes.insert(content_hash(changed)).second);
    }
    CHECK(hashes.insert(content_hash(Image<float>({4, 3}, 0.0f))).second);
    CHECK(hashes.insert(content_hash(Image<float>({12, 1}, 0.0f))).second);
    CHECK(hashes.insert(content_hash(Image3({4, 1}, {0, 0, 0}))).second);

    Image<float> padded = image;
    for (int y = 0; y < 4; ++y) {
        for (int x = 3; x < padded.stride; ++x) padded.row(y)[x] = 99;
    }
    CHECK(content_hash(padded) == content_hash(image));
}

TEST_CASE("buffer_statistics counts what is not finite and takes the rest") {
    const float infinity = std::numeric_limits<float>::infinity();
    Image<float> image({5, 1}, 7.0f);
    const float values[] = {2.0f, infinity, -1.0f, std::numeric_limits<float>::quiet_NaN(), 0.5f};
    for (int x = 0; x < 5; ++x) image.at(x, 0) = values[x];
    const BufferStatistics statistics = buffer_statistics(image);
    CHECK(statistics.min == -1.0f);
    CHECK(statistics.max == 2.0f);
    CHECK(statistics.mean == 0.5);
    CHECK(statistics.finite == 3);
    CHECK(statistics.nan == 1);
    CHECK(statistics.inf == 1);

    const BufferStatistics background = buffer_statistics(Image<float>({2, 2}, infinity));
    CHECK(background.finite == 0);
    CHECK(background.inf == 4);
    CHECK(background.min == 0);
    CHECK(background.mean == 0);

    const BufferStatistics pooled = buffer_statistics(Image3({3, 3}, {-1, 0, 4}));
    CHECK(pooled.min == -1);
    CHECK(pooled.max == 4);
    CHECK(pooled.mean == 1);
    CHECK(pooled.finite == 27);
}
