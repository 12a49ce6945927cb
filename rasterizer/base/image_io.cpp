#include "rasterizer/base/image_io.h"

#include <bit>
#include <charconv>
#include <cmath>
#include <cstring>
#include <optional>
#include <utility>

#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STB_IMAGE_WRITE_STATIC
#define STBI_WRITE_NO_STDIO
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#include <stb/stb_image_write.h>
#pragma GCC diagnostic pop

#include "rasterizer/base/error.h"
#include "rasterizer/base/file_bytes.h"
#include "rasterizer/lanes/approx_math.h"

namespace crevice {

static_assert(std::endian::native == std::endian::little,
              ".npy files are written as the values lie in memory");

namespace {

constexpr std::string_view kMagic = "\x93NUMPY";
constexpr long long kMaxValues = 1LL << 30;

using PlaneList = std::vector<const Image<float>*>;
PlaneList list(const Image<float>& image) { return {&image}; }
PlaneList list(const Image3& image) { return {&image.x, &image.y, &image.z}; }

// The values of one row in file order, x0 y0 z0 x1 ...
std::vector<float> row_values(const PlaneList& planes, int y) {
    std::vector<float> values;
    values.reserve(static_cast<std::size_t>(planes[0]->size.width) * planes.size());
    for (int x = 0; x < planes[0]->size.width; ++x) {
        for (const Image<float>* plane : planes) values.push_back(plane->at(x, y));
    }
    return values;
}

std::string_view bytes_of(const std::vector<float>& values) {
    return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(float)};
}

void check_extent(Size size, int components) {
    const long long values = static_cast<long long>(size.width) * size.height * components;
    if (size.width > 0 && size.height > 0 && values < kMaxValues) return;
    throw OutputError("an image of " + std::to_string(size.width) + "x" + std::to_string(size.height) + "x" +
                      std::to_string(components) +
                      " cannot be stored; give it at least one pixel and fewer than 2^30 values");
}

std::string npy_of(const PlaneList& planes) {
    const Size size = planes[0]->size;
    check_extent(size, static_cast<int>(planes.size()));
    std::string header = "{'descr': '<f4', 'fortran_order': False, 'shape': (" + std::to_string(size.height) +
                         ", " + std::to_string(size.width) + (planes.size() == 3 ? ", 3" : "") + "), }";
    constexpr std::size_t kPrefix = 10, kAlignment = 64;
    while ((kPrefix + header.size() + 1) % kAlignment != 0) header += ' ';
    header += '\n';
    std::string bytes(kMagic);
    bytes += {'\1', '\0', static_cast<char>(header.size() & 0xff), static_cast<char>(header.size() >> 8)};
    bytes += header;
    for (int y = 0; y < size.height; ++y) bytes += bytes_of(row_values(planes, y));
    return bytes;
}

// The text after 'key': in a .npy header, up to the comma that ends it (commas inside brackets do not).
std::optional<std::string_view> header_entry(std::string_view header, const std::string& key) {
    std::size_t begin = header.find("'" + key + "':");
    if (begin == std::string_view::npos) return std::nullopt;
    begin += key.size() + 3;
    while (begin < header.size() && header[begin] == ' ') ++begin;
    std::size_t end = begin;
    for (int depth = 0; end < header.size(); ++end) {
        const char c = header[end];
        if ((c == ',' || c == '}') && depth == 0) break;
        if (c == '(' || c == '[') ++depth;
        if (c == ')' || c == ']') --depth;
    }
    return header.substr(begin, end - begin);
}

// "(H, W)" or "(H, W, 3)" as numbers; nothing when it is not a tuple of them.
std::optional<std::vector<int>> parse_shape(std::string_view text) {
    if (text.size() < 2 || text.front() != '(' || text.back() != ')') return std::nullopt;
    std::vector<int> shape;
    const char* at = text.data() + 1;
    const char* const end = text.data() + text.size() - 1;
    while (at != end) {
        int extent = 0;
        const auto [next, error] = std::from_chars(at, end, extent);
        if (error != std::errc() || extent < 0) return std::nullopt;
        shape.push_back(extent);
        at = next;
        if (at != end && *at++ != ',') return std::nullopt;
        while (at != end && *at == ' ') ++at;
    }
    return shape;
}

Planes planes_from_values(const char* values, Size size, int components) {
    Planes planes(static_cast<std::size_t>(components), Image<float>(size, 0.0f));
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
            for (Image<float>& plane : planes) {
                std::memcpy(&plane.at(x, y), values, sizeof(float));
                values += sizeof(float);
            }
        }
    }
    return planes;
}

}  // namespace

Planes planes_of(Image<float> image) {
    Planes planes;
    planes.push_back(std::move(image));
    return planes;
}

