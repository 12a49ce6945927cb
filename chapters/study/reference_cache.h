// Reference images on disk, under the hash of what they were made from.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "rasterizer/base/fnv1a.h"
#include "rasterizer/scene/scene.h"
#include "ssao/judge/reference_image.h"

namespace crevice {

// The hash of whatever is added. Plain values only: no pointers, no padding.
class ContentKey {
 public:
    void add_bytes(std::span<const std::byte> bytes);
    template <class T>
    void add(const T& value) {
        add_bytes(std::as_bytes(std::span(&value, 1)));
    }
    template <class Values>  // a vector or a span
    void add_all(const Values& values) {
        add(values.size());
        add_bytes(std::as_bytes(std::span(values)));
    }
    // The pixels, without the padding of rows.
    void add_image(const Image<float>& image);

    std::string hex() const { return hash_.hex(); }

 private:
    Fnv1a hash_;
};

// What of a material decides where its triangles have holes; no more where it cuts nothing out.
void add_cutout(ContentKey& key, const Material& material);

// What was stored as `name`.
struct FoundReference {
    std::optional<ReferenceImage> image;  // none: it was not there, or is damaged
    std::string damage;                   // one line on what is wrong with what is there; empty: nothing is
};
// The images are believed only where their checksum, which was stored behind them, says that they are those that were stored.
FoundReference find_reference(const std::filesystem::path& cache, const std::string& name, Size size);
// Throws OutputError.
void store_reference(const std::filesystem::path& cache, const std::string& name,
                     const ReferenceImage& image);

}  // namespace crevice
