#include "chapters/study/reference_cache.h"

#include <array>
#include <system_error>
#include <utility>

#include "rasterizer/base/error.h"
#include "rasterizer/base/file_bytes.h"
#include "rasterizer/base/image_io.h"
#include "rasterizer/base/write_file.h"

namespace crevice {

namespace {

// The four images of a reference, in the order in which they are stored. Their checksum is stored last: a set is whole
// when that is there.
constexpr const char* kParts[] = {"half_1", "half_2", "error", "mean"};
constexpr std::size_t kPartCount = 4;
constexpr std::uintmax_t kMostChecksumBytes = 64;

std::array<const Image<float>*, kPartCount> parts_of(const ReferenceImage& image) {
    return {&image.half[0], &image.half[1], &image.error, &image.mean};
}

std::filesystem::path part_path(const std::filesystem::path& cache, const std::string& name,
                                std::size_t part) {
    return cache / (name + "-" + kParts[part] + ".npy");
}

std::filesystem::path checksum_path(const std::filesystem::path& cache, const std::string& name) {
    return cache / (name + "-checksum.txt");
}

// Of the pixels, as they are in memory.
std::string checksum_of(const ReferenceImage& image) {
    ContentKey key;
    for (const Image<float>* part : parts_of(image)) key.add_image(*part);
    return key.hex() + "\n";
}

}  // namespace

void ContentKey::add_bytes(std::span<const std::byte> bytes) {
    for (const std::byte b : bytes) hash_.add(static_cast<std::uint8_t>(b));
}

void ContentKey::add_image(const Image<float>& image) {
    add(image.size.width);
    add(image.size.height);
    for (int y = 0; y < image.size.height; ++y)
        add_bytes(std::as_bytes(std::span(image.row(y), static_cast<std::size_t>(image.size.width))));
}

void add_cutout(ContentKey& key, const Material& material) {
    key.add(material.alpha_cutoff);
    if (!(material.alpha_cutoff > 0) || material.texture == nullptr) return;
    for (std::size_t level = 0; level < material.texture->levels().size(); ++level)
        key.add_image(material.texture->alpha(level));
    const Sampler& sampler = material.sampler;
    key.add(sampler.filter);
    key.add(sampler.max_anisotropy);
    key.add(sampler.address_u);
    key.add(sampler.address_v);
    key.add(sampler.border);
}

FoundReference find_reference(const std::filesystem::path& cache, const std::string& name, Size size) {
    const std::filesystem::path checksum = checksum_path(cache, name);
    std::error_code none;
    if (!std::filesystem::is_regular_file(checksum, none)) return {};
    const auto damaged = [](const std::filesystem::path& path, const std::string& what) {
        return FoundReference{
            {}, path.string() + ": this reference in the cache is damaged (" + what + "); made anew"};
    };
    Image<float> found[kPartCount];
    for (std::size_t part = 0; part < kPartCount; ++part) {
        const std::filesystem::path path = part_path(cache, name, part);
        try {
            Planes planes = read_npy(path);
            if (planes.size() != 1 || planes[0].size != size) return damaged(path, "of another size");
            found[part] = std::move(planes[0]);
        } catch (const InputError&) {
            return damaged(path, "it cannot be read");
        }
    }
    ReferenceImage image{
        std::move(found[3]), std::move(found[2]), {std::move(found[0]), std::move(found[1])}};
    std::string stored;
    try {
        stored = read_file(checksum, kMostChecksumBytes);
    } catch (const InputError&) {
        return damaged(checksum, "it cannot be read");
    }
    if (stored != checksum_of(image)) return damaged(checksum, "the images are not those it was taken of");
    return {std::move(image), {}};
}

void store_reference(const std::filesystem::path& cache, const std::string& name,
                     const ReferenceImage& image) {
    std::error_code error;
    std::filesystem::create_directories(cache, error);
    if (error)
        throw OutputError(cache.string() + ": cannot make this directory (" + error.message() +
                          "); choose another --cache, or --no-cache");
    const auto parts = parts_of(image);
    for (std::size_t part = 0; part < kPartCount; ++part)
        write_npy(part_path(cache, name, part), *parts[part]);
    write_file_atomically(checksum_path(cache, name), checksum_of(image));
}

}  // namespace crevice