Planes planes_of(Image3 image) {
    Planes planes;
    for (Image<float>* plane : {&image.x, &image.y, &image.z}) planes.push_back(std::move(*plane));
    return planes;
}

std::string npy_bytes(const Image<float>& image) { return npy_of(list(image)); }
std::string npy_bytes(const Image3& image) { return npy_of(list(image)); }
std::string npy_bytes(const Planes& planes) {
    PlaneList all;
    for (const Image<float>& plane : planes) all.push_back(&plane);
    return npy_of(all);
}

void write_npy(const std::filesystem::path& path, const Image<float>& image) {
    write_file_atomically(path, npy_bytes(image));
}
void write_npy(const std::filesystem::path& path, const Image3& image) {
    write_file_atomically(path, npy_bytes(image));
}

Planes planes_from_npy(std::string_view bytes, const std::string& name) {
    const auto fail = [&name](const std::string& what) {
        throw InputError(name + ": " + what + "; give a .npy of '<f4' in C order, shape (H, W) or (H, W, 3)");
    };
    if (bytes.size() < 10 || bytes.substr(0, kMagic.size()) != kMagic) fail("not a .npy file");
    const auto byte = [&bytes](std::size_t at) { return static_cast<unsigned char>(bytes[at]); };
    if (byte(6) != 1 || byte(7) != 0) {
        fail("a .npy of version " + std::to_string(byte(6)) + "." + std::to_string(byte(7)) + ", not 1.0");
    }
    const std::size_t header_size = byte(8) + 256u * byte(9);
    if (bytes.size() < 10 + header_size) fail("cut off inside its header");
    const std::string_view header = bytes.substr(10, header_size);
    const auto entry = [&](const std::string& key) {
        const auto text = header_entry(header, key);
        if (!text) fail("its header has no '" + key + "'");
        return text.value_or("");
    };
    if (entry("descr") != "'<f4'") fail("values of type " + std::string(entry("descr")));
    if (entry("fortran_order") != "False") fail("fortran_order is " + std::string(entry("fortran_order")));
    const auto shape = parse_shape(entry("shape")).value_or(std::vector<int>());
    const bool has_components = shape.size() == 3 && shape[2] == 3;
    const bool known = (shape.size() == 2 || has_components) && shape[0] > 0 && shape[1] > 0;
    const int components = has_components ? 3 : 1;
    if (!known || static_cast<long long>(shape[0]) * shape[1] >= kMaxValues / components) {
        fail("shape is " + std::string(entry("shape")));
    }
    const Size size{shape[1], shape[0]};
    const std::size_t expected = sizeof(float) * static_cast<std::size_t>(size.width) *
                                 static_cast<std::size_t>(size.height) * static_cast<std::size_t>(components);
    const std::string_view values = bytes.substr(10 + header_size);
    if (values.size() != expected) {
        fail("holds " + std::to_string(values.size()) + " bytes of values where its shape needs " +
             std::to_string(expected));
    }
    return planes_from_values(values.data(), size, components);
}

Planes read_npy(const std::filesystem::path& path) {
    constexpr std::uintmax_t kMaxHeader = 10 + 65535;
    return planes_from_npy(read_file(path, kMaxHeader + sizeof(float) * kMaxValues), path.string());
}

std::string png_bytes(Size size, int channels, std::span<const std::uint8_t> pixels) {
    check_extent(size, channels);
    const std::size_t row_bytes = static_cast<std::size_t>(size.width) * static_cast<std::size_t>(channels);
    if ((channels != 1 && channels != 3) || size.width > kMaxPngSide || size.height > kMaxPngSide ||
        pixels.size() != row_bytes * static_cast<std::size_t>(size.height)) {
        throw OutputError("a picture of " + std::to_string(size.width) + "x" + std::to_string(size.height) +
                          "x" + std::to_string(channels) + " in " + std::to_string(pixels.size()) +
                          " bytes cannot be a PNG; give 1 or 3 channels and sides of at most " +
                          std::to_string(kMaxPngSide));
    }
    std::string bytes;
    const auto append = [](void* context, void* block, int count) {
        static_cast<std::string*>(context)->append(static_cast<const char*>(block),
                                                   static_cast<std::size_t>(count));
    };
    if (stbi_write_png_to_func(append, &bytes, size.width, size.height, channels, pixels.data(),
                               static_cast<int>(row_bytes)) == 0) {
        throw OutputError("a picture could not be encoded as PNG; there may be too little memory");
    }
    return bytes;
}

void write_png(const std::filesystem::path& path, Size size, int channels,
               std::span<const std::uint8_t> pixels) {
    write_file_atomically(path, png_bytes(size, channels, pixels));
}

}  // namespace crevice
