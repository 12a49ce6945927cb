#include "chapters/study/reference_cache.h"

#include "rasterizer/base/error.h"
#include "rasterizer/base/image_io.h"

namespace crevice {

namespace {

// The four images of a reference, in the order in which they are stored: a set is whole when the last is there.
constexpr const char* kParts[] = {"half_1", "half_2", "error", "mean"};

std::filesystem::path part_path(const std::filesystem::path& cache, const std::string& name, int part) {
    return cache / (name + "-" + kParts[part] + ".npy");
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

std::optional<ReferenceImage> find_reference(const std::filesystem::path& cache, const std::string& name,
                                             Size size) {
    Image<float> found[4];
    for (int part = 0; part < 4; ++part) {
        const std::filesystem::path path = part_path(cache, name, part);
        std::error_code none;
        if (!std::filesystem::is_regular_file(path, none)) return std::nullopt;
        try {
            Planes planes = read_npy(path);
            if (planes.size() != 1 || planes[0].size != size) return std::nullopt;
            found[part] = std::move(planes[0]);
        } catch (const InputError&) {
            return std::nullopt;
        }
    }
    return ReferenceImage{
        std::move(found[3]), std::move(found[2]), {std::move(found[0]), std::move(found[1])}};
}

void store_reference(const std::filesystem::path& cache, const std::string& name,
                     const ReferenceImage& image) {
    std::error_code error;
    std::filesystem::create_directories(cache, error);
    if (error)
        throw OutputError(cache.string() + ": cannot make this directory (" + error.message() +
                          "); choose another --cache, or --no-cache");
    const Image<float>* const parts[] = {&image.half[0], &image.half[1], &image.error, &image.mean};
    for (int part = 0; part < 4; ++part) write_npy(part_path(cache, name, part), *parts[part]);
}

}  // namespace crevice
