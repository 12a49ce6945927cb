#include "chapters/compare/compared_image.h"

#include <algorithm>
#include <cctype>
#include <ostream>
#include <utility>

#include "chapters/images/exr.h"
#include "chapters/images/pfm.h"
#include "chapters/images/tiff.h"
#include "rasterizer/base/error.h"
#include "rasterizer/base/file_bytes.h"
#include "rasterizer/textures/image_file.h"

namespace crevice {

namespace fs = std::filesystem;

namespace {

constexpr std::uintmax_t kMaxFile = std::uintmax_t{1} << 34;

// In small letters, whatever the disk says.
std::string extension_of(const fs::path& path) {
    std::string extension = path.extension().string();
    for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return extension;
}

ComparedImage of_npy(const fs::path& path, std::ostream& warnings) {
    NpyImage image = read_npy_image(path);
    if (image.rounded > 0)
        warnings << "warning: " << path.string() << ": " << image.rounded
                 << " of its values are doubles that no float holds; the nearest floats are compared\n";
    return {.planes = std::move(image.planes)};
}

ComparedImage of_png(const fs::path& path) {
    ImageCodes codes = read_png(path);
    return {.planes = planes_of(std::move(codes.colour)),
            .alpha = std::move(codes.alpha),
            .linear = codes.linear,
            .picture = true};
}

ComparedImage of_tiff(const fs::path& path) {
    TiffImage image = tiff_image(read_file(path, kMaxFile), path.string());
    return {.planes = std::move(image.planes),
            .alpha = std::move(image.alpha),
            .linear = image.linear,
            .picture = true};
}

std::vector<ComparedImage> of_exr(const fs::path& path) {
    std::vector<ComparedImage> images;
    for (ExrLayer& layer : exr_layers(read_file(path, kMaxFile), path.string()))
        images.push_back({.layer = std::move(layer.name),
                          .planes = std::move(layer.planes),
                          .alpha = std::move(layer.alpha),
                          .light = layer.colour});
    return images;
}

}  // namespace

std::vector<ComparedImage> compared_images(const fs::path& path, std::ostream& warnings) {
    const std::string extension = extension_of(path);
    if (extension == ".npy") return {of_npy(path, warnings)};
    if (extension == ".pfm") return {{.planes = planes_from_pfm(read_file(path, kMaxFile), path.string())}};
    if (extension == ".png") return {of_png(path)};
    if (extension == ".tif" || extension == ".tiff") return {of_tiff(path)};
    if (extension == ".exr") return of_exr(path);
    throw InputError(path.string() + ": not an image that can be compared (" + extension + "); give " +
                     kComparedKinds);
}

bool is_compared_kind(const fs::path& path) {
    const char* const kinds[] = {".npy", ".pfm", ".png", ".tif", ".tiff", ".exr"};
    return std::ranges::find(kinds, extension_of(path)) != std::end(kinds);
}

bool is_layered_kind(const fs::path& path) { return extension_of(path) == ".exr"; }

}  // namespace crevice
