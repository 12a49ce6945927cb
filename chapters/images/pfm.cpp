#include "chapters/images/pfm.h"

#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstring>

#include "rasterizer/base/error.h"

namespace crevice {

namespace {

// The words of a header, one after the other; each ends with one blank character.
class HeaderWords {
 public:
    explicit HeaderWords(const std::string& bytes) : bytes_(bytes) {}

    std::string next() {
        const std::size_t begin = at_;
        while (at_ < bytes_.size() && !blank(bytes_[at_])) ++at_;
        const std::string word = bytes_.substr(begin, at_ - begin);
        at_ = std::min(at_ + 1, bytes_.size());
        return word;
    }
    std::size_t at() const { return at_; }

 private:
    static bool blank(char c) { return c == ' ' || c == '\n' || c == '\t'; }

    const std::string& bytes_;
    std::size_t at_ = 0;
};

template <class T>
T number(const std::string& word) {
    T value{};
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    return error == std::errc() && end == word.data() + word.size() ? value : T{};
}

float float_at(const char* at, bool little_endian) {
    char bytes[sizeof(float)];
    std::memcpy(bytes, at, sizeof bytes);
    if (little_endian != (std::endian::native == std::endian::little))
        std::reverse(bytes, bytes + sizeof bytes);
    float value;
    std::memcpy(&value, bytes, sizeof value);
    return value;
}

}  // namespace

Planes planes_from_pfm(const std::string& bytes, const std::string& name) {
    const auto fail = [&](const std::string& what) {
        throw InputError(name + ": " + what + "; give a PFM: Pf or PF, width, height, scale, then floats");
    };
    HeaderWords words(bytes);
    const std::string kind = words.next();
    if (kind != "Pf" && kind != "PF") fail("not a PFM file");
    const std::string width = words.next(), height = words.next(), scale = words.next();
    const Size size{number<int>(width), number<int>(height)};
    const int components = kind == "PF" ? 3 : 1;
    if (size.width <= 0 || size.height <= 0 ||
        static_cast<long long>(size.width) * size.height >= kMaxImageValues / components)
        fail("its size is no size (" + width + " " + height + ")");
    const double unit = number<double>(scale);
    if (unit == 0 || !std::isfinite(unit)) fail("its scale is no scale (" + scale + ")");
    const std::size_t expected = sizeof(float) * static_cast<std::size_t>(components) *
                                 static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height);
    if (bytes.size() - words.at() != expected)
        fail("holds " + std::to_string(bytes.size() - words.at()) + " bytes of values where its size needs " +
             std::to_string(expected));
    Planes planes(static_cast<std::size_t>(components), Image<float>(size, 0.0f));
    const char* at = bytes.data() + words.at();
    for (int y = size.height - 1; y >= 0; --y) {
        for (int x = 0; x < size.width; ++x) {
            for (Image<float>& plane : planes) {
                plane.at(x, y) = float_at(at, unit < 0);
                at += sizeof(float);
            }
        }
    }
    return planes;
}

}  // namespace crevice
