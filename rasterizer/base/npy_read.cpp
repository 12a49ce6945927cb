#include "rasterizer/base/npy.h"

#include <bit>
#include <charconv>
#include <cstdint>
#include <cstring>
#include <optional>
#include <utility>

#include "rasterizer/base/error.h"
#include "rasterizer/base/file_bytes.h"
#include "rasterizer/base/npy_format.h"
#include "rasterizer/lanes/half.h"

namespace crevice {

static_assert(std::endian::native == std::endian::little, ".npy files are read as the values lie in memory");

namespace {

constexpr int kMaxComponents = 4;

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

// A kind of number that NumPy stores.
struct ValueType {
    std::string_view descr;
    std::size_t bytes;
    double (*value)(const char* at);
};

template <class T>
T stored(const char* at) {
    T value;
    std::memcpy(&value, at, sizeof value);
    return value;
}

constexpr ValueType kValueTypes[] = {
    {"'<f4'", 4, [](const char* at) { return static_cast<double>(stored<float>(at)); }},
    {"'<f2'", 2,
     [](const char* at) {
         return static_cast<double>(float_from_half_bits<float>(stored<std::uint16_t>(at)));
     }},
    {"'<f8'", 8, [](const char* at) { return stored<double>(at); }},
    {"'|u1'", 1, [](const char* at) { return stored<std::uint8_t>(at) / 255.0; }},
    {"'<u2'", 2, [](const char* at) { return stored<std::uint16_t>(at) / 65535.0; }},
};
constexpr const ValueType& kFloat32 = kValueTypes[0];

// What stands before the values.
struct NpyHeader {
    std::string_view descr, order, shape_text;
    std::vector<int> shape;  // empty: not one that is known
    std::string_view values;

    Size size() const { return {shape[1], shape[0]}; }
    int components() const { return shape.size() == 3 ? shape[2] : 1; }
};

// Throws InputError: "NAME: what is wrong; `advice`".
class NpyReader {
 public:
    NpyReader(std::string_view bytes, const std::string& name, std::string_view advice)
        : bytes_(bytes), name_(name), advice_(advice) {}

    NpyHeader header() const {
        if (bytes_.size() < 10 || bytes_.substr(0, kNpyMagic.size()) != kNpyMagic) fail("not a .npy file");
        const int version = byte(6);
        if (version < 1 || version > 3 || byte(7) != 0)
            fail("a .npy of version " + std::to_string(version) + "." + std::to_string(byte(7)) +
                 ", not 1.0, 2.0 or 3.0");
        const std::size_t start = version == 1 ? 10 : 12;
        if (bytes_.size() < start) fail("cut off inside its header");
        const std::size_t size =
            byte(8) + 256u * byte(9) + (version == 1 ? 0 : 65536u * byte(10) + 16777216u * byte(11));
        if (bytes_.size() - start < size) fail("cut off inside its header");
        const std::string_view text = bytes_.substr(start, size);
        const auto entry = [&](const std::string& key) {
            const auto found = header_entry(text, key);
            if (!found) fail("its header has no '" + key + "'");
            return found.value_or("");
        };
        NpyHeader header{
            entry("descr"), entry("fortran_order"), entry("shape"), {}, bytes_.substr(start + size)};
        if (header.order != "False") fail("fortran_order is " + std::string(header.order));
        header.shape = parse_shape(header.shape_text).value_or(std::vector<int>());
        const auto& shape = header.shape;
        const bool image =
            shape.size() == 2 || (shape.size() == 3 && shape[2] > 0 && shape[2] <= kMaxComponents);
        if (!image || shape[0] <= 0 || shape[1] <= 0 ||
            static_cast<long long>(shape[0]) * shape[1] >= kMaxImageValues / header.components()) {
            fail("shape is " + std::string(header.shape_text));
        }
        return header;
    }

    NpyImage image(const NpyHeader& header, const ValueType& type) const {
        const Size size = header.size();
        const auto components = static_cast<std::size_t>(header.components());
        const std::size_t expected = type.bytes * static_cast<std::size_t>(size.width) *
                                     static_cast<std::size_t>(size.height) * components;
        if (header.values.size() != expected) {
            fail("holds " + std::to_string(header.values.size()) + " bytes of values where its shape needs " +
                 std::to_string(expected));
        }
        NpyImage result{Planes(components, Image<float>(size, 0.0f)),
                        type.descr.find('u') != std::string_view::npos};
        const char* at = header.values.data();
        for (int y = 0; y < size.height; ++y) {
            for (int x = 0; x < size.width; ++x) {
                for (Image<float>& plane : result.planes) {
                    if (type.descr == kFloat32.descr) {  // with the bits of a NaN
                        plane.at(x, y) = stored<float>(at);
                    } else {
                        const double value = type.value(at);
                        plane.at(x, y) = static_cast<float>(value);
                        result.rounded += type.bytes == sizeof(double) && value == value &&
                                          static_cast<double>(plane.at(x, y)) != value;
                    }
                    at += type.bytes;
                }
            }
        }
        return result;
    }

    [[noreturn]] void fail(const std::string& what) const {
        throw InputError(name_ + ": " + what + "; " + std::string(advice_));
    }

 private:
    unsigned char byte(std::size_t at) const { return static_cast<unsigned char>(bytes_[at]); }

    std::string_view bytes_;
    const std::string& name_;
    std::string_view advice_;
};

std::string npy_file_bytes(const std::filesystem::path& path) {
    constexpr std::uintmax_t kMaxHeader = 1 << 20;
    return read_file(path, kMaxHeader + sizeof(double) * kMaxImageValues);
}

}  // namespace

NpyImage npy_image(std::string_view bytes, const std::string& name) {
    const NpyReader reader(
        bytes, name,
        "give a .npy of f2, f4, f8, u1 or u2 in C order, little-endian, shape (H, W) or (H, W, 1 to 4)");
    const NpyHeader header = reader.header();
    for (const ValueType& type : kValueTypes) {
        if (header.descr == type.descr) return reader.image(header, type);
    }
    reader.fail("values of type " + std::string(header.descr));
}

NpyImage read_npy_image(const std::filesystem::path& path) {
    return npy_image(npy_file_bytes(path), path.string());
}

Planes planes_from_npy(std::string_view bytes, const std::string& name) {
    const NpyReader reader(bytes, name, "give a .npy of '<f4' in C order, shape (H, W) or (H, W, 3)");
    const NpyHeader header = reader.header();
    if (header.descr != kFloat32.descr) reader.fail("values of type " + std::string(header.descr));
    if (header.shape.size() == 3 && header.components() != 3)
        reader.fail("shape is " + std::string(header.shape_text));
    return reader.image(header, kFloat32).planes;
}

Planes read_npy(const std::filesystem::path& path) {
    return planes_from_npy(npy_file_bytes(path), path.string());
}

}  // namespace crevice
